// SPDX-License-Identifier: Apache-2.0
// Pictures of a grid: PNG or SVG, drawn with cairo, no display needed.
//
// A planar grid is seen from +z: its grid lines on a light tint. A surface grid or a volume grid is
// seen in parallel projection: boundary surfaces and index planes, shaded, hidden parts removed.
// Grid lines that would run together into a solid patch are thinned until they can be told apart.
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

/// From the front, the right and above.
inline constexpr Vec3 isometric_view{0.75, -1, 0.65};

struct PictureOptions {
    int width = 1200;  ///< pixels (PNG), points (SVG)
    int height = 900;
    ColourBy colour = ColourBy::zone;
    /// xmin, ymin, xmax, ymax in the view's plane (x and y of a planar grid); what is outside is
    /// cut off.
    std::optional<std::array<double, 4>> window;
    /// The direction in which the eye stands. Planar grids: seen from +z unless given; others:
    /// `isometric_view`.
    std::optional<Vec3> view;
    std::optional<Vec3> up;             ///< what points up: z, or y for a view along z
    std::vector<IndexPlane> planes;     ///< besides or instead of the boundary
    bool boundary = true;               ///< draw the boundary surfaces of 3D grids
    std::vector<std::string> families;  ///< only these boundaries; empty: all
    std::string title;                  ///< above the picture; may be empty
};

enum class PictureFormat { png, svg };

/// What a picture shows: the number of zones in it, and the part of the view's plane (xmin, ymin,
/// xmax, ymax; usable as PictureOptions::window).
struct PictureSummary {
    int zones = 0;
    std::array<double, 4> window{};
};

/// By the ending of the name; throws UsageError for another ending.
PictureFormat picture_format(const std::filesystem::path& name);

/// Draws the grid to `path` (stage it with OutputFiles first). Boundary surfaces are the patches of
/// the grid; all outer sides of the zones when it has none. Throws UsageError for an unknown zone
/// or family, an index out of range or a picture with nothing in it, MachineError when the file
/// cannot be written.
PictureSummary draw_picture(const MultiblockGrid& grid, const PictureOptions& options,
                            PictureFormat format, const std::filesystem::path& path);

}  // namespace hexweave
