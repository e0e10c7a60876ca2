// SPDX-License-Identifier: Apache-2.0
#include "elliptic/acceleration.h"

#include <algorithm>
#include <utility>

#include "core/assert.h"
#include "elliptic/cell_units.h"

namespace hexweave {

namespace {

/// Folded nodes must not outweigh all others: cells flatter than this (6 degrees) are weighed as if
/// they were so thick.
constexpr double least_sine_of_weights = 0.1;

/// A pivot this small beside its column's square: the column says nothing new.
constexpr double least_independence = 1e-10;

/// Inner products of the columns with one another and, last, with the residual.
using Gram = std::vector<std::vector<double>>;

Gram gram_matrix(const NodeLattice& lattice, const Nodes& points, const std::vector<Nodes>& columns,
                 const Nodes& residual) {
    const std::size_t m = columns.size();
    Gram gram(m, std::vector<double>(m + 1, 0.0));
    std::vector<Vec3> cells(m + 1);
    for_interior(lattice, [&](std::size_t p) {
        const CellFrame frame = cell_frame(lattice, points, p, least_sine_of_weights);
        for (std::size_t c = 0; c < m; ++c) cells[c] = frame.cells(columns[c][p]);
        cells[m] = frame.cells(residual[p]);
        for (std::size_t r = 0; r < m; ++r) {
            for (std::size_t c = r; c <= m; ++c) gram[r][c] += dot(cells[r], cells[c]);
        }
    });
    return gram;
}

/// Solves the normal equations of columns `first`.. by Cholesky elimination; empty when the
/// columns depend on one another.
std::vector<double> solve_normal_equations(const Gram& gram, std::size_t first) {
    const std::size_t m = gram.size();
    Gram a = gram;
    for (std::size_t k = first; k < m; ++k) {
        if (!(a[k][k] > least_independence * gram[k][k])) return {};
        for (std::size_t r = k + 1; r < m; ++r) {
            const double factor = a[k][r] / a[k][k];
            for (std::size_t c = r; c <= m; ++c) a[r][c] -= factor * a[k][c];
        }
    }
    std::vector<double> g(m, 0.0);
    for (std::size_t r = m; r-- > first;) {
        double sum = a[r][m];
        for (std::size_t c = r + 1; c < m; ++c) sum -= a[r][c] * g[c];
        g[r] = sum / a[r][r];
    }
    return g;
}

}  // namespace

Acceleration::Acceleration(const NodeLattice& lattice, std::size_t window)
    : lattice_(lattice), window_(window) {
    HEXWEAVE_ASSERT(window > 0);
}

void Acceleration::restart() {
    point_changes_.clear();
    residual_changes_.clear();
    has_last_ = false;
}

std::vector<double> Acceleration::best_combination(const Nodes& points,
                                                   const Nodes& residual) const {
    const Gram gram = gram_matrix(lattice_, points, residual_changes_, residual);
    for (std::size_t first = 0; first < gram.size(); ++first) {
        std::vector<double> g = solve_normal_equations(gram, first);
        if (!g.empty()) return g;
    }
    std::vector<double> none(gram.size(), 0.0);
    return none;
}

/// Adds the changes that the last step brought, in the place of the oldest when the window is full.
void Acceleration::remember(const Nodes& residual) {
    if (point_changes_.size() < window_) {
        point_changes_.emplace_back(residual.size());
        residual_changes_.emplace_back(residual.size());
    } else {
        std::rotate(point_changes_.begin(), point_changes_.begin() + 1, point_changes_.end());
        std::rotate(residual_changes_.begin(), residual_changes_.begin() + 1,
                    residual_changes_.end());
    }
    std::swap(point_changes_.back(), last_step_);
    Nodes& change = residual_changes_.back();
    for (std::size_t p = 0; p < change.size(); ++p) change[p] = residual[p] - last_residual_[p];
}

void Acceleration::accelerate(const Nodes& points, double damping, Nodes& step) {
    if (has_last_) remember(step);
    last_residual_ = step;
    const std::vector<double> g = best_combination(points, step);
    for (std::size_t p = 0; p < step.size(); ++p) {
        Vec3 s = damping * step[p];
        for (std::size_t n = 0; n < g.size(); ++n) {
            s -= g[n] * (point_changes_[n][p] + damping * residual_changes_[n][p]);
        }
        step[p] = s;
    }
    last_step_ = step;
    has_last_ = true;
}

}  // namespace hexweave
