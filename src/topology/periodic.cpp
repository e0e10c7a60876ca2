// SPDX-License-Identifier: Apache-2.0
#include "topology/periodic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "topology/grid_sides.h"
#include "topology/periodic_match.h"
#include "topology/periodic_remedy.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr double near_image = 1e-9;  // of the grid's size

struct Pairing {
    Network& network;
    Diagnostics& diagnostics;
    GridSides sides;
    std::vector<const Name*> claims;  ///< for every side where an interface names it

    std::string text(int side) const {
        return fmt::format("{} {}", sides.kind,
                           quoted(sides.names[static_cast<std::size_t>(side)]));
    }
    std::string counted(std::size_t count) const {
        return fmt::format("{} {}{}", count, sides.kind, count == 1 ? "" : "s");
    }
    bool is_near(const SideMatch& match) const {
        return match.distance <= near_image * network.topology.size;
    }
};

Periodicity periodicity_of(const PeriodicEntry& entry) {
    if (const auto* way = std::get_if<Vec3>(&entry.map.value)) return {{}, {}, *way};
    const auto& turn = std::get<RotationEntry>(entry.map.value);
    return {turn.center, turn.angle * turn.axis, {}};
}

/// Whether a side is free to be periodic; it is claimed then.
bool claim(Pairing& pairing, int side, const Name& name) {
    const auto n = static_cast<std::size_t>(side);
    const GridSides& sides = pairing.sides;
    const auto refuse = [&](const std::string& why, const std::string& hint) -> Diagnostic& {
        return pairing.diagnostics.error(
            name.place, fmt::format("{} cannot be periodic: {}", pairing.text(side), why), hint);
    };
    if (sides.users[n].size() > 1) {
        refuse("it joins " + users_text(sides, sides.users[n]),
               fmt::format("a periodic side belongs to one {}", sides.user));
    } else if (sides.collapsed[n] > 0) {
        refuse("it is collapsed", "leave it out: a pole is joined with nothing");
    } else if (pairing.claims[n] != nullptr) {
        refuse("it is named already", "leave it out in one of the two places")
            .notes.push_back({pairing.claims[n]->place, "here"});
    } else {
        pairing.claims[n] = &name;
        return true;
    }
    return false;
}

struct NamedSide {
    int side = 0;
    const Name* name = nullptr;
};

std::vector<NamedSide> claim_sides(Pairing& pairing, const std::vector<Name>& names) {
    std::vector<NamedSide> found;
    for (const Name& name : names) {
        const auto side =
            find_side(pairing.network, pairing.sides, name,
                      {"a periodic interface", "periodic interfaces"}, pairing.diagnostics);
        if (side && claim(pairing, *side, name)) found.push_back({*side, &name});
    }
    return found;
}

/// What of the nearest side is off the image, and how far.
std::string miss_text(const Pairing& pairing, const SideMatch& best) {
    const auto part = [&](int edge, int vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        return vertex >= 0
                   ? fmt::format("vertex {}", quoted(pairing.network.topology.vertices[v].name))
                   : fmt::format("edge {}", quoted(pairing.network.edge(edge).name));
    };
    return fmt::format("{} is {} away from the image of {}", part(best.edge.to, best.vertex_to),
                       number_text(best.distance), part(best.edge.from, best.vertex_from));
}

void report_no_image(Pairing& pairing, const Name& interface, const NamedSide& from,
                     const SideMatch& best) {
    if (!best.divided_alike) {
        pairing.diagnostics.error(
            from.name->place,
            fmt::format("{} and {} are not divided alike into edges", pairing.text(from.side),
                        pairing.text(best.pair.to)),
            "an image has as many edges on each of its sides as what it is the image of");
        return;
    }
    Diagnostic& error = pairing.diagnostics.error(
        from.name->place,
        fmt::format("no side of 'to' is the image of {} by {}: {}", pairing.text(from.side),
                    quoted(interface.value), miss_text(pairing, best)),
        best.vertex_from >= 0
            ? fmt::format("the image of that vertex is {}", point_text(best.image))
            : fmt::format("it has the point {} where the image has {}: let it follow the "
                          "same curve, moved",
                          point_text(best.place), point_text(best.image)));
    error.notes.push_back({pairing.sides.places[static_cast<std::size_t>(best.pair.to)],
                           fmt::format("{} comes nearest", pairing.text(best.pair.to))});
}

