// SPDX-License-Identifier: Apache-2.0
// Curves and surfaces as a file writes them: made of one another, in any order.
#include "topology/shapes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "topology/read_case.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

struct Read {
    Case c;
    Diagnostics diagnostics;

    const Curve& curve(const std::string& name) const {
        for (const CurveEntry& entry : c.curves) {
            if (entry.name.value == name && entry.shape) return *entry.shape;
        }
        FAIL("no curve " << name);
        return *c.curves.front().shape;
    }
    const Surface& surface(const std::string& name) const {
        for (const SurfaceEntry& entry : c.surfaces) {
            if (entry.name.value == name && entry.shape) return *entry.shape;
        }
        FAIL("no surface " << name);
        return *c.surfaces.front().shape;
    }
};

Read read_text(const std::string& text) {
    Read result;
    const auto source = std::make_shared<const SourceFile>(SourceFile{"case.yaml", text});
    result.c = read_case(source, {}, result.diagnostics);
    result.diagnostics.sort();
    return result;
}

Read read_sound(const std::string& text) {
    Read result = read_text("hexweave: 1\n" + text);
    INFO(render(result.diagnostics));
    REQUIRE_FALSE(result.diagnostics.has_errors());
    return result;
}

}  // namespace

TEST_CASE("curves of surfaces of curves are read whatever the order") {
    const Read read = read_sound(
        "curves:\n"
        "  seam:  {surface: lid, side: umin}\n"
        "  shift: {of: ring, translate: [0, 0, 2]}\n"
        "  ring:  {surface: ball, v: pi / 6}\n"
        "surfaces:\n"
        "  lid:  {of: wall, scale: 2}\n"
        "  wall: {ruled: [ring, shift]}\n"
        "  ball: {sphere: {center: [0, 0, 0], radius: 2}}\n");
    const Curve& seam = read.curve("seam");
    CHECK(distance(seam.position(0), {2 * std::sqrt(3), 0, 2}) < 1e-14);
    CHECK(distance(seam.position(1), {2 * std::sqrt(3), 0, 6}) < 1e-14);
    CHECK(read.surface("wall").closed_u);
    for (const SurfaceEntry& entry : read.c.surfaces) CHECK(entry.used_by_surface);
    CHECK_FALSE(read.c.curves[0].used_by_curve);
    CHECK(read.c.curves[2].used_by_curve);
}

TEST_CASE("a circle of curves and surfaces is told once, with its way round") {
    const Read read = read_text(
        "hexweave: 1\n"
        "curves:\n"
        "  a: {surface: s, u: 0}\n"
        "surfaces:\n"
        "  s: {extrusion: {curve: b, along: [0, 0, 1]}}\n"
        "  t: {of: s}\n");
    CHECK(read.diagnostics.errors() == 1);
    const Read round = read_text(
        "hexweave: 1\n"
        "curves:\n"
        "  a: {surface: s, u: 0}\n"
        "surfaces:\n"
        "  s: {extrusion: {curve: a, along: [0, 0, 1]}}\n"
        "  t: {of: s}\n");
    CHECK(render(round.diagnostics) ==
          "case.yaml:5:26: error: curve 'a' is made of itself\n"
          "  s: {extrusion: {curve: a, along: [0, 0, 1]}}\n"
          "                         ^\n"
          "  hint: it is made of surface 's', which is made of it\n");
}

TEST_CASE("long rows of shapes come to an end from either end") {
    for (const bool backwards : {false, true}) {
        std::string text = "hexweave: 1\nsurfaces:\n";
        constexpr int count = 150;
        const auto line = [](int n) {
            return "  s" + std::to_string(n) +
                   (n == 0 ? ": {plane: {point: [0, 0], u: [1, 0], v: [0, 1]}}\n"
                           : ": {of: s" + std::to_string(n - 1) + "}\n");
        };
        for (int n = 0; n < count; ++n) text += line(backwards ? count - 1 - n : n);
        const Read read = read_text(text);
        INFO(render(read.diagnostics));
        REQUIRE(read.diagnostics.errors() >= 1);
        CHECK(read.diagnostics.all()[0].message == "more than 100 shapes are made of one another");
    }
}

