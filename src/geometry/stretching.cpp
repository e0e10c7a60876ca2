// SPDX-License-Identifier: Apache-2.0
#include "geometry/stretching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "geometry/root.h"

namespace hexweave {

namespace {

/// The cells that a function is determined with, and the intervals that each is divided into.
struct Cells {
    int count = 1;
    int refinement = 1;

    int intervals() const { return count * refinement; }
    /// In cells, at the end of so many intervals.
    double index(int interval) const { return static_cast<double>(interval) / refinement; }
};

/// Fractions from a function of the index in cells, which need not be whole; the ends are exact.
template <class Function>
std::vector<double> tabulate(const Cells& cells, Function&& fraction) {
    const int intervals = cells.intervals();
    std::vector<double> fractions(static_cast<std::size_t>(intervals) + 1);
    for (int i = 1; i < intervals; ++i) {
        fractions[static_cast<std::size_t>(i)] = fraction(cells.index(i));
    }
    fractions.back() = 1;
    return fractions;
}

std::vector<double> uniform(const Cells& cells) {
    return tabulate(cells, [&](double i) { return i / cells.count; });
}

/// The two families that Vinokur's functions switch between: hyperbolic for small cells, circular
/// for large ones.
enum class Branch { hyperbolic, circular };

double sine(Branch branch, double x) {
    return branch == Branch::hyperbolic ? std::sinh(x) : std::sin(x);
}
double cosine(Branch branch, double x) {
    return branch == Branch::hyperbolic ? std::cosh(x) : std::cos(x);
}

/// The parameter and the branch of a stretching function.
struct Stretch {
    Branch branch = Branch::hyperbolic;
    double step = 0;  ///< the function's argument over one cell; 0 when not stretched
};

/// The stretch at which `value(branch, step)` is `wanted`. `plain` is its value without stretching,
/// from which it falls on the hyperbolic branch and rises on the circular one; the limits bracket
/// the solution.
template <class Function>
Stretch find_stretch(Function&& value, double plain, double wanted, double hyperbolic_limit,
                     double circular_limit) {
    const double excess = std::log(plain / wanted);
    if (std::abs(excess) <= 4 * std::numeric_limits<double>::epsilon()) return {};
    const Branch branch = excess > 0 ? Branch::hyperbolic : Branch::circular;
    const double limit = excess > 0 ? hyperbolic_limit : circular_limit;
    const auto mismatch = [&](double step) {
        return step == 0 ? excess : std::log(value(branch, step) / wanted);
    };
    return {branch, bracketed_root(mismatch, 0.0, limit)};
}

/// Vinokur's two-sided function written by odds s / (1 - s): with u the symmetric function, the
/// odds of s are those of u divided by A, and those of u at i of n cells are
/// sinh(i a) / sinh((n - i) a). The first and last cells then fix A, and one equation is left for
/// a.
std::vector<double> two_sided_tanh(const Cells& all, double first, double last) {
    const int cells = all.count;
    const double first_odds = first / (1 - first);
    const double last_odds = last / (1 - last);
    const double a = std::sqrt(last_odds / first_odds);
    const double odds = std::sqrt(last_odds * first_odds);
    const auto value = [&](Branch branch, double step) {
        return sine(branch, step) / sine(branch, (cells - 1) * step);
    };
    const Stretch stretch = find_stretch(value, 1.0 / (cells - 1), odds,
                                         -std::log(odds) / (cells - 2), std::numbers::pi / cells);
    return tabulate(all, [&](double i) {
        const double from_start = stretch.step > 0 ? sine(stretch.branch, i * stretch.step) : i;
        const double from_end =
            stretch.step > 0 ? sine(stretch.branch, (cells - i) * stretch.step) : cells - i;
        return from_start / (from_start + a * from_end);
    });
}

/// One half of the symmetric function, from the small end.
std::vector<double> one_sided_tanh(const Cells& all, double first) {
    const int cells = all.count;
    const auto value_at = [&](Branch branch, double step, double i) {
        return sine(branch, i * step) /
               (sine(branch, cells * step) * cosine(branch, (cells - i) * step));
    };
    const auto value = [&](Branch branch, double step) { return value_at(branch, step, 1); };
    const Stretch stretch =
        find_stretch(value, 1.0 / cells, first, std::log(2 / first) / (2 * (cells - 1)),
                     std::numbers::pi / (2 * cells));
    if (stretch.step == 0) return uniform(all);
    return tabulate(all, [&](double i) { return value_at(stretch.branch, stretch.step, i); });
}

std::vector<double> geometric_by_log_ratio(const Cells& cells, double log_ratio) {
    if (log_ratio == 0) return uniform(cells);
    return tabulate(cells, [&](double i) {
        return std::expm1(i * log_ratio) / std::expm1(cells.count * log_ratio);
    });
}

std::vector<double> geometric_from_first(const Cells& all, double first) {
    const int cells = all.count;
    const auto mismatch = [&](double log_ratio) {
        const double cells_of_first_size =
            log_ratio == 0 ? cells : std::expm1(cells * log_ratio) / std::expm1(log_ratio);
        return std::log(cells_of_first_size * first);
    };
    const double low = std::log1p(-first);               // endlessly many cells fill the length
    const double high = -std::log(first) / (cells - 1);  // the last cell alone fills it
    return geometric_by_log_ratio(all, bracketed_root(mismatch, low, high));
}

/// Cells that change from both ends inwards by exp(rate) a cell: of the two progressions the
/// smaller one counts where they grow, the larger one where they shrink.
class TwoSidedCells {
public:
    TwoSidedCells(int cells, double first, double last)
        : cells_(cells), first_(first), last_(last) {}

