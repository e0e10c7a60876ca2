// SPDX-License-Identifier: Apache-2.0
#include "quality/jacobian_bound.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

/// A prism of height `height` over the square [-1/2, 1/2]^2, whose top is a linear image of it.
CellNodes prism(double xx, double xy, double yx, double yy, double height) {
    CellNodes nodes{};
    for (std::size_t c = 0; c < 8; ++c) {
        const double x = (c & 1) != 0 ? 0.5 : -0.5;
        const double y = (c & 2) != 0 ? 0.5 : -0.5;
        nodes[c] = c < 4 ? Vec3{x, y, 0} : Vec3{xx * x + xy * y, yx * x + yy * y, height};
    }
    return nodes;
}

/// The top turned by an angle: at the share z of its height the Jacobian is
/// 1 - 2 z (1 - z) (1 - cos), over the whole cross section.
CellNodes twisted(double angle) {
    return prism(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 1);
}

JacobianVerdict judged(const CellNodes& nodes, const FlatCorners& flat = {}) {
    return judge_jacobian(jacobian_coefficients(nodes), flat);
}

}  // namespace

TEST_CASE("the Jacobian of a sheared box is its volume everywhere") {
    CellNodes nodes{};
    for (std::size_t c = 0; c < 8; ++c) {
        const Vec3 unit{double(c & 1), double((c >> 1) & 1), double(c >> 2)};
        nodes[c] = {2 * unit.x + 0.5 * unit.y, 3 * unit.y - unit.z, 0.25 * unit.z + 0.1 * unit.x};
    }
    // det [[2, .5, 0], [0, 3, -1], [.1, 0, .25]]
    const double volume = 2 * 3 * 0.25 - 0.5 * (0 * 0.25 + 1 * 0.1);
    const JacobianCoefficients coefficients = jacobian_coefficients(nodes);
    for (const double c : coefficients) CHECK(c == Approx(volume).epsilon(1e-14));
    CHECK(cell_volume(coefficients) == Approx(volume).epsilon(1e-14));
    CHECK(judged(nodes) == JacobianVerdict::positive);
}

TEST_CASE("a twisted prism has the volume of the integral and its waist as bound") {
    const double angle = pi / 2;
    const JacobianCoefficients coefficients = jacobian_coefficients(twisted(angle));
    CHECK(cell_volume(coefficients) == Approx(1 - (1 - std::cos(angle)) / 3).epsilon(1e-14));
    const auto [least, greatest] = std::minmax_element(coefficients.begin(), coefficients.end());
    CHECK(*least <= 0.5);  // the Jacobian at half height
    CHECK(*greatest == Approx(1).epsilon(1e-14));
    CHECK(judged(twisted(angle)) == JacobianVerdict::positive);
    CHECK(judged(twisted(0.99 * pi)) == JacobianVerdict::positive);
    CHECK(judged(twisted(pi)) == JacobianVerdict::not_positive);
}

TEST_CASE("a cell that is positive at its corners and negative inside is found out") {
    // (1 - 2 z) (1 - 4 z): 1 and 3 at the ends, negative from z = 1/4 to 1/2.
    const CellNodes nodes = prism(-1, 0, 0, -3, 1);
    const JacobianCoefficients coefficients = jacobian_coefficients(nodes);
    for (const std::size_t corner : {0U, 2U, 6U, 8U}) {
        CHECK(coefficients[corner] == Approx(1));
        CHECK(coefficients[corner + 18] == Approx(3));
    }
    CHECK(judged(nodes) == JacobianVerdict::not_positive);
    CHECK(cell_volume(coefficients) == Approx(2.0 / 3).epsilon(1e-14));
}

TEST_CASE("a mirrored cell is not positive, one that touches zero inside is not proven") {
    CHECK(judged(prism(1, 0, 0, 1, -1)) == JacobianVerdict::not_positive);
    // (1 - 2 z)^2 + a little: positive, but by less than the subdivisions can tell from zero.
    const CellNodes waist = twisted(pi * (1 - 1e-6));
    CHECK(judged(waist) != JacobianVerdict::not_positive);
    CHECK(judge_jacobian(jacobian_coefficients(waist), {}, 0) == JacobianVerdict::undecided);
}

TEST_CASE("flat corners are excepted where they are declared, and only there") {
    // Two sides of the cell lie in one plane: the corners 0 and 4 are flat.
    CellNodes nodes = prism(1, 0, 0, 1, 1);
    nodes[0] = {0, 0, 0};
    nodes[4] = {0, 0, 1};
    FlatCorners flat{};
    CHECK(judged(nodes, flat) == JacobianVerdict::not_positive);
    flat[0] = flat[4] = true;
    CHECK(judged(nodes, flat) == JacobianVerdict::positive);
    nodes[0] = {0.01, 0.01, 0};  // turned inside out: not flat, whatever is declared beside it
    flat[0] = false;
    CHECK(judged(nodes, flat) == JacobianVerdict::not_positive);
}

TEST_CASE("a cell whose side is collapsed to a line is sound but for that side") {
    // A wedge: the side at i = 0 is a line along k, askew so that nothing is zero by chance.
    const Vec3 foot{0.1, 0.2, 0.3};
    const Vec3 head{0.2, 0.13, 1.7};
    CellNodes nodes = prism(1.1, 0.3, -0.2, 0.9, 1);
    nodes[0] = nodes[2] = Vec3{-0.5, 0, 0} + foot;
    nodes[4] = nodes[6] = Vec3{-0.5, 0, 0} + head;
    nodes[1] += foot;
    nodes[3] += foot;
    nodes[5] += head - Vec3{0, 0, 1};
    nodes[7] += head - Vec3{0, 0, 1};
    const FlatCorners pole{true, false, true, false, true, false, true, false};
    CHECK(cell_volume(jacobian_coefficients(nodes)) > 0.1);
    CHECK(judged(nodes, pole) == JacobianVerdict::positive);
    CHECK(judged(nodes) == JacobianVerdict::not_positive);
    std::swap(nodes[5], nodes[7]);  // the other side twisted inside out
    CHECK(judged(nodes, pole) == JacobianVerdict::not_positive);
}
