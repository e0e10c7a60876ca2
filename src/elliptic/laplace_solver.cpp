// SPDX-License-Identifier: Apache-2.0
#include "elliptic/laplace_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/assert.h"

namespace hexweave {

namespace {

/// The nodes whose values are sought: a rectangle, since whole sides are fixed. Indices of the
/// fields with ghosts, both ends included.
struct Unknowns {
    std::array<int, 2> low;
    std::array<int, 2> high;

    Unknowns(const Conductances& network, const std::array<bool, 4>& fixed)
        : low{fixed[0] ? 2 : 1, fixed[2] ? 2 : 1},
          high{network.ni - (fixed[1] ? 1 : 0), network.nj - (fixed[3] ? 1 : 0)} {}
};

/// One network with the values sought on it and the currents that are to flow out of its nodes.
class Level {
public:
    Level(const Conductances& network, const std::array<bool, 4>& fixed)
        : values(network.east.extent()),
          sources(network.east.extent()),
          network_(network),
          unknowns_(network, fixed),
          pivots_{Field(network.east.extent()), Field(network.east.extent())},
          line_(static_cast<std::size_t>(std::max(network.ni, network.nj)) + 2) {
        factor(0);
        factor(1);
    }

    /// Solves every line of nodes along `axis` with the others held: first the lines of the one
    /// parity, then those of the other.
    void relax(int axis, int first_parity) {
        const auto across = static_cast<std::size_t>(1 - axis);
        for (const int parity : {first_parity, 1 - first_parity}) {
            int line = unknowns_.low[across];
            if (line % 2 != parity) ++line;
            for (; line <= unknowns_.high[across]; line += 2) relax_line(axis, line);
        }
    }
    /// What is wrong at the nodes: the source plus the current into them.
    double residual(int i, int j) const {
        const std::size_t node = values.extent().offset(i, j);
        return sources[node] + network_.current(values.data(), node);
    }
    /// The residual weighed with the transpose of interpolation becomes the coarse source.
    void restrict_to(Level& coarse, const std::array<AxisCoarsening, 2>& coarsening) const;
    /// Adds the interpolated coarse values.
    void correct_from(const Level& coarse, const std::array<AxisCoarsening, 2>& coarsening);
    const Unknowns& unknowns() const { return unknowns_; }

    Field values;
    Field sources;

private:
    void factor(int axis);
    void relax_line(int axis, int line);
    std::size_t stride(int axis) const {
        return axis == 0 ? 1 : static_cast<std::size_t>(values.extent().ni);
    }
    const Field& along(int axis) const { return axis == 0 ? network_.east : network_.north; }

