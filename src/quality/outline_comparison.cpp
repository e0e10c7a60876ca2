// SPDX-License-Identifier: Apache-2.0
#include "quality/outline_comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "quality/outline_parts.h"

namespace hexweave {
namespace {

/// "wing", or `none` where there is nothing.
std::string or_none(const std::string& text, const char* none) {
    return text.empty() ? none : text;
}

void compare_units(OutlineComparison& c) {
    if (c.candidate.units != c.golden.units) {
        c.tell("units", fmt::format("the length unit is {}, golden {}",
                                    or_none(c.candidate.units, "not given"),
                                    or_none(c.golden.units, "not given")));
    }
    const auto dimensions = [](const GridOutline& grid) {
        return fmt::format("{} of cells, {} of space", grid.cell_dimension,
                           grid.physical_dimension);
    };
    if (dimensions(c.candidate) != dimensions(c.golden)) {
        c.tell("dimensions", fmt::format("dimensions are {}, golden {}", dimensions(c.candidate),
                                         dimensions(c.golden)));
    }
}

void compare_zones(OutlineComparison& c) {
    for (std::size_t n = 0; n < c.candidate.zones.size(); ++n) {
        const ZoneOutline& own = c.candidate.zones[n];
        const int axes = c.candidate.cell_dimension;
        if (!c.of_candidate[n]) {
            c.tell("zone", fmt::format("zone '{}' ({}) has no counterpart in the golden grid",
                                       own.name, to_text(own.extent, axes)));
            continue;
        }
        const ZoneMatch& match = *c.of_candidate[n];
        const ZoneOutline& other = c.golden.zones[static_cast<std::size_t>(match.golden)];
        if (!(own.extent == own_extent(match.to_golden, other.extent))) {
            c.tell("dimensions", fmt::format("zone '{}' has {} nodes, golden {}", own.name,
                                             to_text(own.extent, axes),
                                             to_text(other.extent, c.golden.cell_dimension)));
        }
    }
    for (std::size_t n = 0; n < c.golden.zones.size(); ++n) {
        if (c.of_golden[n]) continue;
        const ZoneOutline& zone = c.golden.zones[n];
        c.tell("zone", fmt::format("zone '{}' ({}) of the golden grid is missing", zone.name,
                                   to_text(zone.extent, c.golden.cell_dimension)));
    }
}

void compare_families(OutlineComparison& c) {
    const auto find = [](const GridOutline& grid, const std::string& name) {
        return std::find_if(grid.families.begin(), grid.families.end(),
                            [&name](const Family& family) { return family.name == name; });
    };
    for (const Family& family : c.candidate.families) {
        const auto other = find(c.golden, family.name);
        if (other == c.golden.families.end()) {
            c.tell("family", fmt::format("family '{}' ({}) is not in the golden grid", family.name,
                                         family.type));
        } else if (other->type != family.type && !family.undeclared && !other->undeclared) {
            c.tell("family", fmt::format("family '{}' is of type {}, golden {}", family.name,
                                         family.type, other->type));
        }
    }
    for (const Family& family : c.golden.families) {
        if (find(c.candidate, family.name) == c.candidate.families.end()) {
            c.tell("family", fmt::format("family '{}' ({}) of the golden grid is missing",
                                         family.name, family.type));
        }
    }
}

}  // namespace

std::vector<Difference> compare_outlines(const GridOutline& candidate, const GridOutline& golden,
                                         const std::vector<ZoneMatch>& matches,
                                         const PointBox& golden_box) {
    OutlineComparison c{candidate, golden, golden_box, {}, {}, {}};
    c.of_candidate.resize(candidate.zones.size());
    c.of_golden.resize(golden.zones.size());
    for (const ZoneMatch& match : matches) {
        c.of_candidate[static_cast<std::size_t>(match.candidate)] = match;
        c.of_golden[static_cast<std::size_t>(match.golden)] = match;
    }
    compare_units(c);
    compare_zones(c);
    compare_families(c);
    compare_boundaries(c);
    compare_interfaces(c);
    return std::move(c.found);
}

}  // namespace hexweave
