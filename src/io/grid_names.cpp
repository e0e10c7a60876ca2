// SPDX-License-Identifier: Apache-2.0
#include "io/grid_names.h"

#include <fmt/format.h>

#include "core/diagnostics.h"
#include "core/errors.h"

namespace hexweave {

std::string unknown_in_grid(const std::string& kind, const std::string& name,
                            const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(name, known);
    if (!nearest.empty()) {
        return fmt::format("the grid has no {} '{}'; did you mean '{}'?", kind, name, nearest);
    }
    std::string list;
    for (std::size_t i = 0; i < known.size() && i < 12; ++i) {
        list += (i == 0 ? "" : ", ") + known[i];
    }
    if (known.size() > 12) list += fmt::format(", and {} more", known.size() - 12);
    if (list.empty()) list = "none";
    return fmt::format("the grid has no {} '{}'; it has: {}", kind, name, list);
}

std::vector<int> zones_of_plane(const MultiblockGrid& grid, const IndexPlane& plane) {
    std::vector<int> zones;
    for (std::size_t n = 0; n < grid.zones.size(); ++n) {
        const Zone& zone = grid.zones[n];
        if (!plane.zone.empty() && plane.zone != zone.name) continue;
        const int nodes = zone.points.extent()[plane.axis];
        if (plane.index < 0 || plane.index >= nodes) {
            const char axis = "ijk"[plane.axis];
            throw UsageError(
                fmt::format("zone '{}' has no index plane {} = {}: {} runs from 1 to {}", zone.name,
                            axis, plane.index + 1, axis, nodes));
        }
        zones.push_back(static_cast<int>(n));
    }
    if (zones.empty()) throw UsageError(unknown_in_grid("zone", plane.zone, names_of(grid.zones)));
    return zones;
}

}  // namespace hexweave
