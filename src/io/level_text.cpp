// SPDX-License-Identifier: Apache-2.0
#include "io/level_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hexweave {
namespace {

std::string ordinal(int n) {
    return fmt::format("{}{}", n, n == 2 ? "nd" : n == 3 ? "rd" : "th");
}

/// The greatest ratio of neighbouring cells along the lines of a grid.
double growth_along(const Report& report) {
    double worst = 1;
    for (const ZoneMeasure& zone : report.zones) {
        for (const GrowthMeasure& growth : zone.growth) worst = std::max(worst, growth.ratio);
    }
    return worst;
}

double growth_across(const Report& report) {
    double worst = 1;
    for (const InterfaceMeasure& i : report.interfaces) worst = std::max(worst, i.growth.ratio);
    return worst;
}

/// How many times the cells of a grid line there are, on average over the axes along which there
/// are more: not along that of a sweep by one cell.
double refinement(const Report& coarser, const Report& finer) {
    const Extent& less = coarser.zones.front().extent;
    const Extent& more = finer.zones.front().extent;
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) axes += more[axis] > less[axis] ? 1 : 0;
    const double cells = static_cast<double>(finer.cells) / static_cast<double>(coarser.cells);
    return std::pow(cells, 1.0 / std::max(axes, 1));
}

std::string walls_text(const Report& report) {
    std::string text;
    for (const WallMeasure& wall : report.walls) {
        text +=
            fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", wall.family, wall.median_height);
    }
    return text.empty() ? "-" : text;
}

}  // namespace

std::string level_line(const LevelMeasure& level) {
    const std::string source = level.stride == 1
                                   ? "solved itself"
                                   : fmt::format("every {} point of level {}, which is solved",
                                                 ordinal(level.stride), level.solved);
    return fmt::format("level {} of {}, factor {:g}: {}\n", level.name,
                       fmt::join(level.names, ", "), level.factor, source);
}

std::string family_table(const std::vector<Report>& reports) {
    std::size_t width = 6;
    for (const Report& report : reports) width = std::max(width, report.level->name.size());
    std::string text = fmt::format("{:<{}}  {:>14} {:>8} | {:>14} {:>8} | {:>12} {:>8}  {}\n",
                                   "family", width, "cells", "per line", "growth, lines", "across",
                                   "worst corner", "folded", "median first height");
    for (std::size_t n = 0; n < reports.size(); ++n) {
        const Report& report = reports[n];
        text +=
            fmt::format("{:<{}}  {:>14} {:>8} | {:>14.4g} {:>8.4g} | {:>12.4g} {:>8}  {}\n",
                        report.level->name, width, report.cells,
                        n == 0 ? "-" : fmt::format("x {:.3f}", refinement(reports[n - 1], report)),
                        growth_along(report), growth_across(report), report.worst_scaled_jacobian(),
                        report.folded(), walls_text(report));
    }
    return text;
}

}  // namespace hexweave