    double cell(int i, double rate) const {
        const double from_start = first_ * std::exp(i * rate);
        const double from_end = last_ * std::exp((cells_ - 1 - i) * rate);
        return grows_ ? std::min(from_start, from_end) : std::max(from_start, from_end);
    }
    /// How much of cell i lies within part t of it: it grows within as the cells do.
    double part(int i, double rate, double t) const {
        const bool from_start = cell(i, rate) == first_ * std::exp(i * rate);
        const double log_ratio = from_start ? rate : -rate;
        return log_ratio == 0 ? t : std::expm1(t * log_ratio) / std::expm1(log_ratio);
    }
    double sum(double rate) const {
        double total = 0;
        for (int i = 0; i < cells_; ++i) total += cell(i, rate);
        return total;
    }
    /// The rate at which the cells fill the length.
    double fitting_rate() {
        // With this rate one progression leads from the first cell to the last.
        const double through = std::abs(std::log(first_ / last_)) / (cells_ - 1);
        grows_ = sum(through) <= 1;
        const int middle = (cells_ - 1) / 2;
        const double limit =
            grows_ ? -std::log(std::min(first_, last_)) / middle : std::log1p(-first_ - last_);
        return bracketed_root([&](double rate) { return std::log(sum(rate)); },
                              grows_ ? through : -through, limit);
    }

private:
    int cells_;
    double first_;
    double last_;
    bool grows_ = true;
};

std::vector<double> two_sided_geometric(const Cells& all, double first, double last) {
    const int cells = all.count;
    TwoSidedCells progression(cells, first, last);
    const double rate = progression.fitting_rate();
    // Summed from the nearer end, so that both ends keep their digits.
    const int half = cells / 2;
    std::vector<double> ends(static_cast<std::size_t>(cells) + 1);
    double from_start = 0;
    for (int i = 1; i <= half; ++i) {
        from_start += progression.cell(i - 1, rate);
        ends[static_cast<std::size_t>(i)] = from_start;
    }
    double from_end = 0;
    ends.back() = 1;
    for (int i = cells - 1; i > half; --i) {
        from_end += progression.cell(i, rate);
        ends[static_cast<std::size_t>(i)] = 1 - from_end;
    }
    return tabulate(all, [&](double at) {
        const int cell = static_cast<int>(at);
        const double begin = ends[static_cast<std::size_t>(cell)];
        if (at == cell) return begin;
        const double size = ends[static_cast<std::size_t>(cell) + 1] - begin;
        return begin + size * progression.part(cell, rate, at - cell);
    });
}

/// Two cells of these sizes, which make up the length.
std::vector<double> two_cells(const Cells& all, double first, double last) {
    if (all.refinement == 1) return {0, first / (first + last), 1};
    return geometric_by_log_ratio(all, std::log(last / first));
}

}  // namespace

std::vector<double> uniform_fractions(int cells, int refinement) {
    return uniform({cells, refinement});
}

std::vector<double> tanh_fractions(int cells, const std::optional<double>& first,
                                   const std::optional<double>& last, int refinement) {
    const Cells all{cells, refinement};
    if (cells == 1 || (!first && !last)) return uniform(all);
    if (!last) return one_sided_tanh(all, *first);
    if (!first) return reversed_fractions(one_sided_tanh(all, *last));
    if (cells == 2) return two_cells(all, *first, *last);
    return two_sided_tanh(all, *first, *last);
}

std::vector<double> ratio_fractions(int cells, double ratio, int refinement) {
    return geometric_by_log_ratio({cells, refinement}, std::log(ratio));
}

std::vector<double> geometric_fractions(int cells, const std::optional<double>& first,
                                        const std::optional<double>& last, int refinement) {
    const Cells all{cells, refinement};
    if (cells == 1 || (!first && !last)) return uniform(all);
    if (!last) return geometric_from_first(all, *first);
    if (!first) return reversed_fractions(geometric_from_first(all, *last));
    if (cells == 2) return two_cells(all, *first, *last);
    return two_sided_geometric(all, *first, *last);
}

std::vector<double> reversed_fractions(const std::vector<double>& fractions) {
    std::vector<double> back(fractions.rbegin(), fractions.rend());
    for (double& f : back) f = 1 - f;
    return back;
}

double smallest_cell(const std::vector<double>& fractions) {
    double smallest = 1;
    for (std::size_t i = 1; i < fractions.size(); ++i) {
        const double cell = fractions[i] - fractions[i - 1];
        if (std::isnan(cell)) return cell;
        smallest = std::min(smallest, cell);
    }
    return smallest;
}

}  // namespace hexweave
