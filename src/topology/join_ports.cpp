// SPDX-License-Identifier: Apache-2.0
#include "topology/join_ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "topology/case_positions.h"
#include "topology/instance_scope.h"
#include "topology/joined_names.h"
#include "topology/names.h"

namespace hexweave {

namespace {

/// Points of ports that are meant to be one may differ by this part of the case's size.
constexpr double coincidence = 1e-9;

enum class Kind { vertex, edge, face };

std::string_view word(Kind kind) {
    return kind == Kind::vertex ? "a vertex" : kind == Kind::edge ? "an edge" : "a face";
}

/// One part of a port and what it is joined to, with the words of the join.
struct Pair {
    Name inside;
    Name outside;
    const PortJoin& join;
};

struct Joining {
    Case& c;
    const Instances& instances;
    Diagnostics& diagnostics;
    Positions positions;
    double tolerance = 0;
    JoinedNames joined{};
    std::vector<JoinedPart> parts{};  ///< `outside` is known when all are joined
};

void join_vertex(Joining& joining, const Pair& pair, const std::string& inside,
                 const std::string& outside) {
    joining.joined.join_vertex(inside, outside);
    joining.parts.push_back({"vertex", inside, {}, false, pair.join.place});
}

template <class Entry>
Entry* find_entry(std::vector<Entry>& entries, const std::string& name) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.name.value == name; });
    return found == entries.end() ? nullptr : &*found;
}

std::vector<Kind> kinds_of(Case& c, const std::string& name) {
    std::vector<Kind> kinds;
    if (find_entry(c.vertices, name) != nullptr) kinds.push_back(Kind::vertex);
    if (find_entry(c.edges, name) != nullptr) kinds.push_back(Kind::edge);
    if (find_entry(c.faces, name) != nullptr) kinds.push_back(Kind::face);
    return kinds;
}

std::string known_hint(const Case& c, const std::string& name) {
    std::vector<std::string> known;
    for (const auto& v : c.vertices) known.push_back(v.name.value);
    for (const auto& e : c.edges) known.push_back(e.name.value);
    for (const auto& f : c.faces) known.push_back(f.name.value);
    const std::string nearest = nearest_name(name, known);
    return nearest.empty() ? "a port joins vertices, edges and faces that are drawn"
                           : fmt::format("did you mean '{}'?", nearest);
}

void tell_apart(Joining& joining, const Pair& pair, const std::string& what, double off) {
    Diagnostic& d = joining.diagnostics.error(
        pair.join.place,
        fmt::format("{} is {:.6g} off what it is joined to, {}", what, off,
                    quoted(pair.outside.value)),
        "what is joined must lie in the same place: see the instance's transform and parameters");
    d.notes.push_back({pair.inside.place, "the part of the port"});
}

/// Makes two vertices one, if they lie in one place.
bool join_vertices(Joining& joining, const Pair& pair, const std::string& inside,
                   const std::string& outside) {
    const auto a = joining.positions.of(inside);
    const auto b = joining.positions.of(outside);
    if (!a || !b) return false;  // told elsewhere
    const double off = distance(*a, *b);
    if (off <= joining.tolerance) {
        join_vertex(joining, pair, inside, outside);
        return true;
    }
    tell_apart(joining, pair, "vertex " + quoted(inside), off);
    return false;
}

/// How far the ends of two edges are apart, the same way round and the other.
std::array<double, 2> end_distances(Joining& joining, const EdgeEntry& a, const EdgeEntry& b) {
    const auto from_a = joining.positions.of(a.from.value);
    const auto to_a = joining.positions.of(a.to.value);
    const auto from_b = joining.positions.of(b.from.value);
    const auto to_b = joining.positions.of(b.to.value);
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (!from_a || !to_a || !from_b || !to_b) return {unknown, unknown};
    return {std::max(distance(*from_a, *from_b), distance(*to_a, *to_b)),
            std::max(distance(*from_a, *to_b), distance(*to_a, *from_b))};
}

