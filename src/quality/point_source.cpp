// SPDX-License-Identifier: Apache-2.0
#include "quality/point_source.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

namespace hexweave {
namespace {

/// Nodes of a box of `length` nodes per axis with a neighbour on each side, inside the extent.
double nodes_with_neighbours(const std::array<int, 3>& length, const Extent& extent) {
    double nodes = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        nodes *= std::min(length[axis] + 2, extent[static_cast<int>(axis)]);
    }
    return nodes;
}

/// The largest portion that keeps to `most_nodes`: whole grid lines along i where it can, then
/// whole layers of j.
std::array<int, 3> portion_length(const Extent& extent, std::size_t most_nodes) {
    std::array<int, 3> length{extent.ni, extent.nj, extent.nk};
    const auto most = static_cast<double>(most_nodes);
    for (const std::size_t axis : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
        if (nodes_with_neighbours(length, extent) <= most) break;
        length[axis] = 1;
        if (nodes_with_neighbours(length, extent) > most) continue;
        // At least one layer fits: as many as do.
        const double layer =
            nodes_with_neighbours(length, extent) / std::min(3, extent[static_cast<int>(axis)]);
        length[axis] = std::max(1, static_cast<int>(most / layer) - 2);
    }
    return length;
}

struct Asked {
    int zone;
    IndexBox box;
};

/// The points of one box, copied.
struct CopiedPiece {
    std::array<std::vector<double>, 3> values;
};

Piece copy(const PointField& points, const IndexBox& box, CopiedPiece& to) {
    Piece piece{box, {}};
    for (std::vector<double>& values : to.values) values.clear();
    for (int k = box.begin[2]; k <= box.end[2]; ++k)
        for (int j = box.begin[1]; j <= box.end[1]; ++j)
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                to.values[0].push_back(points.x(i, j, k));
                to.values[1].push_back(points.y(i, j, k));
                to.values[2].push_back(points.z(i, j, k));
            }
    for (std::size_t axis = 0; axis < 3; ++axis) piece.values[axis] = to.values[axis].data();
    return piece;
}

/// Adds the points of a piece to what is known of the zone.
void look_at(const Piece& piece, const std::array<Node, 64>& nodes, ZoneSurvey& survey) {
    const Extent extent = piece.extent();
    for (std::size_t n = 0; n < extent.nodes(); ++n) {
        const Vec3 p = piece.at(n);
        if (!is_finite(p)) {
            if (survey.not_finite) continue;
            const auto place = static_cast<int>(n);
            survey.not_finite = Node{piece.box.begin[0] + place % extent.ni,
                                     piece.box.begin[1] + place / extent.ni % extent.nj,
                                     piece.box.begin[2] + place / extent.ni / extent.nj};
            continue;
        }
        survey.box.include(p);
    }
    for (std::size_t sample = 0; sample < nodes.size(); ++sample) {
        const Node& node = nodes[sample];
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            inside =
                inside && node[axis] >= piece.box.begin[axis] && node[axis] <= piece.box.end[axis];
        }
        if (inside) survey.samples[sample] = piece.at(piece.offset(node));
    }
}

ZoneSurvey survey_zone(const PointSource& source, int zone) {
    const Extent& extent = source.outline.zones[static_cast<std::size_t>(zone)].extent;
    const std::vector<Portion> portions = cut(extent, source.piece_nodes);
    const std::array<Node, 64> nodes = sample_nodes(extent);
    ZoneSurvey found;
    source.ask(zone, portions.front().core);
    for (std::size_t n = 0; n < portions.size(); ++n) {
        if (n + 1 < portions.size()) source.ask(zone, portions[n + 1].core);
        look_at(source.take(), nodes, found);
    }
    return found;
}

}  // namespace

GridOutline outline_of(const MultiblockGrid& grid) {
    GridOutline outline{grid.title,
                        grid.units,
                        grid.cell_dimension,
                        grid.physical_dimension,
                        {},
                        grid.interfaces,
                        grid.families,
                        grid.patches,
                        grid.provenance,
                        {},
                        {}};
    for (const Zone& zone : grid.zones) outline.zones.push_back({zone.name, zone.points.extent()});
    return outline;
}

PointSource source_of(const MultiblockGrid& grid, std::size_t piece_nodes) {
    const auto asked = std::make_shared<std::deque<Asked>>();
    const auto copied = std::make_shared<CopiedPiece>();
    PointSource source;
    source.outline = outline_of(grid);
    source.piece_nodes = piece_nodes;
    source.ask = [asked](int zone, const IndexBox& box) { asked->push_back({zone, box}); };
    source.take = [asked, copied, &grid] {
        const Asked next = asked->front();
        asked->pop_front();
        return copy(grid.zones[static_cast<std::size_t>(next.zone)].points, next.box, *copied);
    };
    return source;
}

std::vector<Portion> cut(const Extent& extent, std::size_t most_nodes) {
    const std::array<int, 3> length = portion_length(extent, most_nodes);
    std::vector<Portion> portions;
    for (int k = 0; k < extent.nk; k += length[2])
        for (int j = 0; j < extent.nj; j += length[1])
            for (int i = 0; i < extent.ni; i += length[0]) {
                Portion portion{{{i, j, k}, {}}, {}};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const int last = extent[static_cast<int>(axis)] - 1;
                    IndexBox& core = portion.core;
                    core.end[axis] = std::min(core.begin[axis] + length[axis] - 1, last);
                    portion.with_neighbours.begin[axis] = std::max(core.begin[axis] - 1, 0);
                    portion.with_neighbours.end[axis] = std::min(core.end[axis] + 1, last);
                }
                portions.push_back(portion);
            }
    return portions;
}

std::array<Node, 64> sample_nodes(const Extent& extent) {
    std::array<std::array<int, 4>, 3> along{};
    for (int axis = 0; axis < 3; ++axis) {
        const int last = extent[axis] - 1;
        const int inner = std::min(last, std::max(1, last / 3));
        along[static_cast<std::size_t>(axis)] = {0, inner, last - inner, last};
    }
    std::array<Node, 64> nodes{};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        nodes[n] = {along[0][n % 4], along[1][n / 4 % 4], along[2][n / 16]};
    }
    return nodes;
}

std::vector<ZoneSurvey> survey(const PointSource& source) {
    std::vector<ZoneSurvey> found;
    found.reserve(source.outline.zones.size());
    for (int zone = 0; zone < static_cast<int>(source.outline.zones.size()); ++zone) {
        found.push_back(survey_zone(source, zone));
    }
    return found;
}

PointBox box_of(const std::vector<ZoneSurvey>& surveys) {
    PointBox box;
    for (const ZoneSurvey& zone : surveys) {
        box.include(zone.box.least);
        box.include(zone.box.greatest);
    }
    return box;
}

}  // namespace hexweave
