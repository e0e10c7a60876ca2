// SPDX-License-Identifier: Apache-2.0
// What goes between levels: changes are carried up exactly where they are linear in the
// parameters, and residuals come down by the transpose.
#include "elliptic/transfer.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "elliptic/levels.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

using Axes = std::array<bool, 3>;

struct Step {
    Extent extent;
    Axes halved;
};

const std::vector<Step> steps{
    {{17, 9, 1}, {true, true, false}},  {{18, 7, 1}, {true, true, false}},
    {{47, 4, 1}, {true, false, false}}, {{6, 33, 1}, {false, true, false}},
    {{9, 9, 9}, {true, true, true}},    {{10, 7, 6}, {true, true, true}},
    {{10, 7, 6}, {true, false, true}},  {{7, 10, 5}, {false, true, true}},
    {{18, 3, 4}, {true, false, false}}, {{3, 5, 18}, {false, false, true}},
    {{4, 18, 3}, {false, true, false}},
};

/// Irregular along every axis, but a product: s depends on i alone.
Vec3 product(double xi, double eta, double zeta) {
    return {0.1 * xi + 0.9 * std::pow(xi, 4), std::expm1(6 * eta) / std::expm1(6.0),
            zeta * (1.9 - 0.9 * zeta)};
}

double linear(const Vec3& s, int component) {
    return component == 0   ? 0.3 + s.x - 2 * s.y + s.z
           : component == 1 ? 1 - 3 * s.x + s.y * s.z
                            : 2 * s.x * s.y - s.z;
}

}  // namespace

TEST_CASE("changes that are linear in s, t and u are interpolated exactly") {
    for (const Step& step : steps) {
        Level fine = shapes::level_of(PointField(step.extent),
                                      shapes::sample_parameters(step.extent, product), 3);
        Level coarse = coarser_level(fine, step.halved);
        const Extent c = coarse.extent;
        const auto parameters = [](const Level& level, int i, int j, int k) {
            return Vec3{shapes::at(level.parameters, level, i, j, k, 0),
                        shapes::at(level.parameters, level, i, j, k, 1),
                        level.axes == 3 ? shapes::at(level.parameters, level, i, j, k, 2) : 0};
        };
        for (int k = 0; k < c.nk; ++k) {
            for (int j = 0; j < c.nj; ++j) {
                for (int i = 0; i < c.ni; ++i) {
                    for (int n = 0; n < 3; ++n) {
                        shapes::at(coarse.points, coarse, i, j, k, n) =
                            linear(parameters(coarse, i, j, k), n);
                    }
                }
            }
        }
        interpolate_changes(fine, coarse);
        double worst = 0;
        shapes::for_inside(fine, [&](int i, int j, int k) {
            for (int n = 0; n < 3; ++n) {
                worst = std::max(
                    worst,
                    std::abs(static_cast<double>(shapes::at(fine.corrections, fine, i, j, k, n)) -
                             linear(parameters(fine, i, j, k), n)));
            }
        });
        INFO(step.extent.ni << " x " << step.extent.nj << " x " << step.extent.nk);
        CHECK(worst < 2e-6);
    }
}

TEST_CASE("restriction is the transpose of interpolation") {
    for (const Step& step : steps) {
        Level fine = shapes::level_of(shapes::sample(step.extent, shapes::leaning),
                                      shapes::sample_parameters(step.extent, shapes::leaning), 3);
        Level coarse = coarser_level(fine, step.halved);
        shapes::add_work(coarse);
        inject_points(fine, coarse);
        RowArray<float> changes(coarse.extent, 3);
        shapes::fill_inside(coarse, changes, 3, 5);
        shapes::for_inside(coarse, [&](int i, int j, int k) {
            for (int n = 0; n < 3; ++n) {
                shapes::at(coarse.points, coarse, i, j, k, n) +=
                    static_cast<double>(shapes::at(changes, coarse, i, j, k, n));
            }
        });
        shapes::fill_inside(fine, fine.residuals, 3, 6);
        interpolate_changes(fine, coarse);
        double on_fine = 0;
        double size = 0;
        shapes::for_inside(fine, [&](int i, int j, int k) {
            for (int n = 0; n < 3; ++n) {
                const double product =
                    static_cast<double>(shapes::at(fine.corrections, fine, i, j, k, n)) *
                    static_cast<double>(shapes::at(fine.residuals, fine, i, j, k, n));
                on_fine += product;
                size += std::abs(product);
            }
        });
        restrict_residuals(fine, coarse);
        double on_coarse = 0;
        shapes::for_inside(coarse, [&](int i, int j, int k) {
            for (int n = 0; n < 3; ++n) {
                on_coarse += static_cast<double>(shapes::at(changes, coarse, i, j, k, n)) *
                             static_cast<double>(shapes::at(coarse.residuals, coarse, i, j, k, n));
            }
        });
        INFO(step.extent.ni << " x " << step.extent.nj << " x " << step.extent.nk);
        REQUIRE(size > 1);
        CHECK(std::abs(on_fine - on_coarse) < 1e-6 * size);
    }
}

TEST_CASE("corrections move interior nodes alone, and are summed up") {
    for (const Extent e : {Extent{9, 5, 1}, Extent{6, 5, 4}}) {
        const PointField points = shapes::sample(e, shapes::leaning);
        Level level = shapes::level_of(points, shapes::sample_parameters(e, shapes::leaning), 3);
        level.steps = RowArray<float>(e, 3);
        shapes::fill_inside(level, level.corrections, 3, 9);
        // What interpolation leaves at the boundary is rounding, and must not get into the points.
        shapes::at(level.corrections, level, 0, 2, level.first_k()) = 1;
        shapes::at(level.corrections, level, e.ni - 1, 2, level.first_k()) = 1;
        add_corrections(level, 0.5);
        add_corrections(level, 0.25);
        shapes::for_inside(level, [&](int i, int j, int k) {
            const double correction =
                static_cast<double>(shapes::at(level.corrections, level, i, j, k, 1));
            CHECK(shapes::at(level.points, level, i, j, k, 1) ==
                  Approx(points(i, j, k).y + 0.75 * correction).margin(1e-15));
            CHECK(static_cast<double>(shapes::at(level.steps, level, i, j, k, 1)) ==
                  Approx(0.75 * correction).epsilon(1e-6));
        });
        CHECK(shapes::at(level.points, level, 0, 2, level.first_k()) ==
              points(0, 2, level.first_k()).x);
        CHECK(shapes::at(level.points, level, e.ni - 1, 2, level.first_k()) ==
              points(e.ni - 1, 2, level.first_k()).x);
    }
}

}  // namespace hexweave
