// SPDX-License-Identifier: Apache-2.0
#include "io/report_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "io/graph_lines.h"
#include "io/picture_colours.h"
#include "io/picture_drawing.h"

namespace hexweave {

namespace {

using Pair = std::pair<int, int>;

constexpr double spring_length = 110;  ///< between joined zones [pixels]
constexpr int rounds = 400;
constexpr double margin = 80;

/// Zones that are joined, each pair once, with the names of the interfaces between them.
std::map<Pair, std::vector<const Interface*>> joins_of(const MultiblockGrid& grid) {
    std::map<Pair, std::vector<const Interface*>> joins;
    for (const Interface& interface : grid.interfaces) {
        joins[std::minmax(interface.zone, interface.donor)].push_back(&interface);
    }
    return joins;
}

/// One step of the forces of Fruchterman and Reingold: all zones push each other away, joined ones
/// pull each other together; no zone moves farther than `reach`.
void relax(std::vector<PagePoint>& spots, const std::vector<Pair>& joined, double reach) {
    std::vector<PagePoint> force(spots.size());
    const auto push = [&](std::size_t a, std::size_t b, double strength) {
        const double dx = spots[a].x - spots[b].x;
        const double dy = spots[a].y - spots[b].y;
        const double d = std::max(std::hypot(dx, dy), 1e-3);
        const double size = strength > 0 ? strength * spring_length * spring_length / d
                                         : strength * d * d / spring_length;
        force[a].x += dx / d * size;
        force[a].y += dy / d * size;
        force[b].x -= dx / d * size;
        force[b].y -= dy / d * size;
    };
    for (std::size_t a = 0; a < spots.size(); ++a) {
        for (std::size_t b = a + 1; b < spots.size(); ++b) push(a, b, 1);
    }
    for (const auto& [a, b] : joined) {
        push(static_cast<std::size_t>(a), static_cast<std::size_t>(b), -1);
    }
    for (std::size_t n = 0; n < spots.size(); ++n) {
        const double size = std::max(std::hypot(force[n].x, force[n].y), 1e-12);
        spots[n].x += force[n].x / size * std::min(size, reach);
        spots[n].y += force[n].y / size * std::min(size, reach);
    }
}

std::vector<PagePoint> place_zones(std::size_t count, const std::vector<Pair>& joined) {
    constexpr double turn = 6.283185307179586;
    std::vector<PagePoint> spots(count);
    const double radius = spring_length * std::max(1.0, static_cast<double>(count) / 6);
    for (std::size_t n = 0; n < count; ++n) {
        const double angle = turn * static_cast<double>(n) / static_cast<double>(count);
        // Not quite a circle, on which forces of a symmetric graph could cancel.
        const double r = radius * (1 + 0.02 * static_cast<double>(n % 3));
        spots[n] = {r * std::cos(angle), r * std::sin(angle)};
    }
    const int steps = count > 400 ? 40 : rounds;
    for (int step = 0; step < steps; ++step) {
        relax(spots, joined, spring_length * 0.3 * (1 - static_cast<double>(step) / steps));
    }
    return spots;
}

void move_to_margins(std::vector<PagePoint>& spots, double& width, double& height) {
    PagePoint low = spots.front();
    PagePoint high = spots.front();
    for (const PagePoint& s : spots) {
        low = {std::min(low.x, s.x), std::min(low.y, s.y)};
        high = {std::max(high.x, s.x), std::max(high.y, s.y)};
    }
    for (PagePoint& s : spots) s = {s.x - low.x + margin, s.y - low.y + margin};
    width = high.x - low.x + 2 * margin;
    height = high.y - low.y + 2 * margin;
}

std::string range_text(const IndexBox& box) {
    return fmt::format("({}, {}, {}) to ({}, {}, {})", box.begin[0] + 1, box.begin[1] + 1,
                       box.begin[2] + 1, box.end[0] + 1, box.end[1] + 1, box.end[2] + 1);
}

std::string join_text(const MultiblockGrid& grid, const std::vector<const Interface*>& interfaces) {
    std::string text;
    for (const Interface* i : interfaces) {
        text += fmt::format("{}{}{}: {} {} = {} {}", text.empty() ? "" : "\n", i->name,
                            i->periodic ? " (periodic)" : "",
                            grid.zones[static_cast<std::size_t>(i->zone)].name, range_text(i->box),
                            grid.zones[static_cast<std::size_t>(i->donor)].name,
                            range_text(i->donor_box));
    }
    return escape_html(text);
}

std::string draw_join(const MultiblockGrid& grid, const std::vector<PagePoint>& spots,
                      const Pair& pair, const std::vector<const Interface*>& interfaces) {
    const bool periodic = std::any_of(interfaces.begin(), interfaces.end(),
                                      [](const Interface* i) { return i->periodic.has_value(); });
    const std::string path = svg_path(link_line(spots[static_cast<std::size_t>(pair.first)],
                                                spots[static_cast<std::size_t>(pair.second)], 0));
    return fmt::format(
        "<path class=\"join{}\" d=\"{}\" stroke-width=\"{}\"><title>{}</title></path>\n",
        periodic ? " periodic" : "", path, std::min<std::size_t>(interfaces.size(), 4) + 1,
        join_text(grid, interfaces));
}

/// The families that bound a zone, ascending.
std::set<int> families_of(const MultiblockGrid& grid, int zone) {
    std::set<int> families;
    for (const BoundaryPatch& patch : grid.patches) {
        if (patch.zone == zone) families.insert(patch.family);
    }
    return families;
}

std::string draw_zone(const MultiblockGrid& grid, int index, const PagePoint& at) {
    const Zone& zone = grid.zones[static_cast<std::size_t>(index)];
    const Extent& e = zone.points.extent();
    const std::string name = escape_html(zone.name);
    const double width = 18 + 7.2 * static_cast<double>(zone.name.size());
    std::string text = fmt::format(
        "<g class=\"zone\" data-zone=\"{}\" tabindex=\"0\"><title>{}: {} x {} x {} nodes, {} "
        "cells</title>"
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"24\" rx=\"5\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>",
        index, name, e.ni, e.nj, e.nk, e.cells(), at.x - width / 2, at.y - 12, width, at.x,
        at.y + 4, name);
    const std::set<int> families = families_of(grid, index);
    double x = at.x - 7 * static_cast<double>(families.size() - 1);
    for (const int family : families) {
        const Family& f = grid.families[static_cast<std::size_t>(family)];
        text += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"#{:06x}\"><title>{} "
            "({})</title></circle>",
            x, at.y + 21, to_rgb(palette(family)), escape_html(f.name), escape_html(f.type));
        x += 14;
    }
    return text + "</g>\n";
}

}  // namespace

std::string escape_html(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string topology_graph(const MultiblockGrid& grid) {
    const auto joins = joins_of(grid);
    std::vector<Pair> joined;
    for (const auto& [pair, interfaces] : joins) {
        if (pair.first != pair.second) joined.push_back(pair);
    }
    std::vector<PagePoint> spots = place_zones(grid.zones.size(), joined);
    double width = 0;
    double height = 0;
    move_to_margins(spots, width, height);
    std::string text = fmt::format(
        "<svg class=\"graph\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"zones and "
        "the interfaces between them\">\n",
        width, height);
    for (const auto& [pair, interfaces] : joins) text += draw_join(grid, spots, pair, interfaces);
    for (std::size_t n = 0; n < spots.size(); ++n) {
        text += draw_zone(grid, static_cast<int>(n), spots[n]);
    }
    return text + "</svg>\n";
}

}  // namespace hexweave
