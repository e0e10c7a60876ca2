// SPDX-License-Identifier: Apache-2.0
#include "io/measure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "io/text_parts.h"

namespace hexweave {

std::string worst_cell_text(const ZoneMeasure& z) {
    return node_text(z.worst_cell, z.extent.nk == 1 ? 2 : 3);
}

std::string zone_table(const Report& report) {
    std::size_t width = 4;
    for (const ZoneMeasure& z : report.zones) width = std::max(width, z.name.size());
    std::string text =
        fmt::format("{:<{}}  {:>10} {:>12} {:>10} {:>7} {:>6}  {}\n", "zone", width, "cells",
                    "worst corner", "inside", "folded", "flat", "worst cell");
    for (const ZoneMeasure& z : report.zones) {
        text +=
            fmt::format("{:<{}}  {:>10} {:>12.4g} {:>10.4g} {:>7} {:>6}  {} at {}\n", z.name, width,
                        grouped(z.cells), z.worst_scaled_jacobian, z.worst_inside, z.folded,
                        z.flat_corners, worst_cell_text(z), place_text(z.worst_place));
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
        "angles {:.1f} to {:.1f} degrees, the worst at {}; {:.1f} % within 5 "
        "of 90, {:.1f} % within 10\n",
        angles.least, angles.greatest, place_text(angles.worst_place()), percent(angles.within_5),
        percent(angles.within_10));
}

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

}  // namespace hexweave
