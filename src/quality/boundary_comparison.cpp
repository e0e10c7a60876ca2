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
    std::string type;
    bool by_family = false;  ///< the type is its family's, which the file declares

    auto key() const { return std::tie(zone, box.begin, box.end, family, type); }
};

Boundary boundary(const OutlineComparison& c, const ZoneMatch& match, const GridOutline& grid,
                  const BoundaryPatch& patch) {
    const Family& family = grid.families[static_cast<std::size_t>(patch.family)];
    return {match.candidate, carried(c, match, patch.box), family.name,
            type_of(patch, grid.families), patch.type.empty() && !family.undeclared};
}

std::vector<Boundary> boundaries_of_candidate(const OutlineComparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.candidate.patches) {
        if (!c.of_candidate[static_cast<std::size_t>(patch.zone)]) continue;
        list.push_back(boundary(c, {patch.zone, 0, {}}, c.candidate, patch));
    }
    return list;
}

std::vector<Boundary> boundaries_of_golden(const OutlineComparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.golden.patches) {
        const auto& match = c.of_golden[static_cast<std::size_t>(patch.zone)];
        if (match) list.push_back(boundary(c, *match, c.golden, patch));
    }
    return list;
}

/// "zone 'wing', nodes [1, 1, 1] to [9, 5, 1]".
std::string place_of(const OutlineComparison& c, const Boundary& b) {
    return fmt::format("zone '{}', nodes {}", c.zone(b.zone).name,
                       to_text(b.box, c.candidate.cell_dimension));
}

/// Pairs boundaries with golden ones that `alike` accepts and tells of each pair what `text` says,
/// if anything; both are taken out.
template <class Alike, class Text>
void tell_pairs(OutlineComparison& c, std::vector<Boundary>& own, std::vector<Boundary>& golden,
                Alike&& alike, Text&& text) {
    std::vector<Boundary> rest;
    for (const Boundary& b : own) {
        const auto other = take(golden, [&](const Boundary& g) { return alike(b, g); });
        if (!other) {
            rest.push_back(b);
            continue;
        }
        const std::string said = text(b, *other);
        if (!said.empty()) c.tell("boundary", place_of(c, b) + ": " + said);
    }
    own = std::move(rest);
}

bool same_nodes(const Boundary& b, const Boundary& g) {
    return b.zone == g.zone && b.box == g.box;
}

bool same_family(const Boundary& b, const Boundary& g) {
    return b.zone == g.zone && b.family == g.family;
}

/// Nothing where the two families tell it.
std::string types_text(const Boundary& b, const Boundary& g) {
    if (b.by_family && g.by_family) return {};
    return fmt::format("boundary '{}' is of type {}, golden {}", b.family, b.type, g.type);
}

std::string families_text(const Boundary& b, const Boundary& g) {
    return fmt::format("the boundary is of family '{}', golden '{}'", b.family, g.family);
}

}  // namespace

void compare_boundaries(OutlineComparison& c) {
    std::vector<Boundary> own = boundaries_of_candidate(c);
    std::vector<Boundary> golden = boundaries_of_golden(c);
    keep_unlike(own, golden);
    // A type that was changed first, then a family, then a range, so that one fault is told once.
    tell_pairs(
        c, own, golden,
        [](const Boundary& b, const Boundary& g) { return same_nodes(b, g) && same_family(b, g); },
        types_text);
    tell_pairs(c, own, golden, same_nodes, families_text);
    tell_pairs(c, own, golden, same_family, [&c](const Boundary& b, const Boundary& g) {
        return fmt::format("boundary '{}', golden nodes {}", b.family,
                           to_text(g.box, c.candidate.cell_dimension));
    });
    for (const Boundary& b : own) {
        c.tell("boundary", fmt::format("{}: boundary '{}' is not in the golden grid",
                                       place_of(c, b), b.family));
    }
    for (const Boundary& g : golden) {
        c.tell("boundary", fmt::format("{}: boundary '{}' of the golden grid is missing",
                                       place_of(c, g), g.family));
    }
}

}  // namespace hexweave
