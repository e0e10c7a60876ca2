// SPDX-License-Identifier: Apache-2.0
#include "geometry/airfoil.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "geometry/curve_checks.h"

using namespace hexweave;

namespace {

std::string file_text(const std::string& name) {
    std::ifstream file(std::string(HEXWEAVE_SOURCE_DIR) + "/data/airfoils/" + name);
    REQUIRE(file.good());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string lines_of(const std::vector<Vec3>& points) {
    std::string text;
    for (const Vec3& p : points) {
        std::array<char, 80> line{};
        std::snprintf(line.data(), line.size(), "%.17g  %.17g\n", p.x, p.y);
        text += line.data();
    }
    return text;
}

/// The points of a section in Selig order written as two blocks from the leading edge.
std::string lednicer_text(const std::vector<Vec3>& points, bool counts) {
    const auto nose = std::min_element(points.begin(), points.end(),
                                       [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    std::vector<Vec3> upper(points.begin(), nose + 1);
    std::reverse(upper.begin(), upper.end());
    const std::vector<Vec3> lower(nose, points.end());
    std::string text = "A TITLE 12\n";
    if (counts) {
        text += std::to_string(upper.size()) + ". " + std::to_string(lower.size()) + ".\n";
    }
    return text + "\n" + lines_of(upper) + "\n" + lines_of(lower);
}

std::vector<Vec3> points_of(const std::string& text,
                            AirfoilContent content = AirfoilContent::section) {
    const AirfoilPoints read = read_airfoil(text, content);
    INFO(read.error);
    REQUIRE(read.error.empty());
    return read.points;
}

Curve shape(const std::string& text, const AirfoilShape& how) {
    return airfoil_from_text(text, AirfoilContent::section, how).curve.value();
}

AirfoilShape side(AirfoilSide part) {
    AirfoilShape how;
    how.side = part;
    return how;
}

std::string fault(const std::string& text, AirfoilContent content = AirfoilContent::section) {
    const CurveResult result = airfoil_from_text(text, content, {});
    REQUIRE_FALSE(result.curve);
    return std::to_string(result.line) + ": " + result.error;
}

/// A small section with a line for each point, the last one closing it.
const std::string diamond = "1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n";

}  // namespace

TEST_CASE("a Selig file is read as it stands") {
    const std::vector<Vec3> points = points_of(file_text("rae2822.dat"));
    CHECK(points.size() == 129);
    CHECK(points[1] == Vec3{0.999398, 0.000128, 0});
    CHECK(points.front() == points.back());
}

TEST_CASE("a file that runs along the lower side first is turned round") {
    const std::vector<Vec3> points = points_of(file_text("onera_d_normal_section.dat"));
    CHECK(points.size() == 301);
    CHECK(points.front() == Vec3{1, 0.00078, 0});
    CHECK(points.back() == Vec3{1, -0.00078, 0});
    std::vector<Vec3> turned = points_of(file_text("rae2822.dat"));
    std::reverse(turned.begin(), turned.end());
    CHECK(points_of(lines_of(turned)) == points_of(file_text("rae2822.dat")));
}

TEST_CASE("every order of a file gives the same points") {
    const std::vector<Vec3> points = points_of(file_text("rae2822.dat"));
    CHECK(points_of(lednicer_text(points, true)) == points);
    CHECK(points_of(lednicer_text(points, false)) == points);
    const std::vector<Vec3> symmetric = points_of(file_text("naca0012.dat"));
    const auto nose = std::find(symmetric.begin(), symmetric.end(), Vec3{0, 0, 0});
    REQUIRE(nose != symmetric.end());
    const std::string half = "half\n" + lines_of({symmetric.begin(), nose + 1});
    CHECK(points_of(half, AirfoilContent::symmetric_half) == symmetric);
    const std::string lower = lines_of({nose, symmetric.end()});
    CHECK(points_of(lower, AirfoilContent::symmetric_half) == symmetric);
}

TEST_CASE("titles, commas, tabs, carriage returns and Fortran's exponents are read") {
    const std::vector<Vec3> points = points_of(diamond);
    CHECK(points_of("\xEF\xBB\xBF"
                    "1, 0\r\n5.0D-1,\t+1.E-1\r\n0 0\r\n.5 -.1\r\n1 0") == points);
    CHECK(points_of("RAE 2822\n# 2\n0012\n\n-5.0 5.0 -5.0 5.0\n" + diamond) == points);
}

TEST_CASE("the section passes its points, and its sides are its parts") {
    const std::string text = file_text("rae2822.dat");
    const std::vector<Vec3> points = points_of(text);
    const Curve whole = shape(text, {});
    CHECK(whole.closed);
    for (const Vec3& p : points) CHECK(project(whole, p).distance == 0);
    const Curve upper = shape(text, side(AirfoilSide::upper));
    const Curve lower = shape(text, side(AirfoilSide::lower));
    for (const Curve& part : {upper, lower}) {
        CHECK(evaluate(part, part.begin) == Vec3{0, 0, 0});
        CHECK(evaluate(part, part.end) == Vec3{1, 0, 0});
        CHECK(derivative_error(part) < 1e-5);
    }
    CHECK(evaluate(upper, 0.5 * (upper.begin + upper.end)).y > 0.03);
    CHECK(arc_length(upper, upper.begin, upper.end) + arc_length(lower, lower.begin, lower.end) ==
          Approx(arc_length(whole, whole.begin, whole.end)).epsilon(1e-13));
    // Smooth over the leading edge: the sides leave it in opposite directions.
    const Vec3 up = evaluate_derivative(upper, upper.begin);
    const Vec3 down = evaluate_derivative(lower, lower.begin);
    CHECK(norm(up + down) < 1e-14 * norm(up));
}

TEST_CASE("the spline through NACA 0012 coordinates is the formula's shape") {
    const Curve whole = shape(file_text("naca0012.dat"), {});
    const Curve exact =
        naca_airfoil("0012", 1, AirfoilSide::whole, TrailingEdge::blunt).curve.value();
    double at_nose = 0;
    double behind = 0;
    for (int k = 0; k <= 500; ++k) {
        const Vec3 p = evaluate(whole, whole.begin + whole.period() * k / 500);
        double& worst = p.x < 0.05 ? at_nose : behind;
        worst = std::max(worst, project(exact, p).distance);
    }
    // 69 points of seven digits; the formula's slope of curvature jumps at the leading edge.
    CHECK(behind < 2e-6);
    CHECK(at_nose < 3e-5);
}

TEST_CASE("a blunt trailing edge is kept, or closed by shearing both sides") {
    const std::string text = file_text("naca0012.dat");
    const Curve open = shape(text, {});
    CHECK_FALSE(open.closed);
    AirfoilShape how;
    how.close_trailing_edge = true;
    const Curve closed = shape(text, how);
    CHECK(closed.closed);
    CHECK(evaluate(closed, closed.begin) == Vec3{1, 0, 0});
    CHECK(evaluate(closed, closed.end) == Vec3{1, 0, 0});
    // y is lowered by x times half the base; the point of the file nearest to the middle shows it.
    const std::vector<Vec3> points = points_of(text);
    for (const std::size_t k : {std::size_t{3}, std::size_t{15}, std::size_t{25}}) {
        const Vec3 p = points[k];
        CHECK(project(closed, {p.x, p.y - 0.00126 * p.x, 0}).distance < 1e-15);
    }
    how.side = AirfoilSide::upper;
    const Curve upper = shape(text, how);
    CHECK(evaluate(upper, upper.begin) == Vec3{0, 0, 0});
    CHECK(evaluate(upper, upper.end) == Vec3{1, 0, 0});
}

TEST_CASE("a chord moves the leading edge to the origin and scales") {
    std::vector<Vec3> points = points_of(file_text("rae2822.dat"));
    for (Vec3& p : points) p = 254.0 * p + Vec3{30, 10, 0};
    AirfoilShape how;
    how.chord = 2.0;
    how.side = AirfoilSide::lower;
    const Curve scaled = airfoil(points, how).curve.value();
    CHECK(norm(evaluate(scaled, scaled.begin)) < 1e-15);
    CHECK(distance(evaluate(scaled, scaled.end), {2, 0, 0}) < 1e-15);
    const Curve plain = shape(file_text("rae2822.dat"), side(AirfoilSide::lower));
    const Vec3 p = evaluate(plain, lerp({plain.begin, 0, 0}, {plain.end, 0, 0}, 0.3).x);
    CHECK(project(scaled, 2 * p).distance < 1e-14);
}

TEST_CASE("the leading edge is the spline's where no point is extreme") {
    // An ellipse of chord 1 with points on either side of its nose, none at it.
    std::vector<Vec3> points;
    const int count = 81;
    for (int k = 0; k <= count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.push_back({0.5 + 0.5 * std::cos(angle), 0.1 * std::sin(angle), 0});
    }
    points.back() = points.front();
    const Curve upper = airfoil(points, side(AirfoilSide::upper)).curve.value();
    const Vec3 nose = evaluate(upper, upper.begin);
    CHECK(nose.x == Approx(0).margin(1e-4));
    CHECK(nose.y == Approx(0).margin(1e-9));
    const Vec3 tangent = evaluate_derivative(upper, upper.begin);
    CHECK(std::abs(tangent.x) < 1e-9 * norm(tangent));
}

TEST_CASE("files that hold no airfoil are refused with the line") {
    CHECK(fault("") == "0: no line of two numbers: not an airfoil's coordinates");
    CHECK(fault("title\nanother\n") == "0: no line of two numbers: not an airfoil's coordinates");
    CHECK(fault("title\n1 0\n0.5 0.1\nlower side\n0 0\n") ==
          "4: text among the coordinates: 'lower'");
    CHECK(fault("title\n1 0\n0.5 0.1\n0.O 0\n") == "4: not a number: '0.O'");
    CHECK(fault("1.0 O.0\n0.5 0.1\n") == "1: not a number: 'O.0'");
    CHECK(fault("1 0\n0.5\n0 0\n") == "2: expected two numbers, x and y, found 1 number");
    CHECK(fault("1.0\n0.5\n0.1\n") == "1: expected two numbers, x and y, found 1 number");
    CHECK(fault("1 0\n0,5 0,1\n") == "2: expected two numbers, x and y, found 4 numbers");
    CHECK(fault("t\n1 0\n0.5 nan\n") == "3: not a finite number: 'nan'");
    CHECK(fault("t\n1 0\n0.5 1e999\n") == "3: not a finite number: '1e999'");
    CHECK(fault("1 0\n0 0.1\n1 0\n") == "0: only 3 points; an airfoil needs at least 5");
    CHECK(fault("1 0\n0.5 0.1\n0 0\n0 0\n0.5 -0.1\n1 0\n") == "4: the same point as on line 3");
    CHECK(fault("1 0\n0.5 0\n0 0\n0.4 0\n1 0\n") ==
          "0: the points enclose no area: not an airfoil");
    CHECK(fault("two\n" + diamond + "999 999\n" + diamond) ==
          "7: a separator (999 999): the file holds several sections, one is needed");
    CHECK(fault("t\n4. 4.\n\n0 0\n0.5 0.1\n1 0\n0 0\n0.5 -0.1\n1 0\n") ==
          "2: the counts of the two blocks do not add up to the 6 points that follow");
    CHECK(fault("0 0\n0.2 0.1\n0.5 0.1\n0.8 0.05\n1 0\n") ==
          "1: the points start at the leading edge and do not come back to it: one side of an "
          "airfoil only, or an order that is neither Selig's nor Lednicer's");
}

TEST_CASE("halves that cannot be mirrored are refused") {
    const AirfoilContent half = AirfoilContent::symmetric_half;
    CHECK(fault("0 0.01\n0.5 0.1\n1 0\n", half) ==
          "1: the leading edge of a symmetric half must lie at y = 0");
    CHECK(fault("t\n" + diamond, half) == "2: a whole section where a symmetric half is expected");
    CHECK(fault("0 0\n1 0\n", half) == "0: only 2 points; an airfoil needs at least 3");
}

TEST_CASE("points that make no section are refused") {
    CHECK(airfoil({{1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {}).error ==
          "an airfoil needs at least 5 points, not 3");
    AirfoilShape how;
    how.chord = 1.0;
    CHECK(airfoil({{0, 0, 0}, {0.5, -0.1, 0}, {1, 0, 0}, {0.5, 0.1, 0}, {0, 0, 0}}, how).error ==
          "the trailing edge does not lie behind the leading edge along x");
}
