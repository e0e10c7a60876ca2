// SPDX-License-Identifier: Apache-2.0
#include "geometry/control_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "geometry/knots.h"

namespace hexweave {

namespace {

/// One axis of a mesh: where its lines of points lie, and how the points of a line are stored.
struct Axis {
    std::vector<double> knots;
    std::size_t stride = 1;       ///< from a point to the next along this axis
    std::size_t lines = 1;        ///< of points along this axis
    std::size_t line_stride = 1;  ///< from a line to the next
    bool closed = false;

    std::size_t count() const { return knots.size(); }
    std::size_t at(std::size_t n, std::size_t line) const {
        return n * stride + line * line_stride;
    }
};

std::array<Axis, 2> axes_of(const ControlMesh& mesh) {
    const auto nu = static_cast<std::size_t>(mesh.count_u);
    const auto nv = static_cast<std::size_t>(mesh.count_v);
    std::array<Axis, 2> axes{Axis{std::vector<double>(nu, 0.0), 1, nv, nu},
                             Axis{std::vector<double>(nv, 0.0), nu, nu, 1}};
    for (Axis& axis : axes) {
        axis.closed = true;
        for (std::size_t line = 0; line < axis.lines; ++line) {
            axis.closed = axis.closed && mesh.points[axis.at(0, line)] ==
                                             mesh.points[axis.at(axis.count() - 1, line)];
        }
        for (std::size_t n = 1; n < axis.count(); ++n) {
            double sum = 0;
            for (std::size_t line = 0; line < axis.lines; ++line) {
                sum += distance(mesh.points[axis.at(n - 1, line)], mesh.points[axis.at(n, line)]);
            }
            axis.knots[n] = axis.knots[n - 1] + sum;
        }
        axis.closed = axis.closed && axis.count() > 3;
        const double whole = axis.knots.back();
        if (whole > 0) {
            for (double& knot : axis.knots) knot /= whole;
        }
    }
    return axes;
}

/// Which points the derivative at a knot is made of, and their weights.
struct Stencil {
    static constexpr std::size_t size = 5;
    std::array<std::size_t, size> points{};
    std::array<double, size> weights{};
    std::size_t count = 0;
};

/// The weights of the derivative at knots[at] of the polynomial through some points.
void set_weights(Stencil& stencil, const std::array<double, Stencil::size>& knots, std::size_t at) {
    for (std::size_t j = 0; j < stencil.count; ++j) {
        if (j == at) continue;
        double product = 1 / (knots[j] - knots[at]);
        for (std::size_t m = 0; m < stencil.count; ++m) {
            if (m != j && m != at) product *= (knots[at] - knots[m]) / (knots[j] - knots[m]);
        }
        stencil.weights[j] = product;
        stencil.weights[at] -= product;  // a constant has no derivative
    }
}

Stencil stencil_at(const Axis& axis, std::size_t n) {
    Stencil stencil;
    std::array<double, Stencil::size> knots{};
    const std::size_t last = axis.count() - 1;
    stencil.count = axis.closed ? Stencil::size : std::min(axis.count(), Stencil::size);
    if (axis.closed) {
        // The last point is the first, a period later.
        for (std::size_t m = 0; m < Stencil::size; ++m) {
            const std::size_t index = n + m + last - 2;
            stencil.points[m] = index % last;
            const std::size_t periods = index / last;
            knots[m] = axis.knots[index % last] + static_cast<double>(periods) - 1;
        }
        set_weights(stencil, knots, 2);
        return stencil;
    }
    const std::size_t first =
        std::min(n - std::min<std::size_t>(n, 2), axis.count() - stencil.count);
    for (std::size_t m = 0; m < stencil.count; ++m) {
        stencil.points[m] = first + m;
        knots[m] = axis.knots[first + m];
    }
    set_weights(stencil, knots, n - first);
    return stencil;
}

/// The derivatives along an axis of values at the points of a mesh.
std::vector<Vec3> slopes(const Axis& axis, const std::vector<Vec3>& values) {
    std::vector<Vec3> result(values.size());
    for (std::size_t n = 0; n < axis.count(); ++n) {
        const Stencil stencil = stencil_at(axis, n);
        for (std::size_t line = 0; line < axis.lines; ++line) {
            Vec3 sum;
            for (std::size_t m = 0; m < stencil.count; ++m) {
                sum += stencil.weights[m] * values[axis.at(stencil.points[m], line)];
            }
            result[axis.at(n, line)] = sum;
        }
    }
    return result;
}

/// The four cubics of Hermite on an interval, at a parameter: of the values at its begin and end
/// and of the derivatives there.
struct Hermite {
    std::size_t begin = 0;
    std::array<double, 2> value{};
    std::array<double, 2> slope{};
};

Hermite hermite(const std::vector<double>& knots, double t) {
    const std::size_t k = knot_interval(knots, t);
    const double h = knots[k + 1] - knots[k];
    const double x = (t - knots[k]) / h;
    const double y = 1 - x;
    return {k, {y * y * (1 + 2 * x), x * x * (3 - 2 * x)}, {h * x * y * y, -h * x * x * y}};
}

Hermite hermite_derivative(const std::vector<double>& knots, double t) {
    const std::size_t k = knot_interval(knots, t);
    const double h = knots[k + 1] - knots[k];
    const double x = (t - knots[k]) / h;
    const double y = 1 - x;
    return {k, {-6 * x * y / h, 6 * x * y / h}, {y * (1 - 3 * x), x * (3 * x - 2)}};
}

struct Interpolant {
    Axis u;
    Axis v;
    std::vector<Vec3> points;
    std::vector<Vec3> along_u;
    std::vector<Vec3> along_v;
    std::vector<Vec3> along_both;

