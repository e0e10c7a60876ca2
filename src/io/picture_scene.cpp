// SPDX-License-Identifier: Apache-2.0
#include "io/picture_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/errors.h"
#include "io/grid_names.h"

namespace hexweave {

namespace {

constexpr double block_edge = 1.0;  ///< pixels
constexpr double grid_edge = 1.6;
constexpr double family_edge = 2.8;

const Zone& zone_of(const MultiblockGrid& grid, int zone) {
    return grid.zones[static_cast<std::size_t>(zone)];
}

std::vector<int> running_axes(const IndexBox& box) {
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (box.begin[a] != box.end[a]) axes.push_back(axis);
    }
    return axes;
}

IndexBox forwards(IndexBox box) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (box.begin[a] > box.end[a]) std::swap(box.begin[a], box.end[a]);
    }
    return box;
}

IndexBox whole(const Extent& extent) {
    return {{0, 0, 0}, {extent.ni - 1, extent.nj - 1, extent.nk - 1}};
}

IndexBox plane_of(const Extent& extent, int axis, int index) {
    IndexBox box = whole(extent);
    box.begin[static_cast<std::size_t>(axis)] = index;
    box.end[static_cast<std::size_t>(axis)] = index;
    return box;
}

/// For every family whether it is to be drawn.
std::vector<bool> chosen_families(const MultiblockGrid& grid, const PictureOptions& options) {
    const std::vector<std::string> names = names_of(grid.families);
    std::vector<bool> chosen(names.size(), options.families.empty());
    for (const std::string& wanted : options.families) {
        const auto found = std::find(names.begin(), names.end(), wanted);
        if (found == names.end()) throw UsageError(unknown_in_grid("family", wanted, names));
        chosen[static_cast<std::size_t>(found - names.begin())] = true;
    }
    return chosen;
}

void check_patches(const MultiblockGrid& grid) {
    for (const BoundaryPatch& patch : grid.patches) {
        const Zone& zone = zone_of(grid, patch.zone);
        const IndexBox box = forwards(patch.box);
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            if (box.begin[a] < 0 || box.end[a] >= zone.points.extent()[axis]) {
                throw UsageError(
                    fmt::format("boundary '{}' lies outside its zone '{}'", patch.name, zone.name));
            }
        }
    }
}

/// Collects the scene and remembers what of it the legend must name.
class Collector {
public:
    Collector(const MultiblockGrid& grid, const PictureOptions& options)
        : grid_(grid),
          options_(options),
          by_family_(options.colour == ColourBy::family),
          families_(chosen_families(grid, options)),
          family_seen_(families_.size(), false),
          zone_seen_(grid.zones.size(), false) {
        check_patches(grid);
    }

    /// A planar or surface grid: every zone, its sides, and the boundaries on them.
    void add_faces() {
        if (!options_.planes.empty()) {
            throw UsageError("index planes need a grid of volumes; this one has only faces");
        }
        for (int zone = 0; zone < static_cast<int>(grid_.zones.size()); ++zone) {
            add_sheet(zone, whole(zone_of(grid_, zone).points.extent()), std::nullopt);
        }
        if (!options_.boundary) return;
        for (const BoundaryPatch& patch : chosen_patches()) {
            const IndexBox box = forwards(patch.box);
            if (running_axes(box).size() != 1) continue;
            const Colour colour = by_family_ ? palette(patch.family) : ink;
            scene_.edges.push_back({patch.zone, box, colour, by_family_ ? family_edge : grid_edge});
            family_seen_[static_cast<std::size_t>(patch.family)] = true;
        }
    }

    void add_boundary() {
        if (!options_.boundary) return;
        if (grid_.patches.empty() && options_.families.empty()) {
            for (int zone = 0; zone < static_cast<int>(grid_.zones.size()); ++zone) {
                const Extent& extent = zone_of(grid_, zone).points.extent();
                for (int axis = 0; axis < 3; ++axis) {
                    add_sheet(zone, plane_of(extent, axis, 0), std::nullopt);
                    add_sheet(zone, plane_of(extent, axis, extent[axis] - 1), std::nullopt);
                }
            }
        }
        for (const BoundaryPatch& patch : chosen_patches()) {
            add_sheet(patch.zone, forwards(patch.box), patch.family);
        }
    }

