// SPDX-License-Identifier: Apache-2.0
#include "topology/handedness.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/surface_patch.h"
#include "geometry/surface_set.h"
#include "topology/corner_order.h"
#include "topology/face_frame.h"
#include "topology/outline.h"
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

EdgeLookup edges_of(const Topology& topology) {
    return [&topology](int index) -> const Edge& {
        return topology.edges[static_cast<std::size_t>(index)];
    };
}

std::string edges_text(const Topology& topology, const std::vector<EdgeUse>& side) {
    std::vector<std::string> names;
    names.reserve(side.size());
    for (const EdgeUse& use : side) {
        names.push_back(topology.edges[static_cast<std::size_t>(use.edge)].name);
    }
    return listed(names);
}

template <std::size_t count>
std::string corner_list(const std::array<Name, count>& corners,
                        const std::array<std::size_t, count>& order) {
    std::string text;
    for (const std::size_t n : order) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", corners[n].value);
    }
    return text;
}

template <std::size_t count>
std::array<Vec3, count> positions(const Topology& topology,
                                  const std::array<int, count>& vertices) {
    std::array<Vec3, count> points;
    for (std::size_t n = 0; n < count; ++n) points.at(n) = position(topology, vertices.at(n));
    return points;
}

/// What to write so that a face whose lines i and j turn clockwise turns the other way.
std::string face_remedy(const Topology& topology, const Face& face, const FaceEntry& entry) {
    if (const auto* corners = std::get_if<std::array<Name, 4>>(&entry.shape)) {
        const std::array<std::size_t, 4> order = order_round(positions(topology, face.corners));
        if (order == std::array<std::size_t, 4>{0, 1, 2, 3}) {
            return "its corners are in order, but its curved sides lead round it the other way: "
                   "see "
                   "'along' and 'through' of its edges";
        }
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

/// What to write so that the sides of a face do not cross; what to look at where that is not found.
std::string crossing_remedy(const Topology& topology, const Face& face, const FaceEntry& entry) {
    if (const auto* corners = std::get_if<std::array<Name, 4>>(&entry.shape)) {
        return fmt::format("list its corners going round it: [{}]",
                           corner_list(*corners, order_round(positions(topology, face.corners))));
    }
    if (const auto way = reroute(face.sides, edges_of(topology))) {
        return fmt::format("run the other way round there: {}: {}",
                           side_name(static_cast<Side>(way->side)),
                           chain_text(way->uses, edges_of(topology)));
    }
    return "jmin and jmax lead from imin to imax, side by side; so do imin and imax from jmin to "
           "jmax";
}

std::string block_remedy(const Topology& topology, const Block& block, const BlockEntry& entry) {
    if (const auto* corners = std::get_if<std::array<Name, 8>>(&entry.shape)) {
        return fmt::format(
            "four corners round one side, then those above them in the same order: [{}]",
            corner_list(*corners, order_of_hexahedron(positions(topology, block.corners))));
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

/// Tells a face that is not right-handed; false where it encloses nothing.
bool check_face(const Network& network, std::size_t index, Diagnostics& diagnostics) {
    const Topology& topology = network.topology;
    const Face& face = topology.faces[index];
    const FaceEntry* const entry =
        network.face_entries[index];  // null for a made face, which is sound
    const std::optional<int> turns = outline_turns(face.sides, edges_of(topology));
    if (turns && *turns != 1 && *turns != -1) {
        diagnostics.error(face.place,
                          fmt::format("the sides of face {} cross, or run round it in opposite "
                                      "senses: no grid can lie between them",
                                      quoted(face.name)),
                          crossing_remedy(topology, face, *entry));
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
                      face_remedy(topology, face, *entry));
    return true;
}

bool check_block(const Network& network, std::size_t index, Diagnostics& diagnostics) {
    const Topology& topology = network.topology;
    const Block& block = topology.blocks[index];
    const BlockEntry& entry = *network.block_entries[index];
    Points corners;
    for (const int corner : block.corners) corners.push_back(position(topology, corner));
    for (const BlockSide& faces : block.sides) {
        for (const FaceUse& use : faces.faces) {
            for (const auto& side : network.face(use.face).sides) {
                const Points points = sample_side(topology.edges, side, 8);
                corners.insert(corners.end(), points.begin(), points.end());
            }
        }
    }
    const double size = box_around(corners).diagonal();
    const double volume = signed_volume(topology, block);
    if (volume > nothing * size * size * size) return true;
    if (volume >= -nothing * size * size * size) {
        diagnostics.error(block.place,
                          fmt::format("block {} encloses no volume", quoted(block.name)),
                          std::holds_alternative<std::array<Name, 8>>(entry.shape)
                              ? block_remedy(topology, block, entry)
                              : "its sides lie on top of each other: name others");
        return false;
    }
    diagnostics.error(block.place, fmt::format("block {} is left-handed", quoted(block.name)),
                      block_remedy(topology, block, entry));
    return true;
}

}  // namespace

double signed_area(const Topology& topology, const Face& face) {
    const Vec3 origin = position(topology, face.corners[0]);
    const std::array<Points, 4> sides = sampled(topology, face.sides, origin);
    double twice = 0;
    const auto add = [&](const Points& points, double sign) {
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
    bool enclosing = true;
    if (!network.three_dimensional && topology.planar) {
        for (std::size_t f = 0; f < topology.faces.size(); ++f) {
            enclosing = check_face(network, f, diagnostics) && enclosing;
        }
    }
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        enclosing = check_block(network, b, diagnostics) && enclosing;
    }
    return enclosing;
}

}  // namespace hexweave