    Vec3 sum(const Hermite& a, const Hermite& b) const {
        Vec3 total;
        for (std::size_t m = 0; m < 2; ++m) {
            for (std::size_t l = 0; l < 2; ++l) {
                const std::size_t n = a.begin + l + (b.begin + m) * u.count();
                total += b.value[m] * (a.value[l] * points[n] + a.slope[l] * along_u[n]) +
                         b.slope[m] * (a.value[l] * along_v[n] + a.slope[l] * along_both[n]);
            }
        }
        return total;
    }
};

}  // namespace

std::string fault_of(const ControlMesh& mesh) {
    if (mesh.count_u < 2 || mesh.count_v < 2) {
        return "a surface needs at least two points each way, not " + std::to_string(mesh.count_u) +
               " times " + std::to_string(mesh.count_v);
    }
    if (!std::all_of(mesh.points.begin(), mesh.points.end(), is_finite)) {
        return "a point is infinite";
    }
    const std::array<Axis, 2> axes = axes_of(mesh);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::vector<double>& knots = axes[axis].knots;
        for (std::size_t n = 1; n < knots.size(); ++n) {
            if (knots[n] - knots[n - 1] > 1e-14) continue;
            return std::string("the lines of points ") + std::to_string(n) + " and " +
                   std::to_string(n + 1) + (axis == 0 ? " of equal u" : " of equal v") +
                   " coincide";
        }
    }
    return {};
}

Surface control_surface(const ControlMesh& mesh) {
    auto [u, v] = axes_of(mesh);
    const std::vector<Vec3> along_u = slopes(u, mesh.points);
    const auto data = std::make_shared<const Interpolant>(
        Interpolant{u, v, mesh.points, along_u, slopes(v, mesh.points), slopes(v, along_u)});
    Surface surface;
    surface.position = [data](double a, double b) {
        return data->sum(hermite(data->u.knots, a), hermite(data->v.knots, b));
    };
    surface.derivative_u = [data](double a, double b) {
        return data->sum(hermite_derivative(data->u.knots, a), hermite(data->v.knots, b));
    };
    surface.derivative_v = [data](double a, double b) {
        return data->sum(hermite(data->u.knots, a), hermite_derivative(data->v.knots, b));
    };
    surface.closed_u = u.closed;
    surface.closed_v = v.closed;
    surface.breaks_u.assign(u.knots.begin() + 1, u.knots.end() - 1);
    surface.breaks_v.assign(v.knots.begin() + 1, v.knots.end() - 1);
    return surface;
}

}  // namespace hexweave
