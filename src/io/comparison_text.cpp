// SPDX-License-Identifier: Apache-2.0
#include "io/comparison_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "io/text_parts.h"

namespace hexweave {
namespace {

std::string nodes_text(const Extent& extent, int axes) {
    std::string text = std::to_string(extent.ni);
    for (int axis = 1; axis < axes; ++axis) text += fmt::format("x{}", extent[axis]);
    return text;
}

std::string size_text(double size) {
    return std::isinf(size) ? "infinite" : size == 0 ? "0" : fmt::format("{:.3g}", size);
}

std::string zone_text(const ZoneComparison& zone) {
    std::string text = zone.name;
    if (zone.name != zone.golden_name) text += " = " + zone.golden_name;
    if (!(zone.to_golden == Orientation{})) text += " " + to_string(zone.to_golden, 3);
    return text;
}

/// The cells of one line of the table.
using Line = std::array<std::string, 7>;

Line heading(const GridComparison& comparison) {
    const std::string unit = comparison.units.empty() ? "length" : comparison.units;
    return {"zone", "nodes", "beyond", "cells", "at", "x, y, z", unit};
}

Line line_of(const ZoneComparison& zone, int axes) {
    const ZoneDeviation& d = zone.deviation;
    const Vec3& p = d.in_cells.place;
    const bool any = d.in_cells.size > 0;
    return {zone_text(zone),
            nodes_text(zone.extent, axes),
            std::to_string(d.beyond),
            size_text(d.in_cells.size),
            any ? node_text(d.in_cells.node, axes) : "-",
            any ? place_text(p) : "-",
            size_text(d.in_length.size)};
}

std::string table(const std::vector<Line>& lines) {
    std::array<std::size_t, 7> widths{};
    for (const Line& line : lines) {
        for (std::size_t n = 0; n < line.size(); ++n) {
            widths[n] = std::max(widths[n], line[n].size());
        }
    }
    std::string text;
    for (const Line& line : lines) {
        std::string row = fmt::format("{:<{}}", line[0], widths[0]);
        for (std::size_t n = 1; n < line.size(); ++n) {
            row += fmt::format("  {:>{}}", line[n], widths[n]);
        }
        text += row + "\n";
    }
    return text;
}

std::string others_text(const char* which, const std::vector<OtherNodes>& others) {
    std::string text;
    for (const OtherNodes& kind : others) {
        text += fmt::format("not compared, in the {}: {} ({}), {}{}\n", which, kind.kind,
                            kind.count, kind.first, kind.count > 1 ? ", ..." : "");
    }
    return text;
}

std::string plural_of(const std::string& kind) {
    if (kind == "dimensions" || kind == "units") return kind;
    return kind.back() == 'y' ? kind.substr(0, kind.size() - 1) + "ies" : kind + "s";
}

/// "2 boundaries, 1 interface".
std::string kinds_text(const std::vector<Difference>& differences) {
    std::vector<std::string> kinds;
    std::map<std::string, std::size_t> counts;
    for (const Difference& d : differences) {
        if (counts[d.kind]++ == 0) kinds.push_back(d.kind);
    }
    std::string text;
    for (const std::string& kind : kinds) {
        text += text.empty() ? "" : ", ";
        text += kind == "units" ? kind : counted(counts[kind], kind, plural_of(kind));
    }
    return text;
}

}  // namespace

std::string to_text(const GridComparison& comparison) {
    std::vector<Line> lines{heading(comparison)};
    for (const ZoneComparison& zone : comparison.zones) {
        lines.push_back(line_of(zone, comparison.cell_dimension));
    }
    std::string text = comparison.zones.empty() ? "" : table(lines);
    for (const Difference& d : comparison.differences) {
        text += fmt::format("{}: {}\n", d.kind, d.text);
    }
    text += others_text("new grid", comparison.others);
    text += others_text("golden grid", comparison.golden_others);
    return text;
}

std::string verdict(const GridComparison& comparison) {
    const ZoneDeviation all = comparison.all();
    const std::string largest = fmt::format(
        "largest deviation {} cells, {}{}{}", size_text(all.in_cells.size),
        size_text(all.in_length.size), comparison.units.empty() ? "" : " ", comparison.units);
    if (comparison.same()) {
        // Below the floor no part of a cell counts.
        const std::string floor =
            all.in_cells.size > comparison.tolerance
                ? fmt::format(" or round-off, {:.3g}{}{}", comparison.floor,
                              comparison.units.empty() ? "" : " ", comparison.units)
                : "";
        return fmt::format("same: {} in {}, within {:g} of a cell{}; {}",
                           counted(all.points, "point"), counted(comparison.zones.size(), "zone"),
                           comparison.tolerance, floor, largest);
    }
    std::string text = "different: ";
    if (all.beyond > 0) {
        text += fmt::format("{} of {} beyond {:g} of a cell", counted(all.beyond, "point"),
                            all.points, comparison.tolerance);
        if (all.not_finite > 0) text += fmt::format(", {} no finite number", all.not_finite);
        if (std::isfinite(all.in_cells.size)) text += ", " + largest;
    }
    if (!comparison.differences.empty()) {
        text += all.beyond > 0 ? "; also " : "";
        text += kinds_text(comparison.differences);
    }
    return text;
}

}  // namespace hexweave
