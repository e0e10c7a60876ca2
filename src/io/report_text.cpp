// SPDX-License-Identifier: Apache-2.0
#include "io/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/heights_text.h"
#include "io/level_text.h"

namespace hexweave {
namespace {

/// 1234567 as "1,234,567".
std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), ",");
    }
    return digits;
}

/// "1 cell", "2 cells"; "1 pass", "2 passes".
std::string counted(std::size_t number, const std::string& one, const std::string& more) {
    return grouped(number) + " " + (number == 1 ? one : more);
}
std::string counted(std::size_t number, const std::string& one) {
    return counted(number, one, one + "s");
}

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

std::string place_text(const Vec3& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
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

std::string node_text(const ZoneMeasure& z) {
    if (z.extent.nk == 1) return fmt::format("({}, {})", z.worst_cell[0] + 1, z.worst_cell[1] + 1);
    return fmt::format("({}, {}, {})", z.worst_cell[0] + 1, z.worst_cell[1] + 1,
                       z.worst_cell[2] + 1);
}

std::string zone_table(const Report& report) {
    std::size_t width = 4;
    for (const ZoneMeasure& z : report.zones) width = std::max(width, z.name.size());
    std::string text =
        fmt::format("{:<{}}  {:>10} {:>12} {:>10} {:>7} {:>6}  {}\n", "zone", width, "cells",
                    "worst corner", "inside", "folded", "flat", "worst cell");
    for (const ZoneMeasure& z : report.zones) {
        text += fmt::format(
            "{:<{}}  {:>10} {:>12.4g} {:>10.4g} {:>7} {:>6}  {} at ({:.6g}, {:.6g}, {:.6g})\n",
            z.name, width, grouped(z.cells), z.worst_scaled_jacobian, z.worst_inside, z.folded,
            z.flat_corners, node_text(z), z.worst_place.x, z.worst_place.y, z.worst_place.z);
    }
    const std::size_t poles = report.pole_corners();
    if (poles > 0) text += fmt::format("{} corners at poles are counted apart\n", grouped(poles));
    return text;
}

std::string angle_line(const Report& report) {
    const AngleMeasure angles = report.angles();
    if (angles.corners == 0) return {};
    const auto percent = [&](std::size_t corners) {
        return 100.0 * static_cast<double>(corners) / static_cast<double>(angles.corners);
    };
    return fmt::format(
        "angles {:.1f} to {:.1f} degrees, the worst at ({:.6g}, {:.6g}, {:.6g}); {:.1f} % within 5 "
        "of 90, {:.1f} % within 10\n",
        angles.least, angles.greatest, angles.worst_place.x, angles.worst_place.y,
        angles.worst_place.z, percent(angles.within_5), percent(angles.within_10));
}

/// The worst along the lines of each axis, and across interfaces.
std::string growth_line(const Report& report) {
    std::string text;
    const auto add = [&](const std::string& where, double ratio, const std::string& entity) {
        if (ratio <= 1) return;
        text += fmt::format("{} {:.3g} {} ('{}')", text.empty() ? "growth at most" : ",", ratio,
                            where, entity);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto worst = std::max_element(report.zones.begin(), report.zones.end(),
                                            [axis](const auto& a, const auto& b) {
                                                return a.growth[axis].ratio < b.growth[axis].ratio;
                                            });
        if (worst == report.zones.end()) continue;
        add(fmt::format("along {}", "ijk"[axis]), worst->growth[axis].ratio, worst->name);
    }
    const auto worst = std::max_element(
        report.interfaces.begin(), report.interfaces.end(),
        [](const auto& a, const auto& b) { return a.growth.ratio < b.growth.ratio; });
    if (worst != report.interfaces.end()) add("across", worst->growth.ratio, worst->name);
    return text.empty() ? text : text + "\n";
}

/// The worst bend across an interface, and what would straighten it.
std::string bend_line(const Report& report) {
    constexpr double striking = 30;
    const auto worst = std::max_element(
        report.interfaces.begin(), report.interfaces.end(),
        [](const InterfaceMeasure& a, const InterfaceMeasure& b) { return a.bend < b.bend; });
    if (worst == report.interfaces.end() || worst->bend < striking) return {};
    std::string text =
        fmt::format("warning: grid lines bend by up to {:.0f} degrees across '{}', at {}",
                    worst->bend, worst->name, place_text(worst->bend_place));
    const bool faces_alone = std::none_of(report.solves.begin(), report.solves.end(),
                                          [](const SolveMeasure& s) { return s.is_block; });
    if (faces_alone) {
        text += fmt::format("\n  hint: `orthogonal` at {} and {} makes them cross it straight",
                            worst->sides[0], worst->sides[1]);
    }
    return text + "\n";
}

std::string wall_lines(const Report& report) {
    std::string text;
    for (const WallMeasure& w : report.walls) {
        text += fmt::format("wall '{}': ", w.family);
        if (w.nodes > 0) {
            text += fmt::format(
                "lines leave {:.2g} degrees off its normal on average, {:.2g} at most, {:.2g} "
                "beside its ends; ",
                w.mean_angle, w.greatest_angle, w.greatest_angle_beside_ends);
        } else {
            text += "too few nodes to measure angles; ";
        }
        text += fmt::format("first heights {:.3g} to {:.3g}, median {:.3g}\n", w.least_height,
                            w.greatest_height, w.median_height);
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
        found.push_back(fmt::format("{} in zone '{}', the worst {} at ({:.6g}, {:.6g}, {:.6g})",
                                    counted(z.folded, "folded cell"), z.name, node_text(z),
                                    z.worst_place.x, z.worst_place.y, z.worst_place.z));
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
    text += "\n" + angle_line(report) + growth_line(report) + bend_line(report) +
            wall_lines(report) + gate_lines(report);
    text += "\n" + stage_line(report);
    return text;
}

std::string cautions(const Report& report) {
    std::string text;
    for (const SolveMeasure* face : report.folded_faces()) {
        const auto& untangling = face->result.untangling;
        text += fmt::format(
            "warning: face '{}' folds as a surface, in {}{}{}\n", face->name,
            counted(static_cast<std::size_t>(face->result.folded_after), "cell"),
            untangling && untangling->left_at ? " at " + place_text(*untangling->left_at) : "",
            report.folded() == 0 ? "; no cell of the blocks is folded" : "");
    }
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
