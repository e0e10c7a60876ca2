// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/grid_operator.h"

namespace hexweave::bench {

namespace {

// The differences are the innermost loop of every linear solve: left to itself the compiler calls
// some of them through memory, at a quarter of the whole time.

/// v+ - v-, twice the central first difference.
[[gnu::always_inline]] inline Vec3 first_difference(const Vec3* v, std::ptrdiff_t d) {
    return v[d] - v[-d];
}

/// As a difference of differences: of strongly clustered parameters it keeps its digits.
[[gnu::always_inline]] inline Vec3 second_difference(const Vec3* v, std::ptrdiff_t d) {
    return (v[d] - v[0]) - (v[0] - v[-d]);
}

/// Four times the central mixed difference.
[[gnu::always_inline]] inline Vec3 mixed_difference(const Vec3* v, std::ptrdiff_t d,
                                                    std::ptrdiff_t e) {
    return (v[d + e] - v[d - e]) - (v[e - d] - v[-d - e]);
}

template <int axes>
[[gnu::always_inline]] inline Vec3 second_order_part(const Stencil& c, const Vec3* v,
                                                     const Strides& d) {
    Vec3 sum = c.second[0] * second_difference(v, d[0]) + c.second[1] * second_difference(v, d[1]) +
               c.mixed[0] * mixed_difference(v, d[0], d[1]);
    if constexpr (axes == 3) {
        sum += c.second[2] * second_difference(v, d[2]) +
               c.mixed[1] * mixed_difference(v, d[0], d[2]) +
               c.mixed[2] * mixed_difference(v, d[1], d[2]);
    }
    return sum;
}

template <int axes>
[[gnu::always_inline]] inline Vec3 whole_operator(const Stencil& c, const Vec3* v,
                                                  const Strides& d) {
    Vec3 sum = second_order_part<axes>(c, v, d) + c.first[0] * first_difference(v, d[0]) +
               c.first[1] * first_difference(v, d[1]);
    if constexpr (axes == 3) sum += c.first[2] * first_difference(v, d[2]);
    return sum;
}

/// alpha^ij up to a common factor: on a face from the base vectors [eq. (42)], in a block as inner
/// products of their cross products, which are the cofactors of eq. (87) without cancellation.
template <int axes>
Stencil second_order_coefficients(const Vec3* x, const Strides& d) {
    Stencil c;
    const Vec3 a1 = first_difference(x, d[0]);
    const Vec3 a2 = first_difference(x, d[1]);
    if constexpr (axes == 2) {
        c.second = {dot(a2, a2), dot(a1, a1), 0};
        c.mixed = {-dot(a1, a2), 0, 0};
    } else {
        const Vec3 a3 = first_difference(x, d[2]);
        const Vec3 b1 = cross(a2, a3);
        const Vec3 b2 = cross(a3, a1);
        const Vec3 b3 = cross(a1, a2);
        c.second = {dot(b1, b1), dot(b2, b2), dot(b3, b3)};
        c.mixed = {dot(b1, b2), dot(b1, b3), dot(b2, b3)};
    }
    const double centre = 2 * (c.second[0] + c.second[1] + c.second[2]);
    if (centre == 0) {
        c = Stencil{};
        for (std::size_t axis = 0; axis < axes; ++axis) c.second[axis] = 0.5 / axes;
        return c;
    }
    for (double& second : c.second) second /= centre;
    for (double& mixed : c.mixed)
        mixed *= 0.5 / centre;  // 2 alpha^ij, over the 4 of the difference
    return c;
}

/// Chooses first[] such that the operator annihilates s, t (and u): Cramer's rule for
/// T (S, T, U) = -w with the columns of T the first differences of the parameters.
template <int axes>
void set_first_order_coefficients(const Vec3* s, const Strides& d, Stencil& c) {
    const Vec3 w = second_order_part<axes>(c, s, d);
    const Vec3 t1 = first_difference(s, d[0]);
    const Vec3 t2 = first_difference(s, d[1]);
    if constexpr (axes == 2) {
        const double determinant = t1.x * t2.y - t2.x * t1.y;
        c.first = {(t2.x * w.y - w.x * t2.y) / determinant, (w.x * t1.y - t1.x * w.y) / determinant,
                   0};
    } else {
        const Vec3 t3 = first_difference(s, d[2]);
        const double determinant = triple(t1, t2, t3);
        c.first = {-triple(w, t2, t3) / determinant, -triple(t1, w, t3) / determinant,
                   -triple(t1, t2, w) / determinant};
    }
}

template <int axes>
void assemble(const NodeLattice& lattice, const Nodes& points, const Nodes& parameters,
              Stencils& stencils) {
    const Strides d = lattice.strides;
    for_interior(lattice, [&](std::size_t p) {
        Stencil c = second_order_coefficients<axes>(points.data() + p, d);
        set_first_order_coefficients<axes>(parameters.data() + p, d, c);
        stencils[p] = c;
    });
}

}  // namespace

void assemble_stencils(const NodeLattice& lattice, const Nodes& points, const Nodes& parameters,
                       Stencils& stencils) {
    stencils.resize(lattice.extent.nodes());
    if (lattice.axes == 2) {
        assemble<2>(lattice, points, parameters, stencils);
    } else {
        assemble<3>(lattice, points, parameters, stencils);
    }
}

void apply_stencils(const NodeLattice& lattice, const Stencils& stencils, const Nodes& field,
                    Nodes& result) {
    const Strides d = lattice.strides;
    if (lattice.axes == 2) {
        for_interior(lattice, [&](std::size_t p) {
            result[p] = whole_operator<2>(stencils[p], field.data() + p, d);
        });
    } else {
        for_interior(lattice, [&](std::size_t p) {
            result[p] = whole_operator<3>(stencils[p], field.data() + p, d);
        });
    }
}

}  // namespace hexweave::bench
