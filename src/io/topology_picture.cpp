// SPDX-License-Identifier: Apache-2.0
#include "io/topology_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/block_graph.h"
#include "io/graph_lines.h"
#include "io/label_placement.h"
#include "io/topology_layout.h"
#include "io/topology_legend.h"
#include "io/topology_text.h"

namespace hexweave {
namespace {

constexpr int page_width = 1600;  // about A4's shape
constexpr int page_height = 1130;
constexpr double letters = 13;
constexpr double room_for_title = 56;
constexpr double room_for_legend = 52;
constexpr Colour red{0.75, 0.15, 0.12};
constexpr Colour blue{0.1, 0.3, 0.7};

/// How often each edge bounds a face.
std::vector<int> face_counts(const Topology& topology) {
    std::vector<int> counts(topology.edges.size(), 0);
    for (const Face& face : topology.faces) {
        for (const auto& side : face.sides) {
            for (const EdgeUse& use : side) ++counts[static_cast<std::size_t>(use.edge)];
        }
    }
    return counts;
}

/// A head in the direction of travel.
Polyline arrow_head(const LinePoint& tip, double size) {
    const PagePoint& d = tip.along;
    return {tip.at,
            {tip.at.x - size * (d.x + 0.45 * d.y), tip.at.y - size * (d.y - 0.45 * d.x)},
            {tip.at.x - size * (d.x - 0.45 * d.y), tip.at.y - size * (d.y + 0.45 * d.x)}};
}

struct Page {
    const Topology& topology;
    TopologyLayout layout;
    Frame frame;
    Drawing drawing;
    LabelPlacement labels;
};

void append_faces(Page& page) {
    for (const Face& face : page.topology.faces) {
        if (face.is_collapsed()) continue;
        const Polyline ring = face_ring(face, page.layout);
        page.drawing.items.emplace_back(Fill{{ring}, mix(white, plaster, 0.22)});
        const auto place = widest_place(ring);
        if (!place) continue;
        page.labels.place({face.name, letters + 3, ink, true}, {*place});
        page.labels.place(
            {fmt::format("{} x {} cells", face.cells_i, face.cells_j), letters - 2, pencil},
            {{place->x, place->y + 19}});
    }
}

/// Arrows i and j at the face's first corner, along the sides that leave it.
void append_directions(Page& page) {
    for (const Face& face : page.topology.faces) {
        if (face.is_collapsed()) continue;
        const Polyline i_side = side_line(face.side(Side::jmin), page.layout);
        const Polyline j_side = side_line(face.side(Side::imin), page.layout);
        const double reach = std::min({34.0, 0.3 * line_length(i_side), 0.3 * line_length(j_side)});
        if (reach < 8) continue;
        const PagePoint i = point_on(i_side, 0.02).along;
        const PagePoint j = point_on(j_side, 0.02).along;
        const PagePoint corner = i_side.front();
        const PagePoint from{corner.x + 0.35 * reach * (i.x + j.x),
                             corner.y + 0.35 * reach * (i.y + j.y)};
        const auto arrow = [&](const PagePoint& way, const Colour& colour, const char* name) {
            const PagePoint tip{from.x + reach * way.x, from.y + reach * way.y};
            page.drawing.items.emplace_back(Stroke{{{from, tip}}, colour, 1.4});
            page.drawing.items.emplace_back(Fill{{arrow_head({tip, way}, 7)}, colour});
            page.labels.place({name, letters - 1, colour, true},
                              {{tip.x + 9 * way.x, tip.y + 9 * way.y}});
            page.labels.avoid({from, tip});
        };
        arrow(i, red, "i");
        arrow(j, blue, "j");
    }
}

/// The two sides of every periodic pair broken, and an arrow from the one to the other.
void append_periodic(Page& page) {
    const Topology& topology = page.topology;
    if (topology.is_3d()) return;  // the graph beside the drawing tells
    const auto line = [&](int edge) -> const Polyline& {
        return page.layout.edges[static_cast<std::size_t>(edge)];
    };
    for (const PeriodicInterface& interface : topology.periodic) {
        for (const PeriodicPair& pair : interface.pairs) {
            for (const int edge : {pair.from, pair.to}) {
                page.drawing.items.emplace_back(Stroke{{line(edge)}, white, 3});
                page.drawing.items.emplace_back(Stroke{dashes(line(edge)), periodic_colour, 3});
            }
            const Polyline way =
                link_line(point_on(line(pair.from), 0.4).at,
                          point_on(line(pair.to), pair.orientation.axes[0] < 0 ? 0.6 : 0.4).at, 0);
            page.drawing.items.emplace_back(Stroke{dashes(way), periodic_colour, 1});
            page.drawing.items.emplace_back(
                Fill{{arrow_head(point_on(way, 0.99), 9)}, periodic_colour});
            const LabelText text{interface.name, letters - 1, periodic_colour};
            page.labels.place(text, places_beside(way, text));
        }
    }
}

void append_edges(Page& page) {
    const Topology& topology = page.topology;
    const std::vector<int> counts = face_counts(topology);
    const std::vector<int> families = topology.is_3d() ? std::vector<int>(topology.edges.size(), -1)
                                                       : families_of_sides(topology);
    const std::vector<bool> cut =
        topology.is_3d() ? std::vector<bool>(families.size(), false) : cut_edges(topology);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (topology.edges[e].pole || counts[e] == 0) continue;
        const Polyline& line = page.layout.edges[e];
        const bool free = families[e] >= 0;
        if (cut[e]) page.drawing.items.emplace_back(Stroke{{line}, cut_colour, 7});
        const Colour colour = free ? palette(families[e]) : pencil;
        page.drawing.items.emplace_back(Stroke{{line}, colour, free ? 3.0 : 1.3});
        page.drawing.items.emplace_back(Fill{{arrow_head(point_on(line, 0.62), 8)}, colour});
        page.labels.avoid(line);
    }
}

void label_edges(Page& page) {
    const Topology& topology = page.topology;
    const std::vector<int> counts = face_counts(topology);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const Edge& edge = topology.edges[e];
        if (edge.pole || counts[e] == 0) continue;
        const bool named = !edge.made || (!topology.is_3d() && counts[e] == 1);
        const std::string cells = fmt::format("{}", edge.cells);
        const LabelText text{named ? edge.name + " · " + cells : cells, letters - 1,
                             named ? ink : pencil};
        page.labels.place(text, places_beside(page.layout.edges[e], text));
    }
}

