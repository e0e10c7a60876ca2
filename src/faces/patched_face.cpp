// SPDX-License-Identifier: Apache-2.0
#include "faces/patched_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/parallel.h"
#include "faces/folded_start.h"
#include "faces/transfinite_face.h"

namespace hexweave {

namespace {

/// The boundary nodes once round, from the corner (0, 0).
std::vector<std::array<int, 2>> boundary_nodes(const Extent& e) {
    std::vector<std::array<int, 2>> nodes;
    nodes.reserve(2 * static_cast<std::size_t>(e.ni + e.nj));
    for (int i = 0; i < e.ni - 1; ++i) nodes.push_back({i, 0});
    for (int j = 0; j < e.nj - 1; ++j) nodes.push_back({e.ni - 1, j});
    for (int i = e.ni - 1; i > 0; --i) nodes.push_back({i, e.nj - 1});
    for (int j = e.nj - 1; j > 0; --j) nodes.push_back({0, j});
    return nodes;
}

/// Calls task(i, j) for all interior nodes of a row, for several rows at once.
template <class Task>
void for_interior_rows(const Extent& e, Task&& task) {
    if (e.ni < 3 || e.nj < 3) return;
    parallel_for(static_cast<std::size_t>(e.nj - 2), [&](std::size_t row) {
        for (int i = 1; i < e.ni - 1; ++i) task(i, static_cast<int>(row) + 1);
    });
}

}  // namespace

PatchedFace::PatchedFace(const std::vector<std::shared_ptr<const Surface>>& surfaces,
                         PointField& points, const ParameterField& parameters, bool start_folded)
    : surfaces_(surfaces), extent_(points.extent()), nodes_(extent_.nodes()) {
    off_.size = surfaces_.size();
    place_boundary(points);
    interpolate_face(points, parameters);
    place_interior(points);
    if (start_folded) {
        fold_interior(points);
        place_interior(points);
    }
    kept_ = nodes_;
}

void PatchedFace::place_boundary(const PointField& points) {
    const std::vector<std::array<int, 2>> nodes = boundary_nodes(extent_);
    std::vector<Vec3> line;
    line.reserve(nodes.size());
    for (const auto& [i, j] : nodes) line.push_back(points(i, j));
    const std::vector<PatchPoint> places = surfaces_.along(line);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const auto& [i, j] = nodes[n];
        at(i, j) = places[n];
        off_.include(places[n].point.distance, line[n]);
    }
}

void PatchedFace::place_interior(PointField& points) {
    const Extent& e = extent_;
    for_interior_rows(e, [&](int i, int j) {
        const PatchPoint found = surfaces_.nearest_from(
            points(i, j), {at(i - 1, j), at(i, 0), at(i, e.nj - 1), at(0, j), at(e.ni - 1, j)});
        at(i, j) = found;
        points.set(i, j, 0, found.point.position);
    });
}

void PatchedFace::project_interior(PointField& points) {
    for_interior_rows(extent_, [&](int i, int j) {
        at(i, j) = surfaces_.nearest_from(points(i, j), {at(i, j)});
        points.set(i, j, 0, at(i, j).point.position);
    });
}

PatchPoint PatchedFace::moved_to(const PointField& points, const CellPlace& place) const {
    const int i = place.i;
    const int j = place.j;
    // A boundary node may be a pole of its surface, from where no way leads downhill.
    std::array<std::array<int, 2>, 4> corners{{{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}}};
    std::stable_partition(corners.begin(), corners.end(), [&](const auto& n) {
        return n[0] > 0 && n[0] < extent_.ni - 1 && n[1] > 0 && n[1] < extent_.nj - 1;
    });
    std::vector<PatchPoint> starts;
    for (const auto& [a, b] : corners) {
        const PatchPoint& corner = at(a, b);
        if (std::none_of(starts.begin(), starts.end(),
                         [&](const PatchPoint& p) { return p.patch == corner.patch; })) {
            starts.push_back(corner);
        }
    }
    return surfaces_.nearest_from({place.of(points.x), place.of(points.y), place.of(points.z)},
                                  starts);
}

double PatchedFace::move_nodes(PointField& points, const Field& s, const Field& t,
                               const ParameterField& wanted) {
    const Extent& e = extent_;
    std::vector<PatchPoint> moved = nodes_;
    std::vector<double> farthest(static_cast<std::size_t>(e.nj), 0.0);
    for_interior_rows(e, [&](int i, int j) {
        const CellPlace place = place_of(s, t, {wanted.s(i, j), wanted.t(i, j)}, {i, j, 0.5, 0.5});
        moved[e.offset(i, j)] = moved_to(points, place);
        double& row = farthest[static_cast<std::size_t>(j)];
        row = std::max(
            {row, std::abs(place.i + place.alpha - i), std::abs(place.j + place.beta - j)});
    });
    nodes_ = std::move(moved);
    for_interior_rows(e, [&](int i, int j) { points.set(i, j, 0, at(i, j).point.position); });
    return *std::max_element(farthest.begin(), farthest.end());
}

BoundFace PatchedFace::bound() {
    BoundFace face;
    face.move = [this](PointField& points, const Field& s, const Field& t,
                       const ParameterField& wanted) { return move_nodes(points, s, t, wanted); };
    face.project = [this](PointField& points) { project_interior(points); };
    face.keep = [this](const PointField&) { kept_ = nodes_; };
    face.restore = [this](PointField& points) {
        nodes_ = kept_;
        for_interior_rows(extent_,
                          [&](int i, int j) { points.set(i, j, 0, at(i, j).point.position); });
    };
    return face;
}

}  // namespace hexweave
