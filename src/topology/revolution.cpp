// SPDX-License-Identifier: Apache-2.0
#include "topology/revolution.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "topology/boundaries.h"
#include "topology/sample.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr double full = 2 * std::numbers::pi;
constexpr double slit = 1e-4;  // radians: as when 2 pi is written with five digits or more

constexpr double near_to = 1e-9;  // the axis, of the grid's size

/// The coordinate in the plane that tells the distance from an axis along x or y.
double& radial(Vec3& p, const RotationEntry& turn) {
    return turn.axis.x != 0 ? p.y : p.x;
}

double off_axis(Vec3 p, const RotationEntry& turn) {
    return radial(p, turn) - (turn.axis.x != 0 ? turn.center.y : turn.center.x);
}

/// Moves what is on the axis exactly there; tells how far the grid reaches to either side.
AxisReach collapse_at_axis(Network& network, const RotationEntry& turn) {
    constexpr int intervals = 32;
    Topology& topology = network.topology;
    const double near = near_to * topology.size;
    const int axis = turn.axis.x != 0 ? 1 : 0;
    const double value = axis == 1 ? turn.center.y : turn.center.x;
    AxisReach all;
    for (Vertex& vertex : topology.vertices) {
        const double off = off_axis(vertex.position, turn);
        include(all, off);
        if (std::abs(off) <= near) radial(vertex.position, turn) = value;
    }
    for (Edge& edge : topology.edges) {
        AxisReach own;
        for (const Vec3& p : sample_edge(edge, intervals)) include(own, off_axis(p, turn));
        include(all, own.low);
        include(all, own.high);
        edge.on_axis = own.low >= -near && own.high <= near;
        if (edge.on_axis) edge.planes.push_back({axis, value});
    }
    straighten(network);
    return all;
}

}  // namespace

Sweep revolution(Network& network, const SweepEntry& entry, const RotationEntry& turn,
                 Diagnostics& diagnostics) {
    const AxisReach reach = collapse_at_axis(network, turn);
    const double near = near_to * network.topology.size;
    if (reach.low < -near && reach.high > near) {
        diagnostics.error(entry.place, "the grid lies on both sides of the axis of 'revolve'",
                          fmt::format("it reaches {} to the one side and {} to the other: draw the "
                                      "one side only",
                                      number_text(-reach.low), number_text(reach.high)));
    }
    Sweep sweep;
    sweep.whole = {turn.center, turn.angle * turn.axis, {}};
    // A turn about x moves points of greater y towards +z, one about y those of smaller x.
    const double sense = turn.axis.x != 0 ? turn.axis.x : -turn.axis.y;
    sweep.reversed = sense * turn.angle * (reach.low + reach.high) < 0;
    const double short_of = full - std::abs(turn.angle);
    sweep.full_turn = short_of < slit;
    if (sweep.full_turn && short_of > 1e-12 * full) {
        diagnostics.error(entry.place,
                          fmt::format("'revolve' turns by {} radians less than a full turn",
                                      number_text(short_of)),
                          "write 'angle: 2 * pi': the last plane is then the first one");
    }
    return sweep;
}

void check_turn(const Sweep& sweep, const SweepEntry& entry, Diagnostics& diagnostics) {
    const double turn = norm(sweep.whole.angle);
    constexpr double half = std::numbers::pi * (1 - 1e-9);
    if (turn / sweep.cells < half) return;
    diagnostics.error(
        entry.cells.place,
        fmt::format("each layer of 'revolve' turns by {} degrees: no cell can turn by 180 or more",
                    number_text(turn / sweep.cells * 180 / std::numbers::pi)),
        fmt::format("give it at least {} 'cells'; grid lines that turn by 10 degrees "
                    "from layer to layer need {}",
                    std::floor(turn / half) + 1, std::ceil(turn / (std::numbers::pi / 18) - 1e-9)));
}

}  // namespace hexweave
