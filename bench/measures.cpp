// SPDX-License-Identifier: Apache-2.0
#include "bench/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/multiblock.h"
#include "quality/measure.h"

namespace hexweave::bench {

namespace {

using Triple = std::array<double, 3>;

template <class Visit>
void for_each_interior(const Extent& e, Visit&& visit) {
    const bool is_face = e.nk == 1;
    for (int k = is_face ? 0 : 1; k < (is_face ? 1 : e.nk - 1); ++k) {
        for (int j = 1; j < e.nj - 1; ++j) {
            for (int i = 1; i < e.ni - 1; ++i) visit(Node{i, j, k});
        }
    }
}

Node moved(Node node, int axis, int by) {
    node[static_cast<std::size_t>(axis)] += by;
    return node;
}

template <class Values>
auto at(const Values& values, const Node& n) {
    return values(n[0], n[1], n[2]);
}

Vec3 base_vector(const PointField& x, const Node& n, int axis) {
    return 0.5 * (at(x, moved(n, axis, 1)) - at(x, moved(n, axis, -1)));
}

/// The contravariant base vectors at a node; on a face the third is the unit normal over the root
/// of the cell's area.
std::array<Vec3, 3> contravariant(const PointField& x, const Node& n) {
    const Vec3 a1 = base_vector(x, n, 0);
    const Vec3 a2 = base_vector(x, n, 1);
    if (x.extent().nk > 1) {
        const Vec3 a3 = base_vector(x, n, 2);
        const double volume = triple(a1, a2, a3);
        return {cross(a2, a3) / volume, cross(a3, a1) / volume, cross(a1, a2) / volume};
    }
    const Vec3 normal = cross(a1, a2);
    const double area = norm(normal);
    return {cross(a2, normal) / (area * area), cross(normal, a1) / (area * area),
            normal / (area * std::sqrt(area))};
}

/// The larger, or NaN where either is.
double larger(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

double in_cells(const std::array<Vec3, 3>& contravariant, const Vec3& d) {
    double size = 0;
    for (const Vec3& a : contravariant) size = larger(std::abs(dot(a, d)), size);
    return size;
}

bool is_planar(const PointField& x) {
    for (std::size_t p = 0; p < x.extent().nodes(); ++p) {
        if (x.z[p] != x.z[0]) return false;
    }
    return true;
}

/// The second derivative along axes a and b of one component or of points.
template <class Values>
auto second_derivative(const Values& v, const Node& n, int a, int b) {
    if (a == b) {
        return (at(v, moved(n, a, 1)) - at(v, n)) - (at(v, n) - at(v, moved(n, a, -1)));
    }
    const Node up = moved(n, a, 1);
    const Node down = moved(n, a, -1);
    return 0.25 * ((at(v, moved(up, b, 1)) - at(v, moved(up, b, -1))) -
                   (at(v, moved(down, b, 1)) - at(v, moved(down, b, -1))));
}

double first_derivative(const Field& v, const Node& n, int axis) {
    return 0.5 * (at(v, moved(n, axis, 1)) - at(v, moved(n, axis, -1)));
}

/// Solves T p = -r by Gaussian elimination with pivots; `size` is 2 or 3.
Triple solve_small(std::array<Triple, 3> t, Triple r, std::size_t size) {
    for (std::size_t c = 0; c < size; ++c) {
        std::size_t pivot = c;
        for (std::size_t k = c; k < size; ++k) {
            if (std::abs(t[k][c]) > std::abs(t[pivot][c])) pivot = k;
        }
        std::swap(t[c], t[pivot]);
        std::swap(r[c], r[pivot]);
        for (std::size_t k = c + 1; k < size; ++k) {
            const double factor = t[k][c] / t[c][c];
            for (std::size_t m = c; m < size; ++m) t[k][m] -= factor * t[c][m];
            r[k] -= factor * r[c];
        }
    }
    Triple p{};
    for (std::size_t c = size; c-- > 0;) {
        double sum = -r[c];
        for (std::size_t m = c + 1; m < size; ++m) sum -= t[c][m] * p[m];
        p[c] = sum / t[c][c];
    }
    return p;
}

/// P_ab of one node: the control functions of the composite map.
Triple control_function(const ParameterField& s, const Node& n, int a, int b, int axes) {
    const std::array<const Field*, 3> fields{&s.s, &s.t, &s.u};
    std::array<Triple, 3> t{};
    Triple r{};
    for (std::size_t c = 0; c < static_cast<std::size_t>(axes); ++c) {
        for (int axis = 0; axis < axes; ++axis) {
            t[c][static_cast<std::size_t>(axis)] = first_derivative(*fields[c], n, axis);
        }
        r[c] = second_derivative(*fields[c], n, a, b);
    }
    return solve_small(t, r, static_cast<std::size_t>(axes));
}

/// J^2 a^ab: cofactors of the covariant metric tensor. They are taken of the base vectors
/// themselves, which keeps their digits in thin cells.
double metric(const std::array<Vec3, 3>& base, int a, int b, int axes) {
    if (axes == 2) {
        const double product =
            dot(base[static_cast<std::size_t>(1 - a)], base[static_cast<std::size_t>(1 - b)]);
        return a == b ? product : -product;
    }
    const auto area = [&](int axis) {
        const auto n = static_cast<std::size_t>(axis);
        return cross(base[(n + 1) % 3], base[(n + 2) % 3]);
    };
    return dot(area(a), area(b));
}

double node_residual(const PointField& x, const ParameterField& parameters, const Node& n) {
    const int axes = x.extent().nk == 1 ? 2 : 3;
    std::array<Vec3, 3> base{};
    for (int a = 0; a < axes; ++a) base[static_cast<std::size_t>(a)] = base_vector(x, n, a);
    Vec3 residual;
    double centre = 0;
    for (int a = 0; a < axes; ++a) {
        centre += 2 * metric(base, a, a, axes);
        for (int b = 0; b < axes; ++b) {
            Vec3 term = second_derivative(x, n, a, b);
            const Triple p = control_function(parameters, n, a, b, axes);
            for (std::size_t c = 0; c < 3; ++c) term += p[c] * base[c];
            residual += metric(base, a, b, axes) * term;
        }
    }
    return in_cells(contravariant(x, n), residual / centre);
}

}  // namespace

GridQuality grid_quality(const PointField& points) {
    const bool planar = points.extent().nk == 1 && is_planar(points);
    const ZoneMeasure zone = measure_zone({"", points}, planar ? 2 : 3);
    return {static_cast<long>(zone.folded), static_cast<long>(zone.flat_corners),
            zone.worst_scaled_jacobian};
}

double error_in_cells(const PointField& points, const PointField& reference) {
    double error = 0;
    for_each_interior(reference.extent(), [&](const Node& n) {
        const Vec3 d = at(points, n) - at(reference, n);
        error = larger(in_cells(contravariant(reference, n), d), error);
    });
    return error;
}

double size_ratio_where_moved(const PointField& points, const PointField& other) {
    const int axes = points.extent().nk == 1 ? 2 : 3;
    const auto differs = [&](const Node& n) { return !(at(points, n) == at(other, n)); };
    double largest = 1;
    for_each_interior(points.extent(), [&](const Node& n) {
        for (int axis = 0; axis < axes; ++axis) {
            const Node up = moved(n, axis, 1);
            const Node down = moved(n, axis, -1);
            if (!differs(n) && !differs(up) && !differs(down)) continue;
            const double ahead = distance(at(points, n), at(points, up));
            const double behind = distance(at(points, n), at(points, down));
            largest = larger(std::max(ahead, behind) / std::min(ahead, behind), largest);
        }
    });
    return largest;
}

double residual_in_cells(const PointField& points, const ParameterField& parameters) {
    double residual = 0;
    for_each_interior(points.extent(), [&](const Node& n) {
        residual = larger(node_residual(points, parameters, n), residual);
    });
    return residual;
}

}  // namespace hexweave::bench
