// SPDX-License-Identifier: Apache-2.0
#include "faces/edge_functions.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "faces/arc_length.h"
#include "faces/flat_corners.h"

using namespace hexweave;

TEST_CASE("an edge function without exponents is the arc length to the bit") {
    const std::vector<Vec3> line{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.3, 0}, {0.1, 0.3, 0.7}};
    CHECK(edge_function(line, {}) == normalized_arc_length(line));
}

TEST_CASE("an exponent at one end is a power of the distance from it") {
    for (const double f : {0.0, 0.01, 0.3, 0.9, 1.0}) {
        CHECK(edge_function(f, {1, 0.7}) == 1 - std::pow(1 - f, 0.7));
        CHECK(edge_function(f, {0.5, 1}) == std::sqrt(f));
    }
}

TEST_CASE("edge functions run from 0 to 1, rise, and are the same from both ends") {
    for (const EndExponents p : {EndExponents{0.7, 0.7}, EndExponents{0.5, 0.7},
                                 EndExponents{0.3, 0.3}, EndExponents{1, 0.5}}) {
        CHECK(edge_function(0.0, p) == 0);
        CHECK(edge_function(1.0, p) == 1);
        double before = 0;
        for (int n = 1; n <= 1000; ++n) {
            const double f = n / 1000.0;
            const double value = edge_function(f, p);
            CHECK(value > before);
            CHECK(value == Approx(1 - edge_function(1 - f, {p.end, p.start})).margin(1e-14));
            before = value;
        }
        // Like the power of the distance, up to a factor, at either end.
        const double ratio = edge_function(1e-8, p) / edge_function(1e-10, p);
        CHECK(ratio == Approx(std::pow(100, p.start)).epsilon(0.01));
    }
}

namespace {

/// The boundary of one cell round by round: a face of 2 x 2 nodes.
PointField quadrilateral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    PointField points(Extent{2, 2, 1});
    points.set(0, 0, 0, a);
    points.set(1, 0, 0, b);
    points.set(1, 1, 0, c);
    points.set(0, 1, 0, d);
    return points;
}

}  // namespace

TEST_CASE("corners wider than 150 degrees are flat") {
    using Flat = std::array<bool, 4>;
    CHECK(flat_corners(quadrilateral({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}), true) == Flat{});
    const Vec3 tip{0, 1, 0};
    const Vec3 low{0, 0.1, 0};  // 169 degrees, and 191 where it is below
    CHECK(flat_corners(quadrilateral({-1, 0, 0}, low * -1, {1, 0, 0}, tip), true) ==
          Flat{false, true, false, false});
    CHECK(flat_corners(quadrilateral(low, {1, 0, 0}, tip, {-1, 0, 0}), true) ==
          Flat{true, false, false, false});
    // 270 degrees: through a planar face; in space the normal is not known.
    const auto dart = quadrilateral({-1, -1, 0}, {0, 0, 0}, {1, -1, 0}, tip);
    CHECK(flat_corners(dart, true)[1]);
    CHECK_FALSE(flat_corners(dart, false)[1]);
    // Seen from the other side, a face in space is the same.
    CHECK(flat_corners(quadrilateral(low, {-1, 0, 0}, tip, {1, 0, 0}), false) ==
          Flat{true, false, false, false});
}

TEST_CASE("an exponent stands at both sides of its corner") {
    const EndExponents none{};
    const EndExponents at_start{0.7, 1};
    const EndExponents at_end{1, 0.7};
    using Sides = std::array<EndExponents, 4>;
    CHECK(corner_exponents({true, false, false, false}, 0.7) ==
          Sides{at_start, none, at_start, none});
    CHECK(corner_exponents({false, true, false, false}, 0.7) ==
          Sides{none, at_start, at_end, none});
    CHECK(corner_exponents({false, false, true, false}, 0.7) == Sides{none, at_end, none, at_end});
    CHECK(corner_exponents({false, false, false, true}, 0.7) ==
          Sides{at_end, none, none, at_start});
}
