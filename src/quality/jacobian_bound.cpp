// SPDX-License-Identifier: Apache-2.0
#include "quality/jacobian_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

/// Of the binomials C(2, n): what a product of two linear Bernstein polynomials is to be divided
/// by.
constexpr std::array<double, 3> binomial{1, 2, 1};

constexpr std::size_t place(std::size_t a, std::size_t b, std::size_t c) {
    return a + 3 * b + 9 * c;
}

/// The cell's edges along one axis, by the two bits of the other axes (the lower axis first).
std::array<Vec3, 4> edges_along(const CellNodes& nodes, std::size_t axis) {
    const std::size_t first = axis == 0 ? 1 : 0;
    const std::size_t second = axis == 2 ? 1 : 2;
    std::array<Vec3, 4> edges;
    for (std::size_t n = 0; n < 4; ++n) {
        const std::size_t low = ((n & 1) << first) | ((n >> 1) << second);
        edges[n] = nodes[low | (std::size_t{1} << axis)] - nodes[low];
    }
    return edges;
}

/// Coefficients along one axis of the two halves of a quadratic: de Casteljau's construction.
struct Halves {
    std::array<double, 3> low;
    std::array<double, 3> high;
};
Halves halves(double b0, double b1, double b2) {
    const double left = (b0 + b1) / 2;
    const double right = (b1 + b2) / 2;
    const double middle = (left + right) / 2;
    return {{b0, left, middle}, {middle, right, b2}};
}

/// The polynomial over one half of its cube along an axis.
JacobianCoefficients half(const JacobianCoefficients& whole, std::size_t axis, bool high) {
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    JacobianCoefficients part = whole;
    for (std::size_t n = 0; n < 27; ++n) {
        if (n / stride % 3 != 0) continue;
        const Halves h = halves(whole[n], whole[n + stride], whole[n + 2 * stride]);
        const auto& chosen = high ? h.high : h.low;
        for (std::size_t m = 0; m < 3; ++m) part[n + m * stride] = chosen[m];
    }
    return part;
}

/// Which coefficients may be zero: those of flat corners, of edges that are flat at both ends, and
/// of faces that are flat at all four corners, as one that is collapsed to a pole.
using MayVanish = std::array<bool, 27>;

/// The same over one half of the cube: along a line of three, all if all may; else the end alone
/// that the half contains.
MayVanish half(const MayVanish& whole, std::size_t axis, bool high) {
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    MayVanish part = whole;
    for (std::size_t n = 0; n < 27; ++n) {
        if (n / stride % 3 != 0) continue;
        if (whole[n] && whole[n + stride] && whole[n + 2 * stride]) continue;
        part[n] = !high && whole[n];
        part[n + stride] = false;
        part[n + 2 * stride] = high && whole[n + 2 * stride];
    }
    return part;
}

constexpr std::size_t corner_place(std::size_t corner) {
    return place(2 * (corner & 1), 2 * ((corner >> 1) & 1), 2 * (corner >> 2));
}

MayVanish vanishing(const JacobianCoefficients& c, const FlatCorners& flat) {
    constexpr double zero = 1e-9;
    MayVanish result{};
    for (std::size_t corner = 0; corner < 8; ++corner) result[corner_place(corner)] = flat[corner];
    const double scale = std::abs(*std::max_element(
        c.begin(), c.end(), [](double p, double q) { return std::abs(p) < std::abs(q); }));
    // Half-way between two corners, over an edge, and from edge to edge then, over a face.
    const auto between = [&](std::size_t low, std::size_t high) {
        const std::size_t middle = (low + high) / 2;
        if (result[low] && result[high]) result[middle] = std::abs(c[middle]) <= zero * scale;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t n = corner_place(corner);
            if (n / stride % 3 == 0) between(n, n + 2 * stride);
        }
    }
    for (const std::size_t n : {place(0, 1, 0), place(0, 1, 2)}) between(n, n + place(2, 0, 0));
    for (const std::size_t n : {place(0, 0, 1), place(2, 0, 1)}) between(n, n + place(0, 2, 0));
    for (const std::size_t n : {place(1, 0, 0), place(1, 2, 0)}) between(n, n + place(0, 0, 2));
    return result;
}

JacobianVerdict judge(const JacobianCoefficients& c, const MayVanish& may_vanish, int depth) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t n = corner_place(corner);
        if (!may_vanish[n] && !(c[n] > 0)) return JacobianVerdict::not_positive;
    }
    bool positive = true;
    for (std::size_t n = 0; n < c.size(); ++n) positive = positive && (c[n] > 0 || may_vanish[n]);
    if (positive) return JacobianVerdict::positive;
    if (depth == 0) return JacobianVerdict::undecided;
    JacobianVerdict verdict = JacobianVerdict::positive;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        JacobianCoefficients part = c;
        MayVanish part_may_vanish = may_vanish;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool high = ((octant >> axis) & 1) != 0;
            part = half(part, axis, high);
            part_may_vanish = half(part_may_vanish, axis, high);
        }
        const JacobianVerdict found = judge(part, part_may_vanish, depth - 1);
        if (found == JacobianVerdict::not_positive) return found;
        if (found == JacobianVerdict::undecided) verdict = found;
    }
    return verdict;
}

}  // namespace

JacobianCoefficients jacobian_coefficients(const CellNodes& nodes) {
    const auto u = edges_along(nodes, 0);  // by bits (j, k)
    const auto v = edges_along(nodes, 1);  // by bits (i, k)
    const auto w = edges_along(nodes, 2);  // by bits (i, j)
    JacobianCoefficients sum{};
    for (std::size_t m = 0; m < 4; ++m) {
        for (std::size_t n = 0; n < 4; ++n) {
            const Vec3 normal = cross(v[m], w[n]);
            for (std::size_t l = 0; l < 4; ++l) {
                const std::size_t a = (m & 1) + (n & 1);
                const std::size_t b = (l & 1) + (n >> 1);
                const std::size_t c = (l >> 1) + (m >> 1);
                sum[place(a, b, c)] += dot(u[l], normal);
            }
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t b = 0; b < 3; ++b) {
            for (std::size_t a = 0; a < 3; ++a) {
                sum[place(a, b, c)] /= binomial[a] * binomial[b] * binomial[c];
            }
        }
    }
    return sum;
}

double cell_volume(const JacobianCoefficients& coefficients) {
    double sum = 0;
    for (const double c : coefficients) sum += c;
    return sum / static_cast<double>(coefficients.size());
}

JacobianVerdict judge_jacobian(const JacobianCoefficients& coefficients, const FlatCorners& flat,
                               int depth) {
    JacobianCoefficients c = coefficients;
    const MayVanish may_vanish = vanishing(c, flat);
    for (std::size_t n = 0; n < c.size(); ++n) {
        if (may_vanish[n]) c[n] = 0;
    }
    return judge(c, may_vanish, depth);
}

}  // namespace hexweave
