// SPDX-License-Identifier: Apache-2.0
#include "topology/spacing_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/stretching.h"
#include "geometry/wall_scaling.h"

namespace hexweave {

namespace {

/// Sizes that must add up to the length are taken to do so within this part of it.
constexpr double agreement = 1e-9;
/// Cells smaller than this part of the edge are lost in the rounding of their fractions.
constexpr double smallest_fraction = 1e-14;

/// An asked size on its own. `which` is "first" or "last".
std::string misfit_of_size(const char* which, double size, double length, int cells) {
    if (!(size > 0) || !std::isfinite(size)) {
        return fmt::format("the {} cell, {:g}, must be greater than 0", which, size);
    }
    if (cells == 1) {
        if (std::abs(size - length) <= agreement * length) return {};
        return fmt::format("the only cell is as long as the edge, {:g}; the {} cell cannot be {:g}",
                           length, which, size);
    }
    if (size > length) {
        return fmt::format("the {} cell, {:g}, is longer than the edge, {:g}", which, size, length);
    }
    if (size == length) {
        return fmt::format("the {} cell, {:g}, leaves nothing of the edge to the other {}", which,
                           size, cells == 2 ? "cell" : "cells");
    }
    if (size < smallest_fraction * length) {
        return fmt::format("the {} cell, {:g}, is less than {:g} of the edge, {:g}", which, size,
                           smallest_fraction, length);
    }
    return {};
}

/// The asked first and last cells, together.
std::string misfit_of_sizes(const std::optional<double>& start, const std::optional<double>& end,
                            double length, int cells) {
    if (start) {
        if (std::string misfit = misfit_of_size("first", *start, length, cells); !misfit.empty()) {
            return misfit;
        }
    }
    if (end) {
        if (std::string misfit = misfit_of_size("last", *end, length, cells); !misfit.empty()) {
            return misfit;
        }
    }
    if (!start || !end || cells == 1) return {};
    const double sum = *start + *end;
    if (cells == 2 && std::abs(sum - length) > agreement * length) {
        return fmt::format(
            "two cells make up the edge, {:g}; the first and last cells, {:g} and {:g}, add up to "
            "{:g}",
            length, *start, *end, sum);
    }
    if (cells > 2 && sum >= length) {
        return fmt::format(
            "the first and last cells, {:g} and {:g}, leave nothing of the edge, {:g}, to the "
            "cells between",
            *start, *end, length);
    }
    return {};
}

/// A law whose points were computed, on trial.
std::string misfit_of_fractions(const std::vector<double>& fractions) {
    const double smallest = smallest_cell(fractions);
    if (smallest >= smallest_fraction) return {};
    return fmt::format("the smallest cell would be less than {:g} of the edge", smallest_fraction);
}

std::optional<double> over(const std::optional<double>& size, double length) {
    return size ? std::optional(*size / length) : std::nullopt;
}

std::string misfit(const UniformLaw& /*law*/, int /*cells*/, double /*length*/) {
    return {};
}

/// A law that is scaled near one end; its sizes fit as those of a plain one.
std::string misfit_of_natural(const TanhLaw& law, int cells, double length) {
    const auto [natural, within] = *law.natural;
    const double asked = law.start ? *law.start : *law.end;
    if (!(within > std::max(asked, natural)) || within > length) {
        return fmt::format(
            "'within', {:g}, must be more than both cells, {:g} and {:g}, and at most the edge, "
            "{:g}",
            within, asked, natural, length);
    }
    const auto fractions = held_tanh_fractions(cells, asked / length, natural / length,
                                               within / length, law.end.has_value());
    if (std::isfinite(greatest_growth(fractions))) return misfit_of_fractions(fractions);
    return fmt::format(
        "a cell of {:g} is too far from the natural one, {:g}, to be had within {:g}", asked,
        natural, within);
}

std::string misfit(const TanhLaw& law, int cells, double length) {
    std::string reason = misfit_of_sizes(law.start, law.end, length, cells);
    if (!reason.empty()) return reason;
    if (law.natural) {
        reason = misfit_of_sizes(law.natural->size, std::nullopt, length, cells);
        return reason.empty() ? misfit_of_natural(law, cells, length) : reason;
    }
    return misfit_of_fractions(
        tanh_fractions(cells, over(law.start, length), over(law.end, length)));
}

std::string misfit(const GeometricLaw& law, int cells, double length) {
    if (!law.ratio) {
        std::string reason = misfit_of_sizes(law.start, law.end, length, cells);
        if (!reason.empty()) return reason;
        return misfit_of_fractions(
            geometric_fractions(cells, over(law.start, length), over(law.end, length)));
    }
    if (law.start || law.end) {
        return "the ratio and a cell's size cannot both be met: with this many cells one gives the "
               "other";
    }
    if (!(*law.ratio > 0) || !std::isfinite(*law.ratio)) {
        return fmt::format("the ratio, {:g}, must be greater than 0", *law.ratio);
    }
    return misfit_of_fractions(ratio_fractions(cells, *law.ratio));
}

/// Positions from 0 to 1; `what` says whether they are "values" or a "formula".
std::string misfit_of_positions(const char* what, const std::vector<double>& values) {
    constexpr double rounding = 1e-12;
    if (!(std::abs(values.front()) <= rounding)) {
        return fmt::format("the {} must start at 0, not {:g}", what, values.front());
    }
    if (!(std::abs(values.back() - 1) <= rounding)) {
        return fmt::format("the {} must end at 1, not {:g}", what, values.back());
    }
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!(values[i] - values[i - 1] >= smallest_fraction)) {
            return fmt::format("the {} must increase: point {} is at {:g}, point {} at {:g}", what,
                               i - 1, values[i - 1], i, values[i]);
        }
    }
    return {};
}

std::string misfit(const ExplicitLaw& law, int cells, double /*length*/) {
    if (law.formula) {
        std::vector<double> values;
        for (int i = 0; i <= cells; ++i) {
            values.push_back(law.formula(static_cast<double>(i) / cells));
        }
        return misfit_of_positions("formula", values);
    }
    const std::size_t needed = static_cast<std::size_t>(cells) + 1;
    if (law.values.size() != needed) {
        return fmt::format("{} {} need{} {} values, not {}", cells, cells == 1 ? "cell" : "cells",
                           cells == 1 ? "s" : "", needed, law.values.size());
    }
    return misfit_of_positions("values", law.values);
}

std::string misfit(const SameAs& /*law*/, int /*cells*/, double /*length*/) {
    return {};
}

}  // namespace

std::string spacing_hint(const SpacingLaw& law, int cells, double length) {
    if (std::holds_alternative<ExplicitLaw>(law)) {
        return "fractions ascend from 0 to 1; a formula in t fits any number of cells";
    }
    return fmt::format(
        "of {} equal cells each would be {:g}; first and last cells are lengths, in "
        "the units of the case",
        cells, length / cells);
}

std::string spacing_misfit(const SpacingLaw& law, int cells, double length) {
    return std::visit([&](const auto& chosen) { return misfit(chosen, cells, length); }, law);
}

}  // namespace hexweave
