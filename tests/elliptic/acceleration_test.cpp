// SPDX-License-Identifier: Apache-2.0
// Anderson acceleration of a linear iteration is a Krylov method: it ends after as many steps as
// the iteration has different rates.
#include "elliptic/acceleration.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/shapes.h"

namespace hexweave {
namespace {

/// Distance to the fixed point after `steps` accelerated steps of an iteration with three rates,
/// one of which grows: x - x* is multiplied by 0.9, -0.5 or -1.2 in every plain step.
double distance_after(int steps, std::size_t window, double damping) {
    const Extent e{7, 7, 1};
    const NodeLattice lattice(e);
    const Nodes goal = shapes::nodes_of(shapes::sample(e, [](double u, double v, double) {
        return Vec3{u, v, 0};
    }));
    constexpr std::array rates{0.9, -0.5, -1.2};
    Acceleration acceleration(lattice, window);
    Nodes x = goal;
    for_interior(lattice, [&](std::size_t p) {
        x[p] += 0.01 * Vec3{std::sin(static_cast<double>(p)), std::cos(static_cast<double>(p)), 0};
    });
    for (int n = 0; n < steps; ++n) {
        Nodes step(x.size());
        for (std::size_t p = 0; p < x.size(); ++p) step[p] = (rates[p % 3] - 1) * (x[p] - goal[p]);
        acceleration.accelerate(x, damping, step);
        for (std::size_t p = 0; p < x.size(); ++p) x[p] += step[p];
    }
    double largest = 0;
    for (std::size_t p = 0; p < x.size(); ++p) largest = std::max(largest, distance(x[p], goal[p]));
    return largest;
}

}  // namespace

TEST_CASE("an iteration of three rates ends after four accelerated steps") {
    CHECK(distance_after(3, 5, 1) > 1e-6);
    CHECK(distance_after(4, 5, 1) < 1e-12);
    CHECK(distance_after(4, 5, 0.5) < 1e-12);
}

TEST_CASE("steps beyond the end do no harm") {
    CHECK(distance_after(9, 5, 1) < 1e-12);
}

TEST_CASE("a window shorter than the number of rates does not end, but converges") {
    CHECK(distance_after(4, 2, 1) > 1e-6);
    CHECK(distance_after(60, 2, 1) < 1e-8);
}

TEST_CASE("the first step is a plain one") {
    CHECK(distance_after(1, 5, 1) == Approx(0.012).epsilon(0.05));
}

}  // namespace hexweave
