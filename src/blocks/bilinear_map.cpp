// SPDX-License-Identifier: Apache-2.0
#include "blocks/bilinear_map.h"

#include <cmath>
#include <limits>
#include <vector>

#include "core/orientation.h"
#include "core/parallel.h"
#include "faces/arc_length.h"
#include "faces/straight_line_map.h"

namespace hexweave {

namespace {

/// Bilinear interpolation of four stations.
double blend(const std::array<double, 4>& v, double first, double second) {
    return between(between(v[0], v[1], first), between(v[2], v[3], first), second);
}

double mean(const std::array<double, 4>& v) {
    return 0.25 * ((v[0] + v[1]) + (v[2] + v[3]));
}

/// The four numbers of the straight-line map of the plane at u.
struct Plane {
    double s0;
    double s1;
    double t0;
    double t1;

    Plane(const EdgeStations& e, double u)
        : s0(between(e.s[0], e.s[2], u)),
          s1(between(e.s[1], e.s[3], u)),
          t0(between(e.t[0], e.t[2], u)),
          t1(between(e.t[1], e.t[3], u)) {}

    SquarePoint crossing() const { return straight_line_point(s0, s1, t0, t1); }
};

/// d/du of u - u(s(u), t(u)), where s and t follow u in the plane.
double slope(const EdgeStations& e, const Plane& plane, const SquarePoint& p) {
    const double s_t = plane.s1 - plane.s0;
    const double t_s = plane.t1 - plane.t0;
    const double s_u = between(e.s[2] - e.s[0], e.s[3] - e.s[1], p.t);
    const double t_u = between(e.t[2] - e.t[0], e.t[3] - e.t[1], p.s);
    const double determinant = 1 - s_t * t_s;
    const double s_slope = (s_u + s_t * t_u) / determinant;
    const double t_slope = (t_u + t_s * s_u) / determinant;
    const double u_s = between(e.u[1] - e.u[0], e.u[3] - e.u[2], p.t);
    const double u_t = between(e.u[2] - e.u[0], e.u[3] - e.u[1], p.s);
    return 1 - u_s * s_slope - u_t * t_slope;
}

/// The edge functions of the four edges along one axis, node by node.
std::vector<std::array<double, 4>> edge_stations(const PointField& boundary, int axis,
                                                 const std::array<EndExponents, 4>& exponents) {
    const Extent n = boundary.extent();
    const Node last{n.ni - 1, n.nj - 1, n.nk - 1};
    const std::size_t first = axis == 0 ? 1 : 0;
    const std::size_t second = axis == 2 ? 1 : 2;
    std::vector<std::array<double, 4>> stations(static_cast<std::size_t>(n[axis]));
    std::vector<std::vector<Vec3>> lines;
    for (std::size_t edge = 0; edge < 4; ++edge) {
        Node start{};
        if (edge % 2 == 1) start[first] = last[first];
        if (edge / 2 == 1) start[second] = last[second];
        lines.push_back(grid_line(boundary, start, axis));
    }
    const auto values = parallel_edge_functions(lines, {exponents.begin(), exponents.end()});
    for (std::size_t edge = 0; edge < 4; ++edge) {
        for (std::size_t node = 0; node < stations.size(); ++node) {
            stations[node][edge] = values[edge][node];
        }
    }
    return stations;
}

}  // namespace

CubePoint bilinear_point(const EdgeStations& stations) {
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    double low = 0;
    double high = 1;
    double u = blend(stations.u, mean(stations.s), mean(stations.t));
    double step = 1;
    while (std::abs(step) > rounding) {
        const Plane plane(stations, u);
        const SquarePoint p = plane.crossing();
        const double excess = u - blend(stations.u, p.s, p.t);
        if (std::abs(excess) <= rounding) break;
        (excess < 0 ? low : high) = u;
        const double newton = u - excess / slope(stations, plane, p);
        // Halve the bracket where Newton leaves it or no longer gains a factor of two.
        const bool good =
            newton > low && newton < high && std::abs(newton - u) <= 0.5 * std::abs(step);
        const double next = good ? newton : 0.5 * (low + high);
        step = next - u;
        u = next;
    }
    const SquarePoint p = Plane(stations, u).crossing();
    return {p.s, p.t, blend(stations.u, p.s, p.t)};
}

ParameterField bilinear_map(const PointField& boundary,
                            const PerBlockEdge<EndExponents>& exponents) {
    const Extent n = boundary.extent();
    const auto along_i = edge_stations(boundary, 0, exponents[0]);
    const auto along_j = edge_stations(boundary, 1, exponents[1]);
    const auto along_k = edge_stations(boundary, 2, exponents[2]);
    ParameterField parameters{Field(n), Field(n), Field(n)};
    parallel_for(static_cast<std::size_t>(n.nk), [&](std::size_t k) {
        std::size_t node = n.offset(0, 0, static_cast<int>(k));
        for (const auto& t : along_j) {
            for (const auto& s : along_i) {
                const CubePoint p = bilinear_point({s, t, along_k[k]});
                parameters.s[node] = p.s;
                parameters.t[node] = p.t;
                parameters.u[node] = p.u;
                ++node;
            }
        }
    });
    return parameters;
}

}  // namespace hexweave
