// SPDX-License-Identifier: Apache-2.0
// The smoother: exact along lines, blind to how it is spread over threads.
#include "elliptic/line_relaxation.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "elliptic/assembly.h"
#include "elliptic/levels.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

Level level_of(const Extent& e, int components) {
    return shapes::level_of(shapes::sample(e, shapes::leaning),
                            shapes::sample_parameters(e, shapes::leaning), components);
}

/// A stencil that joins nodes along one axis only, differently from node to node.
void couple_along(Level& level, int axis) {
    const int first = level.axes == 3 ? 6 : 3;
    shapes::for_inside(level, [&](int i, int j, int k) {
        shapes::at(level.stencils, level, i, j, k, axis) = 0.5F;
        shapes::at(level.stencils, level, i, j, k, first + axis) =
            static_cast<float>(0.3 * std::sin(i + 2 * j + 3 * k));
    });
}

/// The largest of |operator(corrections) - residuals| with the stencil along `axis`.
double defect_along(const Level& level, int axis) {
    const int first = level.axes == 3 ? 6 : 3;
    const std::array<int, 3> d{axis == 0, axis == 1, axis == 2};
    double largest = 0;
    shapes::for_inside(level, [&](int i, int j, int k) {
        const auto number = [&](int n) {
            return static_cast<double>(shapes::at(level.stencils, level, i, j, k, n));
        };
        for (int c = 0; c < level.components; ++c) {
            const auto v = [&](int sign) {
                return static_cast<double>(shapes::at(level.corrections, level, i + sign * d[0],
                                                      j + sign * d[1], k + sign * d[2], c));
            };
            const double value =
                number(axis) * (v(1) - 2 * v(0) + v(-1)) + number(first + axis) * (v(1) - v(-1));
            const double residual =
                static_cast<double>(shapes::at(level.residuals, level, i, j, k, c));
            largest = std::max(largest, std::abs(value - residual));
        }
    });
    return largest;
}

std::vector<float> numbers_of(const Level& level) {
    const float* const first = level.corrections.row(0, 0);
    return {first, first + level.extent.nk * level.corrections.stride_k()};
}

struct Shape {
    Extent extent;
    int components;
};

const std::vector<Shape> all_shapes{
    {{9, 9, 1}, 2},  {{18, 7, 1}, 2}, {{3, 47, 1}, 3}, {{47, 3, 1}, 3},
    {{4, 5, 1}, 3},  {{3, 3, 1}, 2},  {{9, 9, 9}, 3},  {{18, 7, 5}, 3},
    {{5, 18, 6}, 3}, {{3, 4, 18}, 3}, {{4, 4, 4}, 3},  {{33, 4, 5}, 3},
};

}  // namespace

TEST_CASE("nodes that are coupled along one axis only are solved for in one sweep") {
    for (const Shape& shape : all_shapes) {
        for (int axis = 0; axis < (shape.extent.nk > 1 ? 3 : 2); ++axis) {
            Level level = level_of(shape.extent, shape.components);
            couple_along(level, axis);
            shapes::fill_inside(level, level.residuals, shape.components, 8);
            relax_lines(level, 1);
            INFO(shape.extent.ni << " x " << shape.extent.nj << " x " << shape.extent.nk
                                 << ", axis " << axis);
            CHECK(defect_along(level, axis) < 3e-4);
        }
    }
}

TEST_CASE("sweeps keep the boundary and the padding at zero") {
    for (const Shape& shape : all_shapes) {
        Level level = level_of(shape.extent, shape.components);
        assemble(level, {Assembly::residuals_and_stencils, RightHandSide::zero}, 1);
        shapes::fill_inside(level, level.residuals, shape.components, 8);
        relax_lines(level, 2);
        double inside = 0;
        int nodes = 0;
        shapes::for_inside(level, [&](int i, int j, int k) {
            ++nodes;
            for (int c = 0; c < shape.components; ++c) {
                inside +=
                    std::abs(static_cast<double>(shapes::at(level.corrections, level, i, j, k, c)));
            }
        });
        CHECK(inside > 0.1 * nodes);
        double all = 0;
        for (const float value : numbers_of(level)) all += std::abs(static_cast<double>(value));
        CHECK(all == Approx(inside));
    }
}

TEST_CASE("sweeps reduce the residual of the operator, every one of them") {
    for (const Extent e : {Extent{17, 17, 1}, Extent{10, 9, 8}}) {
        Level level = level_of(e, 3);
        assemble(level, {Assembly::residuals_and_stencils, RightHandSide::zero}, 1);
        shapes::fill_inside(level, level.residuals, 3, 8);
        double before = 1e30;
        std::vector<float> last(numbers_of(level));
        for (int sweep = 0; sweep < 6; ++sweep) {
            relax_lines(level, 1);
            const std::vector<float> now = numbers_of(level);
            double change = 0;
            for (std::size_t n = 0; n < now.size(); ++n) {
                const double d = static_cast<double>(now[n]) - static_cast<double>(last[n]);
                change += d * d;
            }
            CHECK(change < before);
            before = change;
            last = now;
        }
    }
}

TEST_CASE("of blocks one interior node thick, sweeps touch nothing but the interior") {
    for (const Extent& e :
         {Extent{18, 9, 3}, Extent{18, 3, 9}, Extent{3, 3, 3}, Extent{33, 4, 3}}) {
        for (int axis = 0; axis < 3; ++axis) {
            Level level = level_of(e, 3);
            couple_along(level, axis);
            shapes::fill_inside(level, level.residuals, 3, 8);
            relax_lines(level, 2);
            CHECK(defect_along(level, axis) < 3e-4);
        }
    }
}

TEST_CASE("sweeps have the same bits on any number of threads") {
    const int before = threads();
    for (const Shape& shape : {Shape{{150, 131, 1}, 2}, Shape{{131, 150, 1}, 3},
                               Shape{{46, 35, 31}, 3}, Shape{{500, 40, 4}, 3}}) {
        std::vector<float> reference;
        for (const int count : {1, 2, 4, 7}) {
            set_threads(count);
            Level level = level_of(shape.extent, shape.components);
            assemble(level, {Assembly::residuals_and_stencils, RightHandSide::zero}, 1);
            shapes::fill_inside(level, level.residuals, shape.components, 8);
            relax_lines(level, 2);
            const std::vector<float> numbers = numbers_of(level);
            if (count == 1) reference = numbers;
            CHECK(numbers == reference);
        }
    }
    set_threads(before);
}

}  // namespace hexweave
