// SPDX-License-Identifier: Apache-2.0
#include "bench/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/machine.h"
#include "bench/traffic.h"

namespace hexweave::bench {

namespace {

using Json = nlohmann::ordered_json;

std::string size_of(const Extent& e) {
    if (e.nk == 1) return fmt::format("{}x{}", e.ni, e.nj);
    return fmt::format("{}x{}x{}", e.ni, e.nj, e.nk);
}

const char* verdict(bool good) {
    return good ? "PASS" : "miss";
}

/// Microseconds per point, ">" and the time it had where it did not arrive.
std::string time_of(const MethodRun& run, const std::optional<Timing>& timing) {
    if (timing) return fmt::format("{:.2f}", run.microseconds_per_point(*timing));
    if (run.diverged) return "diverged";
    return fmt::format("> {:.0f}", run.microseconds_per_point({run.seconds, 0}));
}

std::string memory_of(const MethodRun& run) {
    return run.bytes_per_point > 0 ? fmt::format("{:.0f}", run.bytes_per_point) : "-";
}

std::string runs_table(const Comparison& all) {
    std::string text =
        fmt::format("{:8}{:>13}{:>9}  {:26}{:>10}{:>10}{:>8}{:>9}\n", "problem", "points", "",
                    "method", "us/pt 1%", "to 1e-4", "cycles", "bytes/pt");
    for (const CaseComparison& c : all.cases) {
        const MethodRun* slor = best_of(c, "SLOR");
        for (const MethodRun& run : c.runs) {
            if (run.family == "SLOR" && &run != slor) continue;
            text += fmt::format("{:8}{:>13}{:>9}  {:26}{:>10}{:>10}{:>8}{:>9}\n", run.problem,
                                size_of(run.extent), run.extent.nodes(), run.name,
                                time_of(run, run.to_coarse), time_of(run, run.to_fine),
                                run.to_fine ? std::to_string(run.to_fine->cycles) : "-",
                                memory_of(run));
        }
        if (!c.reference_trusted) {
            text += fmt::format("{:8}{:>13}  reference not converged: residual {:.1e} cells\n",
                                c.where.problem, size_of(c.where.extent), c.reference_residual);
        }
    }
    return text;
}

std::string ratio_text(const Ratio& ratio, double asked) {
    if (ratio.none) return fmt::format("{:>8} / {:<3} {:4}", "-", asked, "");
    const std::string value = fmt::format("{}{:.1f}", ratio.at_least ? ">" : "", ratio.value);
    return fmt::format("{:>8} / {:<3} {:4}", value, asked,
                       ratio.value >= asked ? "PASS"
                       : ratio.at_least     ? "?"
                                            : "miss");
}

std::string ratios_table(const Comparison& all) {
    std::string text = "times faster than the best of each, to 1e-4 of a cell: got / asked\n" +
                       fmt::format("{:8}{:>13}{:>20}{:>20}{:>20}\n", "problem", "", "hypre", "SLOR",
                                   "ILU-BiCGSTAB");
    for (const Demand& demand : demands) {
        for (const CaseComparison& c : all.cases) {
            if (c.where.problem != demand.where.problem || c.where.extent != demand.where.extent) {
                continue;
            }
            text += fmt::format("{:8}{:>13}", c.where.problem, size_of(c.where.extent));
            for (const char* family : {"hypre", "SLOR", "ILU-BiCGSTAB"}) {
                text += fmt::format("{:>20}", ratio_text(ratio_to(c, family), demand.of(family)));
            }
            text += "\n";
        }
    }
    return text;
}

std::string cycles_table(const Comparison& all) {
    std::string text =
        fmt::format("cycles to 1e-4 of a cell, at most {} asked\n", most_cycles_asked);
    for (const CycleCount& count : all.cycle_counts) {
        const bool good = count.cycles && *count.cycles <= most_cycles_asked;
        text +=
            fmt::format("{:8}{:>13}{:>6}  {}{}\n", count.where.problem, size_of(count.where.extent),
                        count.cycles ? std::to_string(*count.cycles) : "-", verdict(good),
                        count.reference_trusted ? "" : "  (reference not converged)");
    }
    return text;
}

/// "moved 0.3 % of the points in 1.2 % of the time, size ratio 1.66 -> 1.66".
std::string untangling_text(const FoldCheck& check) {
    if (!check.untangled) return "";
    const double moved =
        static_cast<double>(check.points_moved) / static_cast<double>(check.where.extent.nodes());
    const double cost = check.untangle_seconds / check.solve_seconds;
    const bool good = !check.whole_grid && moved <= most_points_moved &&
                      cost <= most_untangling_cost &&
                      check.seam_after <= seam_slack * check.seam_before;
    return fmt::format(
        "  untangled: {:.2f} % moved, {:.1f} % of the solve, size ratio {:.2f} -> "
        "{:.2f}{}  {}",
        100 * moved, 100 * cost, check.seam_before, check.seam_after,
        check.whole_grid ? ", whole grid" : "", verdict(good));
}

std::string folds_table(const Comparison& all) {
    const char* row = "{:8}{:>13}  {:12}{:>15}{:>8}{:>8}{:>8}{:>8}{:>10}";
    std::string text = fmt::format(fmt::runtime(row), "folded", "points", "start", "status",
                                   "cycles", "start", "solved", "end", "min SJ") +
                       "\n";
    for (const FoldCheck& check : all.folds) {
        const bool good = check.after.folded == 0 && check.status == SolveStatus::converged;
        text += fmt::format(fmt::runtime(row), check.where.problem, size_of(check.where.extent),
                            check.start == Start::folded ? "folded" : "transfinite",
                            status_name(check.status), check.cycles, check.folded_at_start,
                            check.folded_by_solve, check.after.folded,
                            fmt::format("{:.2g}", check.after.least_scaled_jacobian)) +
                fmt::format("  {}{}\n", verdict(good), untangling_text(check));
    }
    return text;
}

std::string machine_lines(const Comparison& all) {
    std::string text;
    if (all.block_cycle) {
        const BlockCycle& cycle = *all.block_cycle;
        const double over = cycle.seconds_per_cycle / cycle.seconds_at_bandwidth;
        const double gain = cycle.seconds_one_thread / cycle.seconds_two_threads;
        const auto points = static_cast<double>(cycle.where.extent.nodes());
        text += fmt::format(
            "a cycle of {} {}: {:.3f} us/pt; triad {:.1f} GB/s and {} bytes/pt would be {:.3f}: "
            "{:.1f} times, at most {} asked  {}\n",
            cycle.where.problem, size_of(cycle.where.extent),
            1e6 * cycle.seconds_per_cycle / points, 1e-9 * cycle.triad, block_cycle_bytes_per_point,
            1e6 * cycle.seconds_at_bandwidth / points, over, most_over_bandwidth,
            verdict(over <= most_over_bandwidth));
        text += fmt::format("two threads on it: {:.2f} times one, at least {} asked  {}\n", gain,
                            least_gain_of_two_threads, verdict(gain >= least_gain_of_two_threads));
    }
    if (all.whole_run) {
        text += fmt::format(
            "a whole run of {:.0f} points: {:.0f} bytes/pt beyond an empty one, at most {} asked  "
            "{}; {:.1f} s\n",
            all.whole_run->points, all.whole_run->bytes_per_point, most_bytes_of_run,
            verdict(all.whole_run->bytes_per_point <= most_bytes_of_run), all.whole_run->seconds);
    }
    return text;
}

Json timing_json(const MethodRun& run, const std::optional<Timing>& timing) {
    if (!timing) return nullptr;
    return {{"seconds", timing->seconds},
            {"microseconds_per_point", run.microseconds_per_point(*timing)},
            {"cycles", timing->cycles}};
}

Json case_json(const Case& c) {
    return {{"problem", c.problem}, {"extent", {c.extent.ni, c.extent.nj, c.extent.nk}}};
}

Json runs_json(const Comparison& all) {
    Json rows = Json::array();
    for (const CaseComparison& c : all.cases) {
        for (const MethodRun& run : c.runs) {
            Json row = case_json(c.where);
            row["method"] = run.name;
            row["family"] = run.family;
            row["to_1e-2"] = timing_json(run, run.to_coarse);
            row["to_1e-4"] = timing_json(run, run.to_fine);
            row["seconds"] = run.seconds;
            row["diverged"] = run.diverged;
            row["bytes_per_point"] = run.bytes_per_point;
            row["reference_trusted"] = c.reference_trusted;
            rows.push_back(row);
        }
    }
    return rows;
}

Json ratios_json(const Comparison& all) {
    Json rows = Json::array();
    for (const CaseComparison& c : all.cases) {
        Json row = case_json(c.where);
        for (const char* family : {"hypre", "SLOR", "ILU-BiCGSTAB"}) {
            const Ratio ratio = ratio_to(c, family);
            if (ratio.none) continue;
            row[family] = {{"ratio", ratio.value}, {"at_least", ratio.at_least}};
        }
        rows.push_back(row);
    }
    return rows;
}

Json folds_json(const Comparison& all) {
    Json rows = Json::array();
    for (const FoldCheck& check : all.folds) {
        Json row = case_json(check.where);
        row["start"] = check.start == Start::folded ? "folded" : "transfinite";
        row["status"] = status_name(check.status);
        row["cycles"] = check.cycles;
        row["seconds"] = check.solve_seconds;
        row["folded_at_start"] = check.folded_at_start;
        row["folded_by_solve"] = check.folded_by_solve;
        row["folded_after"] = check.after.folded;
        row["flat_corners"] = check.after.flat_corners;
        row["least_scaled_jacobian"] = check.after.least_scaled_jacobian;
        if (check.untangled) {
            row["untangling"] = {{"seconds", check.untangle_seconds},
                                 {"points_moved", check.points_moved},
                                 {"whole_grid", check.whole_grid},
                                 {"size_ratio_before", check.seam_before},
                                 {"size_ratio_after", check.seam_after}};
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

std::string report_text(const Comparison& all) {
    std::string text = fmt::format("{}; {}\none core, processor time, unless said\n",
                                   processor_name(), build_description());
    if (!all.cases.empty()) text += "\n" + runs_table(all);
    if (all.cases.size() > 1) text += "\n" + ratios_table(all);
    if (!all.cycle_counts.empty()) text += "\n" + cycles_table(all);
    if (!all.folds.empty()) text += "\n" + folds_table(all);
    return text + "\n" + machine_lines(all);
}

std::string report_json(const Comparison& all) {
    Json json;
    json["machine"] = processor_name();
    json["build"] = build_description();
    json["runs"] = runs_json(all);
    json["ratios"] = ratios_json(all);
    json["cycles"] = Json::array();
    for (const CycleCount& count : all.cycle_counts) {
        Json row = case_json(count.where);
        row["cycles"] = count.cycles ? Json(*count.cycles) : Json(nullptr);
        json["cycles"].push_back(row);
    }
    json["folds"] = folds_json(all);
    if (all.block_cycle) {
        json["block_cycle"] = {{"seconds", all.block_cycle->seconds_per_cycle},
                               {"triad_bytes_per_second", all.block_cycle->triad},
                               {"seconds_at_bandwidth", all.block_cycle->seconds_at_bandwidth},
                               {"seconds_one_thread", all.block_cycle->seconds_one_thread},
                               {"seconds_two_threads", all.block_cycle->seconds_two_threads}};
    }
    if (all.whole_run) {
        json["whole_run"] = {{"points", all.whole_run->points},
                             {"seconds", all.whole_run->seconds},
                             {"bytes_per_point", all.whole_run->bytes_per_point}};
    }
    return json.dump(2) + "\n";
}

}  // namespace hexweave::bench
