// SPDX-License-Identifier: Apache-2.0
// The functional that unfolds patches, its model, and what it aims at.
#include "elliptic/foldover_functional.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "elliptic/fold_count.h"
#include "elliptic/patch_solver.h"
#include "elliptic/shapes.h"
#include "elliptic/target_cells.h"

namespace hexweave {
namespace {

Runs interior(const Extent& e) {
    Runs runs;
    for (int k = e.nk == 1 ? 0 : 1; k < (e.nk == 1 ? 1 : e.nk - 1); ++k) {
        for (int j = 1; j < e.nj - 1; ++j) runs.push_back({k, j, 1, e.ni - 2});
    }
    return runs;
}

/// All interior nodes of a leaning grid free, some of them pushed across others.
Patch folded_patch(const Extent& e) {
    PointField points = shapes::sample(e, shapes::leaning);
    Patch patch = make_patch(points, interior(e), 1, e.nk == 1 ? plane_normal(points) : Vec3{});
    aim_at_sheared_cells(patch);
    for (const int free : patch.free) {
        const double wave = std::sin(3.7 * free);
        patch.points[static_cast<std::size_t>(free)] +=
            0.2 * Vec3{wave, wave * wave, e.nk == 1 ? 0 : -wave};
    }
    return patch;
}

}  // namespace

TEST_CASE("the gradient is that of the functional, for folded cells too") {
    for (const Extent e : {Extent{5, 4, 1}, Extent{4, 5, 4}}) {
        Patch patch = folded_patch(e);
        REQUIRE(count_folded(patch) > 0);
        constexpr double epsilon = 0.3;
        constexpr double h = 1e-6;
        QuadraticModel model;
        assemble(patch, epsilon, model);
        for (std::size_t f = 0; f < patch.free.size(); ++f) {
            Vec3& x = patch.points[static_cast<std::size_t>(patch.free[f])];
            const Vec3 centre = x;
            const auto slope = [&](const Vec3& way) {
                x = centre + h * way;
                const double high = evaluate(patch, epsilon).energy;
                x = centre - h * way;
                const double low = evaluate(patch, epsilon).energy;
                x = centre;
                return (high - low) / (2 * h);
            };
            const Vec3 g = model.gradient[f];
            const double scale = norm(g) + 1;
            CHECK(std::abs(g.x - slope({1, 0, 0})) < 1e-5 * scale);
            CHECK(std::abs(g.y - slope({0, 1, 0})) < 1e-5 * scale);
            CHECK(std::abs(g.z - slope({0, 0, 1})) < 1e-5 * scale);
        }
    }
}

TEST_CASE("the linear solver solves the model, which never curves down") {
    for (const Extent e : {Extent{5, 6, 1}, Extent{5, 4, 6}}) {
        const Patch patch = folded_patch(e);
        QuadraticModel model;
        assemble(patch, 0.3, model);
        PatchSolver solver(patch);
        std::vector<Vec3> step;
        solver.solve(model, 1e-10, 1000, step);
        // The residual of the system by its blocks.
        std::vector<Vec3> residual = model.gradient;
        const auto add = [&](std::size_t to, const Matrix3& m, const Vec3& v, bool transposed) {
            const auto at = [&](std::size_t r, std::size_t c) {
                return transposed ? m[3 * c + r] : m[3 * r + c];
            };
            residual[to] += Vec3{at(0, 0) * v.x + at(0, 1) * v.y + at(0, 2) * v.z,
                                 at(1, 0) * v.x + at(1, 1) * v.y + at(1, 2) * v.z,
                                 at(2, 0) * v.x + at(2, 1) * v.y + at(2, 2) * v.z};
        };
        double curvature = 0;
        for (std::size_t f = 0; f < step.size(); ++f) {
            add(f, model.diagonal[f], step[f], false);
            for (std::size_t c = 0; c < patch.couplings(); ++c) {
                const int ahead = patch.ahead[f * patch.couplings() + c];
                if (ahead < 0) continue;
                const auto a = static_cast<std::size_t>(ahead);
                const Matrix3& block = model.coupling[f * patch.couplings() + c];
                add(f, block, step[a], false);
                add(a, block, step[f], true);
            }
        }
        double largest = 0;
        double scale = 0;
        for (std::size_t f = 0; f < step.size(); ++f) {
            largest = std::max(largest, norm(residual[f]));
            scale = std::max(scale, norm(model.gradient[f]));
            curvature -= dot(step[f], model.gradient[f]);
        }
        CHECK(largest < 1e-7 * scale);
        CHECK(curvature > 0);
    }
}

TEST_CASE("a sound corner is its own target") {
    const std::array<Vec3, 3> legs{Vec3{2, 0.1, 0}, Vec3{0.3, 1e-3, 1e-4}, Vec3{0.5, 0.2, 3}};
    const TargetCorner target = sheared_corner(legs, -1, 3, 1);
    const auto& m = target.inverse_gram;
    const std::array<double, 9> inverse{m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5]};
    // The shear is of the second leg only: the Gram matrix keeps the lengths and the angle 0, 2.
    double volume = std::abs(triple(legs[0], legs[1], legs[2]));
    REQUIRE(volume / (norm(legs[0]) * norm(legs[1]) * norm(legs[2])) < 0.15);
    CHECK(1 / target.inverse_volume ==
          Approx(0.15 * norm(legs[0]) * norm(legs[1]) * norm(legs[2])));

    const std::array<Vec3, 3> sound{Vec3{2, 0.1, 0}, Vec3{0.3, 1, 0.1}, Vec3{0.5, 0.2, 3}};
    const TargetCorner own = sheared_corner(sound, 1, 3, 1);
    volume = triple(sound[0], sound[1], sound[2]);
    CHECK(own.inverse_volume == Approx(1 / volume));
    const auto& o = own.inverse_gram;
    const std::array<double, 9> g{o[0], o[1], o[2], o[1], o[3], o[4], o[2], o[4], o[5]};
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            double sum = 0;
            for (std::size_t c = 0; c < 3; ++c) sum += g[3 * a + c] * dot(sound[c], sound[b]);
            CHECK(sum == Approx(a == b ? 1 : 0).margin(1e-12));
        }
    }
    CHECK(inverse[4] > 0);
}

TEST_CASE("the functional of a grid of sound cells is least where it is") {
    const Extent e{5, 4, 4};
    const PointField points = shapes::sample(e, shapes::leaning);
    Patch patch = make_patch(points, interior(e), 2, {});
    aim_at_sheared_cells(patch);
    const double corners = static_cast<double>(patch.targets.size());
    // Three for the shape and one for the volume at every corner with a free node.
    CHECK(evaluate(patch, 1e-9).energy <= 4 * corners * (1 + 1e-12));
    QuadraticModel model;
    assemble(patch, 1e-9, model);
    for (const Vec3& g : model.gradient) CHECK(norm(g) < 1e-10);
}

}  // namespace hexweave
