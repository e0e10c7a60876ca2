// SPDX-License-Identifier: Apache-2.0
#include "io/remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "io/text_parts.h"

namespace hexweave {

namespace {

/// First heights at a side of a face or block.
struct Row {
    const SolveMeasure& solve;
    const HeightMeasure& height;

    std::string entity() const {
        return fmt::format("{} '{}'", solve.is_block ? "block" : "face", solve.name);
    }
    std::string name() const {
        return fmt::format("{} {} {}", solve.is_block ? "block" : "face", solve.name,
                           side_name(height.side));
    }
    /// How far a height is from the asked one at worst, as a factor.
    double worst_factor() const { return std::max(height.greatest, 1 / height.least); }
};

std::vector<Row> amiss_rows(const Report& report, bool held) {
    std::vector<Row> rows;
    for (const SolveMeasure& s : report.solves) {
        for (const HeightMeasure& h : s.heights) {
            if (h.held == held && h.is_amiss()) rows.push_back({s, h});
        }
    }
    return rows;
}

void add_folded_faces(const Report& report, std::vector<Remark>& all) {
    for (const SolveMeasure* face : report.folded_faces()) {
        const auto& untangling = face->result.untangling;
        all.push_back(
            {true,
             fmt::format(
                 "face '{}' folds as a surface, in {}{}{}", face->name,
                 counted(static_cast<std::size_t>(face->result.folded_after), "cell"),
                 untangling && untangling->left_at ? " at " + place_text(*untangling->left_at) : "",
                 report.folded() == 0 ? "; no cell of the blocks is folded" : ""),
             {}});
    }
}

/// What keeps heights from those asked.
std::string reasons(const HeightMeasure& h) {
    const auto lines = [](int number) { return counted(static_cast<std::size_t>(number), "line"); };
    std::vector<std::string> all;
    if (h.stopped.growth > 0) all.push_back("`growth` stops " + lines(h.stopped.growth));
    if (h.stopped.fade > 0) {
        all.push_back("`fade` ends within the first cell of " + lines(h.stopped.fade));
    }
    if (h.stopped.folds > 0) all.push_back("folds stop " + lines(h.stopped.folds));
    if (h.ends_amiss > 0) {
        all.push_back("what is fixed at its ends is off at " + counted(h.ends_amiss, "node"));
    }
    return fmt::format("{}{}", all.empty() ? "" : ": ", fmt::join(all, ", "));
}

/// What would help.
std::string remedies(const HeightMeasure& h) {
    std::vector<std::string> all;
    if (h.stopped.growth > 0)
        all.emplace_back("more cells off the side, a greater `fade` or a greater `growth`");
    if (h.stopped.fade > 0 && h.stopped.growth == 0) all.emplace_back("a greater `fade`");
    if (h.ends_amiss > 0) {
        all.emplace_back("ask the edges there, or the faces, for the height too");
    }
    return fmt::format("{}", fmt::join(all, "; "));
}

void add_held_heights(const Report& report, std::vector<Remark>& all) {
    for (const Row& row : amiss_rows(report, true)) {
        all.push_back(
            {true,
             fmt::format("{}: heights held are {:.3g} to {:.3g} of those asked{}", row.name(),
                         row.height.least, row.height.greatest, reasons(row.height)),
             remedies(row.height)});
    }
}

/// One for all sides that are not held, with the worst of them.
void add_free_heights(const Report& report, std::vector<Remark>& all) {
    const std::vector<Row> rows = amiss_rows(report, false);
    if (rows.empty()) return;
    const Row& worst = *std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return a.worst_factor() < b.worst_factor();
    });
    all.push_back(
        {false,
         fmt::format("first heights on walls are more than a tenth off those that edges ask at {}, "
                     "the worst {}: {:.3g} to {:.3g} of them",
                     counted(rows.size(), "side"), worst.name(), worst.height.least,
                     worst.height.greatest),
         fmt::format("`heights: {{{}: held}}` in {} holds them there", side_name(worst.height.side),
                     worst.entity())});
}

void add_bend(const Report& report, std::vector<Remark>& all) {
    constexpr double striking = 30;
    const auto worst = std::max_element(
        report.interfaces.begin(), report.interfaces.end(),
        [](const InterfaceMeasure& a, const InterfaceMeasure& b) { return a.bend < b.bend; });
    if (worst == report.interfaces.end() || worst->bend < striking) return;
    all.push_back(
        {false,
         fmt::format(
             "grid lines bend by up to {:.0f} degrees across '{}' away from its ends, at {}",
             worst->bend, worst->name, place_text(worst->bend_place)),
         worst->may_be_straightened ? fmt::format("`orthogonal` at {} and {} may straighten them",
                                                  worst->sides[0], worst->sides[1])
                                    : ""});
}

}  // namespace

std::vector<Remark> remarks(const Report& report) {
    std::vector<Remark> all;
    add_folded_faces(report, all);
    add_held_heights(report, all);
    add_free_heights(report, all);
    add_bend(report, all);
    return all;
}

bool has_warnings(const Report& report) {
    const std::vector<Remark> all = remarks(report);
    return std::any_of(all.begin(), all.end(), [](const Remark& r) { return r.is_warning; });
}

std::string to_text(const Remark& remark) {
    return fmt::format("{}: {}\n{}", remark.is_warning ? "warning" : "note", remark.message,
                       remark.hint.empty() ? "" : fmt::format("  hint: {}\n", remark.hint));
}

}  // namespace hexweave