void append_vertices(Page& page) {
    constexpr double size = 4;
    std::vector<bool> used(page.topology.vertices.size(), false);
    for (const Edge& edge : page.topology.edges) {
        used[static_cast<std::size_t>(edge.start)] = used[static_cast<std::size_t>(edge.end)] =
            true;
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        const PagePoint& p = page.layout.vertices[v];
        Polyline disc;
        for (int n = 0; n < 16; ++n) {
            disc.push_back({p.x + size * std::cos(n * 0.3927), p.y + size * std::sin(n * 0.3927)});
        }
        page.drawing.items.emplace_back(Fill{{disc}, ink});
        page.labels.avoid({{p.x - size, p.y}, {p.x + size, p.y}});
        const LabelText text{page.topology.vertices[v].name, letters, ink, true};
        page.labels.place(text, places_around(p, text));
    }
}

void append_blocks(Page& page) {
    for (const Block& block : page.topology.blocks) {
        const LabelText text{block.name, letters + 3, blue, true};
        const PagePoint centre = block_centre(block, page.layout);
        page.labels.place(text, {centre,
                                 {centre.x, centre.y - 18},
                                 {centre.x, centre.y + 18},
                                 {centre.x - 40, centre.y},
                                 {centre.x + 40, centre.y},
                                 {centre.x, centre.y - 36},
                                 {centre.x, centre.y + 36}});
    }
}

void append_title(const Page& page, const std::string& title, Drawing& drawing) {
    const Topology& t = page.topology;
    drawing.items.emplace_back(Label{{30, 32}, title, 20, Anchor::left, ink, true});
    std::string told =
        fmt::format("{} vertices, {} edges, {} faces, {} blocks, {} cells", t.vertices.size(),
                    t.edges.size(), t.faces.size(), t.blocks.size(), t.cells());
    told += page.layout.focus
                ? "; not to scale: what is far from the smallest parts is drawn nearer"
                : "; to scale";
    drawing.items.emplace_back(Label{{30, 50}, told, letters - 1, Anchor::left, pencil});
    const std::string copies = copies_text(t);
    double y = 50;
    for (std::size_t begin = 0; begin < copies.size(); begin = copies.find('\n', begin) + 1) {
        y += 16;
        const std::string line = copies.substr(begin, copies.find('\n', begin) - begin);
        drawing.items.emplace_back(Label{{30, y}, line, letters - 1, Anchor::left, pencil});
    }
}

Page empty_page(const Topology& topology) {
    const double right = topology.is_3d() ? 0.56 * page_width : page_width;
    const Frame paper{10, room_for_title, right - 10, page_height - room_for_legend};
    const Frame frame{paper.left + 70, paper.top + 40, paper.right - 70, paper.bottom - 30};
    return {topology, lay_out(topology, frame), frame, {}, LabelPlacement(paper)};
}

}  // namespace

void draw_topology(const Topology& topology, const std::string& title, PictureFormat format,
                   const std::filesystem::path& path) {
    Page page = empty_page(topology);
    page.drawing.width = page_width;
    page.drawing.height = page_height;
    if (topology.is_3d()) {
        append_blocks(page);
    } else {
        append_faces(page);
    }
    append_edges(page);
    append_periodic(page);
    if (!topology.is_3d()) append_directions(page);
    append_vertices(page);
    label_edges(page);
    page.labels.append_to(page.drawing);
    if (topology.is_3d()) {
        append_block_graph(
            topology, page.layout,
            {page.frame.right + 80, page.frame.top, page_width - 20.0, page.frame.bottom},
            page.drawing);
    }
    append_legend(topology, {30, page_height - room_for_legend + 22}, page_width - 20,
                  page.drawing);
    append_title(page, title, page.drawing);
    if (format == PictureFormat::png) {
        write_png(page.drawing, path);
    } else {
        write_svg(page.drawing, path);
    }
}

}  // namespace hexweave
