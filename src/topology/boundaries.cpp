// SPDX-License-Identifier: Apache-2.0
#include "topology/boundaries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "topology/format_table.h"
#include "topology/grid_sides.h"
#include "topology/suggestions.h"

namespace hexweave {

namespace {

void check_sharing(const GridSides& sides, Diagnostics& diagnostics) {
    for (std::size_t n = 0; n < sides.users.size(); ++n) {
        if (sides.collapsed[n] > 0 && sides.users[n].size() == 2) {
            diagnostics.error(
                sides.places[n],
                fmt::format("{} {} is collapsed and cannot join {}", sides.kind,
                            quoted(sides.names[n]), users_text(sides, sides.users[n])),
                fmt::format("give each {} one of its own", sides.user));
        }
        if (sides.users[n].size() <= 2) continue;
        diagnostics.error(
            sides.places[n],
            fmt::format("{} {} is used {} times, by {}", sides.kind, quoted(sides.names[n]),
                        sides.users[n].size(), users_text(sides, sides.users[n])),
            fmt::format("at most two {}s share one {}", sides.user, sides.kind));
    }
}

struct Claim {
    const Name* boundary = nullptr;
    Place place;
};

/// For every side the periodic interface that has it, or none.
std::vector<const PeriodicInterface*> periodic_sides(const Topology& topology, std::size_t count) {
    std::vector<const PeriodicInterface*> interfaces(count);
    for (const PeriodicInterface& interface : topology.periodic) {
        for (const PeriodicPair& pair : interface.pairs) {
            interfaces[static_cast<std::size_t>(pair.from)] = &interface;
            interfaces[static_cast<std::size_t>(pair.to)] = &interface;
        }
    }
    return interfaces;
}

class Assignment {
public:
    Assignment(Network& network, const GridSides& sides, Diagnostics& diagnostics)
        : network_(network),
          sides_(sides),
          diagnostics_(diagnostics),
          periodic_(periodic_sides(network.topology, sides.users.size())),
          claims_(sides.users.size()) {}

    void add(const BoundaryEntry& entry) {
        Boundary boundary;
        boundary.family = {entry.name.value, entry.type.value};
        if (entry.plane) boundary.plane = entry.plane->value;
        for (const Name& name : entry.sides) {
            if (const auto side = free_side(entry, name)) boundary.sides.push_back(*side);
        }
        network_.topology.boundaries.push_back(std::move(boundary));
    }

    /// Poles that nobody claims.
    void collect_poles() {
        // In two dimensions a collapsed side is an edge less one dimension: a point.
        const bool in_space = network_.three_dimensional || network_.topology.sweep;
        const int to_point = in_space ? 2 : 1;
        Boundary lines{{line_family, "BCDegenerateLine"}, {}, {}};
        Boundary points{{point_family, "BCDegeneratePoint"}, {}, {}};
        for (std::size_t n = 0; n < claims_.size(); ++n) {
            if (sides_.collapsed[n] == 0 || !is_unclaimed(n)) continue;
            (sides_.collapsed[n] == to_point ? points : lines).sides.push_back(static_cast<int>(n));
        }
        for (Boundary* poles : {&lines, &points}) {
            if (poles->sides.empty()) continue;
            network_.topology.boundaries.push_back(std::move(*poles));
        }
    }

    /// Free sides that nobody claims go to a family of their own.
    void collect_unassigned(const Place& file) {
        Boundary rest;
        rest.family = {unassigned_family, "UserDefined"};
        std::vector<std::string> names;
        for (std::size_t n = 0; n < claims_.size(); ++n) {
            if (sides_.collapsed[n] > 0 || !is_unclaimed(n)) continue;
            rest.sides.push_back(static_cast<int>(n));
            names.push_back(sides_.names[n]);
        }
        if (rest.sides.empty()) return;
        std::sort(names.begin(), names.end());
        diagnostics_.warning(
            file, fmt::format("no boundary names {}", listed(names)),
            fmt::format("written as family '{}', UserDefined; name {} in 'boundaries'",
                        unassigned_family, names.size() == 1 ? "it" : "them"));
        network_.topology.boundaries.push_back(std::move(rest));
    }

private:
    bool is_unclaimed(std::size_t side) const {
        return claims_[side].boundary == nullptr && periodic_[side] == nullptr &&
               sides_.users[side].size() == 1;
    }

