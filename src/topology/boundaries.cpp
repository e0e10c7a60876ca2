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

namespace hexweave {

namespace {

/// The sides of the grid as boundaries see them: edges of faces, or faces of blocks.
struct Sides {
    std::string kind;                     ///< "edge" or "face"
    std::string user;                     ///< "face" or "block"
    std::vector<std::vector<int>> users;  ///< for every side the faces (blocks) that have it
    std::vector<std::string> names;       ///< of the sides
    std::vector<Place> places;            ///< of the sides
    std::vector<std::string> names_of_users;
    std::vector<int> collapsed;  ///< 0, or by how many dimensions a side is less than the others
};

Sides sides_of(const Topology& topology, bool three_dimensional) {
    Sides sides;
    sides.kind = three_dimensional ? "face" : "edge";
    sides.user = three_dimensional ? "block" : "face";
    const auto enter = [&](const auto& entities) {
        for (const auto& entity : entities) {
            sides.names.push_back(entity.name);
            sides.places.push_back(entity.place);
        }
        sides.users.resize(entities.size());
    };
    if (three_dimensional) {
        enter(topology.faces);
        for (const Face& face : topology.faces) {
            sides.collapsed.push_back((face.collapsed[0] ? 1 : 0) + (face.collapsed[1] ? 1 : 0));
        }
        for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
            sides.names_of_users.push_back(topology.blocks[b].name);
            for (const BlockSide& side : topology.blocks[b].sides) {
                for (const FaceUse& use : side.faces) {
                    sides.users[static_cast<std::size_t>(use.face)].push_back(static_cast<int>(b));
                }
            }
        }
        return sides;
    }
    enter(topology.edges);
    for (const Edge& edge : topology.edges) sides.collapsed.push_back(edge.pole ? 1 : 0);
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        sides.names_of_users.push_back(topology.faces[f].name);
        for (const auto& side : topology.faces[f].sides) {
            for (const EdgeUse& use : side) {
                sides.users[static_cast<std::size_t>(use.edge)].push_back(static_cast<int>(f));
            }
        }
    }
    return sides;
}

std::string users_text(const Sides& sides, const std::vector<int>& users) {
    std::vector<std::string> names;
    for (const int user : users) {
        const std::string& name = sides.names_of_users[static_cast<std::size_t>(user)];
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return fmt::format("{}{} {}", sides.user, names.size() == 1 ? "" : "s", listed(names));
}

void check_sharing(const Sides& sides, Diagnostics& diagnostics) {
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

class Assignment {
public:
    Assignment(Network& network, const Sides& sides, Diagnostics& diagnostics)
        : network_(network),
          sides_(sides),
          diagnostics_(diagnostics),
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
        const int to_point = network_.three_dimensional ? 2 : 1;
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
        return claims_[side].boundary == nullptr && sides_.users[side].size() == 1;
    }

    std::optional<int> find(const Name& name) {
        const NameTable& edges = network_.edge_names;
        const NameTable& faces = network_.face_names;
        const auto edge = find_edge(edges, name.value);
        const auto face = find_face(faces, name.value);
        const bool of_faces = network_.three_dimensional;
        if (of_faces && face) return face;
        if (!of_faces && edge) return edge->edge;
        if (of_faces ? edge.has_value() : face.has_value()) {
            diagnostics_.error(
                name.place,
                fmt::format("{} is {}, but the sides of a boundary are {}s", quoted(name.value),
                            of_faces ? "an edge" : "a face", sides_.kind),
                of_faces ? "with blocks, boundaries are made of faces"
                         : "without blocks, boundaries are made of edges");
        } else if (!name.value.empty()) {
            (of_faces ? faces : edges).report_unknown(name, diagnostics_);
        }
        return std::nullopt;
    }

    /// The side that a boundary may have, which it claims.
    std::optional<int> free_side(const BoundaryEntry& entry, const Name& name) {
        const std::optional<int> side = find(name);
        if (!side || *side == dropped_faulty) return std::nullopt;
        const auto n = static_cast<std::size_t>(*side);
        if (*side < 0 || sides_.users[n].empty()) {
            // The face (block) that has it may be the one that is at fault.
            if (!network_.intact) return std::nullopt;
            diagnostics_.error(
                name.place,
                fmt::format("{} {} is no side of the grid", sides_.kind, quoted(name.value)),
                fmt::format("no {} has it", sides_.user));
            return std::nullopt;
        }
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
        Claim& claim = claims_[n];
        if (claim.boundary != nullptr) {
            diagnostics_
                .error(name.place,
                       fmt::format("{} {} is named twice: boundary {} has it already", sides_.kind,
                                   quoted(name.value), quoted(claim.boundary->value)))
                .notes.push_back({claim.place, "here"});
            return std::nullopt;
        }
        claim = {&entry.name, name.place};
        return side;
    }

    Network& network_;
    const Sides& sides_;
    Diagnostics& diagnostics_;
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

}  // namespace

void resolve_boundaries(Network& network, const Case& c, Diagnostics& diagnostics) {
    check_family_names(c, diagnostics);
    const Sides sides = sides_of(network.topology, network.three_dimensional);
    check_sharing(sides, diagnostics);
    const int errors = diagnostics.errors();
    Assignment assignment(network, sides, diagnostics);
    for (const BoundaryEntry& entry : c.boundaries) assignment.add(entry);
    assignment.collect_poles();
    // After a fault, what seems uncovered may be what a boundary failed to name.
    if (network.intact && diagnostics.errors() == errors) {
        assignment.collect_unassigned(Place{c.source, 0, 0});
    }
}

}  // namespace hexweave
