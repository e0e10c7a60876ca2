// SPDX-License-Identifier: Apache-2.0
#include "geometry/stretching.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "geometry/wall_scaling.h"

using namespace hexweave;

namespace {

double first_of(const std::vector<double>& f) {
    return f[1];
}
double last_of(const std::vector<double>& f) {
    return 1 - f[f.size() - 2];
}

/// Is the cell as asked, as far as a fraction next to 1 can tell?
bool meets(double got, double asked) {
    return std::abs(got - asked) <= 1e-12 * asked + 2.5e-16;
}

double log_uniform(std::mt19937& random, double least, double most) {
    std::uniform_real_distribution<double> exponent(std::log(least), std::log(most));
    return std::exp(exponent(random));
}

void check_ends(const std::vector<double>& f, int cells) {
    REQUIRE(f.size() == static_cast<std::size_t>(cells) + 1);
    REQUIRE(f.front() == 0);
    REQUIRE(f.back() == 1);
    REQUIRE(smallest_cell(f) > 0);
}

}  // namespace

TEST_CASE("tanh meets both cells over many decades, and increases") {
    std::mt19937 random(1);
    for (int trial = 0; trial < 3000; ++trial) {
        const int cells = static_cast<int>(log_uniform(random, 3, 2000));
        const double first = log_uniform(random, 1e-13, 1);
        const double last = log_uniform(random, 1e-13, 1);
        if (first + last > 0.999) continue;  // too little left for the cells between
        CAPTURE(cells, first, last);
        const std::vector<double> f = tanh_fractions(cells, first, last);
        check_ends(f, cells);
        CHECK(first_of(f) == Approx(first).epsilon(2e-12));
        CHECK(meets(last_of(f), last));
    }
}

TEST_CASE("one-sided tanh and geometric growth meet the cell that is asked") {
    std::mt19937 random(2);
    for (int trial = 0; trial < 2000; ++trial) {
        const int cells = static_cast<int>(log_uniform(random, 2, 2000));
        const double size = log_uniform(random, 1e-13, 0.9);
        CAPTURE(cells, size);
        const std::vector<double> start = tanh_fractions(cells, size, std::nullopt);
        check_ends(start, cells);
        CHECK(first_of(start) == Approx(size).epsilon(2e-12));
        const std::vector<double> end = tanh_fractions(cells, std::nullopt, size);
        check_ends(end, cells);
        CHECK(meets(last_of(end), size));
        if (size > 3.0 / cells) continue;  // the other end would shrink below rounding
        CHECK(first_of(geometric_fractions(cells, size, std::nullopt)) ==
              Approx(size).epsilon(2e-12));
        CHECK(meets(last_of(geometric_fractions(cells, std::nullopt, size)), size));
    }
}

TEST_CASE("geometric growth from both ends meets both and changes by one ratio") {
    std::mt19937 random(3);
    for (int trial = 0; trial < 1000; ++trial) {
        const int cells = static_cast<int>(log_uniform(random, 3, 300));
        const double first = log_uniform(random, 1e-9, 0.3);
        const double last = log_uniform(random, 1e-9, 0.3);
        CAPTURE(cells, first, last);
        const std::vector<double> f = geometric_fractions(cells, first, last);
        if (smallest_cell(f) < 1e-12) continue;  // shrinks out of sight: the fit refuses it
        check_ends(f, cells);
        CHECK(first_of(f) == Approx(first).epsilon(1e-12));
        CHECK(meets(last_of(f), last));
    }
    const std::vector<double> f = geometric_fractions(41, 1e-4, 3e-5);
    const double ratio = (f[2] - f[1]) / f[1];
    CHECK(ratio > 1);
    double most = 0;
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
        const double change = std::abs(std::log((f[i + 1] - f[i]) / (f[i] - f[i - 1])));
        most = std::max(most, change);
    }
    CHECK(most == Approx(std::log(ratio)).epsilon(1e-8));
}

TEST_CASE("equal sizes give a symmetric law, and the plain size a uniform one") {
    for (const double size : {1e-6, 0.05, 0.3}) {
        const std::vector<double> f = tanh_fractions(11, size, size);
        for (std::size_t i = 0; i < f.size(); ++i) {
            CHECK(f[i] + f[f.size() - 1 - i] == Approx(1).epsilon(1e-14));
        }
    }
    for (const int cells : {2, 3, 7, 64}) {
        const double size = 1.0 / cells;
        const std::vector<double> uniform = uniform_fractions(cells);
        const std::optional<double> none;
        for (const auto& f :
             {tanh_fractions(cells, size, size), tanh_fractions(cells, size, none),
              tanh_fractions(cells, none, size), geometric_fractions(cells, size, none),
              geometric_fractions(cells, none, size), geometric_fractions(cells, size, size),
              ratio_fractions(cells, 1.0), tanh_fractions(cells, none, none)}) {
            for (std::size_t i = 0; i < f.size(); ++i) {
                CHECK(f[i] == Approx(uniform[i]).margin(1e-14));
            }
        }
    }
}

TEST_CASE("laws seen from the other end are their own reversal") {
    const std::optional<double> none;
    const auto check_same = [](const std::vector<double>& a, const std::vector<double>& b) {
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).margin(1e-14));
    };
    check_same(tanh_fractions(40, 1e-3, 0.2), reversed_fractions(tanh_fractions(40, 0.2, 1e-3)));
    check_same(tanh_fractions(40, none, 1e-3), reversed_fractions(tanh_fractions(40, 1e-3, none)));
    check_same(geometric_fractions(40, 1e-3, 0.02),
               reversed_fractions(geometric_fractions(40, 0.02, 1e-3)));
    check_same(ratio_fractions(40, 1.1), reversed_fractions(ratio_fractions(40, 1 / 1.1)));
}

