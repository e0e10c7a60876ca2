// SPDX-License-Identifier: Apache-2.0
#include "io/picture.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "picture_samples.h"
#include "scratch.h"

namespace {

using namespace hexweave;
using namespace hexweave::samples;

constexpr Pixel paper{255, 255, 255};

Image draw_png(const MultiblockGrid& grid, const PictureOptions& options) {
    const Scratch scratch;
    draw_picture(grid, options, PictureFormat::png, scratch.path("picture.png"));
    return read_png(scratch.path("picture.png"));
}

std::string draw_svg(const MultiblockGrid& grid, const PictureOptions& options) {
    const Scratch scratch;
    draw_picture(grid, options, PictureFormat::svg, scratch.path("picture.svg"));
    return contents(scratch.path("picture.svg"));
}

/// The first colour of the palette is a blue, the second a red.
bool bluish(const Pixel& p) {
    return p.blue - p.red > 45;
}
bool reddish(const Pixel& p) {
    return p.red - p.blue > 45;
}

template <class Like>
int runs_in_row(const Image& image, int row, Like&& like) {
    int runs = 0;
    bool inside = false;
    for (int x = 0; x < image.width; ++x) {
        const bool now = like(image(x, row));
        runs += now && !inside ? 1 : 0;
        inside = now;
    }
    return runs;
}

template <class Like>
std::size_t count(const Image& image, Like&& like) {
    return static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(), like));
}

/// Whether every element is closed in order, and every attribute quoted.
bool well_formed(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
        if (tag.empty() || tag.find('<') != std::string::npos) return false;
        if (tag[0] == '?' || tag.back() == '/') continue;
        const std::string name = tag.substr(0, tag.find_first_of(" \n"));
        if (name[0] != '/') {
            open.push_back(name);
        } else if (open.empty() || "/" + open.back() != name) {
            return false;
        } else {
            open.pop_back();
        }
    }
    return open.empty();
}

/// Two squares one above the other: `below` twice as large as `above`, which has one cell.
MultiblockGrid stacked() {
    MultiblockGrid grid;
    grid.cell_dimension = 2;
    grid.zones.push_back(mapped_zone("below", {9, 9, 1}, [](double s, double t, double) {
        return Vec3{4 * s - 2, 4 * t - 2, 0};
    }));
    grid.zones.push_back(mapped_zone("above", {2, 2, 1}, [](double s, double t, double) {
        return Vec3{2 * s - 1, 2 * t - 1, 1};
    }));
    return grid;
}

}  // namespace

TEST_CASE("a PNG has the size that was asked for") {
    PictureOptions options;
    options.width = 640;
    options.height = 400;
    const Image image = draw_png(squares(2, 5), options);
    CHECK(image.width == 640);
    CHECK(image.height == 400);
    CHECK(image(1, 1) == paper);
}

TEST_CASE("every grid line of a coarse planar grid is drawn once") {
    const int nodes = GENERATE(6, 11, 26);
    const Image image = draw_png(squares(1, nodes), {});
    // The middle row lies between two grid lines when the number of cells is odd; one row in
    // twenty around it lies between two lines in any case.
    int fewest = nodes;
    for (int row = 400; row < 420; ++row) {
        fewest = std::min(fewest, runs_in_row(image, row, bluish));
    }
    CHECK(fewest == nodes - 2);
}

TEST_CASE("zones are told apart by colour, from left to right") {
    const Image image = draw_png(squares(2, 11), {});
    int blue_end = 0;
    int red_start = image.width;
    for (int x = 0; x < image.width; ++x) {
        if (bluish(image(x, 450))) blue_end = x;
        if (reddish(image(x, 450))) red_start = std::min(red_start, x);
    }
    CHECK(blue_end > 0);
    CHECK(blue_end < red_start);
}

TEST_CASE("boundaries are drawn in the colours of their families") {
    PictureOptions options;
    options.colour = ColourBy::family;
    const Image image = draw_png(squares(2, 6), options);
    CHECK(runs_in_row(image, 450, bluish) == 1);
    CHECK(runs_in_row(image, 450, reddish) == 1);
    options.families = {"right"};
    const Image only_right = draw_png(squares(2, 6), options);
    CHECK(count(only_right, bluish) == 0);
    CHECK(runs_in_row(only_right, 450, reddish) == 1);
}

