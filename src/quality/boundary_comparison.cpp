// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <tuple>
#include <vector>

#include "quality/outline_parts.h"

namespace hexweave {
namespace {

/// A box of a golden zone as nodes of its counterpart, running forwards.
IndexBox carried(const OutlineComparison& c, const ZoneMatch& match, const IndexBox& box) {
    const Orientation to_candidate = inverse(match.to_golden);
    const Extent& extent = c.zone(match.candidate).extent;
    IndexBox result{map_node(to_candidate, box.begin, extent),
                    map_node(to_candidate, box.end, extent)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (result.begin[axis] > result.end[axis]) std::swap(result.begin[axis], result.end[axis]);
    }
    return result;
}

struct Boundary {
    int zone = 0;
    IndexBox box;
    std::string family;

    auto key() const { return std::tie(zone, box.begin, box.end, family); }
};

std::vector<Boundary> boundaries_of_candidate(const OutlineComparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.candidate.patches) {
        if (!c.of_candidate[static_cast<std::size_t>(patch.zone)]) continue;
        list.push_back({patch.zone, carried(c, {patch.zone, 0, {}}, patch.box),
                        c.candidate.families[static_cast<std::size_t>(patch.family)].name});
    }
    return list;
}

std::vector<Boundary> boundaries_of_golden(const OutlineComparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.golden.patches) {
        const auto& match = c.of_golden[static_cast<std::size_t>(patch.zone)];
        if (!match) continue;
        list.push_back({match->candidate, carried(c, *match, patch.box),
                        c.golden.families[static_cast<std::size_t>(patch.family)].name});
    }
    return list;
}

}  // namespace

void compare_boundaries(OutlineComparison& c) {
    std::vector<Boundary> own = boundaries_of_candidate(c);
    std::vector<Boundary> golden = boundaries_of_golden(c);
    keep_unlike(own, golden);
    const int axes = c.candidate.cell_dimension;
    const auto where = [&c, axes](const Boundary& b) {
        return fmt::format("zone '{}', nodes {}", c.zone(b.zone).name, to_text(b.box, axes));
    };
    // A family that was changed first, then a range, so that one fault is told once.
    std::vector<Boundary> rest;
    for (const Boundary& b : own) {
        const auto other =
            take(golden, [&b](const Boundary& g) { return g.zone == b.zone && g.box == b.box; });
        if (!other) {
            rest.push_back(b);
            continue;
        }
        c.tell("boundary", fmt::format("{}: the boundary is of family '{}', golden '{}'", where(b),
                                       b.family, other->family));
    }
    for (const Boundary& b : rest) {
        const auto other = take(
            golden, [&b](const Boundary& g) { return g.zone == b.zone && g.family == b.family; });
        c.tell("boundary", other ? fmt::format("{}: boundary '{}', golden nodes {}", where(b),
                                               b.family, to_text(other->box, axes))
                                 : fmt::format("{}: boundary '{}' is not in the golden grid",
                                               where(b), b.family));
    }
    for (const Boundary& g : golden) {
        c.tell("boundary",
               fmt::format("{}: boundary '{}' of the golden grid is missing", where(g), g.family));
    }
}

}  // namespace hexweave
