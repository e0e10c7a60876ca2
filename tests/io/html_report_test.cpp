// SPDX-License-Identifier: Apache-2.0
// What a report holds: the right points, within its bytes, and no text that the page would run.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/errors.h"
#include "io/base64.h"
#include "io/html_report.h"
#include "io/report_graph.h"
#include "io/report_sheets.h"
#include "io/run_of_grid.h"

using namespace hexweave;
using Catch::Matchers::Contains;

namespace {

std::vector<std::uint8_t> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

/// A block of unit cells at `corner`; a column of it is sheared where asked.
Zone box(const std::string& name, const Extent& extent, const Vec3& corner) {
    Zone zone{name, PointField(extent)};
    for (int k = 0; k < extent.nk; ++k) {
        for (int j = 0; j < extent.nj; ++j) {
            for (int i = 0; i < extent.ni; ++i) {
                zone.points.set(i, j, k, corner + Vec3{1.0 * i, 1.0 * j, 1.0 * k});
            }
        }
    }
    return zone;
}

MultiblockGrid one_box(const Extent& extent) {
    MultiblockGrid grid;
    grid.title = "a box";
    grid.zones = {box("box", extent, {10, 20, 30})};
    grid.families = {{"floor", "BCWall"}};
    grid.patches = {{"floor", 0, side_box(Side::kmin, extent), 0}};
    return grid;
}

float component(const std::vector<std::uint8_t>& bytes, std::size_t n) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 4; ++b) bits |= std::uint32_t{bytes[4 * n + b]} << 8 * b;
    return std::bit_cast<float>(bits);
}

std::size_t bytes_of(const std::vector<ReportSheet>& sheets) {
    std::size_t sum = 0;
    for (const ReportSheet& sheet : sheets) sum += sheet_bytes(sheet);
    return sum;
}

}  // namespace

TEST_CASE("bytes become text as RFC 4648 shows") {
    CHECK(to_base64({}).empty());
    CHECK(to_base64(bytes_of("f")) == "Zg==");
    CHECK(to_base64(bytes_of("fo")) == "Zm8=");
    CHECK(to_base64(bytes_of("foo")) == "Zm9v");
    CHECK(to_base64(bytes_of("foobar")) == "Zm9vYmFy");
    CHECK(to_base64({0xFB, 0xFF, 0x00}) == "+/8A");
}

TEST_CASE("a sheet's bytes are the points of its nodes") {
    const MultiblockGrid grid = one_box({5, 4, 3});
    const auto sheets = report_sheets(grid, {{"box", 0, 2}}, {});
    // The plane that was asked for stands last: i = 3 as users count.
    const ReportSheet& plane = sheets.back();
    REQUIRE(plane.axis == 0);
    REQUIRE(plane.index == 2);
    const auto bytes = sheet_coordinates(grid, plane);
    REQUIRE(bytes.size() == 4 * 3 * 12);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 4; ++j) {
            const std::size_t node = 3 * (j + 4 * k);
            CHECK(component(bytes, node) == 12);
            CHECK(component(bytes, node + 1) == 20.0F + static_cast<float>(j));
            CHECK(component(bytes, node + 2) == 30.0F + static_cast<float>(k));
        }
    }
    CHECK(sheet_measures(grid, plane) == [] {
        std::vector<std::uint8_t> cubes;  // scaled Jacobian 1, not skewed, aspect ratio 1, sound
        for (int cell = 0; cell < 6; ++cell) cubes.insert(cubes.end(), {255, 0, 0, 0});
        return cubes;
    }());
}

TEST_CASE("a sheet shows the worse of the cells on its two sides") {
    MultiblockGrid grid = one_box({3, 2, 2});
    // The far end of the second cell is pulled through its near end.
    for (int k = 0; k < 2; ++k) {
        for (int j = 0; j < 2; ++j) grid.zones[0].points.set(2, j, k, {10.5, 20.0 + j, 30.0 + k});
    }
    const auto sheets = report_sheets(grid, {{"box", 0, 0}, {"box", 0, 1}}, {});
    const auto beside_sound = sheet_measures(grid, sheets[sheets.size() - 2]);
    const auto between = sheet_measures(grid, sheets.back());
    CHECK(beside_sound[3] == 0);
    CHECK(between[0] == 0);
    CHECK(between[3] == 255);
}

TEST_CASE("a page has as many planes as there is room for, then every second line of them") {
    const MultiblockGrid grid = one_box({41, 41, 41});
    const auto all = report_sheets(grid, {}, {});
    CHECK(all.size() == 1 + 3 * 9);
    CHECK(all.back().stride == 1);
    const auto fewer = report_sheets(grid, {}, {}, {500'000, 9});
    CHECK(fewer.size() < all.size());
    CHECK(bytes_of(fewer) <= 500'000);
    const auto thin = report_sheets(grid, {}, {}, {30'000, 9});
    CHECK(bytes_of(thin) <= 30'000);
    CHECK(thin.back().stride > 1);
    // The last line is there whatever the stride.
    CHECK(thin.back().lines[0].front() == 0);
    CHECK(thin.back().lines[0].back() == 40);
}

TEST_CASE("the planes beside a worst cell end at the zone's sides") {
    const MultiblockGrid grid = one_box({41, 9, 5});
    WorstCell worst;
    worst.zone = "box";
    worst.cell = {39, 3, 0};
    const auto sheets = report_sheets(grid, {}, {worst});
    const ReportSheet& k_plane = sheets.back();
    REQUIRE(k_plane.worst == 0);
    REQUIRE(k_plane.axis == 2);
    CHECK(k_plane.box == IndexBox{{33, 0, 0}, {40, 8, 0}});
}

TEST_CASE("a plane that the grid does not have is refused by name") {
    const MultiblockGrid grid = one_box({5, 4, 3});
    CHECK_THROWS_WITH(report_sheets(grid, {{"bix", 0, 2}}, {}), Contains("did you mean 'box'"));
    CHECK_THROWS_WITH(report_sheets(grid, {{"", 2, 3}}, {}), Contains("k runs from 1 to 3"));
}

TEST_CASE("names and titles cannot become a part of the page's code") {
    MultiblockGrid grid = one_box({3, 3, 3});
    grid.title = "</script><script>alert(1)</script> & \"quoted\"";
    grid.zones[0].name = "<img src=x>";
    grid.families[0].name = "</title><b>";
    const std::string page =
        html_report(grid, measure_quality(grid), {"<grid>.cgns", {}, "null", {}});
    CHECK(page.find("alert(1)</script>") == std::string::npos);
    CHECK(page.find("<img src=x>") == std::string::npos);
    CHECK(page.find("</title><b>") == std::string::npos);
    CHECK_THAT(page, Contains("<h1>&lt;/script&gt;"));
    CHECK(escape_html("<&>\"'") == "&lt;&amp;&gt;&quot;&#39;");
}

TEST_CASE("a file that no run wrote is refused as one") {
    const MultiblockGrid grid = one_box({3, 3, 3});
    for (const char* text : {"[]", "{", "{\"hexweave_json\": 1, \"command\": \"compare\"}"}) {
        CHECK_THROWS_AS(run_of_grid(text, "run.json", grid), UsageError);
    }
}