/// Tells at once that the map of an interface is wrong, where another one is right for all sides.
bool report_wrong_map(Pairing& pairing, const PeriodicEntry& entry,
                      const std::vector<NamedSide>& from, const std::vector<NamedSide>& to,
                      const SideMatch& miss) {
    const auto indices = [](const std::vector<NamedSide>& sides) {
        std::vector<int> all;
        all.reserve(sides.size());
        for (const NamedSide& side : sides) all.push_back(side.side);
        return all;
    };
    const std::string right = map_that_pairs(pairing.network, entry, indices(from), indices(to));
    if (right.empty()) return false;
    pairing.diagnostics.error(
        entry.map.place,
        fmt::format("the sides of 'to' are no images of those of 'from' by {}: {}",
                    quoted(entry.name.value), miss_text(pairing, miss)),
        fmt::format("with '{}' they are", right));
    return true;
}

/// All ways in which one side may lie on the image of another, nearest first.
std::vector<SideMatch> all_ways(SideMatcher& matcher, int from, const std::vector<NamedSide>& to) {
    std::vector<SideMatch> all;
    for (const NamedSide& side : to) {
        const std::vector<SideMatch> ways = matcher.ways(from, side.side);
        all.insert(all.end(), ways.begin(), ways.end());
    }
    std::stable_sort(all.begin(), all.end(), [](const SideMatch& a, const SideMatch& b) {
        return a.distance < b.distance;
    });
    return all;
}

void pair_side(Pairing& pairing, const NamedSide& side, const std::vector<SideMatch>& ways,
               PeriodicInterface& interface) {
    const PeriodicPair& pair = ways.front().pair;
    const bool taken = std::any_of(interface.pairs.begin(), interface.pairs.end(),
                                   [&](const PeriodicPair& p) { return p.to == pair.to; });
    if (!pairing.is_near(ways.front())) {
        report_no_image(pairing, {interface.name, interface.place}, side, ways.front());
    } else if (taken || pairing.is_near(ways[1])) {
        const int other = taken ? pair.to : ways[1].pair.to;
        pairing.diagnostics.error(
            side.name->place,
            fmt::format("the image of {} is ambiguous: sides of {} lie in the same place",
                        pairing.text(side.side), quoted(interface.name)),
            fmt::format("look at {}", pairing.text(other)));
    } else {
        interface.pairs.push_back(pair);
    }
}

void pair_sides(Pairing& pairing, const PeriodicEntry& entry, const std::vector<NamedSide>& from,
                const std::vector<NamedSide>& to, PeriodicInterface& interface) {
    const PeriodicMap map = periodic_map(interface.periodicity);
    SideMatcher matcher(pairing.network, map);
    std::vector<std::vector<SideMatch>> ways;
    ways.reserve(from.size());
    for (const NamedSide& side : from) ways.push_back(all_ways(matcher, side.side, to));
    const auto miss = std::find_if(ways.begin(), ways.end(), [&](const auto& of_side) {
        return !pairing.is_near(of_side.front()) && of_side.front().divided_alike;
    });
    if (miss != ways.end() && report_wrong_map(pairing, entry, from, to, miss->front())) return;
    for (std::size_t n = 0; n < from.size(); ++n) pair_side(pairing, from[n], ways[n], interface);
}

}  // namespace

void pair_periodic_sides(Network& network, const Case& c, Diagnostics& diagnostics) {
    Pairing pairing{network, diagnostics, grid_sides(network), {}};
    pairing.claims.resize(pairing.sides.users.size());
    for (const PeriodicEntry& entry : c.periodic) {
        PeriodicInterface interface {
            entry.name.value, entry.name.place, periodicity_of(entry), {}
        };
        const std::vector<NamedSide> from = claim_sides(pairing, entry.from);
        const std::vector<NamedSide> to = claim_sides(pairing, entry.to);
        const bool known = from.size() == entry.from.size() && to.size() == entry.to.size();
        if (known && from.size() != to.size()) {
            diagnostics.error(entry.name.place,
                              fmt::format("periodic interface {} has {} in 'from', but {} in 'to'",
                                          quoted(entry.name.value), pairing.counted(from.size()),
                                          pairing.counted(to.size())),
                              "every side of 'to' is the image of one of 'from'");
        } else if (known) {
            pair_sides(pairing, entry, from, to, interface);
        }
        network.topology.periodic.push_back(std::move(interface));
    }
}

}  // namespace hexweave