/// What the edge that stays takes over from the one that goes.
void take_over(Joining& joining, EdgeEntry& inside, EdgeEntry& outside, bool reversed) {
    if (inside.cells && outside.cells && inside.cells->value != outside.cells->value) {
        Diagnostic& d = joining.diagnostics.error(
            inside.cells->place,
            fmt::format("{} cells here, but edge {}, which this edge is joined to, has {}",
                        inside.cells->value, quoted(outside.name.value), outside.cells->value),
            "give the count in one place, or by a parameter of the component");
        d.notes.push_back({outside.cells->place, "the other count"});
    }
    if (!outside.cells) outside.cells = inside.cells;
    if (!outside.multiple_of) outside.multiple_of = inside.multiple_of;
    if (outside.spacing || !inside.spacing) return;
    outside.spacing = inside.spacing;
    if (reversed) outside.spacing->value = reversed_law(inside.spacing->value);
}

bool join_edges(Joining& joining, const Pair& pair, const std::string& inside_name,
                const std::string& outside_name) {
    if (joining.joined.edge(inside_name).name == joining.joined.edge(outside_name).name) {
        return true;
    }
    EdgeEntry& inside = *find_entry(joining.c.edges, inside_name);
    EdgeEntry& outside = *find_entry(joining.c.edges, outside_name);
    const auto [straight, crossed] = end_distances(joining, inside, outside);
    const double off = std::min(straight, crossed);
    if (off == std::numeric_limits<double>::infinity()) return false;  // told elsewhere
    if (off > joining.tolerance) {
        tell_apart(joining, pair, fmt::format("an end of edge {}", quoted(inside_name)), off);
        return false;
    }
    const bool reversed = crossed < straight;
    join_vertex(joining, pair, inside.from.value, reversed ? outside.to.value : outside.from.value);
    join_vertex(joining, pair, inside.to.value, reversed ? outside.from.value : outside.to.value);
    // What either is joined to by now stays; the other goes.
    const JoinedEdge a = joining.joined.edge(inside_name);
    const JoinedEdge b = joining.joined.edge(outside_name);
    const bool turned = a.reversed != (reversed != b.reversed);
    take_over(joining, *find_entry(joining.c.edges, a.name), *find_entry(joining.c.edges, b.name),
              turned);
    joining.joined.join_edge(a.name, {b.name, turned});
    joining.parts.push_back({"edge", a.name, {}, false, pair.join.place});
    return true;
}

/// The drawn edges of a face, each once.
std::vector<std::string> edges_of(const Case& c, const FaceEntry& face) {
    std::set<std::string> names;
    if (const auto* sides = std::get_if<0>(&face.shape)) {
        for (const auto& side : *sides) {
            for (const SignedName& edge : side) names.insert(edge.value);
        }
        return {names.begin(), names.end()};
    }
    const auto& corners = std::get<1>(face.shape);
    for (const EdgeEntry& edge : c.edges) {
        for (std::size_t n = 0; n < 4; ++n) {
            const std::string& a = corners.at(n).value;
            const std::string& b = corners.at((n + 1) % 4).value;
            const bool between = (edge.from.value == a && edge.to.value == b) ||
                                 (edge.from.value == b && edge.to.value == a);
            if (between) names.insert(edge.name.value);
        }
    }
    return {names.begin(), names.end()};
}

std::vector<std::string> vertices_of(Case& c, const FaceEntry& face) {
    std::set<std::string> names;
    if (const auto* corners = std::get_if<1>(&face.shape)) {
        for (const Name& corner : *corners) names.insert(corner.value);
    }
    for (const std::string& name : edges_of(c, face)) {
        const EdgeEntry* edge = find_entry(c.edges, name);
        if (edge == nullptr) continue;
        names.insert(edge->from.value);
        names.insert(edge->to.value);
    }
    return {names.begin(), names.end()};
}

