// SPDX-License-Identifier: Apache-2.0
#include "io/quality_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text_parts.h"

namespace hexweave {

namespace {

std::string nodes_text(const Extent& e) {
    std::string text = fmt::format("{} x {}", e.ni, e.nj);
    if (e.nk > 1) text += fmt::format(" x {}", e.nk);
    return text;
}

template <class T, class Name>
std::size_t width_of(const std::vector<T>& rows, std::size_t least, Name name) {
    std::size_t width = least;
    for (const T& row : rows) width = std::max(width, name(row).size());
    return width;
}

double greatest_growth(const ZoneMeasure& zone) {
    double greatest = 1;
    for (const GrowthMeasure& growth : zone.growth) greatest = std::max(greatest, growth.ratio);
    return greatest;
}

BendMeasure all_bends(const ZoneQuality& zone) {
    BendMeasure all;
    for (const BendMeasure& bends : zone.bends) all.include(bends);
    return all;
}

std::string zone_table(const GridQuality& q) {
    const auto name = [](const ZoneQuality& z) { return z.measure.name; };
    const std::size_t width = width_of(q.zones, 4, name);
    std::string text =
        fmt::format("{:<{}} {:>15} {:>7} {:>9} {:>10} {:>10} {:>10} {:>14} {:>13} {:>8} {:>12}\n",
                    "zone", width, "nodes", "folded", "scaled J.", "least J.", "least vol.",
                    "volume", "angles", "skewness 99 %", "growth", "bend MDS/ADS");
    for (const ZoneQuality& z : q.zones) {
        const BendMeasure bends = all_bends(z);
        text += fmt::format(
            "{:<{}} {:>15} {:>7} {:>9.4f} {:>10.3e} {:>10.3e} {:>10.4g} {:>6.2f} {:>7.2f} {:>7.3f} "
            "{:>5.3f} {:>8.3f} {:>6.1f}/{:.2f}\n",
            z.measure.name, width, nodes_text(z.measure.extent), z.measure.folded,
            z.measure.worst_scaled_jacobian, z.least_jacobian.value, z.least_volume.value, z.volume,
            z.measure.angles.least, z.measure.angles.greatest, z.greatest_skewness.value,
            z.skewness_99, greatest_growth(z.measure), bends.greatest, bends.mean());
    }
    return text;
}

std::string certificate_lines(const GridQuality& q) {
    std::string text = fmt::format(
        "Jacobian positive everywhere inside: {} of {} cells, proven; not positive somewhere: {}; "
        "undecided: {}\n",
        q.cells() - q.not_positive() - q.undecided(), q.cells(), q.not_positive(), q.undecided());
    std::size_t flat = 0;
    for (const ZoneQuality& z : q.zones) flat += z.measure.flat_corners;
    if (flat > 0) text += fmt::format("flat corners on flat edges of zones, excepted: {}\n", flat);
    double aspect = 1;
    for (const ZoneQuality& z : q.zones) aspect = std::max(aspect, z.greatest_aspect_ratio.value);
    return text + fmt::format("greatest aspect ratio: {:.4g}\n", aspect);
}

std::string boundary_table(const GridQuality& q) {
    if (q.boundaries.empty()) return {};
    const auto name = [](const WallMeasure& b) { return b.family; };
    const std::size_t width = width_of(q.boundaries, 8, name);
    std::string text =
        fmt::format("\n{:<{}} {:>9} | {:>22} | {:>11} {:>11} {:>11}\n", "boundary", width, "judged",
                    "off normal, ADO, MDO", "height min", "median", "max");
    for (const WallMeasure& b : q.boundaries) {
        const std::string angles =
            b.nodes > 0 ? fmt::format("{:>13.2f} {:>8.2f}", b.mean_angle, b.greatest_angle)
                        : fmt::format("{:>13} {:>8}", "-", "-");
        text += fmt::format("{:<{}} {:>9} | {} | {:>11.4e} {:>11.4e} {:>11.4e}\n", b.family, width,
                            b.nodes, angles, b.least_height, b.median_height, b.greatest_height);
    }
    return text;
}

std::string interface_table(const GridQuality& q) {
    if (q.interfaces.empty()) return {};
    const auto name = [](const InterfaceQuality& i) { return i.measure.name; };
    const std::size_t width = width_of(q.interfaces, 9, name);
    std::string text = fmt::format("\n{:<{}} {:>10} {:>8} {:>14}\n", "interface", width,
                                   "mismatched", "growth", "bend MDS/ADS");
    for (const InterfaceQuality& i : q.interfaces) {
        text += fmt::format("{:<{}} {:>10} {:>8.3f} {:>8.1f}/{:.2f}\n", i.measure.name, width,
                            i.measure.mismatched, i.measure.growth.ratio, i.bends.greatest,
                            i.bends.mean());
    }
    return text;
}

std::string limit_text(const Histogram& h, std::size_t bin) {
    if (bin == 0) return fmt::format("< {:g}", h.limits.front());
    if (bin == h.limits.size()) return fmt::format(">= {:g}", h.limits.back());
    return fmt::format("{:g} - {:g}", h.limits[bin - 1], h.limits[bin]);
}

std::string histogram_text(const Histogram& h) {
    constexpr double full_bar = 40;
    const std::size_t total = h.total();
    if (total == 0) return {};
    std::string text = "\n" + h.measure + "\n";
    for (std::size_t bin = 0; bin < h.counts.size(); ++bin) {
        const double share = static_cast<double>(h.counts[bin]) / static_cast<double>(total);
        std::string bar(static_cast<std::size_t>(std::lround(share * full_bar)), '#');
        if (bar.empty() && h.counts[bin] > 0) bar = ".";
        text += fmt::format("{:>14} {:>11} {:>6.2f} % {}", limit_text(h, bin), h.counts[bin],
                            100 * share, bar);
        while (text.back() == ' ') text.pop_back();
        text += "\n";
    }
    return text;
}

std::string worst_table(const GridQuality& q) {
    if (q.worst.empty()) return {};
    const auto name = [](const WorstCell& w) { return w.zone; };
    const std::size_t width = width_of(q.worst, 4, name);
    std::string text = fmt::format("\nworst cells\n{:<{}} {:>18} {:>10} {:>11} {:>9}  {}\n", "zone",
                                   width, "cell", "scaled J.", "volume", "skewness", "place");
    for (const WorstCell& w : q.worst) {
        const auto zone = std::find_if(q.zones.begin(), q.zones.end(), [&](const ZoneQuality& z) {
            return z.measure.name == w.zone;
        });
        const bool hidden = w.verdict == JacobianVerdict::not_positive && w.scaled_jacobian > 0;
        text += fmt::format("{:<{}} {:>18} {:>10.6f} {:>11.3e} {:>9.4f}  {}{}\n", w.zone, width,
                            node_text(w.cell, zone->measure.extent.nk == 1 ? 2 : 3),
                            w.scaled_jacobian, w.volume, w.skewness, place_text(w.place),
                            hidden ? ", not positive inside" : "");
    }
    return text;
}

std::string verdict_line(const GridQuality& q) {
    if (q.sound()) {
        return fmt::format("sound: {}, {} cells, none folded\n", counted(q.zones.size(), "zone"),
                           grouped(q.cells()));
    }
    std::string text = "NOT SOUND:";
    if (q.folded() > 0) text += fmt::format(" {},", counted(q.folded(), "folded cell"));
    if (q.not_positive() > 0) {
        text += fmt::format(" {} with a Jacobian that is not positive somewhere,",
                            counted(q.not_positive(), "cell"));
    }
    if (q.folded() + q.not_positive() > 0 && !q.worst.empty()) {
        text += fmt::format(" the worst in '{}' at {},", q.worst.front().zone,
                            place_text(q.worst.front().place));
    }
    if (q.mismatched() > 0) {
        text += fmt::format(" {} of interfaces that differ on the two sides,",
                            counted(q.mismatched(), "node"));
    }
    text.back() = '\n';
    return text;
}

}  // namespace

std::string to_text(const GridQuality& quality) {
    std::string text;
    if (!quality.title.empty()) text += quality.title + "\n";
    text += zone_table(quality) + certificate_lines(quality) + boundary_table(quality) +
            interface_table(quality);
    for (const Histogram& h : quality.histograms) text += histogram_text(h);
    return text + worst_table(quality) + "\n" + verdict_line(quality);
}

}  // namespace hexweave
