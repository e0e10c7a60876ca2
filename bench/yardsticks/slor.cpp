// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/slor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bench/yardsticks/node_lattice.h"

namespace hexweave::bench {

namespace {

/// A look at the grid costs about two sweeps of waiting; so often is often enough.
constexpr int least_sweeps_between_looks = 5;
constexpr double looks_per_sweep = 0.02;

/// Nodes with the line direction fastest, components apart, so that the work along a line
/// vectorises. `out` is the axis across the lines that steps fastest, `slow` the third axis.
struct Layout {
    int axes = 0;
    int length = 0;           ///< nodes of a line
    std::ptrdiff_t out = 0;   ///< to the neighbour line along j (block) or i (face)
    std::ptrdiff_t slow = 0;  ///< to the neighbour line along i (block)

    explicit Layout(const Extent& e)
        : axes(e.nk == 1 ? 2 : 3),
          length(axes == 2 ? e.nj : e.nk),
          out(length),
          slow(axes == 2 ? 0 : static_cast<std::ptrdiff_t>(length) * e.nj) {}

    std::size_t offset(int i, int j, int k) const {
        const std::ptrdiff_t line = axes == 2 ? i * out : i * slow + j * out;
        return static_cast<std::size_t>(line + (axes == 2 ? j : k));
    }
};

using Components = std::array<std::vector<double>, 3>;

/// Coefficients of the operator along one line, and its residual.
struct Line {
    std::array<std::vector<double>, 3> residual;
    std::vector<double> lower, centre, upper, ratio;

    explicit Line(std::size_t length)
        : lower(length), centre(length), upper(length), ratio(length) {
        for (auto& r : residual) r.resize(length);
    }
};

/// The six (three) second-order pairs of axes in the order 11, 22, 33, 12, 13, 23 (11, 22, 12).
template <std::size_t axes>
constexpr std::size_t pairs = axes == 2 ? 3 : 6;

/// Control functions: of every pair, one per axis; those of mixed pairs counted twice.
template <std::size_t axes>
using Controls = std::array<std::vector<double>, pairs<axes> * axes>;

template <std::size_t axes>
struct Differences {
    std::array<double, axes> first;
    std::array<double, pairs<axes>> second;
};

/// Central differences of one component; first differences are doubled, mixed ones are whole.
template <std::size_t axes>
[[gnu::always_inline]] inline Differences<axes> differences(const double* v, const Layout& layout) {
    const std::ptrdiff_t a = layout.out;
    if constexpr (axes == 2) {
        return {{v[a] - v[-a], v[1] - v[-1]},
                {(v[a] - v[0]) - (v[0] - v[-a]), (v[1] - v[0]) - (v[0] - v[-1]),
                 0.25 * ((v[a + 1] - v[a - 1]) - (v[1 - a] - v[-a - 1]))}};
    } else {
        const std::ptrdiff_t b = layout.slow;
        return {{v[b] - v[-b], v[a] - v[-a], v[1] - v[-1]},
                {(v[b] - v[0]) - (v[0] - v[-b]), (v[a] - v[0]) - (v[0] - v[-a]),
                 (v[1] - v[0]) - (v[0] - v[-1]),
                 0.25 * ((v[b + a] - v[b - a]) - (v[a - b] - v[-a - b])),
                 0.25 * ((v[b + 1] - v[b - 1]) - (v[1 - b] - v[-b - 1])),
                 0.25 * ((v[a + 1] - v[a - 1]) - (v[1 - a] - v[-a - 1]))}};
    }
}

template <std::size_t axes>
class LineRelaxation {
public:
    LineRelaxation(const Problem& problem, double relaxation);

    void sweep();
    void copy(PointField& to) const;

private:
    void set_controls(const Components& parameters);
    void assemble(std::size_t line);
    void relax(std::size_t line);