/// Joins every vertex of a face to the one of the other that lies there.
bool join_vertices_of_faces(Joining& joining, const Pair& pair, const FaceEntry& inside,
                            const FaceEntry& outside) {
    bool sound = true;
    for (const std::string& name : vertices_of(joining.c, inside)) {
        const auto at = joining.positions.of(name);
        double least = std::numeric_limits<double>::infinity();
        std::string nearest;
        for (const std::string& other : vertices_of(joining.c, outside)) {
            const auto there = joining.positions.of(other);
            if (!at || !there || distance(*at, *there) >= least) continue;
            least = distance(*at, *there);
            nearest = other;
        }
        if (nearest.empty()) return false;  // told elsewhere
        if (least <= joining.tolerance) {
            join_vertex(joining, pair, name, nearest);
        } else {
            tell_apart(joining, pair, "vertex " + quoted(name), least);
            sound = false;
        }
    }
    return sound;
}

/// Joins every edge of a face to the one of the other that has the same ends.
void join_edges_of_faces(Joining& joining, const Pair& pair, const FaceEntry& inside,
                         const FaceEntry& outside) {
    for (const std::string& name : edges_of(joining.c, inside)) {
        EdgeEntry* edge = find_entry(joining.c.edges, name);
        if (edge == nullptr) continue;
        std::vector<std::string> fitting;
        for (const std::string& other : edges_of(joining.c, outside)) {
            EdgeEntry* there = find_entry(joining.c.edges, other);
            if (there == nullptr) continue;
            const auto [straight, crossed] = end_distances(joining, *edge, *there);
            if (std::min(straight, crossed) <= joining.tolerance) fitting.push_back(other);
        }
        if (fitting.size() == 1) {
            join_edges(joining, pair, name, fitting[0]);
        } else if (fitting.size() > 1 && joining.joined.edge(name).name == name) {
            Diagnostic& d = joining.diagnostics.error(
                pair.join.place,
                fmt::format("edge {} of the port may be any of {}", quoted(name), listed(fitting)),
                "make the edge a port of its own, and join it first");
            d.notes.push_back({edge->name.place, "the edge"});
        }
    }
}

void join_pair(Joining& joining, const Pair& pair) {
    const auto inside = kinds_of(joining.c, pair.inside.value);
    const auto outside = kinds_of(joining.c, pair.outside.value);
    for (const auto& [name, kinds] :
         {std::pair(pair.inside, inside), std::pair(pair.outside, outside)}) {
        if (!kinds.empty()) continue;
        const auto& left_out = joining.c.left_out;
        const auto entry =
            std::find_if(left_out.begin(), left_out.end(),
                         [&wanted = name](const auto& e) { return e.name == wanted.value; });
        if (entry != left_out.end()) {
            tell_left_out("what is joined,", name, entry->when, joining.diagnostics);
            return;
        }
        joining.diagnostics.error(
            name.place, fmt::format("unknown vertex, edge or face {}", quoted(name.value)),
            known_hint(joining.c, name.value));
        return;
    }
    std::vector<Kind> common;
    for (const Kind kind : inside) {
        if (std::find(outside.begin(), outside.end(), kind) != outside.end()) {
            common.push_back(kind);
        }
    }
    if (common.size() != 1) {
        Diagnostic& d = joining.diagnostics.error(
            pair.outside.place,
            common.empty()
                ? fmt::format("{} is {}, but the part {} of the port is {}",
                              quoted(pair.outside.value), word(outside.front()),
                              quoted(pair.inside.value), word(inside.front()))
                : fmt::format("{} and {} are names of {} and of {}", quoted(pair.inside.value),
                              quoted(pair.outside.value), word(common[0]), word(common[1])),
            common.empty() ? "" : "name one of them otherwise");
        d.notes.push_back({pair.inside.place, "the part of the port"});
        return;
    }
    if (common[0] == Kind::vertex) {
        join_vertices(joining, pair, pair.inside.value, pair.outside.value);
    } else if (common[0] == Kind::edge) {
        join_edges(joining, pair, pair.inside.value, pair.outside.value);
    } else {
        const FaceEntry& own = *find_entry(joining.c.faces, pair.inside.value);
        const FaceEntry& other = *find_entry(joining.c.faces, pair.outside.value);
        if (!join_vertices_of_faces(joining, pair, own, other)) return;
        join_edges_of_faces(joining, pair, own, other);
        joining.joined.join_face(pair.inside.value, pair.outside.value);
        joining.parts.push_back({"face", pair.inside.value, {}, false, pair.join.place});
    }
}

