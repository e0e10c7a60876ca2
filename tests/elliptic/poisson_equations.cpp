// SPDX-License-Identifier: Apache-2.0
#include "elliptic/poisson_equations.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexweave::shapes {

namespace {

/// First and second derivatives to the indices, by central differences: d[a], dd[a][b].
struct Derivatives {
    std::array<Vec3, 3> d;
    std::array<std::array<Vec3, 3>, 3> dd;
};

template <class At>
Derivatives derivatives(int axes, const At& at) {
    Derivatives r;
    const auto moved = [&](int a, int by_a, int b, int by_b) {
        std::array<int, 3> n{0, 0, 0};
        n[static_cast<std::size_t>(a)] += by_a;
        n[static_cast<std::size_t>(b)] += by_b;
        return at(n[0], n[1], n[2]);
    };
    const Vec3 here = at(0, 0, 0);
    for (int a = 0; a < axes; ++a) {
        const auto p = static_cast<std::size_t>(a);
        const Vec3 up = moved(a, 1, a, 0);
        const Vec3 down = moved(a, -1, a, 0);
        r.d[p] = 0.5 * (up - down);
        r.dd[p][p] = (up - here) - (here - down);
        for (int b = 0; b < axes; ++b) {
            if (b == a) continue;
            r.dd[p][static_cast<std::size_t>(b)] =
                0.25 * ((moved(a, 1, b, 1) - moved(a, 1, b, -1)) -
                        (moved(a, -1, b, 1) - moved(a, -1, b, -1)));
        }
    }
    return r;
}

/// The solution c of c1 t1 + c2 t2 + c3 t3 = v.
Vec3 combination(const std::array<Vec3, 3>& t, const Vec3& v) {
    const double whole = triple(t[0], t[1], t[2]);
    return {triple(v, t[1], t[2]) / whole, triple(t[0], v, t[2]) / whole,
            triple(t[0], t[1], v) / whole};
}

/// alpha^ij of eq. (42), as a face's, or (87): cofactors of the metric a_ij.
std::array<std::array<double, 3>, 3> alpha(const std::array<Vec3, 3>& x, int axes) {
    const auto a = [&](std::size_t i, std::size_t j) { return dot(x[i], x[j]); };
    if (axes == 2) return {{{a(1, 1), -a(0, 1), 0}, {-a(0, 1), a(0, 0), 0}, {0, 0, 0}}};
    const double a12 = a(0, 2) * a(1, 2) - a(0, 1) * a(2, 2);
    const double a13 = a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1);
    const double a23 = a(0, 1) * a(0, 2) - a(1, 2) * a(0, 0);
    return {{{a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2), a12, a13},
             {a12, a(0, 0) * a(2, 2) - a(0, 2) * a(0, 2), a23},
             {a13, a23, a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1)}}};
}

Derivatives of_points(const PointField& points, int i, int j, int k) {
    return derivatives(points.extent().nk == 1 ? 2 : 3,
                       [&](int a, int b, int c) { return points(i + a, j + b, k + c); });
}

}  // namespace

Vec3 unfulfilled(const PointField& points, const ParameterField& parameters, int i, int j, int k) {
    const int axes = points.extent().nk == 1 ? 2 : 3;
    const Derivatives x = of_points(points, i, j, k);
    Derivatives s = derivatives(axes, [&](int a, int b, int c) {
        return Vec3{parameters.s(i + a, j + b, k + c), parameters.t(i + a, j + b, k + c),
                    axes == 3 ? parameters.u(i + a, j + b, k + c) : 0};
    });
    if (axes == 2) s.d[2] = {0, 0, 1};
    const auto coefficient = alpha(x.d, axes);
    Vec3 sum;
    double diagonal = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(axes); ++a) {
        for (std::size_t b = 0; b < static_cast<std::size_t>(axes); ++b) {
            const Vec3 control = combination(s.d, -s.dd[a][b]);
            sum += coefficient[a][b] *
                   (x.dd[a][b] + control.x * x.d[0] + control.y * x.d[1] + control.z * x.d[2]);
        }
        diagonal += 2 * coefficient[a][a];
    }
    return sum / diagonal;
}

double largest_unfulfilled(const PointField& points, const ParameterField& parameters) {
    const Extent e = points.extent();
    const bool is_face = e.nk == 1;
    double largest = 0;
    for (int k = is_face ? 0 : 1; k < (is_face ? 1 : e.nk - 1); ++k) {
        for (int j = 1; j < e.nj - 1; ++j) {
            for (int i = 1; i < e.ni - 1; ++i) {
                std::array<Vec3, 3> frame = of_points(points, i, j, k).d;
                if (is_face) {
                    const Vec3 normal = cross(frame[0], frame[1]);
                    frame[2] = normal / std::sqrt(norm(normal));
                }
                const Vec3 cells = combination(frame, unfulfilled(points, parameters, i, j, k));
                for (const double component : {cells.x, cells.y, cells.z}) {
                    if (!(std::abs(component) <= largest)) largest = std::abs(component);
                }
            }
        }
    }
    return largest;
}

}  // namespace hexweave::shapes