TEST_CASE("a window cuts off what lies outside") {
    PictureOptions options;
    options.window = {1.225, 0.225, 1.775, 0.775};
    const Scratch scratch;
    const MultiblockGrid grid = squares(2, 21);
    const PictureSummary summary =
        draw_picture(grid, options, PictureFormat::png, scratch.path("picture.png"));
    const Image image = read_png(scratch.path("picture.png"));
    CHECK(runs_in_row(image, 600, bluish) == 0);
    CHECK(runs_in_row(image, 600, reddish) == 11);  // at x = 1.25, 1.3, ..., 1.75
    CHECK(image(image.width - 3, 600) == paper);
    for (std::size_t n = 0; n < 4; ++n) {
        CHECK(summary.window[n] == Approx((*options.window)[n]).margin(1e-9));
    }
}

TEST_CASE("the nearer surface hides the farther one and its lines") {
    PictureOptions options;
    options.view = Vec3{0, 0, 1};
    const Image above = draw_png(stacked(), options);
    const Pixel& middle = above(above.width / 2 - 60, above.height / 2 - 30);
    CHECK(reddish(middle));
    int different = 0;
    for (int y = 360; y < 460; ++y) {
        for (int x = 480; x < 580; ++x) different += above(x, y) == middle ? 0 : 1;
    }
    CHECK(different == 0);
    options.view = Vec3{0, 0, -1};
    const Image below = draw_png(stacked(), options);
    CHECK(bluish(below(below.width / 2 - 60, below.height / 2 - 25)));
    // The legend alone is red.
    CHECK(count(below, reddish) < 400);
}

TEST_CASE("an SVG hides what a PNG hides") {
    PictureOptions options;
    options.view = Vec3{0, 0, -1};
    const std::string below = draw_svg(stacked(), options);
    options.view = Vec3{0, 0, 1};
    const std::string above = draw_svg(stacked(), options);
    const auto colours = [](const std::string& text) {
        std::vector<std::string> found;
        const std::string key = "<path color=\"";
        for (std::size_t at = text.find(key); at != std::string::npos;
             at = text.find(key, at + 1)) {
            found.push_back(text.substr(at + key.size(), 7));
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    };
    CHECK(colours(below).size() == 1);
    CHECK(colours(above).size() == 2);
}

TEST_CASE("an index plane shows the inside of a block") {
    PictureOptions options;
    options.boundary = false;
    options.planes = {{"cube", 0, 3}};
    options.view = Vec3{1, 0, 0};
    const Image image = draw_png(cube(6), options);
    CHECK(bluish(image(500, 400)));
    options.view = Vec3{0, 0, 1};  // seen edge on: a line
    const Image edge_on = draw_png(cube(6), options);
    CHECK(count(edge_on, bluish) < 400);
}

TEST_CASE("only the boundaries of the families asked for are drawn") {
    PictureOptions options;
    options.view = Vec3{0, 0, 1};
    options.colour = ColourBy::family;
    const Image both = draw_png(cube(3), options);
    options.families = {"floor"};
    const Image floor = draw_png(cube(3), options);
    CHECK(reddish(both(500, 350)));
    CHECK(bluish(floor(500, 350)));
}

TEST_CASE("a grid without boundaries is drawn with all its sides") {
    MultiblockGrid grid = cube(4);
    grid.patches.clear();
    CHECK(count(draw_png(grid, {}), bluish) > 100000);
}

TEST_CASE("an SVG is well-formed, whatever names and titles hold") {
    MultiblockGrid grid = squares(2, 7);
    grid.zones[0].name = "a<b&\"c\"";
    grid.zones[1].name = "caf\xE9\x01";  // not UTF-8
    PictureOptions options;
    options.title = "x < y & \xCE\xA9";
    const std::string text = draw_svg(grid, options);
    CHECK(well_formed(text));
    CHECK(text.find("a&lt;b&amp;&quot;c&quot;") != std::string::npos);
    CHECK(text.find("caf??") != std::string::npos);
    CHECK(text.find("x &lt; y &amp; \xCE\xA9") != std::string::npos);
    CHECK(well_formed(draw_svg(cube(5), {})));
    CHECK_NOTHROW(draw_png(grid, options));
}

TEST_CASE("a million cells fit into two megabytes") {
    const MultiblockGrid grid = squares(1, 1001);
    const Scratch scratch;
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
        for (const bool shaded : {false, true}) {
            PictureOptions options;
            options.window = {0.3, 0.3, 0.7, 0.6};  // the page is full of lines
            if (shaded) options.view = Vec3{0.3, -0.2, 1};
            draw_picture(grid, options, format, scratch.path("picture"));
            CHECK(std::filesystem::file_size(scratch.path("picture")) < 2'000'000);
            CHECK(std::filesystem::file_size(scratch.path("picture")) > 10'000);
        }
    }
}

TEST_CASE("the same grid gives the same bytes") {
    const Scratch scratch;
    const MultiblockGrid grid = cube(9);
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
        draw_picture(grid, {}, format, scratch.path("first"));
        draw_picture(grid, {}, format, scratch.path("second"));
        CHECK(contents(scratch.path("first")) == contents(scratch.path("second")));
    }
}

