// SPDX-License-Identifier: Apache-2.0
// A drawing: what stands on a page, as plain data, bottom first; and the two ways to write it. The
// only file of the program that knows cairo.
//
// Page coordinates are pixels, x to the right, y down, from the upper left corner.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "io/picture_colours.h"

namespace hexweave {

struct PagePoint {
    double x = 0;
    double y = 0;

    friend bool operator==(const PagePoint&, const PagePoint&) = default;
};

using Polyline = std::vector<PagePoint>;

/// Closed rings filled with one colour, by the even-odd rule.
struct Fill {
    std::vector<Polyline> rings;
    Colour colour;
};

/// Lines of one colour and width (pixels).
struct Stroke {
    std::vector<Polyline> lines;
    Colour colour;
    double width = 1;
};

/// One tile of a shaded surface.
struct Tile {
    Polyline ring;
    Colour colour;
};

/// Tiles that cover a surface without a gap, farthest first.
struct Mosaic {
    std::vector<Tile> tiles;
};

enum class Anchor { left, middle, right };

/// A line of text; `at` is on its base line.
struct Label {
    PagePoint at;
    std::string text;
    double size = 12;
    Anchor anchor = Anchor::left;
    Colour colour;
    bool bold = false;
};

using DrawingItem = std::variant<Fill, Stroke, Mosaic, Label>;

struct Drawing {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> backdrop;  ///< 0xRRGGBB, row by row; white when empty; PNG only
    std::vector<DrawingItem> items;
};

/// The width of a text in pixels.
double text_width(const std::string& text, double size, bool bold = false);

/// The path data of a line, as SVG has it, to a hundredth of a pixel.
std::string svg_path(const Polyline& line);

/// Writes a file as a whole. Throws MachineError, naming the path and the reason, when it cannot be
/// written; so do the two below.
void write_bytes(const std::string& bytes, const std::filesystem::path& path);
void write_png(const Drawing& drawing, const std::filesystem::path& path);
void write_svg(const Drawing& drawing, const std::filesystem::path& path);

}  // namespace hexweave
