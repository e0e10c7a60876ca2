// SPDX-License-Identifier: Apache-2.0
#include "faces/held_side.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/every_nth.h"
#include "elliptic/fold_count.h"
#include "faces/face_grid.h"
#include "faces/hand_built.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

/// Cells that grow by 1.2, forty of them over the unit length.
double layered(double t) {
    return (std::pow(1.2, 40 * t) - 1) / (std::pow(1.2, 40) - 1);
}
const double first = layered(1.0 / 40);

/// A unit square, or box of `layers` > 1 planes, whose lines along j begin with cells of
/// `first` times height_of(x, z) and end at 1; each cell divided into `refinement` along i and j.
template <class HeightOf>
PointField square(int layers, HeightOf&& height_of, int refinement = 1) {
    PointField points(Extent{32 * refinement + 1, 40 * refinement + 1, layers});
    for (int k = 0; k < layers; ++k) {
        for (int j = 0; j <= 40 * refinement; ++j) {
            for (int i = 0; i <= 32 * refinement; ++i) {
                const double x = i / (32.0 * refinement);
                const double y = layered(j / (40.0 * refinement));
                const double near = std::exp(-y / 0.05);
                const double z = layers == 1 ? 0.0 : k / (layers - 1.0);
                points.set(i, j, k, {x, y * (1 + (height_of(x, z) - 1) * near), z});
            }
        }
    }
    return points;
}

bool same_boundary(const PointField& a, const PointField& b) {
    const Extent e = a.extent();
    bool same = true;
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const bool at_boundary = i == 0 || i == e.ni - 1 || j == 0 || j == e.nj - 1 ||
                                         (e.nk > 1 && (k == 0 || k == e.nk - 1));
                if (at_boundary) same = same && a(i, j, k) == b(i, j, k);
            }
        }
    }
    return same;
}

double bump(double x, double /*z*/) {
    return 1 + 1.5 * std::sin(std::numbers::pi * x);
}

double bump_in_space(double x, double z) {
    return 1 + 1.5 * std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * z);
}

}  // namespace

TEST_CASE("heights between two edges become those of the edges, and boundaries stay") {
    const PointField drifted = square(1, bump);
    PointField points = drifted;
    HeldHeights request;
    request.fade = 0.2;
    request.growth = 1.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(held.fade == Approx(0.2));
    CHECK(held.stopped.growth + held.stopped.fade + held.stopped.folds == 0);
    const double edge = distance(drifted(0, 1), drifted(0, 0));
    CHECK(height_ratios(drifted, held).back().value == Approx(2.5).epsilon(0.01));
    for (const HeightRatio& ratio : height_ratios(points, held))
        CHECK(ratio.value == Approx(1).epsilon(1e-9));
    CHECK(held.asked(16, 0) == Approx(edge).epsilon(1e-12));
    CHECK(same_boundary(points, drifted));
    CHECK(count_folded(points) == 0);
    for (int i = 0; i <= 32; ++i) {
        for (int j = 0; j <= 40; ++j) {
            CHECK(points(i, j).x == Approx(drifted(i, j).x).margin(1e-15));
            if (drifted(i, j).y >= 0.2) CHECK(points(i, j) == drifted(i, j));
            if (j > 0) CHECK(points(i, j).y > points(i, j - 1).y);
        }
    }
}

TEST_CASE("the height between unequal edges goes from one to the other by equal factors") {
    PointField points = square(1, [](double x, double) {
        return x == 0 ? 0.5 : x == 1 ? 2.0 : 1.0;
    });
    HeldHeights request;
    request.fade = 0.3;
    request.growth = 1.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    const double low = distance(points(0, 1), points(0, 0));
    const double high = distance(points(32, 1), points(32, 0));
    for (int i = 0; i <= 32; ++i) {
        const double asked = low * std::pow(high / low, i / 32.0);
        CHECK(distance(points(i, 1), points(i, 0)) == Approx(asked).epsilon(1e-9));
    }
}

TEST_CASE("a given height is held, and from the fixed edges it is come to within the fade") {
    const PointField drifted = square(1, bump);
    PointField points = drifted;
    HeldHeights request;
    request.height = 2 * first;
    request.fade = 0.25;
    request.growth = 1.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(same_boundary(points, drifted));
    double before = distance(points(0, 1), points(0, 0));
    for (int i = 1; i <= 24; ++i) {
        const double height = distance(points(i, 1), points(i, 0));
        if (i >= 8) CHECK(height == Approx(2 * first).epsilon(1e-9));
        CHECK(height > before * (1 - 1e-9));
        CHECK(height < 1.5 * before);
        before = height;
    }
    CHECK(height_ratios(points, held).front().value == Approx(0.5).epsilon(0.01));
}