TEST_CASE("nodes that are not finite leave a hole and no more") {
    MultiblockGrid planar = squares(1, 9);
    MultiblockGrid solid = cube(9);
    for (MultiblockGrid* grid : {&planar, &solid}) {
        grid->zones[0].points.x[13] = std::numeric_limits<double>::quiet_NaN();
        grid->zones[0].points.y[20] = std::numeric_limits<double>::infinity();
        CHECK(count(draw_png(*grid, {}), bluish) > 1000);
        CHECK(draw_svg(*grid, {}).find("nan") == std::string::npos);
    }
}

TEST_CASE("what cannot be drawn is told") {
    const Scratch scratch;
    const auto message = [&](const MultiblockGrid& grid, const PictureOptions& options) {
        try {
            draw_picture(grid, options, PictureFormat::png, scratch.path("picture.png"));
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string("drawn");
    };
    PictureOptions options;
    options.planes = {{"cubes", 2, 0}};
    CHECK(message(cube(4), options) == "the grid has no zone 'cubes'; did you mean 'cube'?");
    options.planes = {{"sphere", 2, 0}};
    CHECK(message(cube(4), options) == "the grid has no zone 'sphere'; it has: cube");
    options.planes = {{"", 1, 4}};
    CHECK(message(cube(4), options) == "zone 'cube' has no index plane j = 5: j runs from 1 to 4");
    options.planes = {{"", 1, -1}};
    CHECK(message(cube(4), options) == "zone 'cube' has no index plane j = 0: j runs from 1 to 4");
    CHECK(message(squares(1, 4), options) ==
          "index planes need a grid of volumes; this one has only faces");
    options = {};
    options.families = {"flor"};
    CHECK(message(cube(4), options) == "the grid has no family 'flor'; did you mean 'floor'?");
    options = {};
    options.boundary = false;
    CHECK(message(cube(4), options) ==
          "the picture would be empty: neither boundary nor index plane");
    options = {};
    options.window = {5, 5, 6, 6};
    CHECK(message(squares(1, 4), options) ==
          "the picture would be empty: nothing of the grid lies in the window");
    CHECK(message(cube(4), options) ==
          "the picture would be empty: nothing of the grid lies in the window");
    options.window = {1, 0, 0, 1};
    CHECK(message(cube(4), options) == "the window is empty: it is xmin ymin xmax ymax");
    options = {};
    options.width = 99999;
    CHECK(message(cube(4), options) ==
          "a picture of 99999 x 900: width and height are 100 to 10000 pixels");
    options = {};
    options.view = Vec3{0, 0, 0};
    CHECK(message(cube(4), options) == "a direction of view has no length");
    options.view = Vec3{0, 1, 0};
    options.up = Vec3{0, 2, 0};
    CHECK(message(cube(4), options) == "the view and what points up are parallel");
    CHECK_FALSE(std::filesystem::exists(scratch.path("picture.png")));
}

TEST_CASE("a picture that cannot be written names its path and the reason") {
    const std::filesystem::path path = "/nonexistent/picture";
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
        try {
            draw_picture(squares(1, 4), {}, format, path);
            FAIL("written");
        } catch (const MachineError& error) {
            CHECK(std::string(error.what()).find("/nonexistent/picture: ") == 0);
            CHECK(std::string(error.what()).find("o such file") != std::string::npos);
        }
    }
}

TEST_CASE("the ending of a picture's name picks its format") {
    CHECK(picture_format("wing.png") == PictureFormat::png);
    CHECK(picture_format("a.b/wing.SVG") == PictureFormat::svg);
    CHECK_THROWS_WITH(picture_format("wing.jpg"),
                      "'wing.jpg': a picture's name ends in .png or .svg");
    CHECK_THROWS_AS(picture_format("png"), UsageError);
}
