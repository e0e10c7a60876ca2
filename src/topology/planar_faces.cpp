// SPDX-License-Identifier: Apache-2.0
#include "topology/planar_faces.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "topology/corner_order.h"
#include "topology/crossing_faults.h"
#include "topology/outline.h"
#include "topology/sample.h"

namespace hexweave {

namespace {

constexpr int intervals = 48;
/// Less than this part of its own size squared is no area: round-off of the sum.
constexpr double nothing = 1e-12;

/// The area that the sampled sides of a face enclose; positive when i to j turns counter-clockwise
/// seen from +z.
double signed_area(const Topology& topology, const Face& face) {
    const Vec3 origin = positions(topology, face.corners)[0];
    std::array<std::vector<Vec3>, 4> sides;
    for (std::size_t s = 0; s < 4; ++s) {
        sides[s] = sample_side(topology.edges, face.sides[s], intervals);
        for (Vec3& p : sides[s]) p -= origin;
    }
    double twice = 0;
    const auto add = [&](const std::vector<Vec3>& points, double sign) {
        for (std::size_t n = 1; n < points.size(); ++n) {
            twice += sign * cross(points[n - 1], points[n]).z;
        }
    };
    add(sides[2], 1);
    add(sides[1], 1);
    add(sides[3], -1);
    add(sides[0], -1);
    return twice / 2;
}

std::set<int> edges_of_sides(const Face& face) {
    std::set<int> edges;
    for (const auto& side : face.sides) {
        for (const EdgeUse& use : side) edges.insert(use.edge);
    }
    return edges;
}

std::string edges_text(const Topology& topology, const std::vector<EdgeUse>& side) {
    std::vector<std::string> names;
    names.reserve(side.size());
    for (const EdgeUse& use : side) {
        names.push_back(topology.edges[static_cast<std::size_t>(use.edge)].name);
    }
    return listed(names);
}

/// What to write so that a face whose lines i and j turn clockwise turns the other way.
std::string face_remedy(const Network& network, const Face& face, const FaceEntry& entry) {
    const Topology& topology = network.topology;
    if (const auto* corners = std::get_if<std::array<Name, 4>>(&entry.shape)) {
        const std::array<std::size_t, 4> order = order_round(positions(topology, face.corners));
        if (is_as_listed(order)) return corners_in_order(network, edges_of_sides(face));
        return fmt::format("list its corners counter-clockwise: [{}]",
                           corner_list(*corners, order));
    }
    if (face.side(Side::imin) == face.side(Side::imax)) {
        // To swap the two sides of a cut would change nothing.
        const auto written = [&](Side side) {
            return fmt::format("{}: {}", side_name(side),
                               chain_text(backwards(face.side(side)), edges_of(topology)));
        };
        return fmt::format("run i the other way round: {}, {}", written(Side::jmin),
                           written(Side::jmax));
    }
    return fmt::format("swap its sides imin ({}) and imax ({}), with what is asked of them",
                       edges_text(topology, face.side(Side::imin)),
                       edges_text(topology, face.side(Side::imax)));
}

/// What to write so that the sides of a face do not cross; empty where its edges are at fault, not
/// the order in which they are named.
std::string order_that_uncrosses(const Topology& topology, const Face& face,
                                 const FaceEntry& entry) {
    if (const auto* corners = std::get_if<std::array<Name, 4>>(&entry.shape)) {
        const std::array<std::size_t, 4> order = order_round(positions(topology, face.corners));
        if (is_as_listed(order)) return {};
        return fmt::format("list its corners going round it: [{}]", corner_list(*corners, order));
    }
    const auto way = reroute(face.sides, edges_of(topology));
    if (!way) return {};
    return fmt::format("run the other way round there: {}: {}",
                       side_name(static_cast<Side>(way->side)),
                       chain_text(way->uses, edges_of(topology)));
}

}  // namespace

bool check_planar_face(CrossingFaults& faults, std::size_t index,
                       const std::optional<EdgeCrossing>& crossing) {
    const Network& network = faults.network;
    Diagnostics& diagnostics = faults.diagnostics;
    const Topology& topology = network.topology;
    const Face& face = topology.faces[index];
    const FaceEntry& entry = *network.face_entries[index];
    const std::optional<int> turns = outline_turns(face.sides, edges_of(topology));
    const bool turned = turns && *turns != 1 && *turns != -1;
    const std::string order = turned ? order_that_uncrosses(topology, face, entry) : std::string();
    if (crossing) {
        tell_crossing(faults, face, *crossing, order);
        return false;
    }
    if (turned) {
        diagnostics.error(face.place,
                          fmt::format("the sides of face {} cross, or run round it in opposite "
                                      "senses: no grid can lie between them",
                                      quoted(face.name)),
                          order.empty() ? "jmin and jmax lead from imin to imax, side by side; so "
                                          "do imin and imax from jmin to jmax"
                                        : order);
        return false;
    }
    double size = 0;
    for (const auto& side : face.sides) {
        for (const EdgeUse& use : side) size += network.edge(use.edge).length;
    }
    const double area = signed_area(topology, face);
    if (area > nothing * size * size) return true;
    if (area >= -nothing * size * size) {
        diagnostics.error(face.place, fmt::format("face {} encloses no area", quoted(face.name)),
                          "its sides lie on top of each other: name others");
        return false;
    }
    diagnostics.error(face.place,
                      fmt::format("face {} is left-handed: seen from +z, i to j turns clockwise",
                                  quoted(face.name)),
                      face_remedy(network, face, entry));
    return true;
}

}  // namespace hexweave