TEST_CASE("a corner's heights are held at the wall and leave no dent in the lines far from it") {
    // Natural heights with a cusp at the middle of the wall, gone at a distance of its width.
    constexpr int last = 200;
    PointField points(Extent{last + 1, 41, 1});
    for (int j = 0; j <= 40; ++j) {
        for (int i = 0; i <= last; ++i) {
            const double x = static_cast<double>(i) / last;
            const double y = layered(j / 40.0);
            const double off_corner = std::hypot(x - 0.5, y + 1e-4) / 0.02;
            points.set(i, j, 0, {x, y * std::exp(-1.5 * std::exp(-off_corner)), 0});
        }
    }
    const PointField natural = points;
    HeldHeights request;
    request.height = first;
    request.fade = 0.4;
    request.growth = 1.6;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(height_ratios(natural, held).front().value < 0.25);
    for (const HeightRatio& ratio : height_ratios(points, held))
        CHECK(ratio.value == Approx(1).epsilon(1e-6));
    CHECK(count_folded(points) == 0);
    const auto dent = [](const PointField& grid, int j) {
        double greatest = 0;
        for (int i = 1; i < last; ++i) {
            const double bend = grid(i - 1, j).y - 2 * grid(i, j).y + grid(i + 1, j).y;
            greatest = std::max(greatest, std::abs(bend) / grid(i, j).y);
        }
        return greatest;
    };
    CHECK(dent(natural, 1) > 0.05);
    CHECK(dent(points, 1) < 1e-6);
    for (int j = 2; j <= 40; ++j) {
        INFO("j = " << j << " at " << natural(0, j).y);
        if (natural(0, j).y > 0.014) CHECK(dent(points, j) < dent(natural, j) + 0.015);
        CHECK(dent(points, j) < 0.13);
    }
}

TEST_CASE("every side of a face can be held, in both its senses") {
    const PointField drifted = square(1, bump);
    const auto turned = [&](Side side, const PointField& from, bool back) {
        const bool swapped = !back && axis_of(side) == 0;
        PointField to(swapped ? Extent{41, 33, 1} : Extent{33, 41, 1});
        for (int j = 0; j <= 40; ++j) {
            for (int i = 0; i <= 32; ++i) {
                const int n = is_max(side) ? 40 - j : j;
                const Node there = axis_of(side) == 0 ? Node{n, i, 0} : Node{i, n, 0};
                if (back) {
                    to.set(i, j, 0, from(there[0], there[1]));
                } else {
                    to.set(there[0], there[1], 0, from(i, j));
                }
            }
        }
        return to;
    };
    PointField expected = drifted;
    hold_heights(expected, Side::jmin, {});
    for (const Side side : {Side::imin, Side::imax, Side::jmin, Side::jmax}) {
        PointField points = turned(side, drifted, false);
        hold_heights(points, side, {});
        CHECK(greatest_distance(turned(side, points, true), expected) == 0);
    }
}

TEST_CASE("what cannot be held without a fold is left, and shows in the ratios") {
    // The lines cross the wall aslant by up to 80 degrees, each way: far higher cells would cross.
    PointField points(Extent{9, 21, 1});
    for (int j = 0; j <= 20; ++j) {
        for (int i = 0; i <= 8; ++i) {
            const double y = std::pow(j / 20.0, 2);
            const double lean = i == 4 ? 0.0 : 3 * std::sin(std::numbers::pi * i / 4) * y * (1 - y);
            points.set(i, j, 0, {i / 8.0 + 0.1 * lean, y, 0});
        }
    }
    REQUIRE(count_folded(points) == 0);
    const PointField before = points;
    HeldHeights request;
    request.height = 0.1;
    request.growth = 50;
    request.fade = 0.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(count_folded(points) == 0);
    CHECK(same_boundary(points, before));
    CHECK(height_ratios(points, held).front().value < 0.1);
}

TEST_CASE("growth is bounded by what is asked, or was there") {
    PointField points = square(1, [](double, double) { return 1.0; });
    const auto line_growth = [&] {
        double greatest = 1;
        for (int j = 1; j < 40; ++j) {
            const double ratio = distance(points(16, j + 1), points(16, j)) /
                                 distance(points(16, j), points(16, j - 1));
            greatest = std::max({greatest, ratio, 1 / ratio});
        }
        return greatest;
    };
    HeldHeights request;
    request.height = first / 1000;
    request.growth = 2.5;
    REQUIRE(line_growth() < 2.5);
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(line_growth() <= 2.5 * (1 + 1e-9));
    CHECK(height_ratios(points, held).front().value > 1.5);
    CHECK(held.stopped.growth == 31);
    request.height = 0.01;
    request.fade = first / 2;
    PointField coarse = square(1, [](double, double) { return 1.0; });
    CHECK(hold_heights(coarse, Side::jmin, request).stopped.fade == 31);
}