TEST_CASE("tanh is Vinokur's function of the slopes it has") {
    // The two-sided function of index is s = u / (A + (1 - A) u), u = 1/2 + tanh(D (x - 1/2)) /
    // (2 tanh(D / 2)): so u, recovered with A from the law, must be symmetric, and
    // atanh((2 u - 1) tanh(D / 2)) linear in x.
    const int cells = 32;
    const double first = 1e-4;
    const double last = 1e-2;
    const std::vector<double> f = tanh_fractions(cells, first, last);
    const double a = std::sqrt(last / (1 - last) / (first / (1 - first)));
    const auto u = [&](std::size_t i) { return a * f[i] / (1 - f[i] + a * f[i]); };
    for (std::size_t i = 0; i < f.size(); ++i) {
        CHECK(u(i) + u(f.size() - 1 - i) == Approx(1).epsilon(1e-12));
    }
    // D from the middle: tanh(D / n) / tanh(D / 2) = 2 u(n/2 + 1) - 1; then all others follow.
    double low = 0.01;
    double high = 100;
    for (int step = 0; step < 200; ++step) {
        const double d = 0.5 * (low + high);
        const bool too_small = std::tanh(d / cells) / std::tanh(d / 2) < 2 * u(17) - 1;
        (too_small ? low : high) = d;
    }
    for (std::size_t i = 0; i < f.size(); ++i) {
        const double x = static_cast<double>(i) / cells;
        CHECK(u(i) ==
              Approx(0.5 + std::tanh(low * (x - 0.5)) / (2 * std::tanh(low / 2))).margin(1e-12));
    }
}

TEST_CASE("a ratio is the ratio of neighbouring cells") {
    const std::vector<double> f = ratio_fractions(20, 1.25);
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
        CHECK((f[i + 1] - f[i]) / (f[i] - f[i - 1]) == Approx(1.25).epsilon(1e-12));
    }
    // 1 + 2 + 4 + 8 = 15
    CHECK(ratio_fractions(4, 2.0)[2] == Approx(3.0 / 15).epsilon(1e-15));
    CHECK(geometric_fractions(4, 1.0 / 15, std::nullopt)[3] == Approx(7.0 / 15).epsilon(1e-14));
    CHECK(geometric_fractions(4, std::nullopt, 8.0 / 15)[1] == Approx(1.0 / 15).epsilon(1e-14));
}

TEST_CASE("two cells split where the sizes say") {
    CHECK(tanh_fractions(2, 0.3, std::nullopt)[1] == Approx(0.3).epsilon(1e-15));
    CHECK(tanh_fractions(2, std::nullopt, 0.3)[1] == Approx(0.7).epsilon(1e-15));
    CHECK(tanh_fractions(2, 0.25, 0.75)[1] == Approx(0.25).epsilon(1e-15));
    CHECK(geometric_fractions(2, 0.3, std::nullopt)[1] == Approx(0.3).epsilon(1e-14));
    CHECK(tanh_fractions(1, 1.0, std::nullopt) == std::vector<double>{0, 1});
}

TEST_CASE(
    "a refined law passes through the points of the plain one, to the bit, and grows between") {
    const std::optional<double> none;
    using Law = std::function<std::vector<double>(int refinement)>;
    const std::vector<Law> laws{
        [](int r) { return uniform_fractions(12, r); },
        [](int r) { return tanh_fractions(12, 1e-4, 0.02, r); },
        [](int r) { return tanh_fractions(12, 0.2, 0.3, r); },
        [&](int r) { return tanh_fractions(12, 1e-5, none, r); },
        [&](int r) { return tanh_fractions(12, none, 1e-5, r); },
        [](int r) { return ratio_fractions(12, 1.3, r); },
        [&](int r) { return geometric_fractions(12, 1e-3, none, r); },
        [](int r) { return geometric_fractions(12, 1e-3, 1e-2, r); },
        [](int r) { return geometric_fractions(12, 0.3, 0.25, r); },
        [](int r) { return held_tanh_fractions(12, 2e-4, 1e-4, 0.1, false, r); },
        [](int r) { return held_tanh_fractions(12, 2e-4, 1e-4, 0.1, true, r); },
        [&](int r) { return tanh_fractions(1, none, none, r); },
    };
    for (std::size_t law = 0; law < laws.size(); ++law) {
        CAPTURE(law);
        const std::vector<double> plain = laws[law](1);
        const int cells = static_cast<int>(plain.size()) - 1;
        for (const int refinement : {2, 4, 8, 3}) {
            const std::vector<double> refined = laws[law](refinement);
            check_ends(refined, cells * refinement);
            for (std::size_t i = 0; i < plain.size(); ++i) {
                CHECK(refined[i * static_cast<std::size_t>(refinement)] == plain[i]);
            }
        }
        // Cells of the refined law grow by no more than those of the plain one, save where two
        // progressions meet.
        CHECK(greatest_growth(laws[law](4)) <= greatest_growth(plain) * 1.0000001);
    }
    const std::vector<double> two = tanh_fractions(2, 0.2, 0.8, 2);
    CHECK(two[2] == Approx(0.2).epsilon(1e-14));
    CHECK((two[2] - two[1]) / two[1] == Approx(2).epsilon(1e-12));  // 4 = 2 * 2
}
