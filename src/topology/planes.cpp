// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "geometry/curve.h"
#include "topology/boundaries.h"
#include "topology/sample.h"
#include "topology/text.h"

namespace hexweave {

namespace {

double& coordinate(Vec3& p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

std::string plane_text(const AxisPlane& plane) {
    constexpr const char* axes = "xyz";
    return fmt::format("{} = {}", axes[plane.axis], number_text(plane.value));
}

Vec3& position(Topology& topology, int vertex) {
    return topology.vertices[static_cast<std::size_t>(vertex)].position;
}

struct OffPlane {
    double distance = -1;
    Vec3 place;
};

/// How far an edge's vertices and curve are off a plane, and where it is farthest.
OffPlane off_plane(Topology& topology, const Edge& edge, const AxisPlane& plane) {
    constexpr int intervals = 64;
    std::vector<Vec3> points = sample_edge(edge, intervals);
    points.push_back(position(topology, edge.start));
    points.push_back(position(topology, edge.end));
    // Knots, which crowd where a curve that was put onto surfaces bends.
    const auto [low, high] = std::minmax(edge.from, edge.to);
    for (const double joint : joints_between(*edge.curve, low, high)) {
        points.push_back(evaluate(*edge.curve, joint));
    }
    OffPlane farthest;
    for (Vec3& p : points) {
        const double off = std::abs(coordinate(p, plane.axis) - plane.value);
        if (off > farthest.distance) farthest = {off, p};
    }
    return farthest;
}

std::set<int> edges_of_side(const Network& network, int side) {
    if (!network.three_dimensional) return {side};
    std::set<int> edges;
    for (const auto& uses : network.face(side).sides) {
        for (const EdgeUse& use : uses) edges.insert(use.edge);
    }
    return edges;
}

bool has_plane(const Edge& edge, const AxisPlane& plane) {
    return std::any_of(edge.planes.begin(), edge.planes.end(), [&](const AxisPlane& p) {
        return p.axis == plane.axis && p.value == plane.value;
    });
}

constexpr double near_plane = 1e-9;  // of the grid's size

void move_ends_onto(Topology& topology, const Edge& edge, const AxisPlane& plane) {
    for (const int vertex : {edge.start, edge.end}) {
        coordinate(position(topology, vertex), plane.axis) = plane.value;
    }
}

void move_onto(Network& network, Edge& edge, const AxisPlane& plane) {
    move_ends_onto(network.topology, edge, plane);
    edge.planes.push_back(plane);
}

/// Moves an edge exactly onto the plane of its entry, or reports how far off it is.
void settle_own(Network& network, Edge& edge, const EdgeEntry& entry, Diagnostics& diagnostics) {
    const AxisPlane& plane = entry.plane->value;
    const OffPlane off = off_plane(network.topology, edge, plane);
    if (off.distance > entry.gap.value_or(near_plane * network.topology.size)) {
        diagnostics.error(
            entry.plane->place,
            fmt::format("edge {} is not on the plane {}: it is {} away at {}", quoted(edge.name),
                        plane_text(plane), number_text(off.distance), point_text(off.place)),
            entry.gap ? "it may be as far as 'gap' says"
                      : "it may be 1e-9 of the size of the grid away, or as far as "
                        "'gap' allows");
        return;
    }
    move_onto(network, edge, plane);
    network.topology.put_on_surface.push_back({fmt::format("edge {}", quoted(edge.name)),
                                               fmt::format("plane {}", plane_text(plane)),
                                               off.distance, off.place});
}

/// What is off the plane of a boundary.
struct Strays {
    const Name* side = nullptr;  ///< the first
    int edge = -1;               ///< of it
    double distance = 0;
    std::set<int> edges;  ///< all
};

/// Moves the edges of a side exactly onto the side's plane; false where there are strays.
bool settle(Network& network, const Name& name, int side, const AxisPlane& plane, Strays& strays) {
    bool on_plane = true;
    for (const int index : edges_of_side(network, side)) {
        Edge& edge = network.edge(index);
        if (has_plane(edge, plane)) continue;
        const double off = off_plane(network.topology, edge, plane).distance;
        if (off <= near_plane * network.topology.size) {
            move_onto(network, edge, plane);
            continue;
        }
        on_plane = false;
        strays.edges.insert(index);
        if (strays.side == nullptr) strays = {&name, index, off, strays.edges};
    }
    return on_plane;
}

/// The plane that some edges are on after all: "z = 0"; empty where there is none.
std::string plane_in_common(Topology& topology, const std::set<int>& edges) {
    const double near = near_plane * topology.size;
    for (const int axis : {0, 1, 2}) {
        Vec3 first =
            position(topology, topology.edges[static_cast<std::size_t>(*edges.begin())].start);
        const double value = coordinate(first, axis);
        const AxisPlane plane{axis, std::abs(value) <= near ? 0 : value};
        const bool all = std::all_of(edges.begin(), edges.end(), [&](int edge) {
            return off_plane(topology, topology.edges[static_cast<std::size_t>(edge)], plane)
                       .distance <= near;
        });
        if (all) return plane_text(plane);
    }
    return {};
}

/// Tells once what of a boundary is off its plane.
void tell_strays(Network& network, const BoundaryEntry& entry, const Strays& strays,
                 Diagnostics& diagnostics) {
    const std::size_t others = strays.edges.size() - 1;
    const std::string more =
        others == 0 ? std::string()
                    : fmt::format(", and so {} {} more of boundary {}", others == 1 ? "is" : "are",
                                  others, quoted(entry.name.value));
    const std::string instead =
        others == 0 ? std::string() : plane_in_common(network.topology, strays.edges);
    diagnostics.error(
        strays.side->place,
        fmt::format("edge {} is {} off the {} {}{}", quoted(network.edge(strays.edge).name),
                    number_text(strays.distance),
                    entry.type.value == "BCSymmetryPlane" ? "symmetry plane" : "plane",
                    plane_text(entry.plane->value), more),
        instead.empty() ? "every point of the side must be on the plane, to 1e-9 of the size of "
                          "the grid"
                        : fmt::format("they are on the plane {}: write that", instead));
}

/// The side of a name, where it is one of the grid.
std::optional<int> side_named(const Network& network, const std::string& name) {
    std::optional<int> side;
    if (network.three_dimensional) {
        side = find_face(network.face_names, name);
    } else if (const auto edge = find_edge(network.edge_names, name)) {
        side = edge->edge;
    }
    return side && *side >= 0 ? side : std::nullopt;
}

/// Moves the sides of a boundary exactly onto its plane, or tells what is off it.
void settle_boundary(Network& network, const BoundaryEntry& entry, Diagnostics& diagnostics) {
    Strays strays;
    for (const Name& name : entry.sides) {
        const std::optional<int> side = side_named(network, name.value);
        if (!side) continue;
        const bool on_plane = settle(network, name, *side, entry.plane->value, strays);
        if (on_plane && network.three_dimensional) {
            network.topology.faces[static_cast<std::size_t>(*side)].plane = entry.plane->value;
        }
    }
    if (strays.side != nullptr) tell_strays(network, entry, strays, diagnostics);
}

}  // namespace

void straighten(Network& network) {
    for (std::size_t e = 0; e < network.topology.edges.size(); ++e) {
        const EdgeEntry* entry = network.edge_entries[e];
        if (entry != nullptr && (entry->along || !entry->surfaces.empty())) continue;
        Edge& edge = network.topology.edges[e];
        make_straight(edge, position(network.topology, edge.start),
                      position(network.topology, edge.end));
    }
}

void put_vertices_onto_planes(Network& network) {
    for (const Edge& edge : network.topology.edges) {
        for (const AxisPlane& plane : edge.planes) move_ends_onto(network.topology, edge, plane);
    }
}

void resolve_planes(Network& network, const Case& c, Diagnostics& diagnostics) {
    bool moved = false;
    for (std::size_t e = 0; e < network.topology.edges.size(); ++e) {
        const EdgeEntry* entry = network.edge_entries[e];
        if (entry == nullptr || !entry->plane) continue;
        settle_own(network, network.topology.edges[e], *entry, diagnostics);
        moved = true;
    }
    for (const BoundaryEntry& entry : c.boundaries) {
        if (!entry.plane) continue;
        settle_boundary(network, entry, diagnostics);
        moved = true;
    }
    if (moved) straighten(network);
}

}  // namespace hexweave
