// SPDX-License-Identifier: Apache-2.0
#include "faces/pole_parameters.h"

#include <array>

#include "core/orientation.h"
#include "faces/arc_length.h"

namespace hexweave {

namespace {

/// Of the surface's own scale: so near is the same point.
constexpr double same_point = 1e-9;

/// The nodes of one side, and the nodes next to its two ends on the neighbouring sides.
struct SideNodes {
    std::vector<std::size_t> nodes;
    std::vector<std::size_t> opposite;
    std::array<std::size_t, 2> beside{};

    SideNodes(const Extent& e, Side side) {
        const bool along_i = axis_of(side) == 1;
        const int last = (along_i ? e.nj : e.ni) - 1;
        const int own = is_max(side) ? last : 0;
        const int inwards = is_max(side) ? last - 1 : 1;
        const int count = along_i ? e.ni : e.nj;
        const auto offset = [&](int along, int across) {
            return along_i ? e.offset(along, across) : e.offset(across, along);
        };
        for (int n = 0; n < count; ++n) {
            nodes.push_back(offset(n, own));
            opposite.push_back(offset(n, last - own));
        }
        beside = {offset(0, inwards), offset(count - 1, inwards)};
    }
};

/// How far along the opposite side each node is in the parameter that varies there.
std::vector<double> fractions_of(const Field& parameter, const std::vector<std::size_t>& nodes) {
    const double first = parameter[nodes.front()];
    const double range = parameter[nodes.back()] - first;
    std::vector<double> fractions;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        fractions.push_back(range != 0
                                ? (parameter[nodes[n]] - first) / range
                                : static_cast<double>(n) / static_cast<double>(nodes.size() - 1));
    }
    return fractions;
}

/// Whether every point of the line of `other` between the two ends, at `fixed`, is the pole.
bool is_one_point(const Surface& surface, bool u_varies, double fixed, double from, double to,
                  const Vec3& pole, double size) {
    for (const double f : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double value = from + f * (to - from);
        const SurfaceParameters p =
            u_varies ? SurfaceParameters{value, fixed} : SurfaceParameters{fixed, value};
        if (!(distance(evaluate(surface, p), pole) <= same_point * size)) return false;
    }
    return true;
}

}  // namespace

void spread_poles(const Surface& surface, const PointField& points, PointField& at) {
    for (const Side side : {Side::imin, Side::imax, Side::jmin, Side::jmax}) {
        const SideNodes of(points.extent(), side);
        std::vector<Vec3> line;
        for (const std::size_t node : of.nodes) line.push_back(points[node]);
        if (has_length(line)) continue;
        const Vec3& pole = line.front();
        const double size = distance(pole, points[of.opposite.front()]);
        for (const bool u_varies : {true, false}) {
            Field& varying = u_varies ? at.x : at.y;
            const Field& fixed = u_varies ? at.y : at.x;
            const double from = varying[of.beside[0]];
            const double to = varying[of.beside[1]];
            const double there = fixed[of.nodes.front()];
            if (from == to || !is_one_point(surface, u_varies, there, from, to, pole, size)) {
                continue;
            }
            const std::vector<double> fractions = fractions_of(varying, of.opposite);
            for (std::size_t n = 0; n < of.nodes.size(); ++n) {
                varying[of.nodes[n]] = from + fractions[n] * (to - from);
            }
            break;
        }
    }
}

}  // namespace hexweave
