// SPDX-License-Identifier: Apache-2.0
// How a level is stored, and which levels there are.
#include "elliptic/level.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "elliptic/coarsening.h"
#include "elliptic/levels.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

/// The plan for a box whose lines along each axis are at the given positions.
std::vector<std::array<bool, 3>> plan_of(const std::array<std::vector<double>, 3>& positions,
                                         const Vec3& size, int least_nodes) {
    const auto nodes = [&](std::size_t axis) { return static_cast<int>(positions[axis].size()); };
    const Extent e{nodes(0), nodes(1), nodes(2)};
    const auto map = [&](double u, double v, double w) {
        const auto on = [&](std::size_t axis, double f) {
            return positions[axis][static_cast<std::size_t>(
                std::lround(f * static_cast<double>(positions[axis].size() - 1)))];
        };
        return Vec3{on(0, u), on(1, v), nodes(2) > 1 ? on(2, w) : 0};
    };
    const auto scaled = [&](double u, double v, double w) {
        const Vec3 s = map(u, v, w);
        return Vec3{size.x * s.x, size.y * s.y, size.z * s.z};
    };
    return plan_coarsening(
        shapes::level_of(shapes::sample(e, scaled), shapes::sample_parameters(e, map), 3),
        least_nodes);
}

std::vector<double> uniform(int nodes) {
    std::vector<double> positions;
    for (int n = 0; n < nodes; ++n) positions.push_back(n / (nodes - 1.0));
    return positions;
}

using Axes = std::array<bool, 3>;

}  // namespace

TEST_CASE("every node of a row has one place, and its neighbours are where its segment says") {
    for (int ni = 2; ni <= 70; ++ni) {
        const RowShape shape(ni);
        std::set<std::ptrdiff_t> places;
        for (int i = 0; i < ni; ++i) {
            const std::ptrdiff_t place = shape.at(i);
            CHECK(place >= 0);
            CHECK(place < shape.length());
            places.insert(place);
            const RowSegment segment = shape.segments()[static_cast<std::size_t>(i % 2)];
            CHECK(place >= segment.first);
            CHECK(place < segment.first + segment.count);
            if (i > 0) CHECK(place + segment.previous == shape.at(i - 1));
            if (i + 1 < ni) CHECK(place + segment.next == shape.at(i + 1));
        }
        CHECK(places.size() == static_cast<std::size_t>(ni));
        CHECK(shape.segments()[0].count + shape.segments()[1].count == shape.length());
        CHECK(shape.segments()[0].count % 8 == 0);
        CHECK(shape.segments()[1].count % 8 == 0);
        CHECK(shape.length() < ni + 16);
    }
}

TEST_CASE("rows, layers and components do not overlap, and padding stays zero") {
    const Extent e{11, 4, 3};
    RowArray<float> rows(e, 2);
    const RowShape shape(e.ni);
    std::set<const float*> places;
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            CHECK(rows.row(j, k) == rows.row(0, 0) + j * rows.stride_j() + k * rows.stride_k());
            for (int c = 0; c < 2; ++c) {
                for (int i = 0; i < e.ni; ++i) {
                    float& value = rows.row(j, k)[c * shape.length() + shape.at(i)];
                    CHECK(value == 0);
                    value = 1;
                    places.insert(&value);
                }
            }
        }
    }
    CHECK(places.size() == 2 * e.nodes());
    float sum = 0;
    for (const float* p = rows.row(0, 0); p < rows.row(0, 0) + e.nk * rows.stride_k(); ++p) {
        sum += *p;
    }
    CHECK(sum == static_cast<float>(2 * e.nodes()));
    rows.clear();
    CHECK(rows.row(2, 1)[shape.at(10)] == 0);
}

TEST_CASE("a field comes back from its rows to the bit, its boundary untouched") {
    for (const Extent e : {Extent{9, 6, 1}, Extent{6, 5, 4}}) {
        Field field(e);
        for (std::size_t n = 0; n < e.nodes(); ++n) field[n] = std::sin(static_cast<double>(n));
        RowArray<double> rows(e, 3);
        store(field, 2, rows);
        Field back(e, -7);
        restore_interior(rows, 2, back);
        for (int k = 0; k < e.nk; ++k) {
            for (int j = 0; j < e.nj; ++j) {
                for (int i = 0; i < e.ni; ++i) {
                    const bool inside = i > 0 && i < e.ni - 1 && j > 0 && j < e.nj - 1 &&
                                        (e.nk == 1 || (k > 0 && k < e.nk - 1));
                    CHECK(back(i, j, k) == (inside ? field(i, j, k) : -7));
                }
            }
        }
    }
}

