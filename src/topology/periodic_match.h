// SPDX-License-Identifier: Apache-2.0
// Which side of the grid is the image of which, and how it lies on it, told by where they are.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "core/periodic_image.h"
#include "core/vec3.h"
#include "topology/draft.h"

namespace hexweave {

/// An edge of the one side and the edge of the other that it is the image of; `reversed` when they
/// run against each other.
struct EdgeMatch {
    int from = 0;
    int to = 0;
    bool reversed = false;
};

/// The edges of two sides: the sides themselves where they are edges, else edge by edge of the two
/// faces. Empty where the faces' sides are divided otherwise.
std::vector<EdgeMatch> matched_edges(const Topology& topology, const PeriodicPair& pair);

/// How far the one side is from the image of the other, at the worst of some points.
struct SideMatch {
    PeriodicPair pair;
    bool divided_alike = false;  ///< otherwise there is no distance
    double distance = 0;
    EdgeMatch edge;        ///< that is farthest off
    Vec3 image;            ///< of a point of edge.from
    Vec3 place;            ///< the point of edge.to that ought to be there
    int vertex_from = -1;  ///< where these points are vertices
    int vertex_to = -1;
};

/// Compares sides under one map, edge by edge at equal fractions of arc length.
class SideMatcher {
public:
    SideMatcher(const Network& network, const PeriodicMap& map) : network_(network), map_(map) {}

    /// All ways in which `to` may lie on the image of `from`, nearest first.
    std::vector<SideMatch> ways(int from, int to);

private:
    static constexpr std::size_t intervals = 8;
    using Samples = std::array<Vec3, intervals + 1>;

    /// The vertex that a sample of an edge is, or -1.
    static int end_at(const Edge& edge, std::size_t sample);
    const Samples& samples(int edge);
    SideMatch compare(const PeriodicPair& pair);

    const Network& network_;
    const PeriodicMap& map_;
    std::map<int, Samples> samples_;
};

}  // namespace hexweave