    void add_planes() {
        for (const IndexPlane& plane : options_.planes) {
            for (const int zone : zones_of_plane(grid_, plane)) {
                const Extent& extent = zone_of(grid_, zone).points.extent();
                add_sheet(zone, plane_of(extent, plane.axis, plane.index), std::nullopt);
            }
        }
    }

    Scene finish() {
        if (scene_.sheets.empty()) {
            throw UsageError(
                options_.families.empty()
                    ? "the picture would be empty: neither boundary nor index plane"
                    : "the picture would be empty: no surface belongs to the families");
        }
        const bool lines = by_family_ && grid_.cell_dimension == 2;
        const auto list = [&](const auto& things, const std::vector<bool>& seen) {
            for (std::size_t i = 0; i < things.size(); ++i) {
                if (!seen[i]) continue;
                const Colour colour = palette(static_cast<int>(i));
                scene_.legend.push_back({things[i].name, lines ? colour : surface_colour(colour)});
            }
        };
        if (by_family_) {
            list(grid_.families, family_seen_);
        } else {
            list(grid_.zones, zone_seen_);
        }
        scene_.zones = static_cast<int>(std::count(zone_seen_.begin(), zone_seen_.end(), true));
        return std::move(scene_);
    }

private:
    std::vector<BoundaryPatch> chosen_patches() const {
        std::vector<BoundaryPatch> chosen;
        for (const BoundaryPatch& patch : grid_.patches) {
            if (families_[static_cast<std::size_t>(patch.family)]) chosen.push_back(patch);
        }
        return chosen;
    }

    void add_sheet(int zone, const IndexBox& box, std::optional<int> family) {
        const std::vector<int> axes = running_axes(box);
        if (axes.size() != 2) return;
        const Colour colour = !by_family_ ? palette(zone) : family ? palette(*family) : plaster;
        scene_.sheets.push_back({zone, box, colour});
        zone_seen_[static_cast<std::size_t>(zone)] = true;
        if (family) family_seen_[static_cast<std::size_t>(*family)] = true;
        for (const int axis : axes) {
            const auto a = static_cast<std::size_t>(axis);
            for (const int index : {box.begin[a], box.end[a]}) {
                IndexBox edge = box;
                edge.begin[a] = edge.end[a] = index;
                scene_.edges.push_back({zone, edge, ink, block_edge});
            }
        }
    }

    const MultiblockGrid& grid_;
    const PictureOptions& options_;
    bool by_family_;
    std::vector<bool> families_;
    std::vector<bool> family_seen_;
    std::vector<bool> zone_seen_;
    Scene scene_;
};

}  // namespace

Scene make_scene(const MultiblockGrid& grid, const PictureOptions& options) {
    Collector collector(grid, options);
    if (grid.cell_dimension == 2) {
        collector.add_faces();
    } else {
        collector.add_boundary();
        collector.add_planes();
    }
    Scene scene = collector.finish();
    scene.flat = grid.cell_dimension == 2 && grid.physical_dimension == 2 && !options.view;
    scene.tinted = options.colour == ColourBy::zone;
    return scene;
}

SightSheet place_nodes(const Zone& zone, const IndexBox& box, const View& view) {
    std::vector<int> axes = running_axes(box);
    for (int axis = 0; axes.size() < 2; ++axis) {
        if (std::find(axes.begin(), axes.end(), axis) == axes.end()) axes.push_back(axis);
    }
    const auto first = static_cast<std::size_t>(axes[0]);
    const auto second = static_cast<std::size_t>(axes[1]);
    SightSheet sheet;
    sheet.ni = box.end[first] - box.begin[first] + 1;
    sheet.nj = box.end[second] - box.begin[second] + 1;
    sheet.nodes.reserve(static_cast<std::size_t>(sheet.ni) * static_cast<std::size_t>(sheet.nj));
    Node node = box.begin;
    for (int n = 0; n < sheet.nj; ++n) {
        node[second] = box.begin[second] + n;
        for (int m = 0; m < sheet.ni; ++m) {
            node[first] = box.begin[first] + m;
            sheet.nodes.push_back(view.place(zone.points(node[0], node[1], node[2])));
        }
    }
    return sheet;
}

}  // namespace hexweave
