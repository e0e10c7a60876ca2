// SPDX-License-Identifier: Apache-2.0
#include "bench/problems.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/block_from_sides.h"
#include "bench/shapes.h"
#include "faces/folded_start.h"
#include "geometry/stretching.h"

namespace hexweave::bench {

namespace {

using std::numbers::pi;

/// The half turn that the far field makes; its ends lie on the axis exactly.
Vec3 half_turn(double u) {
    return {std::cos(pi * u), 0, u == 1 ? 0 : std::sin(pi * u)};
}

std::vector<Vec3> sampled_line(int points, const std::function<Vec3(double)>& map) {
    std::vector<Vec3> line;
    line.reserve(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) line.push_back(map(static_cast<double>(i) / (points - 1)));
    return line;
}

PointField face_between(const std::vector<Vec3>& jmin, const std::vector<Vec3>& jmax,
                        const std::vector<Vec3>& imin, const std::vector<Vec3>& imax) {
    const int ni = static_cast<int>(jmin.size());
    const int nj = static_cast<int>(imin.size());
    PointField face(Extent{ni, nj, 1});
    for (int j = 0; j < nj; ++j) {
        face.set(0, j, 0, imin[static_cast<std::size_t>(j)]);
        face.set(ni - 1, j, 0, imax[static_cast<std::size_t>(j)]);
    }
    for (int i = 0; i < ni; ++i) {
        face.set(i, 0, 0, jmin[static_cast<std::size_t>(i)]);
        face.set(i, nj - 1, 0, jmax[static_cast<std::size_t>(i)]);
    }
    return face;
}

// Problem A.

PointField airfoil_boundary(const Extent& extent, double first_cell) {
    const auto wall = sampled_line(extent.ni, [](double u) {
        const double x = chord_fraction(u);
        return Vec3{x, u == 0 ? 0 : -half_thickness(x), 0};
    });
    const auto far = sampled_line(extent.ni, [](double u) {
        const Vec3 turn = half_turn(u);
        return Vec3{0.5 + 20 * turn.x, -20 * turn.z, 0};
    });
    return face_between(wall, far, geometric_line(wall.front(), far.front(), extent.nj, first_cell),
                        geometric_line(wall.back(), far.back(), extent.nj, first_cell));
}

// Problem B.

/// The meander at `points` stations uniform in its parameter, from midpoint sums.
std::vector<Vec3> meander(int points, double radians) {
    constexpr int steps = 40000;
    std::vector<Vec3> fine{Vec3{}};
    for (int n = 0; n < steps; ++n) {
        const double u = (n + 0.5) / steps;
        const double r = std::min(1.0, 8 * std::min(u, 1 - u));
        const double angle = radians * r * r * (3 - 2 * r) * std::sin(8 * pi * u);
        fine.push_back(fine.back() + Vec3{std::cos(angle), std::sin(angle), 0});
    }
    const double scale = 4 / fine.back().x;
    std::vector<Vec3> line;
    for (int i = 0; i < points; ++i) {
        const double place = static_cast<double>(i) / (points - 1) * steps;
        const int below = std::min(static_cast<int>(place), steps - 1);
        const auto at = static_cast<std::size_t>(below);
        line.push_back(scale * lerp(fine[at], fine[at + 1], place - below));
    }
    line.back() = {4, 0, 0};
    return line;
}

PointField meander_boundary(const Extent& extent, double radians, double first_cell) {
    const auto wall = meander(extent.ni, radians);
    double height = 0;
    for (const Vec3& p : wall) height = std::max(height, p.y);
    height += 1;
    const auto top = sampled_line(extent.ni, [&](double u) { return Vec3{4 * u, height, 0}; });
    return face_between(wall, top, geometric_line(wall.front(), top.front(), extent.nj, first_cell),
                        geometric_line(wall.back(), top.back(), extent.nj, first_cell));
}

// Scherk's surface.

PointField scherk_boundary(const Extent& extent) {
    return sampled_face(extent.ni, extent.nj, [](double u, double v) {
        const double x = 2.4 * u - 1.2;
        const double y = 2.4 * v - 1.2;
        return Vec3{x, y, std::log(std::cos(x) / std::cos(y))};
    });
}

// Problems W and OO. The span runs along -y.

constexpr double semispan = 1.5;

double chord(double y) {
    return 1 - 0.44 * y / semispan;
}

double leading_edge(double y) {
    return y * std::tan(pi / 6);
}

/// The wing at chord fraction `x` and span station `y`, its thickness times `blunting`.
Vec3 wing_point(double u, double y, double blunting) {
    const double x = chord_fraction(u);
    const double z = u == 0 ? 0 : chord(y) * half_thickness(x) * blunting;
    return {leading_edge(y) + chord(y) * x, -y, z};
}

/// Straight lines from the corners of the wall to those of the far field.
std::array<std::vector<Vec3>, 4> corner_rays(const PointField& wall, const PointField& far, int nk,
                                             double first_cell) {
    const int i = wall.extent().ni - 1;
    const int j = wall.extent().nj - 1;
    const auto ray = [&](int a, int b) {
        const double height = first_cell * chord(-wall(a, b).y);
        return geometric_line(wall(a, b), far(a, b), nk, height);
    };
    return {ray(0, 0), ray(i, 0), ray(0, j), ray(i, j)};
}

PointField wing_boundary(const Extent& extent, double first_cell, bool& sound) {
    const PointField wall = sampled_face(
        extent.ni, extent.nj, [](double u, double v) { return wing_point(u, semispan * v, 1); });
    const PointField far = sampled_face(extent.ni, extent.nj, [](double u, double v) {
        const double y = semispan * v;
        return 10 * half_turn(u) + Vec3{0.5 + leading_edge(y), -y, 0};
    });
    return block_between(wall, far, corner_rays(wall, far, extent.nk, first_cell), sound);
}

double tip_blunting(double y) {
    const double q = std::max(0.0, (y - 1.35) / 0.15);
    return std::sqrt(std::max(0.0, 1 - q * q));
}

PointField rounded_tip_boundary(const Extent& extent, double first_cell, bool& sound) {
    const PointField wall = sampled_face(extent.ni, extent.nj, [](double u, double v) {
        const double y = v == 1 ? semispan : semispan * std::sin(pi / 2 * v);
        return wing_point(u, y, v == 1 ? 0 : tip_blunting(y));
    });
    const PointField far = sampled_face(extent.ni, extent.nj, [](double u, double v) {
        const Vec3 p = 10 * quarter_sphere(u, v);
        return Vec3{0.5 + p.x, -p.y, p.z};
    });
    return block_between(wall, far, corner_rays(wall, far, extent.nk, first_cell), sound);
}

// Problem C.

Vec3 wavy_cube(double u, double v, double w) {
    const auto s = [](double a) { return std::sin(2 * pi * a); };
    return {u + 0.16 * s(v) * std::cos(pi * w), v + 0.16 * s(w) * std::cos(2 * pi * u),
            w + 0.16 * s(u) * s(v)};
}

PointField wavy_cube_boundary(const Extent& e) {
    PointField block(e);
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Vec3 u{static_cast<double>(i) / (e.ni - 1),
                             static_cast<double>(j) / (e.nj - 1),
                             static_cast<double>(k) / (e.nk - 1)};
                block.set(i, j, k, wavy_cube(u.x, u.y, u.z));
            }
        }
    }
    return block;
}