    const Conductances& network_;
    Unknowns unknowns_;
    std::array<Field, 2> pivots_;  ///< of the lines along i and along j, inverted
    std::vector<double> line_;
};

/// Elimination along each line. The pivot of a node is its conductance to the next node plus what
/// leaks from the line up to here: kept apart, the leak is exact to rounding even where it is 1e-12
/// of the conductance, and there it decides the solution.
void Level::factor(int axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto across = static_cast<std::size_t>(1 - axis);
    const Field& next = along(axis);
    for (int line = unknowns_.low[across]; line <= unknowns_.high[across]; ++line) {
        double leak = 0;
        for (int n = unknowns_.low[a]; n <= unknowns_.high[a]; ++n) {
            const std::size_t node =
                axis == 0 ? values.extent().offset(n, line) : values.extent().offset(line, n);
            leak += network_.across(node, 1 - axis);
            if (n == unknowns_.low[a]) leak += next[node - stride(axis)];
            if (n == unknowns_.high[a]) leak += next[node];
            const double onward = n == unknowns_.high[a] ? 0 : next[node];
            pivots_[a][node] = 1 / (leak + onward);
            leak *= onward * pivots_[a][node];
        }
    }
}

void Level::relax_line(int axis, int line) {
    const auto a = static_cast<std::size_t>(axis);
    const Field& next = along(axis);
    const std::size_t step = stride(axis);
    const int low = unknowns_.low[a];
    const int high = unknowns_.high[a];
    if (low > high) return;
    const std::size_t first =
        axis == 0 ? values.extent().offset(low, line) : values.extent().offset(line, low);
    const auto count = static_cast<std::size_t>(high - low) + 1;
    double carried = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t node = first + n * step;
        line_[n] = sources[node] + network_.current(values.data(), node) + carried;
        carried = next[node] * pivots_[a][node] * line_[n];
    }
    double change = 0;
    for (std::size_t n = count; n-- > 0;) {
        const std::size_t node = first + n * step;
        const double onward = n + 1 == count ? 0 : next[node] * change;
        change = (line_[n] + onward) * pivots_[a][node];
        line_[n] = change;
    }
    for (std::size_t n = 0; n < count; ++n) values[first + n * step] += line_[n];
}

void Level::restrict_to(Level& coarse, const std::array<AxisCoarsening, 2>& coarsening) const {
    coarse.sources = Field(coarse.sources.extent());
    for (int j = unknowns_.low[1]; j <= unknowns_.high[1]; ++j) {
        const int cell_j = coarsening[1].cell_of(j - 1);
        const double g = coarsening[1].fraction(j - 1, cell_j);
        for (int i = unknowns_.low[0]; i <= unknowns_.high[0]; ++i) {
            const int cell_i = coarsening[0].cell_of(i - 1);
            const double f = coarsening[0].fraction(i - 1, cell_i);
            const double r = residual(i, j);
            coarse.sources(cell_i + 1, cell_j + 1) += (1 - f) * (1 - g) * r;
            coarse.sources(cell_i + 2, cell_j + 1) += f * (1 - g) * r;
            coarse.sources(cell_i + 1, cell_j + 2) += (1 - f) * g * r;
            coarse.sources(cell_i + 2, cell_j + 2) += f * g * r;
        }
    }
}

void Level::correct_from(const Level& coarse, const std::array<AxisCoarsening, 2>& coarsening) {
    const Field& v = coarse.values;
    for (int j = unknowns_.low[1]; j <= unknowns_.high[1]; ++j) {
        const int cell_j = coarsening[1].cell_of(j - 1);
        const double g = coarsening[1].fraction(j - 1, cell_j);
        for (int i = unknowns_.low[0]; i <= unknowns_.high[0]; ++i) {
            const int cell_i = coarsening[0].cell_of(i - 1);
            const double f = coarsening[0].fraction(i - 1, cell_i);
            const double below =
                (1 - f) * v(cell_i + 1, cell_j + 1) + f * v(cell_i + 2, cell_j + 1);
            const double above =
                (1 - f) * v(cell_i + 1, cell_j + 2) + f * v(cell_i + 2, cell_j + 2);
            values(i, j) += (1 - g) * below + g * above;
        }
    }
}

/// The coarsest network has one line of unknowns at most, so that relaxation solves it. Afterwards
/// lines are relaxed in the opposite order of before, which makes the whole a symmetric operator.
void cycle(std::vector<Level>& levels, const LaplaceHierarchy& hierarchy, std::size_t fine) {
    Level& level = levels[fine];
    level.relax(0, 1);
    level.relax(1, 1);
    if (fine + 1 < levels.size()) {
        Level& coarse = levels[fine + 1];
        level.restrict_to(coarse, hierarchy.coarsenings()[fine]);
        coarse.values = Field(coarse.values.extent());
        cycle(levels, hierarchy, fine + 1);
        level.correct_from(coarse, hierarchy.coarsenings()[fine]);
    }
    level.relax(1, 0);
    level.relax(0, 0);
}

/// Conjugate gradients with a cycle as the preconditioner, on the finest network.
class ConjugateGradients {
public:
    ConjugateGradients(const LaplaceHierarchy& hierarchy, const std::array<bool, 4>& fixed,
                       const Field& start);

    /// One step; the largest change of an unknown over the largest difference to a neighbour.
    double step();
    double value(int i, int j) const { return values_(i + 1, j + 1); }

private:
    template <class Visit>
    void for_unknowns(Visit&& visit) const;
    double precondition();
    double scale_step();
    double relative_change(int i, int j, double change) const;

