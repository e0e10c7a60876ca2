// SPDX-License-Identifier: Apache-2.0
// Written by hand: cairo's own SVG is three times as large, and its letters are outlines.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <iterator>

#include "io/picture_drawing.h"
#include "io/picture_text.h"

namespace hexweave {

namespace {

/// Hundredths of a pixel: enough for a large print, and short.
struct Hundredths {
    long x = 0;
    long y = 0;
};

Hundredths round(const PagePoint& point) {
    return {std::lround(100 * point.x), std::lround(100 * point.y)};
}

/// A number of hundredths with no digit too many: "-.5", "12.25", "3".
void append_number(std::string& text, long hundredths, bool separate) {
    if (hundredths < 0) {
        text += '-';
    } else if (separate) {
        text += ' ';
    }
    const long size = std::labs(hundredths);
    if (size >= 100 || size == 0) fmt::format_to(std::back_inserter(text), "{}", size / 100);
    if (size % 10 != 0) {
        fmt::format_to(std::back_inserter(text), ".{:02}", size % 100);
    } else if (size % 100 != 0) {
        fmt::format_to(std::back_inserter(text), ".{}", size % 100 / 10);
    }
}

/// Path data of one polyline: its first point as it is, the others as steps.
void append_path(std::string& text, const Polyline& line, bool closed) {
    if (line.empty()) return;
    Hundredths last = round(line.front());
    text += 'M';
    append_number(text, last.x, false);
    append_number(text, last.y, true);
    bool first = true;
    for (const PagePoint& point : line) {
        const Hundredths next = round(point);
        if (next.x == last.x && next.y == last.y) continue;
        if (first) text += 'l';
        append_number(text, next.x - last.x, !first);
        append_number(text, next.y - last.y, true);
        last = next;
        first = false;
    }
    text += closed ? "z\n" : "\n";
}

std::string hex(const Colour& colour) {
    return fmt::format("#{:06x}", to_rgb(colour));
}

void append(std::string& text, const Fill& fill) {
    text += fmt::format(R"(<path fill="{}" fill-rule="evenodd" d=")", hex(fill.colour));
    for (const Polyline& ring : fill.rings) append_path(text, ring, true);
    text += "\"/>\n";
}

void append(std::string& text, const Stroke& stroke) {
    text += fmt::format(R"(<path fill="none" stroke="{}" stroke-width="{:.3g}" d=")",
                        hex(stroke.colour), stroke.width);
    for (const Polyline& line : stroke.lines) append_path(text, line, false);
    text += "\"/>\n";
}

// Each tile is outlined in its own colour, or the seams between them would shine through.
void append(std::string& text, const Mosaic& mosaic) {
    text += R"(<g fill="currentColor" stroke="currentColor" stroke-width="0.5">)";
    text += '\n';
    for (std::size_t i = 0; i < mosaic.tiles.size();) {
        const Colour colour = mosaic.tiles[i].colour;
        text += fmt::format(R"(<path color="{}" d=")", hex(colour));
        for (; i < mosaic.tiles.size() && mosaic.tiles[i].colour == colour; ++i) {
            append_path(text, mosaic.tiles[i].ring, true);
        }
        text += "\"/>\n";
    }
    text += "</g>\n";
}

void append(std::string& text, const Label& label) {
    const char* const anchor = label.anchor == Anchor::left     ? "start"
                               : label.anchor == Anchor::middle ? "middle"
                                                                : "end";
    text += fmt::format(
        R"(<text x="{:.2f}" y="{:.2f}" font-size="{:.3g}" text-anchor="{}" fill="{}"{}>{}</text>)",
        label.at.x, label.at.y, label.size, anchor, hex(label.colour),
        label.bold ? " font-weight=\"bold\"" : "", xml_escaped(printable(label.text)));
    text += '\n';
}

}  // namespace

std::string svg_path(const Polyline& line) {
    std::string text;
    append_path(text, line, false);
    text.pop_back();
    return text;
}

void write_svg(const Drawing& drawing, const std::filesystem::path& path) {
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" "
        "stroke-linejoin=\"round\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height);
    for (const DrawingItem& item : drawing.items) {
        std::visit([&](const auto& shape) { append(text, shape); }, item);
    }
    text += "</svg>\n";
    write_bytes(text, path);
}

}  // namespace hexweave
