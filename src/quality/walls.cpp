// SPDX-License-Identifier: Apache-2.0
#include "quality/walls.h"

#include <algorithm>
#include <cmath>

#include "quality/angles.h"

namespace hexweave {

namespace {

/// A patch as seen from its zone: the axis that leaves it, which way, and the axes along it. One
/// along which the zone is one cell thick, as after a sweep, is none: its nodes stand on the two
/// sections.
struct PatchAxes {
    std::size_t normal = 0;
    int inward = 1;
    std::vector<std::size_t> along;
};

PatchAxes axes_of(const IndexBox& box, const Extent& extent) {
    PatchAxes axes;
    bool found = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = extent[static_cast<int>(axis)] - 1;
        if (last == 0) continue;
        const bool is_thin = last == 1;
        if (!found && box.begin[axis] == box.end[axis]) {
            axes.normal = axis;
            axes.inward = box.begin[axis] == 0 ? 1 : -1;
            found = true;
        } else if (!is_thin) {
            axes.along.push_back(axis);
        }
    }
    return axes;
}

Vec3 neighbour(const PointField& x, Node n, std::size_t axis, int step) {
    n[axis] += step;
    return x(n[0], n[1], n[2]);
}

/// The direction of a line at one of its nodes: the tangent of the circle through it and its
/// neighbours along an axis, however unequal their distances.
Vec3 tangent(const PointField& x, const Node& n, std::size_t axis) {
    const Vec3 centre = neighbour(x, n, axis, 0);
    const Vec3 back = centre - neighbour(x, n, axis, -1);
    const Vec3 ahead = neighbour(x, n, axis, 1) - centre;
    // Either interval's direction, weighed with the length of the other.
    return norm(ahead) * back / norm(back) + norm(back) * ahead / norm(ahead);
}

/// Whether an interval of the wall beside a node has no length, so that it has no normal there.
bool is_collapsed(const PointField& x, const PatchAxes& axes, const Node& n) {
    const Vec3 centre = x(n[0], n[1], n[2]);
    return std::any_of(axes.along.begin(), axes.along.end(), [&](std::size_t axis) {
        return neighbour(x, n, axis, -1) == centre || neighbour(x, n, axis, 1) == centre;
    });
}

/// Degrees between an interval that leaves the wall and the wall's normal.
double angle_from_normal(const Vec3& interval, const std::vector<Vec3>& tangents) {
    if (tangents.size() == 1) return std::abs(90 - angle_between(interval, tangents[0]));
    const double angle = angle_between(interval, cross(tangents[0], tangents[1]));
    return std::min(angle, 180 - angle);
}

class WallCollector {
public:
    explicit WallCollector(std::string family) { measure_.family = std::move(family); }

    void include(const PointField& x, const IndexBox& box);
    WallMeasure finish();

private:
    void include_node(const PointField& x, const PatchAxes& axes, const Node& n, int from_end);

    WallMeasure measure_;
    std::vector<double> heights_;
};

void WallCollector::include(const PointField& x, const IndexBox& box) {
    const PatchAxes axes = axes_of(box, x.extent());
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node n{i, j, k};
                int from_end = 2;
                for (const std::size_t axis : axes.along) {
                    from_end =
                        std::min({from_end, n[axis] - box.begin[axis], box.end[axis] - n[axis]});
                }
                include_node(x, axes, n, from_end);
            }
        }
    }
}

/// `from_end`: how many nodes from an end of the patch, 2 for more.
void WallCollector::include_node(const PointField& x, const PatchAxes& axes, const Node& n,
                                 int from_end) {
    const Vec3 place = x(n[0], n[1], n[2]);
    const Vec3 interval = neighbour(x, n, axes.normal, axes.inward) - place;
    const double height = norm(interval);
    if (height != 0) heights_.push_back(height);
    if (axes.along.empty() || from_end == 0 || is_collapsed(x, axes, n)) return;
    std::vector<Vec3> tangents;
    for (const std::size_t axis : axes.along) tangents.push_back(tangent(x, n, axis));
    const double angle = angle_from_normal(interval, tangents);
    if (from_end == 1) {
        measure_.greatest_angle_beside_ends = std::max(measure_.greatest_angle_beside_ends, angle);
        return;
    }
    ++measure_.nodes;
    measure_.mean_angle += angle;
    if (measure_.nodes > 1 && angle <= measure_.greatest_angle) return;
    measure_.greatest_angle = angle;
    measure_.worst_place = place;
}

WallMeasure WallCollector::finish() {
    if (measure_.nodes > 0) measure_.mean_angle /= static_cast<double>(measure_.nodes);
    if (heights_.empty()) return measure_;
    std::sort(heights_.begin(), heights_.end());
    measure_.least_height = heights_.front();
    const std::size_t half = heights_.size() / 2;
    measure_.median_height =
        heights_.size() % 2 == 1 ? heights_[half] : (heights_[half - 1] + heights_[half]) / 2;
    measure_.greatest_height = heights_.back();
    return measure_;
}

using PatchFilter = std::function<bool(const BoundaryPatch&)>;

WallMeasure measure_family(const MultiblockGrid& grid, std::size_t family,
                           const PatchFilter& counts) {
    WallCollector collector(grid.families[family].name);
    for (const BoundaryPatch& patch : grid.patches) {
        if (patch.family != static_cast<int>(family) || !counts(patch)) continue;
        collector.include(grid.zones[static_cast<std::size_t>(patch.zone)].points, patch.box);
    }
    return collector.finish();
}

}  // namespace

bool is_wall(const Family& family) {
    return family.type.starts_with("BCWall");
}

std::vector<WallMeasure> measure_walls(const MultiblockGrid& grid, const PatchFilter& counts) {
    std::vector<WallMeasure> walls;
    for (std::size_t f = 0; f < grid.families.size(); ++f) {
        if (is_wall(grid.families[f])) {
            walls.push_back(measure_family(grid, f, counts));
        }
    }
    return walls;
}

std::vector<WallMeasure> measure_boundaries(const MultiblockGrid& grid) {
    std::vector<WallMeasure> boundaries;
    for (std::size_t f = 0; f < grid.families.size(); ++f) {
        boundaries.push_back(measure_family(grid, f, [](const BoundaryPatch&) { return true; }));
    }
    return boundaries;
}

}  // namespace hexweave
