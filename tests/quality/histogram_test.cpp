// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "quality/histogram.h"

using hexweave::Histogram;

TEST_CASE("values lie from one limit to below the next") {
    Histogram h("h", {1, 2});
    for (const double value : {0.5, 1.0, 1.5, 2.0, 7.0}) h.include(value);
    CHECK(h.counts == std::vector<std::size_t>{1, 2, 2});
    CHECK(h.total() == 5);
}

TEST_CASE("what is no number counts as bad") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Histogram small_is_bad("h", {0, 1}, true);
    small_is_bad.include(nan);
    CHECK(small_is_bad.counts == std::vector<std::size_t>{1, 0, 0});
    Histogram great_is_bad("h", {0, 1});
    great_is_bad.include(nan);
    CHECK(great_is_bad.counts == std::vector<std::size_t>{0, 0, 1});
}

TEST_CASE("a quantile is right to the width of a bin") {
    std::vector<double> limits;
    for (int n = 1; n <= 900; ++n) limits.push_back(n / 10.0);
    Histogram h("h", limits);
    for (int n = 0; n < 1000; ++n) h.include(n * 0.08);  // even from 0 to 79.92
    for (const double part : {0.01, 0.5, 0.99, 1.0}) {
        CHECK(h.quantile(part) == Approx(80 * part).margin(0.1));
    }
    CHECK(Histogram("h", limits).quantile(0.99) == 0);
    Histogram beyond("h", {1, 2});
    beyond.include(50);
    CHECK(beyond.quantile(0.99) == 2);
}

TEST_CASE("counted between some of the limits nothing is lost") {
    Histogram fine("h", {1, 2, 3, 4, 5, 6});
    Histogram coarse("h", {2, 5});
    for (int n = 0; n < 30; ++n) {
        fine.include(0.25 * n);
        coarse.include(0.25 * n);
    }
    CHECK(fine.coarsened({2, 5}).counts == coarse.counts);
    CHECK(fine.coarsened({2, 5}).limits == coarse.limits);
}
