// SPDX-License-Identifier: Apache-2.0
#include "io/solve_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "io/text_parts.h"

namespace hexweave {
namespace {

/// How far orthogonality at the boundary got; by default only where it fell short of what was
/// asked.
std::string orthogonality_line(const SolveResult& result, bool verbose) {
    if (!result.orthogonality) return {};
    const Orthogonality& o = *result.orthogonality;
    const bool complete = o.end == OrthogonalityEnd::all_passes;
    if (complete && o.limited == 0 && !verbose) return {};
    std::string text = fmt::format("  orthogonal: {} done",
                                   counted(static_cast<std::size_t>(o.passes), "pass", "passes"));
    if (!complete) {
        text += fmt::format(" of {}, then {}", o.passes_asked, orthogonality_end_name(o.end));
    } else if (o.limited > 0) {
        text += fmt::format(", edge functions limited in {} intervals", o.limited);
    }
    return text + "\n";
}

/// What the solver fell back on; empty where the usual cycles were enough.
std::string safeguard_line(const SolveResult& result) {
    if (result.safeguards.empty()) return {};
    std::string text = "  safeguards entered:";
    for (const Safeguard& s : result.safeguards) {
        text +=
            fmt::format("{} {}", &s == &result.safeguards.front() ? "" : ",", safeguard_name(s));
    }
    return text + "\n";
}

/// Which grid stands where a solve did not converge.
std::string kept_line(const SolveResult& result) {
    if (!result.kept_cycle) return {};
    if (*result.kept_cycle == 0) return "  kept: the start grid; no cycle gave a better one\n";
    return fmt::format("  kept: the best grid, of cycle {} of {}\n", *result.kept_cycle,
                       result.history.size());
}

/// Where untangling acted, how far points moved, and where it failed.
std::string untangling_line(const SolveResult& result) {
    if (!result.untangling) return {};
    const Untangling& u = *result.untangling;
    const auto unsigned_of = [](long n) { return static_cast<std::size_t>(n); };
    std::string text =
        fmt::format("  untangled: {}", counted(unsigned_of(u.folded_before), "folded cell"));
    if (u.points_moved > 0) {
        if (u.patches > 0) {
            text += " in " + counted(static_cast<std::size_t>(u.patches), "patch", "patches");
        }
        if (u.whole_grid) {
            text += u.patches > 0 ? ", then with all points free" : " with all points free";
        }
        text += fmt::format(", {} moved, at most {:.3g} at {}",
                            counted(unsigned_of(u.points_moved), "point"), u.largest_move,
                            place_text(u.place));
    }
    if (u.left_at) text += fmt::format("; STILL FOLDED at {}", place_text(*u.left_at));
    return text + "\n";
}

/// How far the edges of a face are off its surfaces; by default only where it is more than points
/// of a surface are allowed to be.
std::string off_surface_line(const SolveMeasure& s, bool verbose) {
    constexpr double allowed = 1e-10;
    if (!s.off_surface) return {};
    const OffSurface& off = *s.off_surface;
    if (off.distance <= allowed * off.size && !verbose) return {};
    return fmt::format("  its edges are up to {:.2g} off its surface, at {}\n", off.distance,
                       place_text(off.place));
}

std::string solve_row(const SolveMeasure& s, std::size_t width) {
    const SolveResult& r = s.result;
    const std::string name = (s.is_block ? "block " : "face ") + s.name;
    const std::string nodes =
        s.is_block ? fmt::format("{} x {} x {}", s.extent.ni, s.extent.nj, s.extent.nk)
                   : fmt::format("{} x {}", s.extent.ni, s.extent.nj);
    std::string text =
        fmt::format("{:<{}}  {:>15} {:<14} ", name, width, nodes, status_name(r.status));
    if (r.status == SolveStatus::algebraic) {
        text += fmt::format("{:>6} {:>5} {:>14} ", "-", "-", "-");
    } else {
        text += fmt::format("{:>6} {:>5.2f} {:>8.1e} cells ", r.cycles, r.rate, r.displacement);
    }
    return text + fmt::format("{:>13} {:>6}\n", r.folded_before, r.folded_after);
}

}  // namespace

std::string solve_table(const Report& report, bool verbose) {
    std::size_t width = 6;
    for (const SolveMeasure& s : report.solves) width = std::max(width, s.name.size() + 6);
    std::string text =
        fmt::format("{:<{}}  {:>15} {:<14} {:>6} {:>5} {:>14} {:>13} {:>6}\n", "solve", width,
                    "nodes", "status", "cycles", "rate", "displacement", "folded before", "after");
    for (const SolveMeasure& s : report.solves) {
        const SolveResult& r = s.result;
        text += solve_row(s, width) + safeguard_line(r) + kept_line(r) + untangling_line(r) +
                orthogonality_line(r, verbose) + off_surface_line(s, verbose);
        if (!verbose) continue;
        if (!s.flat_at.empty()) {
            text += fmt::format("  sides meet flat at {}\n", fmt::join(s.flat_at, ", "));
        }
        for (std::size_t n = 0; n < r.history.size(); ++n) {
            text += fmt::format("  cycle {:>3}  displacement {:.3e} cells\n", n + 1, r.history[n]);
        }
    }
    return text;
}

}  // namespace hexweave
