// SPDX-License-Identifier: Apache-2.0
// Grids to draw, and pictures to look at.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave::samples {

/// A zone whose nodes are the images of equidistant points of the unit cube.
Zone mapped_zone(const std::string& name, const Extent& extent,
                 const std::function<Vec3(double, double, double)>& map);

/// The planar rectangle [x, x + 1] x [0, 1] with that many nodes along each side.
Zone square_zone(const std::string& name, double x, int nodes);

/// A planar grid of unit squares side by side, families `left` and `right` at its two ends.
MultiblockGrid squares(int zones, int nodes);

/// A cube of one zone `cube`, families `floor` and `roof`.
MultiblockGrid cube(int nodes);

struct Pixel {
    int red = 0;
    int green = 0;
    int blue = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    const Pixel& operator()(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

Image read_png(const std::filesystem::path& path);

}  // namespace hexweave::samples
