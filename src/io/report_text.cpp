// SPDX-License-Identifier: Apache-2.0
#include "io/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/heights_text.h"
#include "io/level_text.h"
#include "io/measure_text.h"
#include "io/remarks.h"
#include "io/solve_text.h"
#include "io/text_parts.h"

namespace hexweave {
namespace {

std::string asked_text(const std::optional<double>& asked) {
    return asked ? fmt::format("{:.6g}", *asked) : "-";
}

/// The greatest relative error of the spacings that were asked; negative when none was.
double worst_spacing_error(const Report& report) {
    double worst = -1;
    const auto include = [&worst](const std::optional<double>& asked, double got) {
        if (asked) worst = std::max(worst, std::abs(got - *asked) / *asked);
    };
    for (const SpacingMeasure& s : report.spacings) {
        include(s.asked_start, s.got_start);
        include(s.asked_end, s.got_end);
    }
    return worst;
}

/// Which grid of a family this is, and of which one the solves below are.
std::string family_lines(const Report& report) {
    if (!report.level) return {};
    std::string text = level_line(*report.level);
    if (report.level->stride > 1) {
        text += fmt::format("cycles, displacements and folds of solves are those of level {}\n",
                            report.level->solved);
    }
    return text;
}

/// Whether first and last cells are asked of another level than this grid's.
bool asks_another_level(const Report& report) {
    return std::any_of(report.spacings.begin(), report.spacings.end(),
                       [](const SpacingMeasure& s) { return s.first != s.got_start; });
}

std::string spacing_table(const Report& report) {
    const bool another = asks_another_level(report);
    std::size_t width = 4;
    for (const SpacingMeasure& s : report.spacings) width = std::max(width, s.edge.size());
    std::string text =
        fmt::format("{:<{}}  {:>6} {:>12} | {:>12} {:>12} | {:>12} {:>12}{}\n", "edge", width,
                    "cells", "length", "first asked", "got", "last asked", "got",
                    another ? fmt::format(" | {:>12} {:>12}", "first here", "last here") : "");
    for (const SpacingMeasure& s : report.spacings) {
        text += fmt::format("{:<{}}  {:>6} {:>12.6g} | {:>12} {:>12.6g} | {:>12} {:>12.6g}{}\n",
                            s.edge, width, s.cells, s.length, asked_text(s.asked_start),
                            s.got_start, asked_text(s.asked_end), s.got_end,
                            another ? fmt::format(" | {:>12.6g} {:>12.6g}", s.first, s.last) : "");
    }
    if (another) text += "first and last cells are asked, and got, at level medium\n";
    const double worst = worst_spacing_error(report);
    if (worst >= 0) text += fmt::format("spacings asked are met to {:.1e} relative\n", worst);
    return text;
}

/// What was put onto surfaces, and how far it was moved for that.
std::string put_lines(const Report& report) {
    std::string text;
    for (const PutMeasure& p : report.put_on_surface) {
        text += fmt::format("{} was put onto {}: it moved by {:.3g}{} {}\n", p.what, p.surfaces,
                            p.distance, p.what.rfind("edge", 0) == 0 ? " at most, at" : " from",
                            place_text(p.place));
    }
    return text;
}

/// Why a gate had nothing to judge.
std::string nothing_to_judge(GateMeasure measure) {
    switch (measure) {
        case GateMeasure::max_growth:
            return "no grid line has two cells";
        case GateMeasure::max_wall_angle:
            return "no boundary of a wall type has nodes off its ends";
        case GateMeasure::wall_spacing_error:
            return "no spacing and no height was asked";
        case GateMeasure::min_scaled_jacobian:
        case GateMeasure::min_angle:
        case GateMeasure::max_angle:
        case GateMeasure::max_skewness:
            break;
    }
    return "no cell has a corner that counts";
}

std::string gate_text(const GateResult& g) {
    const bool lower = is_lower_limit(g.measure);
    const std::string name =
        (g.subject.empty() ? "" : g.subject + ": ") + std::string(gate_name(g.measure));
    const std::string limit =
        fmt::format("{} {:.4g} required", lower ? "at least" : "at most", g.limit);
    if (!g.judged) {
        return fmt::format("{}, {}: nothing to judge, as {}", name, limit,
                           nothing_to_judge(g.measure));
    }
    std::string text = fmt::format("{} {:.4g}, {}", name, g.got, limit);
    if (!g.where.empty()) text += ", in " + g.where;
    if (g.place) text += " at " + place_text(*g.place);
    return text;
}

std::string gate_lines(const Report& report) {
    std::string text;
    for (const GateResult& g : report.gates) {
        text += fmt::format("gate {}: {}\n", g.met ? "met" : "MISSED", gate_text(g));
    }
    return text;
}

std::string stage_line(const Report& report) {
    std::string text = "seconds:";
    for (const StageTime& s : report.stages) {
        text +=
            fmt::format(" {} {:.3f}{}", s.stage, s.seconds, &s == &report.stages.back() ? "" : ",");
    }
    return text + "\n";
}

const ZoneMeasure& worst_zone(const Report& report) {
    return *std::min_element(report.zones.begin(), report.zones.end(),
                             [](const ZoneMeasure& a, const ZoneMeasure& b) {
                                 return a.worst_scaled_jacobian < b.worst_scaled_jacobian;
                             });
}

/// What is wrong, each with the entity that is worst.
std::vector<std::string> faults(const Report& report) {
    std::vector<std::string> found;
    for (const ZoneMeasure& z : report.zones) {
        if (z.folded == 0) continue;
        found.push_back(fmt::format("{} in zone '{}', the worst {} at {}",
                                    counted(z.folded, "folded cell"), z.name, worst_cell_text(z),
                                    place_text(z.worst_place)));
    }
    const bool blocks = !report.solves.empty() && report.solves.back().is_block;
    for (const SolveMeasure& s : report.solves) {
        const bool is_zone = s.is_block == blocks;
        if (is_zone && s.result.untangling && s.result.untangling->left_at &&
            s.result.folded_after > 0) {
            found.push_back(fmt::format("{} '{}' could not be untangled at {}",
                                        s.is_block ? "block" : "face", s.name,
                                        place_text(*s.result.untangling->left_at)));
        }
        if (s.has_converged()) continue;
        found.push_back(fmt::format("{} '{}' {} after {} (displacement {:.1e} cells, asked {:.1e})",
                                    s.is_block ? "block" : "face", s.name,
                                    status_name(s.result.status),
                                    counted(static_cast<std::size_t>(s.result.cycles), "cycle"),
                                    s.result.displacement, s.result.tolerance));
    }
    for (const InterfaceMeasure& i : report.interfaces) {
        if (i.mismatched == 0) continue;
        found.push_back(
            fmt::format("interface '{}' differs at {}", i.name, counted(i.mismatched, "node")));
    }
    for (const GateResult& g : report.gates) {
        if (g.met) continue;
        found.push_back(fmt::format("gate missed ({}:{}:{}): {}",
                                    g.asked_at.file ? g.asked_at.file->name : "", g.asked_at.line,
                                    g.asked_at.column, gate_text(g)));
    }
    return found;
}

}  // namespace

std::string to_text(const Report& report, bool verbose) {
    std::string text = family_lines(report) + spacing_table(report) + put_lines(report);
    text += "\n" + solve_table(report, verbose);
    text += "\n" + heights_text(report) + zone_table(report);
    text +=
        "\n" + angle_line(report) + growth_line(report) + wall_lines(report) + gate_lines(report);
    for (const Remark& remark : remarks(report)) {
        if (!remark.is_warning) text += to_text(remark);
    }
    text += "\n" + stage_line(report);
    return text;
}

std::string verdict(const Report& report) {
    const std::vector<std::string> found = faults(report);
    if (!found.empty()) {
        std::string text = "NOT SOUND: ";
        for (std::size_t f = 0; f < found.size(); ++f) text += (f > 0 ? "; " : "") + found[f];
        return text;
    }
    const auto periodic = static_cast<std::size_t>(
        std::count_if(report.interfaces.begin(), report.interfaces.end(),
                      [](const InterfaceMeasure& i) { return i.periodic; }));
    std::string text = fmt::format(
        "sound: {}, {}, none folded, worst scaled Jacobian {:.4g} in '{}', {} "
        "the same to the last bit",
        counted(report.zones.size(), "zone"), counted(report.cells, "cell"),
        report.worst_scaled_jacobian(), worst_zone(report).name,
        counted(report.interfaces.size() - periodic, "interface"));
    if (periodic > 0) text += fmt::format(", {} periodic", periodic);
    return text;
}

}  // namespace hexweave
