// SPDX-License-Identifier: Apache-2.0
#include "elliptic/assembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/parallel.h"
#include "core/vectorized.h"

namespace hexweave {

namespace {

template <class Real, std::size_t N>
using Numbers = std::array<Real, N>;

/// body(0) .. body(N - 1), written out: a loop inside the loop over nodes would keep the compiler
/// from using vector instructions for that.
template <std::size_t N, class Body>
[[gnu::always_inline]] inline void unrolled(Body&& body) {
    [&]<std::size_t... n>(std::index_sequence<n...>) __attribute__((always_inline)) {
        (body(n), ...);
    }
    (std::make_index_sequence<N>{});
}

template <class Real>
[[gnu::always_inline]] inline Real inner(const Numbers<Real, 2>& a, const Numbers<Real, 2>& b) {
    return a[0] * b[0] + a[1] * b[1];
}

template <class Real>
[[gnu::always_inline]] inline Real inner(const Numbers<Real, 3>& a, const Numbers<Real, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
[[gnu::always_inline]] inline Numbers<Real, 3> outer(const Numbers<Real, 3>& a,
                                                     const Numbers<Real, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// How to reach a node's neighbours in `points` and `parameters`.
struct Reach {
    std::ptrdiff_t previous;
    std::ptrdiff_t next;
    std::ptrdiff_t stride_j;
    std::ptrdiff_t stride_k;
};

/// The differences of a field at one node: first (v+ - v-), second (v+ - 2 v + v-) and mixed
/// (v++ - v+- - v-+ + v--), the latter in the planes (i, j), (i, k), (j, k).
template <class Real, std::size_t axes>
struct Differences {
    std::array<Real, axes> first;
    std::array<Real, axes> second;
    std::array<Real, axes == 3 ? 3 : 1> mixed;
};

/// Differences are taken in double whatever comes after: strongly clustered points have few digits
/// of their own.
template <class Real, std::size_t axes>
[[gnu::always_inline]] inline Differences<Real, axes> differences(const double* v, const Reach& d) {
    const std::ptrdiff_t p = d.previous;
    const std::ptrdiff_t n = d.next;
    const std::ptrdiff_t j = d.stride_j;
    Differences<Real, axes> r;
    r.first[0] = static_cast<Real>(v[n] - v[p]);
    r.first[1] = static_cast<Real>(v[j] - v[-j]);
    // Differences of differences: of strongly clustered parameters they keep their digits.
    r.second[0] = static_cast<Real>((v[n] - v[0]) - (v[0] - v[p]));
    r.second[1] = static_cast<Real>((v[j] - v[0]) - (v[0] - v[-j]));
    r.mixed[0] = static_cast<Real>((v[n + j] - v[n - j]) - (v[p + j] - v[p - j]));
    if constexpr (axes == 3) {
        const std::ptrdiff_t k = d.stride_k;
        r.first[2] = static_cast<Real>(v[k] - v[-k]);
        r.second[2] = static_cast<Real>((v[k] - v[0]) - (v[0] - v[-k]));
        r.mixed[1] = static_cast<Real>((v[n + k] - v[n - k]) - (v[p + k] - v[p - k]));
        r.mixed[2] = static_cast<Real>((v[j + k] - v[j - k]) - (v[k - j] - v[-j - k]));
    }
    return r;
}

/// The operator at one node, its centre -1, and 2 (alpha^11 + alpha^22 + alpha^33) over the
/// determinant of the parameters' first differences.
template <class Real, std::size_t axes>
struct Coefficients {
    std::array<Real, axes> second;
    std::array<Real, axes == 3 ? 3 : 1> mixed;
    std::array<Real, axes> first;
};

template <class Real, std::size_t axes>
[[gnu::always_inline]] inline Real second_order_part(const Coefficients<Real, axes>& c,
                                                     const Differences<Real, axes>& v) {
    Real sum = c.second[0] * v.second[0] + c.second[1] * v.second[1] + c.mixed[0] * v.mixed[0];
    if constexpr (axes == 3) {
        sum += c.second[2] * v.second[2] + c.mixed[1] * v.mixed[1] + c.mixed[2] * v.mixed[2];
    }
    return sum;
}

template <class Real, std::size_t axes>
[[gnu::always_inline]] inline Real whole_operator(const Coefficients<Real, axes>& c,
                                                  const Differences<Real, axes>& v) {
    Real sum =
        second_order_part<Real, axes>(c, v) + c.first[0] * v.first[0] + c.first[1] * v.first[1];
    if constexpr (axes == 3) sum += c.first[2] * v.first[2];
    return sum;
}

/// alpha^ij / (2 (alpha^11 + ..)): on a face from the base vectors [eq. (42)], in a block as inner
/// products of their cross products, the cofactors of eq. (87) without cancellation. Where the
/// points have collapsed so far that all are zero: those of a uniform orthogonal grid.
template <class Real, std::size_t axes, std::size_t components>
[[gnu::always_inline]] inline Real set_second_order(
    const std::array<Differences<Real, axes>, components>& x, Coefficients<Real, axes>& c) {
    Numbers<Real, components> a1;
    Numbers<Real, components> a2;
    unrolled<components>([&](std::size_t n) __attribute__((always_inline)) {
        a1[n] = x[n].first[0];
        a2[n] = x[n].first[1];
    });
    if constexpr (axes == 2) {
        c.second = {inner(a2, a2), inner(a1, a1)};
        c.mixed = {-inner(a1, a2)};
    } else {
        const Numbers<Real, 3> a3{x[0].first[2], x[1].first[2], x[2].first[2]};
        const Numbers<Real, 3> b1 = outer(a2, a3);
        const Numbers<Real, 3> b2 = outer(a3, a1);
        const Numbers<Real, 3> b3 = outer(a1, a2);
        c.second = {inner(b1, b1), inner(b2, b2), inner(b3, b3)};
        c.mixed = {inner(b1, b2), inner(b1, b3), inner(b2, b3)};
    }
    Real sum = c.second[0] + c.second[1];
    if constexpr (axes == 3) sum += c.second[2];
    const bool collapsed = !(sum > 0);
    const Real inverse = Real(0.5) / (collapsed ? Real(1) : sum);
    unrolled<axes>([&](std::size_t n) __attribute__((always_inline)) {
        c.second[n] = collapsed ? Real(0.5) / static_cast<Real>(axes) : c.second[n] * inverse;
    });
    unrolled<axes == 3 ? 3 : 1>([&](std::size_t n) __attribute__((always_inline)) {
        c.mixed[n] *= Real(0.5) * inverse;  // 2 alpha^ij, over the 4 of the difference
    });
    return 2 * sum;
}

/// Chooses first[] such that the operator annihilates s, t (and u): Cramer's rule for
/// T (S, T, U) = -w with the columns of T the first differences of the parameters.
template <class Real, std::size_t axes>
[[gnu::always_inline]] inline Real set_first_order(
    const std::array<Differences<Real, axes>, axes>& s, Coefficients<Real, axes>& c) {
    Numbers<Real, axes> w;
    unrolled<axes>([&](std::size_t n) __attribute__((always_inline)) {
        w[n] = second_order_part<Real, axes>(c, s[n]);
    });
    if constexpr (axes == 2) {
        const Numbers<Real, 2> t1{s[0].first[0], s[1].first[0]};
        const Numbers<Real, 2> t2{s[0].first[1], s[1].first[1]};
        const Real determinant = t1[0] * t2[1] - t2[0] * t1[1];
        const Real inverse = 1 / (determinant == 0 ? Real(1) : determinant);
        c.first = {(t2[0] * w[1] - w[0] * t2[1]) * inverse,
                   (w[0] * t1[1] - t1[0] * w[1]) * inverse};
        return determinant;
    } else {
        const Numbers<Real, 3> t1{s[0].first[0], s[1].first[0], s[2].first[0]};
        const Numbers<Real, 3> t2{s[0].first[1], s[1].first[1], s[2].first[1]};
        const Numbers<Real, 3> t3{s[0].first[2], s[1].first[2], s[2].first[2]};
        const Numbers<Real, 3> b1 = outer(t2, t3);
        const Real determinant = inner(t1, b1);
        const Real inverse = 1 / (determinant == 0 ? Real(1) : determinant);
        c.first = {-inner(w, b1) * inverse, -inner(w, outer(t3, t1)) * inverse,
                   -inner(w, outer(t1, t2)) * inverse};
        return determinant;
    }
}

constexpr int strip_rows = 8;

/// The arrays of one row; components follow one another at the distance `length`.
struct Row {
    const double* points;
    const double* parameters;
    float* stencils;
    float* weights;
    float* residuals;
    double* right_hand_sides;
    std::ptrdiff_t length;
};

template <class Real, std::size_t axes, std::size_t components, Assembly wanted, RightHandSide side>
HEXWEAVE_VECTORIZED void assemble_segment(const Row& row, const RowSegment& segment,
                                          Reach in_points, Reach in_parameters, double scale) {
    using Layout = StencilLayout<static_cast<int>(axes)>;
    constexpr std::size_t planes = Layout::first - Layout::mixed;
    const double* const points = row.points;
    const double* const parameters = row.parameters;
    const std::ptrdiff_t length = row.length;
    float* const stencils = row.stencils;
    float* const weights = row.weights;
    float* const residuals = row.residuals;
    double* const right_hand_sides = row.right_hand_sides;
    const std::ptrdiff_t end = segment.first + segment.count;
    HEXWEAVE_INDEPENDENT_ITERATIONS
    for (std::ptrdiff_t p = segment.first; p < end; ++p) {
        std::array<Differences<Real, axes>, components> x;
        std::array<Differences<Real, axes>, axes> s;
        unrolled<components>([&](std::size_t n) __attribute__((always_inline)) {
            x[n] = differences<Real, axes>(points + static_cast<std::ptrdiff_t>(n) * length + p,
                                           in_points);
        });
        unrolled<axes>([&](std::size_t n) __attribute__((always_inline)) {
            s[n] = differences<Real, axes>(parameters + static_cast<std::ptrdiff_t>(n) * length + p,
                                           in_parameters);
        });
        Coefficients<Real, axes> c;
        const Real centre = set_second_order<Real, axes, components>(x, c);
        const Real determinant = std::abs(set_first_order<Real, axes>(s, c));
        const Real weight =
            static_cast<Real>(scale) * centre / (determinant > 0 ? determinant : Real(1));
        const Real safe_weight = weight > 0 ? weight : Real(1);
        if constexpr (wanted == Assembly::residuals_and_stencils) {
            float* const second = stencils + Layout::second * length + p;
            float* const mixed = stencils + Layout::mixed * length + p;
            float* const first = stencils + Layout::first * length + p;
            unrolled<axes>([&](std::size_t n) __attribute__((always_inline)) {
                const auto offset = static_cast<std::ptrdiff_t>(n) * length;
                second[offset] = static_cast<float>(c.second[n]);
                first[offset] = static_cast<float>(c.first[n]);
            });
            unrolled<planes>([&](std::size_t n) __attribute__((always_inline)) {
                mixed[static_cast<std::ptrdiff_t>(n) * length] = static_cast<float>(c.mixed[n]);
            });
        }
        weights[p] = static_cast<float>(weight);
        unrolled<components>([&](std::size_t n) __attribute__((always_inline)) {
            const Real value = whole_operator<Real, axes>(c, x[n]);
            const std::ptrdiff_t at = p + static_cast<std::ptrdiff_t>(n) * length;
            if constexpr (side == RightHandSide::zero) {
                residuals[at] = static_cast<float>(-value);
            } else if constexpr (side == RightHandSide::given) {
                residuals[at] = static_cast<float>(
                    static_cast<Real>(right_hand_sides[at]) / safe_weight - value);
            } else {
                const Real integrated = static_cast<Real>(residuals[at]);
                right_hand_sides[at] = static_cast<double>(safe_weight * value + integrated);
                residuals[at] = static_cast<float>(integrated / safe_weight);
            }
        });
    }
}

/// Zeros at the boundary nodes of the row and in its padding: there relaxation comes to nothing.
void clear_ends(const RowShape& shape, float* row, int components) {
    const int ni = shape.nodes();
    const auto segments = shape.segments();
    for (int c = 0; c < components; ++c, row += shape.length()) {
        row[0] = 0;
        row[shape.at(ni - 1)] = 0;
        for (std::ptrdiff_t p = (ni + 1) / 2; p < segments[0].count; ++p) row[p] = 0;
        for (std::ptrdiff_t p = ni / 2; p < segments[1].count; ++p) row[segments[1].first + p] = 0;
    }
}

template <bool written, class T>
void prefetch(const T* p, std::ptrdiff_t count) {
    constexpr std::ptrdiff_t per_cache_line = 64 / sizeof(T);
    for (std::ptrdiff_t n = 0; n < count; n += per_cache_line) {
        __builtin_prefetch(p + n, written ? 1 : 0);
    }
}

/// Asks for what row j of the next layer will read and write that this one does not.
void prefetch_next_layer(Level& level, Assembly wanted, int j, int k) {
    if (k + 2 >= level.extent.nk) return;
    const std::ptrdiff_t length = level.shape.length();
    prefetch<false>(level.points.row(j, k + 2), 3 * length);
    prefetch<false>(level.parameters.row(j, k + 2), 3 * length);
    if (wanted == Assembly::residuals_and_stencils) {
        prefetch<true>(level.stencils.row(j, k + 1), StencilLayout<3>::size * length);
    }
    prefetch<true>(level.residuals.row(j, k + 1), 3 * length);
    prefetch<true>(level.weights.row(j, k + 1), length);
}

template <class Real, std::size_t axes, std::size_t components, Assembly wanted, RightHandSide side>
void assemble_rows(Level& level, double scale) {
    const Extent& e = level.extent;
    const auto segments = level.shape.segments();
    const int layers = level.last_k() - level.first_k() + 1;
    // Strips of rows, through all layers: what one layer read of its neighbours is still in cache
    // for the next.
    const int strips = (e.nj - 2 + strip_rows - 1) / strip_rows;
    parallel_blocks(strips * layers, strip_rows * e.ni * 30, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const int k = level.first_k() + n % layers;
            const int first = 1 + n / layers * strip_rows;
            const int last = std::min(first + strip_rows, e.nj - 1);
            for (int j = first; j < last; ++j) {
                if constexpr (axes == 3) prefetch_next_layer(level, wanted, j, k);
                const Row row{
                    level.points.row(j, k),
                    level.parameters.row(j, k),
                    level.stencils.row(j, k),
                    level.weights.row(j, k),
                    level.residuals.row(j, k),
                    side == RightHandSide::zero ? nullptr : level.right_hand_sides.row(j, k),
                    level.shape.length()};
                for (const RowSegment& segment : segments) {
                    assemble_segment<Real, axes, components, wanted, side>(
                        row, segment,
                        {segment.previous, segment.next, level.points.stride_j(),
                         level.points.stride_k()},
                        {segment.previous, segment.next, level.parameters.stride_j(),
                         level.parameters.stride_k()},
                        scale);
                }
                if constexpr (wanted == Assembly::residuals_and_stencils) {
                    clear_ends(level.shape, row.stencils,
                               StencilLayout<static_cast<int>(axes)>::size);
                }
                clear_ends(level.shape, row.weights, 1);
                clear_ends(level.shape, row.residuals, components);
            }
        }
    });
}

template <class Real, std::size_t axes, std::size_t components, Assembly wanted>
void assemble_sided(Level& level, RightHandSide side, double scale) {
    switch (side) {
        case RightHandSide::zero:
            return assemble_rows<Real, axes, components, wanted, RightHandSide::zero>(level, scale);
        case RightHandSide::given:
            return assemble_rows<Real, axes, components, wanted, RightHandSide::given>(level,
                                                                                       scale);
        case RightHandSide::from_residual:
            return assemble_rows<Real, axes, components, wanted, RightHandSide::from_residual>(
                level, scale);
    }
}

template <class Real, std::size_t axes, std::size_t components>
void assemble_wanted(Level& level, const AssemblyOptions& options, double scale) {
    if (options.wanted == Assembly::residuals) {
        assemble_sided<Real, axes, components, Assembly::residuals>(level, options.side, scale);
    } else {
        assemble_sided<Real, axes, components, Assembly::residuals_and_stencils>(
            level, options.side, scale);
    }
}

template <std::size_t axes, std::size_t components>
void assemble_precise(Level& level, const AssemblyOptions& options, double scale) {
    if (options.precise) {
        assemble_wanted<double, axes, components>(level, options, scale);
    } else {
        assemble_wanted<float, axes, components>(level, options, scale);
    }
}

}  // namespace

void assemble(Level& level, const AssemblyOptions& options, double scale) {
    if (level.axes == 3) {
        assemble_precise<3, 3>(level, options, scale);
    } else if (level.components == 3) {
        assemble_precise<2, 3>(level, options, scale);
    } else {
        assemble_precise<2, 2>(level, options, scale);
    }
}

}  // namespace hexweave
