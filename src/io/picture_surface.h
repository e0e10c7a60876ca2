// SPDX-License-Identifier: Apache-2.0
// Shaded surfaces: a raster with a depth for every sample, which removes what is hidden and draws
// the PNG's backdrop, and the tiles that show the same surface in an SVG.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/picture_colours.h"
#include "io/picture_drawing.h"
#include "io/picture_page.h"

namespace hexweave {

/// A page with several samples per pixel in each direction; only the frame is drawn in.
class Raster {
public:
    Raster(int width, int height, const Frame& frame);

    /// Covers the samples that the sheet's cells fall on and that nothing nearer covers. Cells with
    /// a node that is not finite are left out.
    void draw(const SightSheet& sheet, const Colour& colour);
    /// True when nothing covers a point so near to the eye: with a tolerance of one pixel.
    bool sees(const Sight& point) const;
    /// 0xRRGGBB for every pixel, the mean of its samples; white where nothing is.
    std::vector<std::uint32_t> pixels() const;
    bool empty() const { return !covered_; }

private:
    void draw_triangle(const Sight& a, const Sight& b, const Sight& c, std::uint32_t colour);

    Frame frame_;
    int factor_;
    int width_;
    int height_;
    std::vector<double> depth_;
    std::vector<std::uint32_t> colour_;
    bool covered_ = false;
};

/// The colour of a cell in light from the upper left: `cell` holds its corners in order.
Colour shaded(const Colour& colour, const std::array<Sight, 4>& cell);

/// Tiles of about `size` pixels that cover what the raster sees of the sheet, with their depths.
struct DeepTile {
    Tile tile;
    double depth = 0;
};
void append_tiles(const SightSheet& sheet, const Colour& colour, const Frame& frame,
                  const Raster& raster, double size, std::vector<DeepTile>& tiles);

/// Farthest first.
Mosaic mosaic(std::vector<DeepTile> tiles);

}  // namespace hexweave