TEST_CASE("a block's heights are held between its sides, which stay") {
    const PointField drifted = square(9, bump_in_space);
    PointField points = drifted;
    HeldHeights request;
    request.fade = 0.2;
    request.growth = 1.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(same_boundary(points, drifted));
    CHECK(height_ratios(drifted, held).back().value == Approx(2.5).epsilon(0.01));
    for (const HeightRatio& ratio : height_ratios(points, held))
        CHECK(ratio.value == Approx(1).epsilon(1e-9));
    CHECK(count_folded(points) == 0);
}

TEST_CASE(
    "beside a side that is not held a block's heights are that side's, and fade to the asked") {
    // Heights of the planes z = 0 and z = 1 have drifted; those of the others are as asked.
    const PointField drifted =
        square(9, [](double x, double z) { return z == 0 || z == 1 ? bump(x, 0) : 1.0; });
    PointField points = drifted;
    HeldHeights request;
    request.fade = 0.4;
    request.growth = 1.5;
    const HeldSide held = hold_heights(points, Side::jmin, request);
    CHECK(same_boundary(points, drifted));
    const auto ratio = [&](int k) {
        return distance(points(16, 1, k), points(16, 0, k)) / held.asked(16, k);
    };
    CHECK(ratio(0) == Approx(2.5).epsilon(0.01));
    for (int k = 1; k <= 4; ++k) CHECK(ratio(k) < ratio(k - 1));
    CHECK(ratio(1) > 2);
    CHECK(ratio(4) == Approx(1).epsilon(1e-9));
}

TEST_CASE("faces with heights held share the points of their edges to the bit") {
    HandBuilt built;
    built.method = Method::elliptic;
    const int a = built.vertex({-1, 0, 0}), b = built.vertex({0, 0.3, 0}),
              c = built.vertex({1, 0, 0});
    const int d = built.vertex({-1, 1, 0}), e = built.vertex({0, 1, 0}),
              f = built.vertex({1, 1, 0});
    built.law = layered;
    for (const auto& [low, high] : {std::pair{a, d}, {b, e}, {c, f}}) built.between(low, high, 40);
    built.law = identity_law;
    built.quadrilateral({a, b, e, d}, 16, 40);
    built.quadrilateral({b, c, f, e}, 16, 40);
    const auto plain = make_faces(built.topology, built.edges);
    for (Face& face : built.topology.faces) face.solve.heights[2] = HeldHeights{};
    const auto faces = make_faces(built.topology, built.edges);
    for (std::size_t n = 0; n < 2; ++n) {
        REQUIRE(faces[n].heights.size() == 1);
        CHECK(same_boundary(faces[n].points, plain[n].points));
        CHECK(height_ratios(plain[n].points, faces[n].heights[0]).back().value > 1.03);
        for (const HeightRatio& ratio : height_ratios(faces[n].points, faces[n].heights[0])) {
            CHECK(ratio.value == Approx(1).epsilon(1e-4));
        }
    }
}

TEST_CASE("a height held in a finer grid is that of the coarser one in it") {
    HeldHeights request;
    request.fade = 0.2;
    request.growth = 1.5;
    for (const std::optional<double> height :
         {std::optional<double>{}, std::optional<double>{1.1 * first}}) {
        request.height = height;
        request.first = 1;
        request.growth = 1.5;
        PointField plain = square(1, bump);
        hold_heights(plain, Side::jmin, request);
        request.first = 4;
        request.growth = std::pow(1.5, 0.25);
        PointField fine = square(1, bump, 4);
        const HeldSide held = hold_heights(fine, Side::jmin, request);
        const HeldSide coarse = every_nth(fine, held, 4);
        const PointField in_fine = every_nth(fine, 4);
        REQUIRE(coarse.asked.extent() == Extent{33, 1, 1});
        CHECK(coarse.asked(16, 0) == Approx(height ? *height : first).epsilon(1e-9));
        const double at_middle = distance(in_fine(16, 1), in_fine(16, 0));
        CHECK(at_middle == Approx(coarse.asked(16, 0)).epsilon(1e-9));
        CHECK(height_ratios(in_fine, coarse)[16].value == Approx(1).epsilon(1e-9));
        for (int j = 0; j <= 40; ++j) CHECK(distance(in_fine(16, j), plain(16, j)) < 2e-4);
        // One cell of the fine grid: what the law of its edges has there, of the given height.
        const HeldSide finest = every_nth(fine, held, 1);
        const double share = layered(1.0 / 160) / first;
        CHECK(finest.asked(64, 0) == Approx(share * (height ? *height : first)).epsilon(1e-9));
        CHECK(height_ratios(fine, finest)[64].value == Approx(1).epsilon(0.02));
    }
}
