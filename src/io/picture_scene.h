// SPDX-License-Identifier: Apache-2.0
// What of a grid a picture shows: chosen from the options, checked, and coloured.
#pragma once

#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/picture.h"
#include "io/picture_colours.h"
#include "io/picture_page.h"

namespace hexweave {

/// A rectangle of nodes of one zone, with its grid lines.
struct SceneSheet {
    int zone = 0;
    IndexBox box;  ///< runs forwards, one axis constant
    Colour colour;
};

/// A row of nodes of one zone, drawn strongly.
struct SceneEdge {
    int zone = 0;
    IndexBox box;  ///< runs forwards, two axes constant
    Colour colour;
    double width = 1;  ///< pixels
};

struct LegendEntry {
    std::string name;
    Colour colour;  ///< as it is drawn
};

struct Scene {
    bool flat = false;  ///< a planar grid seen from +z: outlines on a tint, nothing hidden
    bool tinted = true;
    std::vector<SceneSheet> sheets;
    std::vector<SceneEdge> edges;  ///< weakest first
    std::vector<LegendEntry> legend;
    int zones = 0;  ///< that are seen
};

/// Throws UsageError for an unknown zone or family, an index out of range, a patch outside its
/// zone, and when nothing is left to draw.
Scene make_scene(const MultiblockGrid& grid, const PictureOptions& options);

/// The nodes of a sheet or an edge (nj = 1) on the page.
SightSheet place_nodes(const Zone& zone, const IndexBox& box, const View& view);

}  // namespace hexweave
