// SPDX-License-Identifier: Apache-2.0
#include "bench/wing_blocks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "bench/block_from_sides.h"
#include "bench/shapes.h"
#include "geometry/stretching.h"

namespace hexweave::bench {

namespace {

using std::numbers::pi;

constexpr double semispan = 1.5;
constexpr double taper = 0.56;
constexpr double thickness_ratio = 9.8 / 12;
/// Of the far field, a little behind the trailing edge of the root.
constexpr double centre = 1.2;

double chord(double y) {
    return 1 - (1 - taper) * std::min(y, semispan) / semispan;
}

double leading_edge(double y) {
    return std::min(y, semispan) * std::tan(pi / 6);
}

/// The wing's upper side at chord fraction x, `v` from 0 at the root to 1 at the tip line.
Vec3 wing_point(double x, double v, Tip tip) {
    const double height = x == 1 ? 0 : thickness_ratio * half_thickness(x);
    if (tip == Tip::elliptic) {
        const double y = semispan * std::sin(pi / 2 * v);
        const double q = std::max(0.0, (y / semispan - 0.9) / 0.1);
        const double fade = v == 1 ? 0 : std::sqrt(std::max(0.0, 1 - q * q));
        return {leading_edge(y) + chord(y) * x, y, chord(y) * height * fade};
    }
    // The first half of v is the span, the second the quarter turn of the cap.
    const double y = semispan * std::min(1.0, 2 * v);
    const double turn = pi / 2 * std::max(0.0, 2 * v - 1);
    const double radius = chord(y) * height;
    return {leading_edge(y) + chord(y) * x, y + radius * std::sin(turn),
            v == 1 ? 0 : radius * std::cos(turn)};
}

/// Points of a curve over [0, 1] at given fractions of its length, from a fine polygon.
std::vector<Vec3> at_arc_length(const std::function<Vec3(double)>& curve,
                                const std::vector<double>& fractions) {
    constexpr int pieces = 4000;
    std::vector<Vec3> fine{curve(0)};
    std::vector<double> length{0};
    for (int n = 1; n <= pieces; ++n) {
        fine.push_back(curve(static_cast<double>(n) / pieces));
        length.push_back(length.back() + distance(fine[fine.size() - 2], fine.back()));
    }
    std::vector<Vec3> points;
    for (const double f : fractions) {
        const double target = f * length.back();
        const auto above = std::upper_bound(length.begin(), length.end(), target);
        const auto n = std::clamp<std::ptrdiff_t>(above - length.begin(), 1, pieces);
        const auto at = static_cast<std::size_t>(n);
        const double piece = length[at] - length[at - 1];
        points.push_back(
            lerp(fine[at - 1], fine[at], piece > 0 ? (target - length[at - 1]) / piece : 1));
    }
    points.back() = fine.back();
    return points;
}

std::vector<double> span_fractions(const WingGrid& grid) {
    return tanh_fractions(grid.points - 1, std::nullopt, grid.tip_cell / semispan);
}

PointField wing_surface(const WingGrid& grid) {
    const std::vector<double> fractions = span_fractions(grid);
    PointField wall(Extent{grid.points, grid.points, 1});
    for (int i = 0; i < grid.points; ++i) {
        const double x = chord_fraction(1 - static_cast<double>(i) / (grid.points - 1));
        const auto line =
            at_arc_length([&](double v) { return wing_point(x, v, grid.tip); }, fractions);
        for (int j = 0; j < grid.points; ++j) {
            wall.set(i, j, 0, line[static_cast<std::size_t>(j)]);
        }
    }
    return wall;
}

/// The line between two points with geometrically growing cells, the first as asked for the chord
/// there, `factor` times.
std::vector<Vec3> ray(const Vec3& from, const Vec3& to, const WingGrid& grid, double factor) {
    return geometric_line(from, to, grid.points, factor * grid.first_cell * chord(from.y));
}

std::optional<Problem> finished_start(const std::string& name, PointField boundary, bool sound,
                                      double exponent) {
    if (!sound) return std::nullopt;
    return start_grid(name, std::move(boundary), exponent);
}

}  // namespace

std::optional<Problem> wing_block(const WingGrid& grid) {
    const int last = grid.points - 1;
    const PointField wall = wing_surface(grid);
    const PointField far = sampled_face(grid.points, grid.points, [&](double u, double v) {
        Vec3 p = grid.far * quarter_sphere(1 - 0.5 * u, v);
        if (u == 1) p.x = 0;
        return Vec3{centre + p.x, p.y, p.z};
    });
    bool sound = true;
    PointField boundary = block_between(
        wall, far,
        {ray(wall(0, 0), far(0, 0), grid, 1), ray(wall(last, 0), far(last, 0), grid, 2),
         ray(wall(0, last), far(0, last), grid, 1),
         ray(wall(last, last), far(last, last), grid, 2)},
        sound);
    return finished_start("wing", std::move(boundary), sound, grid.flat_edge_exponent);
}

std::optional<Problem> wake_block(const WingGrid& grid) {
    const int last = grid.points - 1;
    const std::vector<double> fractions = span_fractions(grid);
    const PointField wing = wing_surface(grid);
    const std::vector<Vec3> trailing_edge = column(wing, last);
    const double outflow = centre + grid.far;
    std::vector<Vec3> outflow_line;
    outflow_line.reserve(fractions.size());
    for (const double f : fractions) {
        outflow_line.push_back({outflow, f * trailing_edge.back().y, 0});
    }
    bool sound = true;
    const double cell = distance(wing(last, 0), wing(last - 1, 0));
    const PointField sheet =
        solved_face(geometric_line(trailing_edge.front(), outflow_line.front(), grid.points, cell),
                    geometric_line(trailing_edge.back(), outflow_line.back(), grid.points, cell),
                    trailing_edge, outflow_line, sound);
    const PointField far = sampled_face(grid.points, grid.points, [&](double u, double v) {
        const Vec3 p = grid.far * quarter_sphere(0.5, v);
        return Vec3{centre + grid.far * u, p.y, p.z};
    });
    PointField boundary = block_between(
        sheet, far,
        {ray(sheet(0, 0), far(0, 0), grid, 2), ray(sheet(last, 0), far(last, 0), grid, 10),
         ray(sheet(0, last), far(0, last), grid, 2),
         ray(sheet(last, last), far(last, last), grid, 10)},
        sound);
    return finished_start("wake", std::move(boundary), sound, grid.flat_edge_exponent);
}

}  // namespace hexweave::bench