    Extent extent_;
    Layout layout_;
    double relaxation_;
    Components x_;
    Controls<axes> controls_;
    Line line_;
};

template <std::size_t axes>
LineRelaxation<axes>::LineRelaxation(const Problem& problem, double relaxation)
    : extent_(problem.points.extent()),
      layout_(extent_),
      relaxation_(relaxation),
      line_(static_cast<std::size_t>(layout_.length)) {
    Components parameters;
    const std::array<const Field*, 3> from{&problem.points.x, &problem.points.y, &problem.points.z};
    const std::array<const Field*, 3> from_parameters{&problem.parameters.s, &problem.parameters.t,
                                                      &problem.parameters.u};
    for (std::size_t c = 0; c < 3; ++c) {
        x_[c].resize(extent_.nodes());
        if (c < axes) parameters[c].resize(extent_.nodes());
        for (int k = 0; k < extent_.nk; ++k) {
            for (int j = 0; j < extent_.nj; ++j) {
                for (int i = 0; i < extent_.ni; ++i) {
                    const std::size_t p = layout_.offset(i, j, k);
                    x_[c][p] = (*from[c])(i, j, k);
                    if (c < axes) parameters[c][p] = (*from_parameters[c])(i, j, k);
                }
            }
        }
    }
    set_controls(parameters);
}

/// P_ij = -T^-1 s_ij by Cramer's rule. [Spekreijse & Boerstoel 1996, eqs. (19), (83)]
template <std::size_t axes>
void LineRelaxation<axes>::set_controls(const Components& parameters) {
    for (auto& control : controls_) control.resize(extent_.nodes());
    const NodeLattice lattice(extent_);
    for_interior(lattice, [&](std::size_t node) {
        const int i = static_cast<int>(node % static_cast<std::size_t>(extent_.ni));
        const auto rest = node / static_cast<std::size_t>(extent_.ni);
        const int j = static_cast<int>(rest % static_cast<std::size_t>(extent_.nj));
        const int k = static_cast<int>(rest / static_cast<std::size_t>(extent_.nj));
        const std::size_t p = layout_.offset(i, j, k);
        std::array<Differences<axes>, axes> d;
        for (std::size_t c = 0; c < axes; ++c) {
            d[c] = differences<axes>(parameters[c].data() + p, layout_);
        }
        std::array<Vec3, 3> t{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
        for (std::size_t axis = 0; axis < axes; ++axis) {
            t[axis] = {0.5 * d[0].first[axis], 0.5 * d[1].first[axis],
                       axes == 3 ? 0.5 * d[axes - 1].first[axis] : 0};
        }
        const double determinant = triple(t[0], t[1], t[2]);
        for (std::size_t m = 0; m < pairs<axes>; ++m) {
            const Vec3 w{d[0].second[m], d[1].second[m], axes == 3 ? d[axes - 1].second[m] : 0};
            const double factor = (m < axes ? -1 : -2) / determinant;
            const std::array<double, 3> solution{factor * triple(w, t[1], t[2]),
                                                 factor * triple(t[0], w, t[2]),
                                                 factor * triple(t[0], t[1], w)};
            for (std::size_t axis = 0; axis < axes; ++axis) {
                controls_[m * axes + axis][p] = solution[axis];
            }
        }
    });
}

/// Coefficients and residual at the inner nodes of the line that starts at offset `line`.
template <std::size_t axes>
void LineRelaxation<axes>::assemble(std::size_t line) {
    const double* x = x_[0].data() + line;
    const double* y = x_[1].data() + line;
    const double* z = x_[2].data() + line;
    std::array<const double*, pairs<axes> * axes> control;
    for (std::size_t m = 0; m < control.size(); ++m) control[m] = controls_[m].data() + line;
    double* lower = line_.lower.data();
    double* centre = line_.centre.data();
    double* upper = line_.upper.data();
    double* rx = line_.residual[0].data();
    double* ry = line_.residual[1].data();
    double* rz = line_.residual[2].data();
    const Layout layout = layout_;
#pragma GCC ivdep
    for (int n = 1; n < layout.length - 1; ++n) {
        const Differences<axes> dx = differences<axes>(x + n, layout);
        const Differences<axes> dy = differences<axes>(y + n, layout);
        const Differences<axes> dz = differences<axes>(z + n, layout);
        std::array<double, pairs<axes>> metric;
        std::array<Vec3, 3> a;
        for (std::size_t m = 0; m < axes; ++m) a[m] = {dx.first[m], dy.first[m], dz.first[m]};
        if constexpr (axes == 2) {
            metric = {dot(a[1], a[1]), dot(a[0], a[0]), -dot(a[0], a[1])};
        } else {
            const Vec3 b1 = cross(a[1], a[2]);
            const Vec3 b2 = cross(a[2], a[0]);
            const Vec3 b3 = cross(a[0], a[1]);
            metric = {dot(b1, b1), dot(b2, b2), dot(b3, b3), dot(b1, b2), dot(b1, b3), dot(b2, b3)};
        }
        // Half of the first-order coefficient: first differences are doubled.
        std::array<double, axes> first{};
        for (std::size_t m = 0; m < pairs<axes>; ++m) {
            for (std::size_t axis = 0; axis < axes; ++axis) {
                first[axis] += 0.5 * metric[m] * control[m * axes + axis][n];
            }
        }
        double sum_x = 0;
        double sum_y = 0;
        double sum_z = 0;
        double diagonal = 0;
        for (std::size_t m = 0; m < pairs<axes>; ++m) {
            const double weight = m < axes ? metric[m] : 2 * metric[m];
            if (m < axes) diagonal += 2 * metric[m];
            sum_x += weight * dx.second[m];
            sum_y += weight * dy.second[m];
            sum_z += weight * dz.second[m];
        }
        for (std::size_t axis = 0; axis < axes; ++axis) {
            sum_x += first[axis] * dx.first[axis];
            sum_y += first[axis] * dy.first[axis];
            sum_z += first[axis] * dz.first[axis];
        }
        rx[n] = sum_x;
        ry[n] = sum_y;
        rz[n] = sum_z;
        lower[n] = metric[axes - 1] - first[axes - 1];
        upper[n] = metric[axes - 1] + first[axes - 1];
        centre[n] = diagonal;
    }
}

/// Solves the line for its displacements and takes them, times the relaxation factor.
template <std::size_t axes>
void LineRelaxation<axes>::relax(std::size_t line) {
    const auto last = static_cast<std::size_t>(layout_.length - 1);
    double ratio = 0;
    std::array<double, 3> d{};
    for (std::size_t n = 1; n < last; ++n) {
        const double lower = line_.lower[n];
        const double pivot = 1 / (line_.centre[n] - lower * ratio);
        ratio = line_.upper[n] * pivot;
        line_.ratio[n] = ratio;
        for (std::size_t c = 0; c < 3; ++c) {
            d[c] = (line_.residual[c][n] + lower * d[c]) * pivot;
            line_.residual[c][n] = d[c];
        }
    }
    d = {};
    for (std::size_t n = last - 1; n > 0; --n) {
        for (std::size_t c = 0; c < 3; ++c) {
            d[c] = line_.residual[c][n] + line_.ratio[n] * d[c];
            x_[c][line + n] += relaxation_ * d[c];
        }
    }
}

template <std::size_t axes>
void LineRelaxation<axes>::sweep() {
    for (int i = 1; i < extent_.ni - 1; ++i) {
        for (int j = axes == 2 ? 0 : 1; j < (axes == 2 ? 1 : extent_.nj - 1); ++j) {
            const std::size_t line = layout_.offset(i, j, 0);
            assemble(line);
            relax(line);
        }
    }
}

template <std::size_t axes>
void LineRelaxation<axes>::copy(PointField& to) const {
    for (int k = 0; k < extent_.nk; ++k) {
        for (int j = 0; j < extent_.nj; ++j) {
            for (int i = 0; i < extent_.ni; ++i) {
                const std::size_t p = layout_.offset(i, j, k);
                to.set(i, j, k, {x_[0][p], x_[1][p], x_[2][p]});
            }
        }
    }
}

template <std::size_t axes>
void relax_until_told(const Problem& problem, double relaxation, const Look& look) {
    LineRelaxation<axes> method(problem, relaxation);
    int sweeps = 0;
    const auto copy = [&](PointField& to) { method.copy(to); };
    do {
        const int count =
            std::max(least_sweeps_between_looks, static_cast<int>(looks_per_sweep * sweeps));
        for (int n = 0; n < count; ++n) method.sweep();
        sweeps += count;
    } while (look(sweeps, copy));
}

}  // namespace

Yardstick line_relaxation(double relaxation) {
    const auto run = [relaxation](const Problem& problem, const Look& look) {
        if (problem.points.extent().nk == 1) {
            relax_until_told<2>(problem, relaxation, look);
        } else {
            relax_until_told<3>(problem, relaxation, look);
        }
    };
    return {"SLOR", fmt::format("SLOR {:.2f}", relaxation), run};
}

}  // namespace hexweave::bench
