// SPDX-License-Identifier: Apache-2.0
#include "topology/handedness.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/surface_patch.h"
#include "geometry/surface_set.h"
#include "topology/corner_order.h"
#include "topology/crossing_faults.h"
#include "topology/crossings.h"
#include "topology/face_frame.h"
#include "topology/outline.h"
#include "topology/planar_faces.h"
#include "topology/sample.h"

namespace hexweave {

namespace {

constexpr int intervals = 48;
/// Less than this part of its own size squared (cubed) is no area (volume): round-off of the sums.
constexpr double nothing = 1e-12;

using Points = std::vector<Vec3>;

/// A Coons patch: the bilinear blend of four sampled sides (in the order of FrameSides).
Vec3 coons(const std::array<Points, 4>& sides, std::size_t a, std::size_t b) {
    const auto last = static_cast<double>(intervals);
    const double u = static_cast<double>(a) / last;
    const double v = static_cast<double>(b) / last;
    const Vec3 across = (1 - u) * sides[0][b] + u * sides[1][b];
    const Vec3 along = (1 - v) * sides[2][a] + v * sides[3][a];
    const Vec3 corners = (1 - v) * ((1 - u) * sides[0].front() + u * sides[1].front()) +
                         v * ((1 - u) * sides[0].back() + u * sides[1].back());
    return across + along - corners;
}

/// The nodes of a patch at equal steps of its two axes, the first axis fastest.
struct PatchNodes {
    Points points;

