// SPDX-License-Identifier: Apache-2.0
// Where a resolved topology stands on a page. A far field of twenty chords would leave an airfoil a
// dot: what lies far from the smallest parts is drawn nearer, its distance from their midst as a
// logarithm. Directions seen from there stay, so that nothing crosses that does not cross in space.
#pragma once

#include <optional>
#include <vector>

#include "io/picture_drawing.h"
#include "io/picture_page.h"
#include "topology/topology.h"

namespace hexweave {

/// Distances from `centre` (in the view's plane) beyond `radius` are shortened.
struct Focus {
    PagePoint centre;
    double radius = 0;
    double growth = 1;  ///< of the page's radius with the logarithm of the distance
};

struct TopologyLayout {
    std::vector<PagePoint> vertices;  ///< in the topology's order
    std::vector<Polyline> edges;      ///< from start to end; of a pole one point
    std::optional<Focus> focus;       ///< none: true to scale
};

/// The topology inside `frame`: planar grids from +z, others from the front, the right and above.
TopologyLayout lay_out(const Topology& topology, const Frame& frame);

/// The ring of a face's edges on the page, counter-clockwise in its own parameters.
Polyline face_ring(const Face& face, const TopologyLayout& layout);
/// The edges of a side in a row.
Polyline side_line(const std::vector<EdgeUse>& side, const TopologyLayout& layout);
/// The place inside a ring that is farthest from it; nothing for one without an area.
std::optional<PagePoint> widest_place(const Polyline& ring);
/// The point at a fraction of a line's length, and the unit vector along the line there.
struct LinePoint {
    PagePoint at;
    PagePoint along;
};
LinePoint point_on(const Polyline& line, double fraction);
double line_length(const Polyline& line);

}  // namespace hexweave
