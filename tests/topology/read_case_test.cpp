// SPDX-License-Identifier: Apache-2.0
#include "topology/read_case.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "geometry/curve.h"

using namespace hexweave;

namespace {

const std::filesystem::path cases = std::filesystem::path(HEXWEAVE_SOURCE_DIR) / "tests/cases";

std::string contents(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    REQUIRE(stream);
    return text.str();
}

struct Read {
    Case c;
    Diagnostics diagnostics;
};

Read read_text(const std::string& text, const std::vector<Override>& overrides = {},
               const std::string& name = "case.yaml") {
    Read result;
    const auto source = std::make_shared<const SourceFile>(SourceFile{name, text});
    result.c = read_case(source, overrides, result.diagnostics);
    result.diagnostics.sort();
    return result;
}

Read read_good(const std::string& file, const std::vector<Override>& overrides = {}) {
    Read result = read_text(contents(cases / "good" / file), overrides, file);
    INFO(render(result.diagnostics));
    REQUIRE(result.diagnostics.all().empty());
    return result;
}

}  // namespace

TEST_CASE("a whole case is read") {
    const Case c = read_good("o_grid.yaml").c;
    CHECK(c.title == "NACA 0012, O-grid of two faces");
    CHECK(c.parameters.size() == 4);
    CHECK(c.parameters[1].value == 20);
    REQUIRE(c.curves.size() == 3);
    CHECK(evaluate(*c.curves[2].shape, 0).x == Approx(20.5).epsilon(1e-15));
    CHECK(std::get<Vec3>(c.vertices[0].where) == Vec3{1, 0, 0});
    CHECK(std::get<OnCurve>(c.vertices[3].where).at == 0.5);
    CHECK(c.edges[0].cells->value == 96);
    CHECK(std::get<TanhLaw>(c.edges[0].spacing->value).end == 2e-3);
    CHECK(std::get<LikeLaw>(c.edges[1].spacing->value).edge.value == "suction");
    CHECK_FALSE(c.edges[3].cells);
    CHECK(c.edges[4].through->value == Vec3{0.5, 20, 0});
    const auto& sides = std::get<0>(c.faces[1].shape);
    CHECK(sides[2][0].reversed);
    CHECK(c.faces[1].how.method == Method::algebraic);
    CHECK(c.boundaries[0].type.value == "BCWallViscous");
    CHECK(c.boundaries[1].sides[1].value == "out_low");
    CHECK(c.solver.tolerance == 1e-4);
    CHECK(c.solver.start_folded);
    CHECK(c.cgns_output->value == "naca0012.cgns");
}