    const Vec3& at(std::size_t a, std::size_t b) const { return points[a + b * (intervals + 1)]; }
};

PatchNodes coons_patch(const std::array<Points, 4>& sides) {
    PatchNodes patch;
    for (std::size_t b = 0; b <= intervals; ++b) {
        for (std::size_t a = 0; a <= intervals; ++a) patch.points.push_back(coons(sides, a, b));
    }
    return patch;
}

/// The part of a surface between four sides: a Coons patch of their parameters.
PatchNodes surface_patch(const Surface& surface, const std::array<Points, 4>& sides) {
    const PatchSides on_surface = sides_on_surface(SurfaceProjection(surface), sides);
    std::array<Points, 4> parameters;
    for (std::size_t s = 0; s < 4; ++s) {
        for (const SurfacePoint& p : on_surface.sides[s]) {
            parameters[s].push_back({p.parameters.u, p.parameters.v, 0});
        }
    }
    PatchNodes patch = coons_patch(parameters);
    for (Vec3& p : patch.points) p = evaluate(surface, {p.x, p.y});
    return patch;
}

/// The part of several surfaces between four sides: a Coons patch moved to the nearest points.
PatchNodes surface_patch(const std::vector<std::shared_ptr<const Surface>>& surfaces,
                         const std::array<Points, 4>& sides) {
    const SurfaceSet set(surfaces);
    PatchNodes patch = coons_patch(sides);
    for (Vec3& p : patch.points) p = set.nearest(p).point.position;
    return patch;
}

/// Six times the volume between the origin and a patch, seen from its axes' right-handed normal.
double six_volumes(const PatchNodes& patch) {
    double sum = 0;
    for (std::size_t b = 0; b < intervals; ++b) {
        for (std::size_t a = 0; a < intervals; ++a) {
            const Vec3& p00 = patch.at(a, b);
            const Vec3& p10 = patch.at(a + 1, b);
            const Vec3& p11 = patch.at(a + 1, b + 1);
            const Vec3& p01 = patch.at(a, b + 1);
            sum += (triple(p00, p10, p11) + triple(p00, p11, p01) + triple(p00, p10, p01) +
                    triple(p10, p11, p01)) /
                   2;
        }
    }
    return sum;
}

const Vec3& position(const Topology& topology, int vertex) {
    return topology.vertices[static_cast<std::size_t>(vertex)].position;
}

std::array<Points, 4> sampled(const Topology& topology, const FrameSides& frame,
                              const Vec3& origin) {
    std::array<Points, 4> sides;
    for (std::size_t s = 0; s < 4; ++s) {
        sides[s] = sample_side(topology.edges, frame[s], intervals);
        for (Vec3& p : sides[s]) p -= origin;
    }
    return sides;
}

/// A face of a block's side, in the side's axes and seen from the origin.
PatchNodes sampled_patch(const Topology& topology, const FaceUse& use, const Vec3& origin) {
    const Face& face = topology.faces[static_cast<std::size_t>(use.face)];
    const FrameSides frame = sides_in_frame(face.sides, use.orientation);
    const Vec3 from = face.is_on_surface() ? Vec3{} : origin;
    const std::array<Points, 4> sides = sampled(topology, frame, from);
    PatchNodes patch = face.surface           ? surface_patch(*face.surface, sides)
                       : face.is_on_surface() ? surface_patch(face.patches, sides)
                                              : coons_patch(sides);
    for (Vec3& p : patch.points) p -= origin - from;
    return patch;
}

/// The axes' normal points out of the block on imax, jmin and kmax.
double outward_sign(Side side) {
    return is_max(side) == (axis_of(side) != 1) ? 1 : -1;
}

std::set<int> edges_of_sides(const Network& network, const Block& block) {
    std::set<int> edges;
    for (const BlockSide& faces : block.sides) {
        for (const FaceUse& face : faces.faces) {
            for (const auto& side : network.face(face.face).sides) {
                for (const EdgeUse& use : side) edges.insert(use.edge);
            }
        }
    }
    return edges;
}

/// The order in which the corners of a block are to be listed; empty where they are not listed, or
/// are so.
std::string other_order(const Topology& topology, const Block& block, const BlockEntry& entry) {
    const auto* corners = std::get_if<std::array<Name, 8>>(&entry.shape);
    if (corners == nullptr) return {};
    const auto order = order_of_hexahedron(positions(topology, block.corners));
    if (is_as_listed(order)) return {};
    return fmt::format("four corners round one side, then those above them in the same order: [{}]",
                       corner_list(*corners, order));
}

/// What to write so that a left-handed block is right-handed.
std::string block_remedy(const Network& network, const Block& block, const BlockEntry& entry) {
    const Topology& topology = network.topology;
    if (std::holds_alternative<std::array<Name, 8>>(entry.shape)) {
        const std::string order = other_order(topology, block, entry);
        return order.empty() ? corners_in_order(network, edges_of_sides(network, block)) : order;
    }
    const auto name = [&](Side side) {
        std::vector<std::string> names;
        for (const FaceUse& use : block.side(side).faces) {
            names.push_back(topology.faces[static_cast<std::size_t>(use.face)].name);
        }
        return listed(names);
    };
    // To swap the two sides of a cut would change nothing.
    const bool cut = name(Side::kmin) == name(Side::kmax);
    const Side low = cut ? Side::jmin : Side::kmin;
    const Side high = cut ? Side::jmax : Side::kmax;
    return fmt::format("swap its sides {} ({}) and {} ({})", side_name(low), name(low),
                       side_name(high), name(high));
}

/// The size of a block, from a few points of its edges.
double size_of(const Network& network, const Block& block) {
    Points points;
    for (const int edge : edges_of_sides(network, block)) {
        const Points own = sample_edge(network.edge(edge), 8);
        points.insert(points.end(), own.begin(), own.end());
    }
    return box_around(points).diagonal();
}

/// Faces by their index, with two of their edges that cross, where they do.
using FaceCrossings = std::vector<std::optional<EdgeCrossing>>;

FaceCrossings crossings_of(const Topology& topology) {
    FaceCrossings crossings;
    for (const Face& face : topology.faces) {
        crossings.push_back(find_crossing(face.sides, edges_of(topology)));
    }
    return crossings;
}

std::optional<std::size_t> crossed_face(const Block& block, const FaceCrossings& crossings) {
    for (const BlockSide& side : block.sides) {
        for (const FaceUse& use : side.faces) {
            const auto face = static_cast<std::size_t>(use.face);
            if (crossings[face]) return face;
        }
    }
    return std::nullopt;
}

bool are_straight(const Network& network, const EdgeCrossing& crossing) {
    constexpr double round_off = 1e-9;
    const auto straight = [&](const Edge& edge) {
        return edge.length <= (1 + round_off) * distance(position(network.topology, edge.start),
                                                         position(network.topology, edge.end));
    };
    return straight(network.edge(crossing.first)) && straight(network.edge(crossing.second));
}

bool check_block(CrossingFaults& faults, std::size_t index, const FaceCrossings& crossings) {
    const Network& network = faults.network;
    Diagnostics& diagnostics = faults.diagnostics;
    const Topology& topology = network.topology;
    const Block& block = topology.blocks[index];
    const BlockEntry& entry = *network.block_entries[index];
    const std::string order = other_order(topology, block, entry);
    const double size = size_of(network, block);
    const double least = nothing * size * size * size;
    const double volume = signed_volume(topology, block);
    const std::optional<std::size_t> crossed = crossed_face(block, crossings);
    if (crossed && (volume > least || order.empty())) {
        const EdgeCrossing& crossing = *crossings[*crossed];
        tell_crossing(faults, topology.faces[*crossed], crossing,
                      are_straight(network, crossing) ? order : std::string());
        return false;
    }
    if (volume > least) return true;
    if (volume >= -least) {
        diagnostics.error(
            block.place, fmt::format("block {} encloses no volume", quoted(block.name)),
            order.empty() ? "its sides lie on top of each other: name others" : order);
        return false;
    }
    diagnostics.error(block.place, fmt::format("block {} is left-handed", quoted(block.name)),
                      block_remedy(network, block, entry));
    return true;
}

/// Tells a face of a grid of faces that cannot hold a grid.
bool check_face(CrossingFaults& faults, std::size_t index,
                const std::optional<EdgeCrossing>& crossing) {
    const Topology& topology = faults.network.topology;
    if (topology.planar) return check_planar_face(faults, index, crossing);
    if (crossing) tell_crossing(faults, topology.faces[index], *crossing, "");
    return !crossing;
}

}  // namespace

double signed_volume(const Topology& topology, const Block& block) {
    const Vec3 origin = position(topology, block.corners[0]);
    double six = 0;
    for (const Side side : all_sides) {
        for (const FaceUse& use : block.side(side).faces) {
            six += outward_sign(side) * six_volumes(sampled_patch(topology, use, origin));
        }
    }
    return six / 6;
}

bool check_handedness(const Network& network, Diagnostics& diagnostics) {
    const Topology& topology = network.topology;
    const FaceCrossings crossings = crossings_of(topology);
    CrossingFaults faults{network, diagnostics};
    bool enclosing = true;
    for (std::size_t f = 0; !network.three_dimensional && f < topology.faces.size(); ++f) {
        enclosing = check_face(faults, f, crossings[f]) && enclosing;
    }
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        enclosing = check_block(faults, b, crossings) && enclosing;
    }
    return enclosing;
}

}  // namespace hexweave
