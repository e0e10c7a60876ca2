// SPDX-License-Identifier: Apache-2.0
#include "edges/spacing.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "geometry/stretching.h"
#include "topology/spacing_fit.h"

using namespace hexweave;

namespace {

const std::optional<double> none;

ExplicitLaw at_values(std::vector<double> values) {
    ExplicitLaw law;
    law.values = std::move(values);
    return law;
}

ExplicitLaw by_formula(std::function<double(double)> formula) {
    ExplicitLaw law;
    law.formula = std::move(formula);
    return law;
}

}  // namespace

TEST_CASE("a cell held over a natural one is met, and the points beyond are those of the law") {
    const double length = 20;
    const double within = 0.03;
    for (const double natural : {1.2e-6, 1e-5, 2.3e-5}) {
        const TanhLaw law{1e-5, none, TanhLaw::Natural{natural, within}};
        const std::vector<double> held = law_fractions(law, 96, length);
        const std::vector<double> plain = law_fractions(TanhLaw{natural, none}, 96, length);
        CHECK(held[1] * length == Approx(1e-5).epsilon(1e-12));
        for (std::size_t n = 1; n < held.size(); ++n) {
            CHECK(held[n] > held[n - 1]);
            if (plain[n] * length >= within) CHECK(held[n] == plain[n]);
        }
        CHECK(spacing_misfit(law, 96, length).empty());

        const TanhLaw turned{none, 1e-5, TanhLaw::Natural{natural, within}};
        const std::vector<double> mirrored = reversed_fractions(law_fractions(turned, 96, length));
        for (std::size_t n = 0; n < held.size(); ++n) {
            CHECK(mirrored[n] == Approx(held[n]).margin(1e-15));
        }
    }
}

TEST_CASE("a cell that cannot be held over a natural one does not fit") {
    const auto misfit = [](double start, double natural, double within) {
        return spacing_misfit(TanhLaw{start, none, TanhLaw::Natural{natural, within}}, 40, 1);
    };
    CHECK(misfit(1e-4, 1e-5, 0.05).empty());
    CHECK(
        misfit(1e-4, 1e-5, 1e-5) ==
        "'within', 1e-05, must be more than both cells, 0.0001 and 1e-05, and at most the edge, 1");
    CHECK(misfit(1e-4, 1e-5, 1.1) ==
          "'within', 1.1, must be more than both cells, 0.0001 and 1e-05, and at most the edge, 1");
    CHECK(misfit(1e-4, 2, 0.05) == "the first cell, 2, is longer than the edge, 1");
    CHECK(misfit(0.04, 1e-6, 0.05) ==
          "a cell of 0.04 is too far from the natural one, 1e-06, to be had within 0.05");
}

TEST_CASE("sizes are arc lengths, not fractions") {
    const std::vector<double> f = law_fractions(TanhLaw{1e-3, 0.5}, 20, 4);
    CHECK(f[1] * 4 == Approx(1e-3).epsilon(1e-12));
    CHECK((1 - f[19]) * 4 == Approx(0.5).epsilon(1e-12));
    const std::vector<double> g = law_fractions(GeometricLaw{none, 0.01, none}, 20, 4);
    CHECK(g[1] * 4 == Approx(0.01).epsilon(1e-12));
}

TEST_CASE("explicit positions are taken as they are, the ends exactly") {
    CHECK(law_fractions(at_values({0, 0.2, 0.9, 1}), 3, 7) == std::vector<double>{0, 0.2, 0.9, 1});
    const std::vector<double> f =
        law_fractions(by_formula([](double t) { return t * t + 1e-13; }), 4, 7);
    CHECK(f.front() == 0);
    CHECK(f[1] == 0.0625 + 1e-13);
    CHECK(f.back() == 1);
}

TEST_CASE("what fits is not refused") {
    CHECK(spacing_misfit(UniformLaw{}, 1, 2).empty());
    CHECK(spacing_misfit(TanhLaw{2.0, none}, 1, 2).empty());
    CHECK(spacing_misfit(TanhLaw{0.5, 1.5}, 2, 2).empty());
    CHECK(spacing_misfit(TanhLaw{1e-12, 1.9}, 3, 2).empty());
    CHECK(spacing_misfit(TanhLaw{none, 1.9}, 50, 2).empty());
    CHECK(spacing_misfit(GeometricLaw{1.2, none, none}, 50, 2).empty());
    CHECK(spacing_misfit(GeometricLaw{none, 1e-5, 1e-3}, 64, 20).empty());
    CHECK(spacing_misfit(at_values({0, 0.25, 1}), 2, 2).empty());
    CHECK(spacing_misfit(by_formula([](double t) { return std::sin(t * std::acos(0.0)); }), 9, 2)
              .empty());
    CHECK(spacing_misfit(SameAs{3, true}, 9, 2).empty());
}

