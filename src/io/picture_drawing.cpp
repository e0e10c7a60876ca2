// SPDX-License-Identifier: Apache-2.0
#include "io/picture_drawing.h"

#include <cairo.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>

#include "core/errors.h"
#include "io/picture_text.h"

namespace hexweave {

namespace {

struct Release {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using SurfacePointer = std::unique_ptr<cairo_surface_t, Release>;
using ContextPointer = std::unique_ptr<cairo_t, Release>;

void fail(const std::filesystem::path& path, cairo_status_t status) {
    throw MachineError(path.string() + ": " + cairo_status_to_string(status));
}

void set_colour(cairo_t* page, const Colour& colour) {
    cairo_set_source_rgb(page, colour.red, colour.green, colour.blue);
}

void set_font(cairo_t* page, double size, bool bold) {
    cairo_select_font_face(page, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(page, size);
}

double advance(cairo_t* page, const std::string& text) {
    cairo_text_extents_t extents;
    cairo_text_extents(page, text.c_str(), &extents);
    return extents.x_advance;
}

void trace(cairo_t* page, const Polyline& line) {
    for (const PagePoint& point : line) cairo_line_to(page, point.x, point.y);
}

void paint(cairo_t* page, const Fill& fill) {
    set_colour(page, fill.colour);
    cairo_set_fill_rule(page, CAIRO_FILL_RULE_EVEN_ODD);
    for (const Polyline& ring : fill.rings) {
        cairo_new_sub_path(page);
        trace(page, ring);
        cairo_close_path(page);
    }
    cairo_fill(page);
}

// Line by line: one path with all of them would make cairo sort them all.
void paint(cairo_t* page, const Stroke& stroke) {
    set_colour(page, stroke.colour);
    cairo_set_line_width(page, stroke.width);
    for (const Polyline& line : stroke.lines) {
        trace(page, line);
        cairo_stroke(page);
    }
}

void paint(cairo_t* page, const Mosaic& mosaic) {
    cairo_set_line_width(page, 0.5);
    for (const Tile& tile : mosaic.tiles) {
        set_colour(page, tile.colour);
        trace(page, tile.ring);
        cairo_close_path(page);
        cairo_fill_preserve(page);
        cairo_stroke(page);
    }
}

void paint(cairo_t* page, const Label& label) {
    const std::string text = printable(label.text);
    set_font(page, label.size, label.bold);
    const double width = label.anchor == Anchor::left ? 0 : advance(page, text);
    const double shift = label.anchor == Anchor::middle ? width / 2 : width;
    set_colour(page, label.colour);
    cairo_move_to(page, label.at.x - shift, label.at.y);
    cairo_show_text(page, text.c_str());
    cairo_new_path(page);
}

void copy_backdrop(const Drawing& drawing, cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    unsigned char* pixels = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto width = static_cast<std::size_t>(drawing.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(drawing.height); ++row) {
        std::memcpy(pixels + row * stride, drawing.backdrop.data() + row * width,
                    width * sizeof(std::uint32_t));
    }
    cairo_surface_mark_dirty(surface);
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void write_bytes(const std::string& bytes, const std::filesystem::path& path) {
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw MachineError(path.string() + ": " + std::generic_category().message(errno));
}

double text_width(const std::string& text, double size, bool bold) {
    const SurfacePointer surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const ContextPointer page(cairo_create(surface.get()));
    set_font(page.get(), size, bold);
    return advance(page.get(), printable(text));
}

void write_png(const Drawing& drawing, const std::filesystem::path& path) {
    const SurfacePointer surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing.width, drawing.height));
    const ContextPointer page(cairo_create(surface.get()));
    if (cairo_status(page.get()) != CAIRO_STATUS_SUCCESS) fail(path, cairo_status(page.get()));
    set_colour(page.get(), white);
    cairo_paint(page.get());
    if (!drawing.backdrop.empty()) copy_backdrop(drawing, surface.get());
    cairo_set_line_join(page.get(), CAIRO_LINE_JOIN_ROUND);
    for (const DrawingItem& item : drawing.items) {
        std::visit([&](const auto& shape) { paint(page.get(), shape); }, item);
    }
    if (cairo_status(page.get()) != CAIRO_STATUS_SUCCESS) fail(path, cairo_status(page.get()));
    cairo_surface_flush(surface.get());
    std::string bytes;
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    if (status != CAIRO_STATUS_SUCCESS) fail(path, status);
    write_bytes(bytes, path);
}

}  // namespace hexweave