/// Displaces the interior by a strong wave in the parameters.
void perturb(Problem& problem) {
    const Extent& e = problem.points.extent();
    const ParameterField& p = problem.parameters;
    for (int k = 1; k < e.nk - 1; ++k) {
        for (int j = 1; j < e.nj - 1; ++j) {
            for (int i = 1; i < e.ni - 1; ++i) {
                const double s = p.s(i, j, k);
                const double t = p.t(i, j, k);
                const double u = p.u(i, j, k);
                const double height = 0.5 * std::sin(pi * s) * std::sin(pi * t) * std::sin(pi * u);
                problem.points.set(
                    i, j, k,
                    problem.points(i, j, k) + height * Vec3{std::sin(9 * t + 3 * u),
                                                            std::cos(8 * u - 5 * s),
                                                            std::sin(7 * s + 9 * t)});
            }
        }
    }
}

/// The angle of "B17"; nothing where the name is not of that kind.
std::optional<double> meander_angle(const std::string& name) {
    const bool matches =
        name.size() == 3 && name[0] == 'B' && name[1] == '1' && name[2] >= '2' && name[2] <= '9';
    if (!matches) return std::nullopt;
    return 1 + 0.1 * (name[2] - '0');
}

}  // namespace

bool is_block(const std::string& name) {
    return name == "W" || name == "OO" || name == "C";
}

std::optional<Problem> make_problem(const std::string& name, const Extent& extent,
                                    const ProblemOptions& options) {
    if ((extent.nk > 2) != is_block(name) || extent.ni < 3 || extent.nj < 3) return std::nullopt;
    const double wall = options.first_cell > 0 ? options.first_cell : name[0] == 'B' ? 1e-4 : 1e-5;
    const std::optional<double> angle = meander_angle(name);
    bool sound = true;
    PointField boundary;
    if (name == "A") boundary = airfoil_boundary(extent, wall);
    if (angle) boundary = meander_boundary(extent, *angle, wall);
    if (name == "Scherk") boundary = scherk_boundary(extent);
    if (name == "W") boundary = wing_boundary(extent, wall, sound);
    if (name == "OO") boundary = rounded_tip_boundary(extent, wall, sound);
    if (name == "C") boundary = wavy_cube_boundary(extent);
    if (!sound || boundary.extent() != extent) return std::nullopt;
    Problem problem = start_grid(name, std::move(boundary), options.flat_edge_exponent);
    if (options.start == Start::folded) {
        if (name == "C") {
            perturb(problem);
        } else {
            fold_interior(problem.points);
        }
    }
    return problem;
}

}  // namespace hexweave::bench
