// SPDX-License-Identifier: Apache-2.0
#include "io/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "core/errors.h"
#include "io/picture_drawing.h"
#include "io/picture_furniture.h"
#include "io/picture_lines.h"
#include "io/picture_page.h"
#include "io/picture_scene.h"
#include "io/picture_surface.h"

namespace hexweave {

namespace {

constexpr double line_width = 0.6;    ///< pixels
constexpr double line_spacing = 2.5;  ///< pixels: grid lines nearer to each other are thinned
constexpr double tile_size = 8;       ///< pixels
constexpr std::array<double, 3> fading{1, 0.65, 0.35};  ///< of width, by tone

void check(const PictureOptions& options) {
    constexpr int smallest = 100;
    constexpr int largest = 10000;
    if (std::min(options.width, options.height) < smallest ||
        std::max(options.width, options.height) > largest) {
        throw UsageError(fmt::format("a picture of {} x {}: width and height are {} to {} pixels",
                                     options.width, options.height, smallest, largest));
    }
    if (options.window) {
        const auto& [xmin, ymin, xmax, ymax] = *options.window;
        if (!(xmin < xmax && ymin < ymax && std::isfinite(xmax - xmin) &&
              std::isfinite(ymax - ymin))) {
            throw UsageError("the window is empty: it is xmin ymin xmax ymax");
        }
    }
    const auto direction = [](const std::optional<Vec3>& v) {
        return !v || (is_finite(*v) && norm(*v) > 0);
    };
    if (!direction(options.view) || !direction(options.up)) {
        throw UsageError("a direction of view has no length");
    }
}

/// Smallest and largest (right, up, depth) of what is seen; nodes that are not finite left out.
std::array<Vec3, 2> bounds(const MultiblockGrid& grid, const Scene& scene, const View& view) {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::array<Vec3, 2> box{Vec3{far, far, far}, Vec3{-far, -far, -far}};
    View plain;
    plain.camera = view.camera;
    for (const SceneSheet& sheet : scene.sheets) {
        const Zone& zone = grid.zones[static_cast<std::size_t>(sheet.zone)];
        for (const Sight& s : place_nodes(zone, sheet.box, plain).nodes) {
            if (!is_finite(s)) continue;
            box[0] = {std::min(box[0].x, s.x), std::min(box[0].y, -s.y),
                      std::min(box[0].z, s.depth)};
            box[1] = {std::max(box[1].x, s.x), std::max(box[1].y, -s.y),
                      std::max(box[1].z, s.depth)};
        }
    }
    const double size = std::max(box[1].x - box[0].x, box[1].y - box[0].y);
    if (!(size > 0 && std::isfinite(size))) {
        throw UsageError("the picture would be empty: the grid has no extent in this view");
    }
    return box;
}

/// The frame shrunk, about its centre, to the shape of a window.
Frame shaped(const Frame& frame, double width, double height) {
    const double scale = std::min(frame.width() / width, frame.height() / height);
    const double dx = (frame.width() - scale * width) / 2;
    const double dy = (frame.height() - scale * height) / 2;
    return {frame.left + dx, frame.top + dy, frame.right - dx, frame.bottom - dy};
}

View make_view(const MultiblockGrid& grid, const Scene& scene, const PictureOptions& options) {
    View view;
    view.frame = grid_frame(scene, options);
    if (!scene.flat) {
        view.camera = look_from(options.view.value_or(isometric_view), options.up);
    }
    const auto [low, high] = bounds(grid, scene, view);
    view.centre = 0.5 * (low + high);
    double width = 1.05 * (high.x - low.x);
    double height = 1.05 * (high.y - low.y);
    if (options.window) {
        const auto& [xmin, ymin, xmax, ymax] = *options.window;
        view.centre = {0.5 * (xmin + xmax), 0.5 * (ymin + ymax), view.centre.z};
        width = xmax - xmin;
        height = ymax - ymin;
        view.frame = shaped(view.frame, width, height);
    }
    view.scale = std::min(view.frame.width() / width, view.frame.height() / height);
    return view;
}

/// The boundary of a sheet as one ring.
Polyline outline(const SightSheet& sheet) {
    Polyline ring;
    const auto add = [&](int i, int j) {
        const Sight& s = sheet(i, j);
        if (is_finite(s)) ring.push_back({s.x, s.y});
    };
    for (int i = 0; i + 1 < sheet.ni; ++i) add(i, 0);
    for (int j = 0; j + 1 < sheet.nj; ++j) add(sheet.ni - 1, j);
    for (int i = sheet.ni - 1; i > 0; --i) add(i, sheet.nj - 1);
    for (int j = sheet.nj - 1; j > 0; --j) add(0, j);
    return ring;
}

/// The sheets and edges of a scene on the page.
struct PlacedScene {
    std::vector<SightSheet> sheets;
    std::vector<SightSheet> edges;
};

PlacedScene place(const MultiblockGrid& grid, const Scene& scene, const View& view) {
    PlacedScene placed;
    const auto nodes = [&](int zone, const IndexBox& box) {
        return place_nodes(grid.zones[static_cast<std::size_t>(zone)], box, view);
    };
    for (const SceneSheet& sheet : scene.sheets) {
        placed.sheets.push_back(nodes(sheet.zone, sheet.box));
    }
    for (const SceneEdge& edge : scene.edges) placed.edges.push_back(nodes(edge.zone, edge.box));
    return placed;
}

Colour grid_line_colour(const Scene& scene, const Colour& sheet) {
    if (!scene.flat) return line_shade(sheet);
    return scene.tinted ? mix(sheet, ink, 0.15) : pencil;
}

void append_tints(const Scene& scene, const PlacedScene& placed, const Frame& frame,
                  Drawing& drawing) {
    for (std::size_t n = 0; n < scene.sheets.size(); ++n) {
        const Polyline ring = clip_polygon(frame, outline(placed.sheets[n]));
        if (ring.size() < 3) continue;
        drawing.items.emplace_back(
            Fill{{simplified(ring, 0.1)}, tint_colour(scene.sheets[n].colour)});
    }
}

void append_surfaces(const Scene& scene, const PlacedScene& placed, const Frame& frame,
                     PictureFormat format, const Raster& raster, Drawing& drawing) {
    if (format == PictureFormat::png) {
        drawing.backdrop = raster.pixels();
        return;
    }
    std::vector<DeepTile> tiles;
    for (std::size_t n = 0; n < scene.sheets.size(); ++n) {
        append_tiles(placed.sheets[n], surface_colour(scene.sheets[n].colour), frame, raster,
                     tile_size, tiles);
    }
    drawing.items.emplace_back(mosaic(std::move(tiles)));
}

/// Appends grid lines and edges; returns whether there was any in the frame.
bool append_lines(const Scene& scene, const PlacedScene& placed, const Sieve& sieve, double scale,
                  Drawing& drawing) {
    bool any = false;
    const auto append = [&](Stroke&& stroke) {
        if (stroke.lines.empty()) return;
        any = true;
        drawing.items.emplace_back(std::move(stroke));
    };
    for (std::size_t n = 0; n < scene.sheets.size(); ++n) {
        const Colour line = grid_line_colour(scene, scene.sheets[n].colour);
        TonedLines lines = grid_lines(placed.sheets[n], sieve, line_spacing * scale);
        for (std::size_t tone = lines.size(); tone-- > 0;) {
            append(Stroke{std::move(lines[tone]), line, fading[tone] * line_width * scale});
        }
    }
    for (std::size_t n = 0; n < scene.edges.size(); ++n) {
        const SceneEdge& edge = scene.edges[n];
        Stroke stroke{{}, edge.colour, edge.width * scale};
        append_line(placed.edges[n].nodes, sieve, stroke.lines);
        append(std::move(stroke));
    }
    return any;
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& name) {
    std::string ending = name.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".svg") return PictureFormat::svg;
    throw UsageError("'" + name.string() + "': a picture's name ends in .png or .svg");
}

PictureSummary draw_picture(const MultiblockGrid& grid, const PictureOptions& options,
                            PictureFormat format, const std::filesystem::path& path) {
    check(options);
    const Scene scene = make_scene(grid, options);
    const View view = make_view(grid, scene, options);
    const PlacedScene placed = place(grid, scene, view);
    Drawing drawing;
    drawing.width = options.width;
    drawing.height = options.height;
    Sieve sieve{view.frame, nullptr};
    std::optional<Raster> raster;
    if (scene.flat) {
        if (scene.tinted) append_tints(scene, placed, view.frame, drawing);
    } else {
        raster.emplace(options.width, options.height, view.frame);
        for (std::size_t n = 0; n < scene.sheets.size(); ++n) {
            raster->draw(placed.sheets[n], surface_colour(scene.sheets[n].colour));
        }
        append_surfaces(scene, placed, view.frame, format, *raster, drawing);
        sieve.raster = &*raster;
    }
    const bool lines = append_lines(scene, placed, sieve, page_scale(options), drawing);
    if (!lines && (!raster || raster->empty())) {
        throw UsageError("the picture would be empty: nothing of the grid lies in the window");
    }
    append_furniture(scene, options, view, grid.units, drawing);
    if (format == PictureFormat::png) {
        write_png(drawing, path);
    } else {
        write_svg(drawing, path);
    }
    return {scene.zones, view.window()};
}

}  // namespace hexweave
