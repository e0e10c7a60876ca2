// SPDX-License-Identifier: Apache-2.0
#include "io/block_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "io/graph_lines.h"

namespace hexweave {
namespace {

constexpr double letters = 12;
constexpr double square = 9;
constexpr double family_step = 46;  // from one square to the next, its side's name between
constexpr std::array<const char*, 6> side_names{"imin", "imax", "jmin", "jmax", "kmin", "kmax"};

/// Where a face stands: block and side of each use.
struct SideOfBlock {
    int block = 0;
    int side = 0;
};

std::map<int, std::vector<SideOfBlock>> uses_of_faces(const Topology& topology) {
    std::map<int, std::vector<SideOfBlock>> uses;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        for (std::size_t s = 0; s < 6; ++s) {
            for (const FaceUse& use : topology.blocks[b].sides[s].faces) {
                uses[use.face].push_back({static_cast<int>(b), static_cast<int>(s)});
            }
        }
    }
    return uses;
}

/// The blocks' order round the circle: by the angle at which they stand about their midst.
std::vector<std::size_t> round_the_circle(const std::vector<PagePoint>& centres,
                                          const PagePoint& midst) {
    std::vector<std::size_t> order(centres.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto angle = [&](std::size_t b) {
        return std::atan2(centres[b].y - midst.y, centres[b].x - midst.x);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
    return order;
}

std::vector<PagePoint> node_places(const Topology& topology, const TopologyLayout& layout,
                                   const Frame& frame) {
    std::vector<PagePoint> centres;
    PagePoint midst;
    for (const Block& block : topology.blocks) {
        centres.push_back(block_centre(block, layout));
        midst = {midst.x + centres.back().x, midst.y + centres.back().y};
    }
    const auto count = static_cast<double>(centres.size());
    midst = {midst.x / count, midst.y / count};
    const auto away = [&](std::size_t b) {
        return std::hypot(centres[b].x - midst.x, centres[b].y - midst.y);
    };
    double farthest = 0;
    for (std::size_t b = 0; b < centres.size(); ++b) farthest = std::max(farthest, away(b));
    std::vector<std::size_t> order = round_the_circle(centres, midst);
    const auto core = std::find_if(order.begin(), order.end(),
                                   [&](std::size_t b) { return away(b) < 0.25 * farthest; });
    const PagePoint middle{(frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2};
    std::vector<PagePoint> places(centres.size(), middle);
    if (centres.size() == 1) return places;
    if (core != order.end() && centres.size() > 3) order.erase(core);
    for (std::size_t n = 0; n < order.size(); ++n) {
        const double angle = 2 * std::numbers::pi * (static_cast<double>(n) + 0.25) /
                             static_cast<double>(order.size());
        places[order[n]] = {middle.x + 0.34 * frame.width() * std::cos(angle),
                            middle.y + 0.38 * frame.height() * std::sin(angle)};
    }
    return places;
}

struct Links {
    const Topology& topology;
    const std::vector<PagePoint>& places;
    std::map<std::pair<int, int>, int> between{};  ///< lines so far, by the two blocks
};

void append_link(Links& links, const SideOfBlock& from, const SideOfBlock& to,
                 const std::string& name, bool periodic, Drawing& drawing, LabelPlacement& labels) {
    const auto ends = std::minmax(from.block, to.block);
    const Polyline line = link_line(links.places[static_cast<std::size_t>(ends.first)],
                                    links.places[static_cast<std::size_t>(ends.second)],
                                    links.between[{ends.first, ends.second}]++);
    const Colour colour = periodic ? periodic_colour : pencil;
    drawing.items.emplace_back(
        Stroke{periodic ? dashes(line) : std::vector<Polyline>{line}, colour, 1.5});
    labels.avoid(line);
    labels.place({name, letters - 1, colour},
                 {point_on(line, 0.5).at, point_on(line, 0.4).at, point_on(line, 0.6).at,
                  point_on(line, 0.3).at, point_on(line, 0.7).at});
}

/// A line for every face that two sides of blocks share, and for every pair of periodic ones.
void append_links(const Topology& topology, const std::vector<PagePoint>& places, Drawing& drawing,
                  LabelPlacement& labels) {
    Links links{topology, places};
    const std::map<int, std::vector<SideOfBlock>> uses = uses_of_faces(topology);
    const auto name = [&](int face) { return topology.faces[static_cast<std::size_t>(face)].name; };
    for (const auto& [face, sides] : uses) {
        if (sides.size() != 2) continue;
        append_link(links, sides[0], sides[1], name(face), false, drawing, labels);
    }
    for (const PeriodicInterface& interface : topology.periodic) {
        for (const PeriodicPair& pair : interface.pairs) {
            append_link(links, uses.at(pair.from).front(), uses.at(pair.to).front(),
                        fmt::format("{} = {}", name(pair.from), name(pair.to)), true, drawing,
                        labels);
        }
    }
}

struct FreeSide {
    const char* name = nullptr;
    int family = 0;

    friend bool operator==(const FreeSide&, const FreeSide&) = default;
};

std::vector<FreeSide> free_sides(const Topology& topology, const Block& block) {
    const std::vector<int> families = families_of_sides(topology);
    std::vector<FreeSide> sides;
    for (std::size_t s = 0; s < 6; ++s) {
        for (const FaceUse& use : block.sides[s].faces) {
            const FreeSide side{side_names[s], families[static_cast<std::size_t>(use.face)]};
            if (side.family >= 0 && (sides.empty() || sides.back() != side)) sides.push_back(side);
        }
    }
    return sides;
}

/// Squares in the colours of the families, in a row about `at`.
void append_families(const std::vector<FreeSide>& sides, const PagePoint& at, Drawing& drawing) {
    double x = at.x - family_step * static_cast<double>(sides.size()) / 2 + 3;
    for (const auto& [name, family] : sides) {
        const Polyline box{
            {x, at.y - square}, {x + square, at.y - square}, {x + square, at.y}, {x, at.y}};
        drawing.items.emplace_back(Fill{{box}, palette(family)});
        drawing.items.emplace_back(
            Label{{x + square + 3, at.y}, name, letters - 2, Anchor::left, ink});
        x += family_step;
    }
}

void append_node(const Topology& topology, const Block& block, const PagePoint& at,
                 Drawing& drawing) {
    const std::string cells = fmt::format("{} x {} x {} cells", block.extent.ni - 1,
                                          block.extent.nj - 1, block.extent.nk - 1);
    const std::vector<FreeSide> sides = free_sides(topology, block);
    const double content =
        std::max({text_width(block.name, letters + 2, true), text_width(cells, letters - 1),
                  family_step * static_cast<double>(sides.size())});
    const double width = content / 2 + 10;
    const Polyline box{{at.x - width, at.y - 26},
                       {at.x + width, at.y - 26},
                       {at.x + width, at.y + 26},
                       {at.x - width, at.y + 26},
                       {at.x - width, at.y - 26}};
    drawing.items.emplace_back(Fill{{box}, tint_colour(plaster)});
    drawing.items.emplace_back(Stroke{{box}, ink, 1.2});
    drawing.items.emplace_back(
        Label{{at.x, at.y - 9}, block.name, letters + 2, Anchor::middle, ink, true});
    drawing.items.emplace_back(Label{{at.x, at.y + 6}, cells, letters - 1, Anchor::middle, ink});
    append_families(sides, {at.x, at.y + 20}, drawing);
}

}  // namespace

PagePoint block_centre(const Block& block, const TopologyLayout& layout) {
    PagePoint sum;
    for (const int corner : block.corners) {
        const PagePoint& p = layout.vertices[static_cast<std::size_t>(corner)];
        sum = {sum.x + p.x / 8, sum.y + p.y / 8};
    }
    return sum;
}

std::vector<int> families_of_sides(const Topology& topology) {
    std::vector<int> families(topology.is_3d() ? topology.faces.size() : topology.edges.size(), -1);
    for (std::size_t b = 0; b < topology.boundaries.size(); ++b) {
        for (const int side : topology.boundaries[b].sides) {
            families[static_cast<std::size_t>(side)] = static_cast<int>(b);
        }
    }
    return families;
}

void append_block_graph(const Topology& topology, const TopologyLayout& layout, const Frame& frame,
                        Drawing& drawing) {
    const std::vector<PagePoint> places = node_places(topology, layout, frame);
    LabelPlacement labels(frame);
    append_links(topology, places, drawing, labels);
    labels.append_to(drawing);
    for (std::size_t b = 0; b < places.size(); ++b) {
        append_node(topology, topology.blocks[b], places[b], drawing);
    }
}

}  // namespace hexweave
