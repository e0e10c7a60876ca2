// SPDX-License-Identifier: Apache-2.0
// Grids larger than memory: their points, asked for box by box.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/grid_outline.h"
#include "core/point_box.h"

namespace hexweave {

/// The points of a box of nodes of one zone, i fastest; the box runs forwards.
struct Piece {
    IndexBox box;
    std::array<const double*, 3> values{};

    Vec3 at(std::size_t offset) const {
        return {values[0][offset], values[1][offset], values[2][offset]};
    }
    Extent extent() const {
        return {box.end[0] - box.begin[0] + 1, box.end[1] - box.begin[1] + 1,
                box.end[2] - box.begin[2] + 1};
    }
    /// The place of a node of the zone among the values.
    std::size_t offset(const Node& n) const {
        return extent().offset(n[0] - box.begin[0], n[1] - box.begin[1], n[2] - box.begin[2]);
    }
};

/// Where points come from. What is asked for is taken in the same order; at most two boxes may be
/// asked for ahead, and a piece lasts until the next one is taken. Both throw UsageError where the
/// points turn out to be unreadable.
struct PointSource {
    GridOutline outline;
    std::size_t piece_nodes = 0;  ///< the most nodes of one piece; 27 at least
    std::function<void(int zone, const IndexBox& box)> ask;
    std::function<Piece()> take;
};

/// A grid without its points.
GridOutline outline_of(const MultiblockGrid& grid);

/// A grid in memory, which must outlive the source, as pieces of `piece_nodes` at most.
PointSource source_of(const MultiblockGrid& grid, std::size_t piece_nodes);

/// The nodes of a piece of work, and the same with those beside them, where there are any.
struct Portion {
    IndexBox core;
    IndexBox with_neighbours;
};

/// Cuts a zone into portions whose nodes, with neighbours, are `most_nodes` (27 or more) at most.
std::vector<Portion> cut(const Extent& extent, std::size_t most_nodes);

/// Where a zone lies, and a few of its points.
struct ZoneSurvey {
    PointBox box;  ///< of the points that are finite
    /// At the nodes of `sample_nodes`; the same nodes in any orientation of the zone.
    std::array<Vec3, 64> samples;
    std::optional<Node> not_finite;  ///< the first node with a coordinate that is no finite number
};

/// Four nodes along each axis: the ends, and two a third of the way in.
std::array<Node, 64> sample_nodes(const Extent& extent);

/// Reads every zone once.
std::vector<ZoneSurvey> survey(const PointSource& source);

/// Where all zones lie.
PointBox box_of(const std::vector<ZoneSurvey>& surveys);

}  // namespace hexweave
