// SPDX-License-Identifier: Apache-2.0
#include "io/topology_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "io/graph_lines.h"
#include "io/topology_text.h"

namespace hexweave {

std::vector<bool> cut_edges(const Topology& topology) {
    std::vector<bool> cut(topology.edges.size(), false);
    for (const Face& face : topology.faces) {
        std::map<int, int> uses;
        for (const auto& side : face.sides) {
            for (const EdgeUse& use : side) ++uses[use.edge];
        }
        for (const auto& [edge, times] : uses) {
            if (times > 1) cut[static_cast<std::size_t>(edge)] = true;
        }
    }
    return cut;
}

namespace {

constexpr double letters = 13;

struct LegendEntry {
    std::string text;
    Stroke sample;  ///< its lines from (0, 0) to (22, 0)
};

std::vector<LegendEntry> legend_of(const Topology& topology) {
    const Polyline line{{0, 0}, {22, 0}};
    std::vector<LegendEntry> entries;
    for (std::size_t b = 0; b < topology.boundaries.size(); ++b) {
        const Family& family = topology.boundaries[b].family;
        entries.push_back({fmt::format("{} ({})", family.name, family.type),
                           {{line}, palette(static_cast<int>(b)), 4}});
    }
    for (const PeriodicInterface& interface : topology.periodic) {
        entries.push_back(
            {fmt::format("{} (periodic: {})", interface.name, map_text(interface.periodicity)),
             {dashes(line), periodic_colour, 3}});
    }
    const std::vector<bool> cut = cut_edges(topology);
    if (!topology.is_3d() && std::find(cut.begin(), cut.end(), true) != cut.end()) {
        entries.push_back({"cut: a face is joined to itself", {{line}, cut_colour, 7}});
    }
    return entries;
}

}  // namespace

void append_legend(const Topology& topology, const PagePoint& at, double right, Drawing& drawing) {
    constexpr double row = 20;
    double x = at.x;
    double y = at.y;
    for (LegendEntry entry : legend_of(topology)) {
        const double width = 34 + text_width(entry.text, letters);
        if (x + width > right) {
            x = at.x;
            y += row;
        }
        for (Polyline& piece : entry.sample.lines) {
            for (PagePoint& p : piece) p = {p.x + x, p.y + y - 4};
        }
        drawing.items.emplace_back(entry.sample);
        drawing.items.emplace_back(Label{{x + 28, y}, entry.text, letters, Anchor::left, ink});
        x += width + 24;
    }
}

}  // namespace hexweave