    const LaplaceHierarchy& hierarchy_;
    std::vector<Level> levels_;  ///< the finest holds residual and preconditioned residual
    Field values_;
    Field direction_;
    double last_product_ = 0;  ///< of residual and preconditioned residual
};

ConjugateGradients::ConjugateGradients(const LaplaceHierarchy& hierarchy,
                                       const std::array<bool, 4>& fixed, const Field& start)
    : hierarchy_(hierarchy) {
    levels_.reserve(hierarchy.networks().size());
    for (const Conductances& network : hierarchy.networks()) levels_.emplace_back(network, fixed);
    values_ = Field(levels_.front().values.extent());
    direction_ = values_;
    for (int j = 0; j < start.extent().nj; ++j) {
        for (int i = 0; i < start.extent().ni; ++i) values_(i + 1, j + 1) = start(i, j);
    }
}

template <class Visit>
void ConjugateGradients::for_unknowns(Visit&& visit) const {
    const Unknowns& unknowns = levels_.front().unknowns();
    for (int j = unknowns.low[1]; j <= unknowns.high[1]; ++j) {
        for (int i = unknowns.low[0]; i <= unknowns.high[0]; ++i) visit(i, j);
    }
}

/// The preconditioned residual, in the finest level's values; its product with the residual.
double ConjugateGradients::precondition() {
    const Conductances& network = hierarchy_.networks().front();
    Level& finest = levels_.front();
    for_unknowns([&](int i, int j) {
        // Anew from the values, not carried along: rounding cannot pile up.
        const std::size_t node = values_.extent().offset(i, j);
        finest.sources[node] = network.current(values_.data(), node);
    });
    finest.values = Field(finest.values.extent());
    cycle(levels_, hierarchy_, 0);
    double product = 0;
    for_unknowns([&](int i, int j) { product += finest.sources(i, j) * finest.values(i, j); });
    return product;
}

/// How far to go along the direction, once its product with the residual is known.
double ConjugateGradients::scale_step() {
    const Conductances& network = hierarchy_.networks().front();
    double power = 0;
    for_unknowns([&](int i, int j) {
        const std::size_t node = direction_.extent().offset(i, j);
        power -= direction_[node] * network.current(direction_.data(), node);
    });
    return power > 0 ? last_product_ / power : 0;
}

double ConjugateGradients::step() {
    const double product = precondition();
    const double kept = last_product_ > 0 ? product / last_product_ : 0;
    last_product_ = product;
    for_unknowns([&](int i, int j) {
        direction_(i, j) = levels_.front().values(i, j) + kept * direction_(i, j);
    });
    const double scale = scale_step();
    for_unknowns([&](int i, int j) { values_(i, j) += scale * direction_(i, j); });
    double largest = 0;
    for_unknowns([&](int i, int j) {
        const double change = relative_change(i, j, std::abs(scale * direction_(i, j)));
        // A value that is not a number must not pass for one that stayed.
        if (!(change <= largest)) largest = change;
    });
    return largest;
}

/// Changes in the last bits of numbers up to one are none.
double ConjugateGradients::relative_change(int i, int j, double change) const {
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    if (change <= rounding) return 0;
    const Field& v = values_;
    double difference = 0;
    for (const int d : {-1, 1}) {
        if (i + d >= 1 && i + d <= v.extent().ni - 2)
            difference = std::max(difference, std::abs(v(i + d, j) - v(i, j)));
        if (j + d >= 1 && j + d <= v.extent().nj - 2)
            difference = std::max(difference, std::abs(v(i, j + d) - v(i, j)));
    }
    return change / difference;
}

}  // namespace

LaplaceHierarchy::LaplaceHierarchy(const PointField& points)
    : LaplaceHierarchy(laplace_conductances(points)) {}

LaplaceHierarchy::LaplaceHierarchy(Conductances finest) {
    networks_.push_back(std::move(finest));
    for (;;) {
        const Conductances& fine = networks_.back();
        const std::array<AxisCoarsening, 2> coarsening{AxisCoarsening(fine.ni),
                                                       AxisCoarsening(fine.nj)};
        if (coarsening[0].keeps_all() && coarsening[1].keeps_all()) return;
        networks_.push_back(coarsen(fine, coarsening[0], coarsening[1]));
        coarsenings_.push_back(coarsening);
    }
}

LaplaceResult solve_laplace(const LaplaceHierarchy& hierarchy, const std::array<bool, 4>& fixed,
                            const LaplaceOptions& options, Field& values) {
    HEXWEAVE_ASSERT((fixed[0] && fixed[1]) || (fixed[2] && fixed[3]));
    ConjugateGradients iteration(hierarchy, fixed, values);
    LaplaceResult result;
    while (result.cycles < options.maximum_cycles && !result.converged) {
        result.change = iteration.step();
        ++result.cycles;
        if (!std::isfinite(result.change)) return result;
        result.converged = result.change <= options.tolerance;
    }
    for (int j = 0; j < values.extent().nj; ++j) {
        for (int i = 0; i < values.extent().ni; ++i) values(i, j) = iteration.value(i, j);
    }
    return result;
}

}  // namespace hexweave
