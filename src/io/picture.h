// SPDX-License-Identifier: Apache-2.0
// Pictures of a grid: PNG or SVG, drawn with cairo, no display needed.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave {

/// One index plane of one zone (all zones when `zone` is empty): axis 0, 1, 2 and a zero-based node
/// index along it.
struct IndexPlane {
    std::string zone;
    int axis = 0;
    int index = 0;
};

enum class ColourBy { zone, family };

struct PictureOptions {
    int width = 1200;  ///< pixels (PNG), points (SVG)
    int height = 900;
    ColourBy colour = ColourBy::zone;
    std::optional<std::array<double, 4>> window;  ///< xmin, ymin, xmax, ymax in the view's plane
    std::optional<Vec3> view;                     ///< from where one looks; 2D grids: along -z
    std::vector<IndexPlane> planes;               ///< besides or instead of the boundary
    bool boundary = true;                         ///< draw the boundary surfaces of 3D grids
    std::vector<std::string> families;            ///< only these boundary surfaces; empty: all
};

enum class PictureFormat { png, svg };

/// By the ending of the name; throws UsageError for another ending.
PictureFormat picture_format(const std::filesystem::path& name);

/// Draws the grid to `path` (stage it with OutputFiles first). Throws UsageError for an unknown
/// zone or family, an index out of range or a picture with nothing in it, MachineError when the
/// file cannot be written.
void draw_picture(const MultiblockGrid& grid, const PictureOptions& options, PictureFormat format,
                  const std::filesystem::path& path);

}  // namespace hexweave
