// SPDX-License-Identifier: Apache-2.0
#include "io/heights_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/text_parts.h"

namespace hexweave {

namespace {

struct Row {
    const SolveMeasure& solve;
    const HeightMeasure& height;

    std::string entity() const {
        return fmt::format("{} '{}'", solve.is_block ? "block" : "face", solve.name);
    }
    /// As in the table.
    std::string name() const {
        return fmt::format("{} {} {}", solve.is_block ? "block" : "face", solve.name,
                           side_name(height.side));
    }
};

std::string lines(int number) {
    return counted(static_cast<std::size_t>(number), "line");
}

/// What keeps heights from those asked, and what would help.
std::string reasons(const HeightMeasure& h) {
    std::vector<std::string> all;
    if (h.stopped.growth > 0) {
        all.push_back(
            fmt::format("`growth` stops {} (more cells off the side help, or a "
                        "greater `growth`)",
                        lines(h.stopped.growth)));
    }
    if (h.stopped.fade > 0) {
        all.push_back(
            fmt::format("`fade` ends within the first cell of {}", lines(h.stopped.fade)));
    }
    if (h.stopped.folds > 0) {
        all.push_back(fmt::format("folds stop {}", lines(h.stopped.folds)));
    }
    if (h.ends_amiss > 0) {
        all.push_back(
            fmt::format("what is fixed at its ends is off at {} (ask the edges there, or "
                        "the faces, for the height too)",
                        counted(h.ends_amiss, "node")));
    }
    return fmt::format("{}{}", all.empty() ? "" : ": ", fmt::join(all, ", "));
}

/// Of held sides that are more than a tenth off.
std::string warnings_of_held(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) {
        if (!row.height.is_amiss()) continue;
        text += fmt::format("warning: {}: heights held are {:.3g} to {:.3g} of those asked{}\n",
                            row.name(), row.height.least, row.height.greatest, reasons(row.height));
    }
    return text;
}

/// How far a height is from the asked one at worst, as a factor.
double worst_factor(const Row& row) {
    return std::max(row.height.greatest, 1 / row.height.least);
}

/// One for all sides that are not held and more than a tenth off, with the worst of them.
std::string warning_of_free(const std::vector<Row>& rows) {
    const auto amiss = std::count_if(rows.begin(), rows.end(),
                                     [](const Row& row) { return row.height.is_amiss(); });
    if (amiss == 0) return {};
    const Row& worst = *std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return worst_factor(a) < worst_factor(b);
    });
    return fmt::format(
        "warning: first heights on walls are more than a tenth off those that edges ask at {}, the "
        "worst {}: {:.3g} to {:.3g} of them\n"
        "  hint: `heights: {{{}: held}}` in {} holds them there\n",
        counted(static_cast<std::size_t>(amiss), "side"), worst.name(), worst.height.least,
        worst.height.greatest, side_name(worst.height.side), worst.entity());
}

std::string table(const std::vector<Row>& rows, const std::string& title) {
    if (rows.empty()) return {};
    std::size_t width = title.size();
    for (const Row& row : rows) width = std::max(width, row.name().size());
    std::string text = fmt::format("{:<{}}  {:>12} {:>12} | {:>9} {:>9} {:>9}\n", title, width,
                                   "least asked", "greatest", "got/asked", "median", "greatest");
    for (const Row& row : rows) {
        const HeightMeasure& h = row.height;
        text +=
            fmt::format("{:<{}}  {:>12.6g} {:>12.6g} | {:>9.4f} {:>9.4f} {:>9.4f}\n", row.name(),
                        width, h.least_asked, h.greatest_asked, h.least, h.median, h.greatest);
    }
    return text;
}

}  // namespace

std::string heights_text(const Report& report) {
    std::vector<Row> held;
    std::vector<Row> free;
    for (const SolveMeasure& s : report.solves) {
        for (const HeightMeasure& h : s.heights) (h.held ? held : free).push_back({s, h});
    }
    std::string text = table(held, "heights held") + warnings_of_held(held);
    if (!free.empty()) {
        text += (held.empty() ? "" : "\n") + table(free, "heights free") + warning_of_free(free);
    }
    return text.empty() ? text : text + "\n";
}

}  // namespace hexweave