    /// The side that a boundary may have, which it claims.
    std::optional<int> free_side(const BoundaryEntry& entry, const Name& name) {
        const std::optional<int> side =
            find_side(network_, sides_, name, {"a boundary", "boundaries"}, diagnostics_);
        if (!side) return std::nullopt;
        const auto n = static_cast<std::size_t>(*side);
        const std::vector<int>& users = sides_.users[n];
        if (users.size() > 1) {
            const bool cut = std::all_of(users.begin(), users.end(),
                                         [&](int user) { return user == users.front(); });
            diagnostics_.error(
                name.place,
                fmt::format("{} {} is no boundary: {} {}", sides_.kind, quoted(name.value),
                            cut ? "it is a cut of" : "it joins", users_text(sides_, users)),
                fmt::format("take it out of boundary {}", quoted(entry.name.value)));
            return std::nullopt;
        }
        if (periodic_[n] != nullptr) {
            diagnostics_.error(
                name.place,
                fmt::format("{} {} is no boundary: it is a side of the periodic interface {}",
                            sides_.kind, quoted(name.value), quoted(periodic_[n]->name)),
                fmt::format("take it out of boundary {}", quoted(entry.name.value)));
            return std::nullopt;
        }
        Claim& claim = claims_[n];
        if (claim.boundary != nullptr) {
            diagnostics_
                .error(name.place,
                       fmt::format("{} {} is named twice: boundary {} has it already", sides_.kind,
                                   quoted(name.value), quoted(claim.boundary->value)),
                       "leave it in one of the two")
                .notes.push_back({claim.place, "here"});
            return std::nullopt;
        }
        claim = {&entry.name, name.place};
        return side;
    }

    Network& network_;
    const GridSides& sides_;
    Diagnostics& diagnostics_;
    std::vector<const PeriodicInterface*> periodic_;
    std::vector<Claim> claims_;
};

/// Families and zones stand side by side in a CGNS file, under names of their own.
void check_family_names(const Case& c, Diagnostics& diagnostics) {
    std::map<std::string, const Name*> zones;
    if (c.blocks.empty()) {
        for (const FaceEntry& face : c.faces) zones.emplace(face.name.value, &face.name);
    } else {
        for (const BlockEntry& block : c.blocks) zones.emplace(block.name.value, &block.name);
    }
    for (const BoundaryEntry& boundary : c.boundaries) {
        const Name& name = boundary.name;
        const bool of_poles = name.value == line_family || name.value == point_family;
        if (name.value == unassigned_family || of_poles) {
            diagnostics.error(name.place,
                              fmt::format("{} is the family of the {} that no boundary names",
                                          quoted(name.value), of_poles ? "poles" : "sides"),
                              "give this boundary another name");
        }
        const auto zone = zones.find(name.value);
        if (zone == zones.end()) continue;
        diagnostics
            .error(name.place,
                   fmt::format("boundary {} has the name of a {}", quoted(name.value),
                               c.blocks.empty() ? "face" : "block"),
                   "a CGNS file cannot hold a family and a zone of one name: rename one")
            .notes.push_back({zone->second->place, "the other one"});
    }
}

/// Only the ends of a sweep are boundaries without sides.
void check_sides_given(const Case& c, Diagnostics& diagnostics) {
    const auto is_end = [&](const BoundaryEntry& boundary) {
        const auto named = [&](const std::optional<Name>& end) {
            return end && end->value == boundary.name.value;
        };
        return c.sweep && (named(c.sweep->ends[0]) || named(c.sweep->ends[1]));
    };
    for (const BoundaryEntry& boundary : c.boundaries) {
        if (!boundary.lacks_sides) continue;
        if (!is_end(boundary)) {
            diagnostics.error(
                boundary.name.place,
                fmt::format("boundary {} lacks the key 'sides'", quoted(boundary.name.value)),
                usage_of(*find_key("boundary", "sides")));
        } else if (boundary.plane) {
            diagnostics.error(boundary.plane->place,
                              "where the end of a sweep lies is not to be said",
                              "leave 'plane' out: its points are exactly there");
        }
    }
}

/// Whether what every boundary names could be read.
bool all_sides_read(const Case& c) {
    return std::all_of(c.boundaries.begin(), c.boundaries.end(), [](const BoundaryEntry& entry) {
        return (entry.lacks_sides || !entry.sides.empty()) &&
               std::none_of(entry.sides.begin(), entry.sides.end(),
                            [](const Name& side) { return side.value.empty(); });
    });
}

/// Whether every side of the periodic interfaces found its image, or its origin.
bool all_paired(const Topology& topology, const Case& c) {
    std::size_t sides = 0;
    std::size_t pairs = 0;
    for (const PeriodicEntry& entry : c.periodic) {
        sides += std::max(entry.from.size(), entry.to.size());
    }
    for (const PeriodicInterface& interface : topology.periodic) pairs += interface.pairs.size();
    return pairs == sides;
}

}  // namespace

void resolve_boundaries(Network& network, const Case& c, Diagnostics& diagnostics) {
    check_family_names(c, diagnostics);
    check_sides_given(c, diagnostics);
    const GridSides sides = grid_sides(network);
    check_sharing(sides, diagnostics);
    const int errors = diagnostics.errors();
    Assignment assignment(network, sides, diagnostics);
    for (const BoundaryEntry& entry : c.boundaries) assignment.add(entry);
    assignment.collect_poles();
    // After a fault, what seems uncovered may be what a boundary failed to name.
    if (network.intact && all_sides_read(c) && diagnostics.errors() == errors &&
        all_paired(network.topology, c)) {
        assignment.collect_unassigned(Place{c.source, 0, 0});
    }
}

}  // namespace hexweave
