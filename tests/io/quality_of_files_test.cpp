// SPDX-License-Identifier: Apache-2.0
// The quality of a published grid, against figures that were worked out without this program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "io/grid_file.h"
#include "io/quality_json.h"
#include "io/quality_text.h"
#include "quality/grid_quality.h"

using namespace hexweave;

namespace {

GridQuality quality_of_published_grid() {
    MultiblockGrid grid =
        read_grid(std::string(HEXWEAVE_SOURCE_DIR) + "/tests/io/grids/n0012_113-33.p2d");
    name_sides_where_nothing_is_named(grid);
    return measure_quality(grid);
}

}  // namespace

TEST_CASE("a published C-grid has the figures that others found") {
    const GridQuality q = quality_of_published_grid();
    REQUIRE(q.zones.size() == 1);
    const ZoneQuality& z = q.zones[0];
    CHECK(z.measure.cells == 3584);
    CHECK(z.measure.folded == 0);
    CHECK(z.positive == 3584);
    CHECK(z.least_volume.value == Approx(2.6147e-08).epsilon(1e-4));
    CHECK(z.greatest_volume.value == Approx(3.6058e+04).epsilon(1e-4));
    CHECK(z.measure.angles.least == Approx(53.86).margin(0.005));
    CHECK(z.measure.angles.greatest == Approx(118.90).margin(0.005));
    // The figure of the others lies between the 36th and the 37th worst cell, 0.4 degrees apart.
    CHECK(z.skewness_99 * 90 == Approx(20.30).margin(0.4));
    CHECK(z.measure.growth[0].ratio == Approx(5.801).margin(5e-4));
    CHECK(z.measure.growth[1].ratio == Approx(4.100).margin(5e-4));
    CHECK(z.greatest_aspect_ratio.value == Approx(2.065e+07).epsilon(5e-4));
    REQUIRE(q.boundaries.size() == 4);
    CHECK(q.boundaries[2].least_height == Approx(8.384e-06).epsilon(1e-4));
    CHECK(q.boundaries[2].median_height == Approx(8.714e-06).epsilon(1e-4));
    CHECK(q.boundaries[2].greatest_height == Approx(3.115e-05).epsilon(1e-4));
}

TEST_CASE("quality as JSON holds the verdict, the zones and the histograms") {
    const GridQuality q = quality_of_published_grid();
    const auto json = nlohmann::json::parse(to_json(q, "naca.p2d"));
    CHECK(json["grid"] == "naca.p2d");
    CHECK(json["sound"] == true);
    CHECK(json["zones"][0]["positive"] == 3584);
    CHECK(json["worst"].size() == 10);
    for (const auto& histogram : json["histograms"]) {
        CHECK(histogram["counts"].size() == histogram["limits"].size() + 1);
    }
    CHECK(to_text(q).find("sound: 1 zone, 3,584 cells, none folded") != std::string::npos);
}
