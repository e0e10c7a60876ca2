// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "core/errors.h"
#include "io/picture_lines.h"
#include "io/picture_page.h"
#include "io/picture_surface.h"
#include "io/picture_text.h"

namespace {

using namespace hexweave;

constexpr Frame frame{0, 0, 200, 200};

/// A rectangle at one depth with equidistant nodes.
SightSheet plain_sheet(int ni, int nj, const Frame& box, double depth) {
    SightSheet sheet{ni, nj, {}};
    for (int j = 0; j < nj; ++j) {
        for (int i = 0; i < ni; ++i) {
            sheet.nodes.push_back({box.left + box.width() * i / (ni - 1),
                                   box.top + box.height() * j / (nj - 1), depth});
        }
    }
    return sheet;
}

double length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("lines of a level keep their distance from each other and from both ends") {
    for (int lines = 3; lines < 200; ++lines) {
        for (int level = 0; level < 8; ++level) {
            int last = 0;
            for (int line = 1; line + 1 < lines; ++line) {
                if (thinning_level(line, lines) < level) continue;
                CHECK(line - last >= 1 << level);
                last = line;
            }
            if (last > 0) CHECK(lines - 1 - last >= 1 << level);
        }
    }
}

TEST_CASE("grid lines a pixel apart are thinned to every fourth") {
    const SightSheet sheet = plain_sheet(101, 2, {50, 50, 150, 60}, 0);
    const TonedLines lines = grid_lines(sheet, {frame, nullptr}, 2.5);
    CHECK(lines[0].size() + lines[1].size() + lines[2].size() == 24);  // 4, 8, ..., 96
    const TonedLines all = grid_lines(sheet, {frame, nullptr}, 0.5);
    CHECK(all[0].size() == 99);
}

TEST_CASE("a grid line behind a surface is cut where it goes behind") {
    Raster raster(200, 200, frame);
    raster.draw(plain_sheet(5, 5, {50, 50, 150, 150}, 10), white);
    std::vector<Polyline> lines;
    append_line({{10, 100, 0}, {190, 100, 0}}, {frame, &raster}, lines);
    CHECK(lines.size() == 2);
    CHECK(length(lines) == Approx(80).margin(4));
    lines.clear();
    append_line({{10, 100, 20}, {190, 100, 20}}, {frame, &raster}, lines);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].size() == 2);
    CHECK(length(lines) == Approx(180));
}

TEST_CASE("a surface covers exactly its pixels, without a gap between its cells") {
    const int nodes = GENERATE(2, 8, 401);
    Raster raster(200, 200, frame);
    raster.draw(plain_sheet(nodes, nodes, {40, 60, 140, 100}, 0), {0, 0, 0});
    const auto pixels = raster.pixels();
    int covered = 0;
    for (const std::uint32_t rgb : pixels) covered += rgb == 0xFFFFFF ? 0 : 1;
    CHECK(covered == 100 * 40);
}

TEST_CASE("tiles cover what is seen of a surface, once") {
    Raster raster(200, 200, frame);
    const SightSheet far = plain_sheet(41, 41, {0, 0, 200, 200}, 0);
    const SightSheet near = plain_sheet(2, 2, {50, 50, 150, 150}, 10);
    raster.draw(far, white);
    raster.draw(near, white);
    const auto area = [&](const SightSheet& sheet) {
        std::vector<DeepTile> tiles;
        append_tiles(sheet, white, frame, raster, 8, tiles);
        double sum = 0;
        for (const DeepTile& tile : tiles) {
            const Polyline& ring = tile.tile.ring;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const PagePoint& a = ring[i];
                const PagePoint& b = ring[(i + 1) % ring.size()];
                sum += (a.x * b.y - b.x * a.y) / 2;
            }
        }
        return sum;
    };
    CHECK(area(near) == Approx(100 * 100));
    CHECK(area(far) >= 200 * 200 - 100 * 100 - 1e-6);
    CHECK(area(far) < 200 * 200 - 60 * 60);  // tiles at the rim of the hidden part remain
}