TEST_CASE("what cannot be met is refused with the reason") {
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    CHECK(spacing_misfit(TanhLaw{5.0, none}, 10, 2) ==
          "the first cell, 5, is longer than the edge, 2");
    CHECK(spacing_misfit(TanhLaw{none, 0.0}, 10, 2) == "the last cell, 0, must be greater than 0");
    CHECK(spacing_misfit(TanhLaw{not_a_number, none}, 10, 2) ==
          "the first cell, nan, must be greater than 0");
    CHECK(spacing_misfit(TanhLaw{2.0, none}, 10, 2) ==
          "the first cell, 2, leaves nothing of the edge to the other cells");
    CHECK(spacing_misfit(TanhLaw{1.5, 0.5}, 10, 2) ==
          "the first and last cells, 1.5 and 0.5, leave nothing of the edge, 2, to the cells "
          "between");
    CHECK(spacing_misfit(TanhLaw{0.5, 0.5}, 2, 2) ==
          "two cells make up the edge, 2; the first and last cells, 0.5 and 0.5, add up to 1");
    CHECK(spacing_misfit(TanhLaw{0.5, none}, 1, 2) ==
          "the only cell is as long as the edge, 2; the first cell cannot be 0.5");
    CHECK(spacing_misfit(TanhLaw{1e-15, none}, 10, 2) ==
          "the first cell, 1e-15, is less than 1e-14 of the edge, 2");
    CHECK(spacing_misfit(GeometricLaw{-1.0, none, none}, 10, 2) ==
          "the ratio, -1, must be greater than 0");
    CHECK(spacing_misfit(GeometricLaw{2.0, none, none}, 100, 2) ==
          "the smallest cell would be less than 1e-14 of the edge");
    CHECK(spacing_misfit(GeometricLaw{none, 1.8, none}, 100, 2) ==
          "the smallest cell would be less than 1e-14 of the edge");
    CHECK(spacing_misfit(GeometricLaw{1.1, 0.1, none}, 10, 2) ==
          "the ratio and a cell's size cannot both be met: with this many cells one gives the "
          "other");
    CHECK(spacing_misfit(at_values({0, 1}), 3, 2) == "3 cells need 4 values, not 2");
    CHECK(spacing_misfit(at_values({0.1, 0.5, 1}), 2, 2) == "the values must start at 0, not 0.1");
    CHECK(spacing_misfit(at_values({0, 0.5, 0.9}), 2, 2) == "the values must end at 1, not 0.9");
    CHECK(spacing_misfit(at_values({0, 0.5, 0.5, 1}), 3, 2) ==
          "the values must increase: point 1 is at 0.5, point 2 at 0.5");
    CHECK(spacing_misfit(by_formula([](double t) { return std::log(t); }), 2, 2) ==
          "the formula must start at 0, not -inf");
    CHECK(spacing_misfit(by_formula([](double t) { return t == 0 || t == 1 ? t : std::nan(""); }),
                         2, 2) == "the formula must increase: point 0 is at 0, point 1 at nan");
}

TEST_CASE("every law that is not refused is met") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> exponent(-15, 0.5);
    std::uniform_int_distribution<int> count(1, 40);
    int passed = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const int cells = count(random);
        const double length = 3;
        const double start = length * std::pow(10, exponent(random));
        const double end = length * std::pow(10, exponent(random));
        CAPTURE(cells, start, end);
        for (const SpacingLaw& law :
             {SpacingLaw{TanhLaw{start, end}}, SpacingLaw{GeometricLaw{none, start, end}},
              SpacingLaw{TanhLaw{start, none}}, SpacingLaw{GeometricLaw{none, start, none}}}) {
            if (!spacing_misfit(law, cells, length).empty()) continue;
            ++passed;
            const std::vector<double> f = law_fractions(law, cells, length);
            REQUIRE(smallest_cell(f) > 0);
            REQUIRE(f[1] * length == Approx(start).epsilon(1e-10));
            if (law.index() == 1 && !std::get<TanhLaw>(law).end) continue;
            if (law.index() == 2 && !std::get<GeometricLaw>(law).end) continue;
            REQUIRE(std::abs((1 - f[f.size() - 2]) * length - end) <= 1e-10 * end + 1e-15);
        }
    }
    CHECK(passed > 10000);
}

TEST_CASE("a refined formula is taken at the finer indices") {
    const SpacingLaw law = by_formula([](double t) { return t * t; });
    const std::vector<double> plain = law_fractions(law, 6, 7);
    const std::vector<double> refined = law_fractions(law, 6, 7, 4);
    REQUIRE(refined.size() == 25);
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK(refined[4 * i] == plain[i]);
    CHECK(refined[1] == Approx(1.0 / 576).epsilon(1e-15));
}

TEST_CASE("an asked cell is that of the plain law also where the law is refined") {
    for (const SpacingLaw& law : std::vector<SpacingLaw>{
             TanhLaw{1e-5, none}, TanhLaw{1e-5, none, TanhLaw::Natural{2.3e-5, 0.03}},
             GeometricLaw{none, 1e-5, none}}) {
        const std::vector<double> refined = law_fractions(law, 96, 20, 2);
        CHECK(refined[2] * 20 == Approx(1e-5).epsilon(1e-12));
        CHECK(refined[1] < 0.5 * refined[2]);
        CHECK(refined[1] > 0.4 * refined[2]);
    }
}
