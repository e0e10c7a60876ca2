// SPDX-License-Identifier: Apache-2.0
#include "io/heights_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace hexweave {

namespace {

struct Row {
    const SolveMeasure& solve;
    const HeightMeasure& height;

    std::string name() const {
        return fmt::format("{} {} {}", solve.is_block ? "block" : "face", solve.name,
                           side_name(height.side));
    }
};

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
    std::string text = table(held, "heights held");
    if (!free.empty()) {
        text += (held.empty() ? "" : "\n") + table(free, "heights free");
    }
    return text.empty() ? text : text + "\n";
}

}  // namespace hexweave
