// SPDX-License-Identifier: Apache-2.0
#include "io/picture_furniture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/errors.h"
#include "core/utf8.h"
#include "io/picture_text.h"

namespace hexweave {

namespace {

constexpr double letters = 13;  ///< pixels
constexpr double title_letters = 18;
constexpr double swatch = 14;
constexpr double legend_line = 22;
constexpr double legend_room = 0.28;  ///< of the page's width, at most

/// The text cut to a width, with an ellipsis where it was cut.
std::string fitted(const std::string& text, double size, double width) {
    std::string shown = printable(text);
    if (text_width(shown, size) <= width) return shown;
    while (!shown.empty() && text_width(shown + "…", size) > width) {
        while (!shown.empty() && is_utf8_continuation(shown.back())) {
            shown.pop_back();
        }
        if (!shown.empty()) shown.pop_back();
    }
    return shown + "…";
}

double legend_width(const Scene& scene, const PictureOptions& options) {
    const double scale = page_scale(options);
    double widest = 0;
    for (const LegendEntry& entry : scene.legend) {
        widest = std::max(widest, text_width(entry.name, letters * scale));
    }
    if (scene.legend.empty()) return 0;
    return std::min(widest + (swatch + 26) * scale, legend_room * options.width);
}

void append_line_between(std::vector<Polyline>& lines, PagePoint a, PagePoint b) {
    lines.push_back({a, b});
}

void append_legend(const Scene& scene, const PictureOptions& options, const Frame& frame,
                   Drawing& drawing) {
    const double scale = page_scale(options);
    const double line = legend_line * scale;
    const double left = frame.right + 14 * scale;
    const double text_left = left + (swatch + 8) * scale;
    const double room = options.width - text_left - 4 * scale;
    const auto fits = static_cast<std::size_t>(
        std::max(1.0, std::floor((options.height - frame.top) / line - 1)));
    const std::size_t shown = scene.legend.size() <= fits ? scene.legend.size() : fits - 1;
    double top = frame.top;
    for (std::size_t i = 0; i < shown; ++i, top += line) {
        const LegendEntry& entry = scene.legend[i];
        const double side = swatch * scale;
        const Polyline square{
            {left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}};
        drawing.items.emplace_back(Fill{{square}, entry.colour});
        Polyline outline = square;
        outline.push_back(outline.front());
        drawing.items.emplace_back(Stroke{{outline}, line_shade(entry.colour), scale});
        drawing.items.emplace_back(Label{{text_left, top + 0.8 * side},
                                         fitted(entry.name, letters * scale, room),
                                         letters * scale,
                                         Anchor::left,
                                         ink});
    }
    if (shown < scene.legend.size()) {
        const std::string rest = fmt::format("and {} more", scene.legend.size() - shown);
        drawing.items.emplace_back(Label{
            {text_left, top + 0.8 * swatch * scale}, rest, letters * scale, Anchor::left, pencil});
    }
}

std::string with_units(const std::string& text, const std::string& units, const char* form) {
    return units.empty() ? text : fmt::format(fmt::runtime(form), text, units);
}

/// The marks of one axis: multiples of a round step between two values.
std::vector<double> marks(double low, double high, double step) {
    const double first = std::ceil(low / step - 1e-9);
    const int count = static_cast<int>(std::floor((high - first * step) / step + 1e-9)) + 1;
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (int n = 0; n < count; ++n) result.push_back((first + n) * step);
    return result;
}

Polyline outline(const Frame& frame) {
    return {{frame.left, frame.top},
            {frame.right, frame.top},
            {frame.right, frame.bottom},
            {frame.left, frame.bottom},
            {frame.left, frame.top}};
}

void append_axes(const View& view, double scale, const std::string& units, Drawing& drawing) {
    const Frame& frame = view.frame;
    const auto [xmin, ymin, xmax, ymax] = view.window();
    const double step = mark_distance(
        std::max(xmax - xmin, ymax - ymin),
        static_cast<int>(std::max(frame.width(), frame.height()) / (110 * scale)) + 1);
    Stroke stroke{{outline(frame)}, pencil, 0.8 * scale};
    const double tick = 5 * scale;
    const double size = letters * scale;
    for (const double x : marks(xmin, xmax, step)) {
        const double at = frame.left + (x - xmin) * view.scale;
        append_line_between(stroke.lines, {at, frame.bottom}, {at, frame.bottom + tick});
        drawing.items.emplace_back(Label{
            {at, frame.bottom + tick + 1.1 * size}, mark_text(x, step), size, Anchor::middle, ink});
    }
    for (const double y : marks(ymin, ymax, step)) {
        const double at = frame.bottom - (y - ymin) * view.scale;
        append_line_between(stroke.lines, {frame.left, at}, {frame.left - tick, at});
        drawing.items.emplace_back(Label{{frame.left - tick - 4 * scale, at + 0.36 * size},
                                         mark_text(y, step),
                                         size,
                                         Anchor::right,
                                         ink});
    }
    drawing.items.emplace_back(std::move(stroke));
    drawing.items.emplace_back(Label{{(frame.left + frame.right) / 2, frame.bottom + 3.2 * size},
                                     with_units("x", units, "{} [{}]"),
                                     size,
                                     Anchor::middle,
                                     ink});
    drawing.items.emplace_back(Label{{frame.left - tick - 4 * scale, frame.top - 0.9 * size},
                                     with_units("y", units, "{} [{}]"),
                                     size,
                                     Anchor::right,
                                     ink});
}

void append_directions(const View& view, double scale, const PagePoint& origin, Drawing& drawing) {
    constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    const double length = 26 * scale;
    Stroke stroke{{}, ink, 1.2 * scale};
    for (std::size_t n = 0; n < 3; ++n) {
        const double dx = dot(axes[n], view.camera.right);
        const double dy = -dot(axes[n], view.camera.up);
        if (std::hypot(dx, dy) < 0.05) continue;
        const PagePoint tip{origin.x + length * dx, origin.y + length * dy};
        append_line_between(stroke.lines, origin, tip);
        const double beyond = length + 9 * scale / std::hypot(dx, dy);
        drawing.items.emplace_back(
            Label{{origin.x + beyond * dx, origin.y + beyond * dy + 4 * scale},
                  std::string(1, "xyz"[n]),
                  letters * scale,
                  Anchor::middle,
                  ink});
    }
    drawing.items.emplace_back(std::move(stroke));
}

void append_scale_bar(const View& view, double scale, const std::string& units,
                      const PagePoint& start, Drawing& drawing) {
    const double shown = view.frame.width() / view.scale;
    const double length = mark_distance(shown, 7);
    const double end = start.x + length * view.scale;
    const double tick = 4 * scale;
    Stroke stroke{{}, ink, 1.2 * scale};
    stroke.lines.push_back(
        {{start.x, start.y - tick}, start, {end, start.y}, {end, start.y - tick}});
    drawing.items.emplace_back(std::move(stroke));
    drawing.items.emplace_back(Label{{(start.x + end) / 2, start.y - 7 * scale},
                                     with_units(mark_text(length, length), units, "{} {}"),
                                     letters * scale,
                                     Anchor::middle,
                                     ink});
}

}  // namespace

double page_scale(const PictureOptions& options) {
    return std::clamp(std::min(options.width / 1200.0, options.height / 900.0), 0.7, 6.0);
}

Frame grid_frame(const Scene& scene, const PictureOptions& options) {
    const double scale = page_scale(options);
    const double legend = legend_width(scene, options);
    const double title = options.title.empty() ? 0 : 30 * scale;
    Frame frame;
    frame.left = std::round((scene.flat ? 70 : 20) * scale);
    frame.right = std::round(options.width - 20 * scale - legend);
    frame.top = std::round((scene.flat ? 34 : 20) * scale + title);
    frame.bottom = std::round(options.height - (scene.flat ? 56 : 94) * scale);
    if (frame.width() < 20 || frame.height() < 20) {
        throw UsageError(fmt::format("a picture of {} x {} leaves no room for the grid",
                                     options.width, options.height));
    }
    return frame;
}

void append_furniture(const Scene& scene, const PictureOptions& options, const View& view,
                      const std::string& units, Drawing& drawing) {
    const double scale = page_scale(options);
    append_legend(scene, options, view.frame, drawing);
    if (scene.flat) {
        append_axes(view, scale, units, drawing);
    } else {
        const double bottom = options.height - 44 * scale;
        if (options.window) {
            drawing.items.emplace_back(Stroke{{outline(view.frame)}, pencil, 0.8 * scale});
        }
        append_directions(view, scale, {50 * scale, bottom}, drawing);
        append_scale_bar(view, scale, units, {120 * scale, bottom + 20 * scale}, drawing);
    }
    if (options.title.empty()) return;
    const Frame& frame = view.frame;
    drawing.items.emplace_back(Label{{(frame.left + frame.right) / 2, frame.top - 16 * scale},
                                     fitted(options.title, title_letters * scale, frame.width()),
                                     title_letters * scale,
                                     Anchor::middle,
                                     ink,
                                     true});
}

}  // namespace hexweave