TEST_CASE("nets, meshes and extrusions are read as they are written") {
    const Read read = read_sound(
        "curves:\n"
        "  quarter: {nurbs: {degree: 2, knots: [0, 0, 0, 1, 1, 1], control: [[1, 0], [1, 1], [0, "
        "1]], weights: [1, sqrt(0.5), 1]}}\n"
        "  lead:    {line: [[5, 5, 5], [5, 5, 9]]}\n"
        "surfaces:\n"
        "  drum:  {extrusion: {curve: quarter, along: lead}}\n"
        "  bent:  {nurbs: {degree: [2, 1], knots: {u: [0, 0, 0, 1, 1, 1], v: [2, 2, 3, 3]},\n"
        "          control: [[[1, 0, 0], [1, 1, 0], [0, 1, 0]], [[1, 0, 4], [1, 1, 4], [0, 1, "
        "4]]],\n"
        "          weights: [[1, sqrt(0.5), 1], [1, sqrt(0.5), 1]]}}\n"
        "  sheet: {control_points: [[[0, 0], [2, 0], [3, 0]], [[0, 1], [2, 1], [3, 1]]]}\n");
    for (int n = 0; n <= 20; ++n) {
        const double u = n / 20.0;
        const double v = std::fmod(3.7 * u, 1.0);
        const Vec3 drum = evaluate(read.surface("drum"), {u, v});
        CHECK(std::hypot(drum.x, drum.y) == Approx(1).epsilon(1e-14));
        CHECK(distance(drum, evaluate(read.surface("bent"), {u, 2 + v})) < 1e-14);
        CHECK(distance(evaluate(read.surface("sheet"), {u, v}), {3 * u, v, 0}) < 1e-14);
    }
}

TEST_CASE("parameters are cut first, then swapped, then reversed") {
    const Read read = read_sound(
        "surfaces:\n"
        "  sheet: {plane: {point: [0, 0], u: [4, 0], v: [0, 2]}}\n"
        "  part:  {of: sheet, range: {u: [0.5, 1]}, swap: true, reverse: v, translate: [0, 0, 1]}\n"
        "  ball:  {sphere: {center: [0, 0, 0], radius: 1}, range: {u: [-pi / 2, pi / 2]}}\n");
    const Surface& part = read.surface("part");
    CHECK(part.range_u == std::array<double, 2>{0, 1});
    CHECK(part.range_v == std::array<double, 2>{0.5, 1});
    CHECK(distance(evaluate(part, {0.25, 0.5}), {4, 0.5, 1}) < 1e-15);
    CHECK(distance(evaluate(part, {0, 1}), {2, 0, 1}) < 1e-15);
    CHECK_FALSE(read.surface("ball").closed_u);
    CHECK(distance(evaluate(read.surface("ball"), {-pi / 2, 0}), {0, -1, 0}) < 1e-15);
}

TEST_CASE("curves lie on surfaces where their entries say") {
    const Read read = read_sound(
        "surfaces:\n"
        "  sheet: {plane: {point: [0, 0, 1], u: [4, 0], v: [0, 2]}}\n"
        "  ball:  {sphere: {center: [0, 0, 0], radius: 1}}\n"
        "curves:\n"
        "  up:      {surface: sheet, u: 0.25}\n"
        "  down:    {surface: sheet, u: 0.25, v: [1, 0.5]}\n"
        "  across:  {surface: sheet, v: 0.5, u: [0, 0.5]}\n"
        "  right:   {surface: sheet, side: umax}\n"
        "  slant:   {surface: sheet, line: [[0, 1], [0.5, 0]], translate: [0, 0, 1]}\n"
        "  equator: {surface: ball, v: 0, u: [pi, 3 * pi]}\n"
        "  bow:     {surface: ball, points: [[1, 0, 0], [0.6, 0.48, 0.64], [0, 1, 0]]}\n");
    const auto runs = [&](const std::string& name, const Vec3& from, const Vec3& to) {
        const Curve& curve = read.curve(name);
        INFO(name);
        CHECK(distance(curve.position(curve.begin), from) < 1e-14);
        CHECK(distance(curve.position(curve.end), to) < 1e-14);
    };
    runs("up", {1, 0, 1}, {1, 2, 1});
    runs("down", {1, 2, 1}, {1, 1, 1});
    runs("across", {0, 1, 1}, {2, 1, 1});
    runs("right", {4, 0, 1}, {4, 2, 1});
    runs("slant", {0, 2, 2}, {2, 0, 2});
    runs("bow", {1, 0, 0}, {0, 1, 0});
    runs("equator", {-1, 0, 0}, {-1, 0, 0});
    CHECK(read.curve("equator").closed);
}

TEST_CASE("a six-digit section without its hyphen is warned of") {
    const Read read = read_text(R"(hexweave: 1
curves:
  six: {naca: "64012"}
  five: {naca: "23012"}
  four: {naca: "6412"}
)");
    REQUIRE(read.diagnostics.all().size() == 1);
    const Diagnostic& warning = read.diagnostics.all()[0];
    CHECK(warning.severity == Severity::warning);
    CHECK(warning.place.line == 3);
    CHECK(warning.message == "'64012' is made as a five-digit section, of a design lift of 0.9");
    CHECK(warning.hint.find("NACA 64-012, of the six-digit series") == 0);
}