/// Ports among some names replaced by their parts, which may be ports of inner instances. Within a
/// port its own name is that of an entity.
std::vector<Name> with_parts(const Instances& instances, const std::vector<Name>& names,
                             const std::set<std::string>& within = {}) {
    std::vector<Name> parts;
    for (const Name& name : names) {
        const auto port = instances.ports.find(name.value);
        if (port == instances.ports.end() || within.count(name.value) > 0) {
            parts.push_back(name);
            continue;
        }
        std::set<std::string> inner = within;
        inner.insert(name.value);
        for (const Name& part : with_parts(instances, port->second, inner)) {
            parts.push_back({part.value, name.place});
        }
    }
    return parts;
}

void join_port(Joining& joining, const PortJoin& join) {
    const std::vector<Name> inside = with_parts(joining.instances, join.inside, {join.port});
    const std::vector<Name> outside = with_parts(joining.instances, join.outside);
    if (outside.size() != inside.size()) {
        if (outside.empty() || inside.empty()) return;  // told when it was read
        joining.diagnostics.error(
            join.place,
            fmt::format("port {} has {} part{}, but what it is joined to has {}", quoted(join.port),
                        inside.size(), inside.size() == 1 ? "" : "s", outside.size()),
            "parts are joined one by one, in order");
        return;
    }
    for (std::size_t n = 0; n < outside.size(); ++n) {
        join_pair(joining, {inside[n], outside[n], join});
    }
}

}  // namespace

void join_ports(Case& c, const Instances& instances, Diagnostics& diagnostics) {
    for (BoundaryEntry& boundary : c.boundaries) {
        boundary.sides = with_parts(instances, boundary.sides);
    }
    if (instances.joins.empty()) return;
    Joining joining{c, instances, diagnostics, Positions(c)};
    joining.tolerance = coincidence * joining.positions.size();
    for (const PortJoin& join : instances.joins) join_port(joining, join);
    c.joined = settled(joining.joined, joining.parts);
    rename_joined(c, joining.joined);
}

void merge_families(Case& c, Diagnostics& diagnostics) {
    std::vector<BoundaryEntry> families;
    for (BoundaryEntry& boundary : c.boundaries) {
        BoundaryEntry* first = find_entry(families, boundary.name.value);
        if (first == nullptr) {
            families.push_back(std::move(boundary));
            continue;
        }
        const bool same_plane = !first->plane || !boundary.plane ||
                                (first->plane->value.axis == boundary.plane->value.axis &&
                                 first->plane->value.value == boundary.plane->value.value);
        if (first->type.value != boundary.type.value || !same_plane) {
            Diagnostic& d = diagnostics.error(
                boundary.name.place,
                fmt::format("the family {} has another {} elsewhere", quoted(boundary.name.value),
                            same_plane ? "type" : "plane"),
                "instances share families of one name, unless they say 'families: own'");
            d.notes.push_back({first->name.place, "elsewhere"});
        }
        if (!first->plane) first->plane = boundary.plane;
        first->sides.insert(first->sides.end(), boundary.sides.begin(), boundary.sides.end());
    }
    c.boundaries = std::move(families);
}

}  // namespace hexweave
