// SPDX-License-Identifier: Apache-2.0
// The operator and residuals of one level against the equations written out plainly.
#include "elliptic/assembly.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/levels.h"
#include "elliptic/poisson_equations.h"
#include "elliptic/shapes.h"
#include "elliptic/transfer.h"

namespace hexweave {
namespace {

constexpr double scale = 1;

Vec3 affine(const Vec3& s) {
    return {2 + s.x + 0.3 * s.y - 0.2 * s.z, 0.1 * s.x + 0.5 * s.y + 0.2 * s.z,
            0.3 * s.x - 0.1 * s.y + 2 * s.z};
}

/// Spacings from 1e-5 on along eta, everything leaning.
Vec3 clustered(double xi, double eta, double zeta) {
    return shapes::leaning(xi, std::expm1(11 * eta) / std::expm1(11.0), zeta);
}

Vec3 planar_annulus(double xi, double eta, double) {
    return shapes::annulus(clustered(xi, eta, 0)) - Vec3{0, 0, clustered(xi, eta, 0).z};
}

Vec3 saddle(double xi, double eta, double) {
    const Vec3 p = planar_annulus(xi, eta, 0);
    return {p.x, p.y, 0.3 * p.x * p.y};
}

Vec3 twisted(double xi, double eta, double zeta) {
    const Vec3 p = shapes::annulus(clustered(xi, eta, zeta));
    return {p.x + 0.2 * p.z * p.y, p.y - 0.1 * p.z * p.x, p.z + 0.1 * p.x * p.y};
}

struct Sample {
    Extent extent;
    int components;
    shapes::Map map;
};

const std::array<Sample, 3> samples{Sample{{14, 9, 1}, 2, planar_annulus},
                                    Sample{{9, 14, 1}, 3, saddle}, Sample{{8, 11, 6}, 3, twisted}};

Level level_of(const Sample& sample) {
    return shapes::level_of(shapes::sample(sample.extent, sample.map),
                            shapes::sample_parameters(sample.extent, clustered), sample.components);
}

double component(const Vec3& v, int c) {
    return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

}  // namespace

TEST_CASE("points linear in the parameters have no residual, however clustered") {
    for (const Extent e : {Extent{14, 33, 1}, Extent{8, 33, 6}}) {
        const auto map = [](double u, double v, double w) { return affine(clustered(u, v, w)); };
        for (const int components : {2, 3}) {
            if (e.nk > 1 && components == 2) continue;
            Level level = shapes::level_of(shapes::sample(e, map),
                                           shapes::sample_parameters(e, clustered), components);
            assemble(level, {Assembly::residuals, RightHandSide::zero}, scale);
            double largest = 0;
            shapes::for_inside(level, [&](int i, int j, int k) {
                for (int c = 0; c < components; ++c) {
                    largest = std::max(largest, static_cast<double>(std::abs(shapes::at(
                                                    level.residuals, level, i, j, k, c))));
                }
            });
            // The rounding of coordinates of size 2.
            CHECK(largest < 2e-15);
        }
    }
}

TEST_CASE("residuals are those of the equations written out") {
    for (const Sample& sample : samples) {
        Level level = level_of(sample);
        const PointField points = shapes::sample(sample.extent, sample.map);
        const ParameterField parameters = shapes::sample_parameters(sample.extent, clustered);
        for (const Assembly wanted : {Assembly::residuals, Assembly::residuals_and_stencils}) {
            level.residuals.clear();
            assemble(level, {wanted, RightHandSide::zero}, scale);
            shapes::for_inside(level, [&](int i, int j, int k) {
                const Vec3 step = shapes::unfulfilled(points, parameters, i, j, k);
                for (int c = 0; c < sample.components; ++c) {
                    const double got =
                        static_cast<double>(shapes::at(level.residuals, level, i, j, k, c));
                    CHECK(std::abs(got + component(step, c)) < 1e-6 * norm(step) + 1e-14);
                }
            });
        }
    }
}

TEST_CASE("the stencil applied to the points is the residual, and its centre is -1") {
    for (const Sample& sample : samples) {
        Level level = level_of(sample);
        assemble(level, {Assembly::residuals_and_stencils, RightHandSide::zero}, scale);
        const int axes = level.axes;
        const int planes = axes == 3 ? 3 : 1;
        shapes::for_inside(level, [&](int i, int j, int k) {
            const auto number = [&](int n) {
                return static_cast<double>(shapes::at(level.stencils, level, i, j, k, n));
            };
            const auto x = [&](std::array<int, 3> by, int c) {
                return shapes::at(level.points, level, i + by[0], j + by[1], k + by[2], c);
            };
            double centre = 0;
            for (int a = 0; a < axes; ++a) centre -= 2 * number(a);
            CHECK(centre == Approx(-1).epsilon(1e-6));
            for (int c = 0; c < sample.components; ++c) {
                double sum = 0;
                double size = 0;
                const auto add = [&](double coefficient, double difference) {
                    sum += coefficient * difference;
                    size += std::abs(coefficient * difference);
                };
                int plane = 0;
                for (int a = 0; a < axes; ++a) {
                    std::array<int, 3> up{};
                    std::array<int, 3> down{};
                    up[static_cast<std::size_t>(a)] = 1;
                    down[static_cast<std::size_t>(a)] = -1;
                    add(number(a), x(up, c) - 2 * x({}, c) + x(down, c));
                    add(number(axes + planes + a), x(up, c) - x(down, c));
                    for (int b = a + 1; b < axes; ++b, ++plane) {
                        const auto corner = [&](int by_a, int by_b) {
                            std::array<int, 3> by{};
                            by[static_cast<std::size_t>(a)] = by_a;
                            by[static_cast<std::size_t>(b)] = by_b;
                            return x(by, c);
                        };
                        add(number(axes + plane),
                            corner(1, 1) - corner(1, -1) - corner(-1, 1) + corner(-1, -1));
                    }
                }
                const double residual =
                    static_cast<double>(shapes::at(level.residuals, level, i, j, k, c));
                CHECK(std::abs(sum + residual) < 1e-6 * size + 1e-14);
            }
        });
    }
}

TEST_CASE("an equation weighs the same on a level and on the next coarser one") {
    // A quadratic bump on an affine map of uniform parameters: the residual is the same everywhere,
    // and the integrals over the control volumes must add up to those of the coarser level.
    const auto uniform = [](double u, double v, double w) { return Vec3{u, v, w}; };
    const auto map = [](double u, double v, double w) {
        return affine({u, v, w}) + 1e-4 * Vec3{u * u + v * v + w * w, u * u - v * v, 3 * u * u};
    };
    for (const Extent e : {Extent{17, 13, 1}, Extent{9, 13, 9}}) {
        for (const std::array<bool, 3> halved :
             {std::array{true, true, e.nk > 1}, std::array{true, false, false},
              std::array{false, true, false}, std::array{false, e.nk == 1, e.nk > 1}}) {
            Level fine =
                shapes::level_of(shapes::sample(e, map), shapes::sample_parameters(e, uniform), 3);
            assemble(fine, {Assembly::residuals, RightHandSide::zero}, scale);
            integrate_residuals(fine);
            Level coarse = coarser_level(fine, halved);
            shapes::add_work(coarse);
            inject_points(fine, coarse);
            restrict_residuals(fine, coarse);
            RowArray<float> from_fine = coarse.residuals;
            assemble(coarse, {Assembly::residuals, RightHandSide::zero}, scale);
            integrate_residuals(coarse);
            shapes::for_inside(coarse, [&](int i, int j, int k) {
                for (int c = 0; c < 3; ++c) {
                    const auto own = shapes::at(coarse.residuals, coarse, i, j, k, c);
                    CHECK(static_cast<double>(shapes::at(from_fine, coarse, i, j, k, c)) ==
                          Approx(static_cast<double>(own)).epsilon(0.02).margin(1e-9));
                }
            });
        }
    }
}

TEST_CASE("a right-hand side made from a residual gives it back, and takes changes into account") {
    for (const Sample& sample : samples) {
        Level level = level_of(sample);
        shapes::fill_inside(level, level.residuals, sample.components, 3);
        const RowArray<float> given = level.residuals;
        assemble(level, {Assembly::residuals, RightHandSide::from_residual}, scale);
        const RowArray<float> scaled = level.residuals;
        assemble(level, {Assembly::residuals_and_stencils, RightHandSide::given}, scale);
        shapes::for_inside(level, [&](int i, int j, int k) {
            for (int c = 0; c < sample.components; ++c) {
                const auto value = [&](const RowArray<float>& rows, int n) {
                    return static_cast<double>(shapes::at(rows, level, i, j, k, n));
                };
                const double integrated = value(level.residuals, c) * value(level.weights, 0);
                CHECK(integrated == Approx(value(given, c)).epsilon(1e-5).margin(1e-5));
                CHECK(value(scaled, c) ==
                      Approx(value(level.residuals, c)).epsilon(1e-5).margin(1e-10));
            }
        });
    }
}

}  // namespace hexweave