TEST_CASE("a straight line keeps its ends only, a curve stays where it is") {
    Polyline straight;
    Polyline circle;
    for (int n = 0; n <= 5000; ++n) {
        straight.push_back({0.01 * n, 0.02 * n});
        const double angle = 2 * M_PI * n / 5000;
        circle.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
    }
    CHECK(simplified(straight, 0.1) == Polyline{straight.front(), straight.back()});
    const Polyline polygon = simplified(circle, 0.1);
    CHECK(polygon.front() == circle.front());
    CHECK(polygon.back() == circle.back());
    CHECK(polygon.size() < 150);
    // A chord of a circle is off by r (1 - cos(half its angle)).
    for (std::size_t i = 1; i < polygon.size(); ++i) {
        const double chord =
            std::hypot(polygon[i].x - polygon[i - 1].x, polygon[i].y - polygon[i - 1].y);
        CHECK(100 - std::sqrt(100 * 100 - chord * chord / 4) < 0.11);
    }
}

TEST_CASE("lines and polygons are cut at the frame") {
    const auto piece = clip(frame, {-100, 50, 0}, {300, 50, 40});
    REQUIRE(piece);
    CHECK((*piece)[0].x == Approx(0));
    CHECK((*piece)[0].depth == Approx(10));
    CHECK((*piece)[1].x == Approx(200));
    CHECK((*piece)[1].depth == Approx(30));
    CHECK_FALSE(clip(frame, {-10, 5, 0}, {5, -10.1, 0}));
    CHECK_FALSE(clip(frame, {NAN, 50, 0}, {50, 50, 0}));
    const Polyline corner = clip_polygon(frame, {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}});
    double area = 0;
    for (std::size_t i = 0; i < corner.size(); ++i) {
        const PagePoint& a = corner[i];
        const PagePoint& b = corner[(i + 1) % corner.size()];
        area += (a.x * b.y - b.x * a.y) / 2;
    }
    CHECK(area == Approx(50 * 50));
    CHECK(clip_polygon(frame, {{-50, -50}, {-5, -50}, {-5, 50}}).empty());
}

TEST_CASE("a camera is a right-handed set of unit vectors that keeps up upright") {
    for (const Vec3& eye : {Vec3{1, -1, 0.8}, Vec3{0, 0, 3}, Vec3{0, 0, -1}, Vec3{-2, 0, 0}}) {
        const Camera camera = look_from(eye, std::nullopt);
        CHECK(norm(camera.right) == Approx(1));
        CHECK(norm(cross(camera.right, camera.up) - camera.eye) == Approx(0).margin(1e-14));
        CHECK(dot(camera.up, eye.x == 0 && eye.y == 0 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}) > 0);
        CHECK(norm(cross(camera.eye, eye)) == Approx(0).margin(1e-14));
    }
    CHECK(look_from({0, 0, 1}, std::nullopt).right == Vec3{1, 0, 0});
    CHECK(look_from({0, -1, 0}, std::nullopt).right == Vec3{1, 0, 0});
    CHECK_THROWS_AS(look_from({0, 0, 1}, Vec3{0, 0, 1}), UsageError);
}

TEST_CASE("marks of an axis are round, and so are their texts") {
    CHECK(mark_distance(10, 10) == Approx(1));
    CHECK(mark_distance(2.1, 10) == Approx(0.2));
    CHECK(mark_distance(4e-5, 8) == Approx(5e-6));
    CHECK(mark_text(0.30000000000000004, 0.1) == "0.3");
    CHECK(mark_text(-1e-17, 0.1) == "0");
    CHECK(mark_text(20, 5) == "20");
    CHECK(mark_text(1.00005, 1e-5) == "1.00005");
    CHECK(mark_text(2e-9, 1e-9) == "2e-09");
    CHECK(mark_text(3e7, 1e7) == "3e+07");
}

TEST_CASE("text that is not UTF-8 or not printable is shown with question marks") {
    CHECK(printable("wing_1 \xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80") ==
          "wing_1 \xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
    CHECK(printable("a\tb\x7F") == "a?b?");
    CHECK(printable("\xC0\x80") == "??");            // overlong
    CHECK(printable("\xED\xA0\x80") == "???");       // a surrogate
    CHECK(printable("\xE2\x82") == "??");            // cut short
    CHECK(printable("\xF4\x90\x80\x80") == "????");  // beyond Unicode
    CHECK(xml_escaped("<a&\"b\">") == "&lt;a&amp;&quot;b&quot;&gt;");
}