TEST_CASE("a coarser level has every second node and always the last") {
    for (int count = 3; count <= 50; ++count) {
        const int coarse = halved_count(count);
        CHECK(finer_index(0, count, true) == 0);
        CHECK(finer_index(coarse - 1, count, true) == count - 1);
        for (int n = 1; n < coarse; ++n) {
            const int step = finer_index(n, count, true) - finer_index(n - 1, count, true);
            CHECK(step == (n == coarse - 1 && count % 2 == 0 ? 1 : 2));
        }
        CHECK(finer_index(count - 1, count, false) == count - 1);
    }
    const Extent e{8, 5, 6};
    const PointField points = shapes::sample(e, shapes::leaning);
    const Level fine = shapes::level_of(points, shapes::sample_parameters(e, shapes::leaning), 3);
    Level coarse = coarser_level(fine, {true, false, true});
    inject_points(fine, coarse);
    CHECK(coarse.extent == Extent{5, 5, 4});
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 5; ++i) {
                const Vec3 x = points(finer_index(i, 8, true), j, finer_index(k, 6, true));
                for (auto* rows : {&coarse.points, &coarse.parameters}) {
                    CHECK(shapes::at(*rows, coarse, i, j, k, 0) == x.x);
                    CHECK(shapes::at(*rows, coarse, i, j, k, 1) == x.y);
                    CHECK(shapes::at(*rows, coarse, i, j, k, 2) == x.z);
                }
            }
        }
    }
}

TEST_CASE("faces are coarsened along all axes that have nodes to spare") {
    const auto plan = plan_of({uniform(33), shapes::geometric(17, 1e-6), {0}}, {4, 1, 0}, 9);
    REQUIRE(plan.size() == 2);
    CHECK(plan[0] == Axes{true, true, false});
    CHECK(plan[1] == Axes{true, false, false});
}

TEST_CASE("a stretched axis of a block is never coarsened, whichever it is") {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<std::vector<double>, 3> positions{uniform(33), uniform(33), uniform(33)};
        positions[axis] = shapes::geometric(32, 1e-5);
        const auto plan = plan_of(positions, {1, 1, 1}, 9);
        REQUIRE(plan.size() == 2);
        for (const Axes& step : plan) {
            for (std::size_t n = 0; n < 3; ++n) CHECK(step[n] == (n != axis));
        }
    }
    for (const Axes& step : plan_of({uniform(33), uniform(33), uniform(33)}, {1, 1, 1}, 9)) {
        CHECK(step == Axes{true, true, true});
    }
}

TEST_CASE("of a block's axes the one with the shortest cells is coarsened first") {
    const auto plan = plan_of({uniform(33), uniform(33), uniform(33)}, {4, 1, 2}, 9);
    REQUIRE(plan.size() == 4);
    CHECK(plan[0] == Axes{false, true, false});
    CHECK(plan[1] == Axes{false, true, true});
    CHECK(plan[2] == Axes{true, false, true});  // along j only 9 nodes are left
    CHECK(plan[3] == Axes{true, false, false});
}

TEST_CASE("no axis is left with fewer nodes than asked, whatever the counts") {
    for (const int ni : {2, 3, 4, 9, 16, 17, 18, 47}) {
        for (const int nj : {2, 5, 17, 100}) {
            for (const int nk : {1, 2, 3, 31}) {
                const std::vector<double> along_k = nk == 1 ? std::vector<double>{0} : uniform(nk);
                std::array<int, 3> nodes{ni, nj, nk};
                const std::array<int, 3> first = nodes;
                for (const Axes& step :
                     plan_of({uniform(ni), uniform(nj), along_k}, {3, 1, 2}, 9)) {
                    CHECK(step != Axes{});
                    for (std::size_t a = 0; a < 3; ++a) {
                        if (step[a]) nodes[a] = halved_count(nodes[a]);
                    }
                }
                for (std::size_t a = 0; a < 3; ++a) {
                    const int least = nk == 1 ? 5 : 9;  // even faces may be very coarse
                    if (a == 2 && nk == 1) continue;
                    CHECK(nodes[a] >= std::min(least, first[a]));
                    CHECK((halved_count(nodes[a]) < least || nodes[a] < 3));
                }
            }
        }
    }
}

}  // namespace hexweave
