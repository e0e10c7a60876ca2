// SPDX-License-Identifier: Apache-2.0
#include "faces/wall_heights.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace hexweave;

namespace {

/// Distances of a boundary layer: cells from `first` on, each `ratio` times the one before.
std::vector<double> layer(double first, double ratio, int cells) {
    std::vector<double> distances{0};
    for (int n = 0; n < cells; ++n) {
        distances.push_back(distances.back() + first * std::pow(ratio, n));
    }
    return distances;
}

/// The part of one factor for the whole line.
double part_of_factor(const std::vector<double>& distances, double factor, double fade,
                      double growth) {
    const std::vector<double> logarithms(distances.size(), std::log(factor));
    return feasible_part(distances, logarithms, fade, growth);
}

}  // namespace

TEST_CASE("a straight line gets the asked height, and keeps what is beyond the fade to the bit") {
    const Vec3 wall{0.3, -0.2, 0.7};
    const Vec3 along = Vec3{1, 2, -2} / 3;
    std::vector<Vec3> line;
    for (const double r : layer(1e-5, 1.2, 60)) line.push_back(wall + r * along);
    const std::vector<double> distances = distances_along(line);
    const double fade = 0.03;
    for (const double factor : {0.2, 0.9, 1.0, 1.1, 5.0}) {
        const auto scaled = scaled_distances(distances, std::log(factor), fade);
        CHECK(scaled[1] == Approx(factor * distances[1]).epsilon(1e-14));
        const auto moved = points_at(line, distances, scaled);
        CHECK(moved[0] == line[0]);
        // The line's own points stand on multiples of the spacing of numbers near one.
        CHECK(distance(wall, moved[1]) == Approx(factor * 1e-5).epsilon(1e-10));
        for (std::size_t n = 1; n < line.size(); ++n) {
            CHECK(scaled[n] > scaled[n - 1]);
            if (distances[n] >= fade) CHECK(scaled[n] == distances[n]);
            if (factor == 1) CHECK(scaled[n] == distances[n]);
            if (factor > 1 && distances[n] < fade) CHECK(scaled[n] > distances[n]);
            CHECK(norm(cross(moved[n] - wall, along)) < 1e-15);
        }
        CHECK(greatest_growth(scaled) < 1.37);
    }
}

TEST_CASE("points moved along a curve stay on it to third order") {
    const auto error = [](int cells) {
        std::vector<Vec3> line;
        for (int n = 0; n <= cells; ++n) {
            const double angle = 1.5 * std::pow(static_cast<double>(n) / cells, 1.5);
            line.push_back({std::cos(angle), std::sin(angle), 0});
        }
        const auto distances = distances_along(line);
        const auto scaled = scaled_distances(distances, std::log(1.5), 1.0);
        double worst = 0;
        for (const Vec3& p : points_at(line, distances, scaled)) {
            worst = std::max(worst, std::abs(norm(p) - 1));
        }
        return worst;
    };
    CHECK(error(20) < 1e-3);
    CHECK(error(20) > 1e-9);
    CHECK(error(40) < error(20) / 6);
    CHECK(error(80) < error(40) / 6);
}

TEST_CASE("at their own distances the points of a curve are themselves") {
    std::vector<Vec3> line;
    for (int n = 0; n <= 12; ++n) line.push_back({0.1 * n * n, std::sin(0.3 * n), std::exp(-n)});
    const auto distances = distances_along(line);
    const auto same = points_at(line, distances, distances);
    for (std::size_t n = 0; n < line.size(); ++n) CHECK(distance(same[n], line[n]) < 1e-14);
    const std::vector<Vec3> two{{0, 0, 0}, {2, 0, 0}};
    CHECK(points_at(two, {0, 2}, {0.5})[0] == Vec3{0.5, 0, 0});
}

TEST_CASE("the growth of a line is its greatest ratio of neighbours, either way") {
    CHECK(greatest_growth({0, 1, 2, 3}) == 1);
    CHECK(greatest_growth({0, 1, 3, 4}) == 2);
    CHECK(greatest_growth(layer(1e-3, 1.25, 20)) == Approx(1.25));
    CHECK(std::isinf(greatest_growth({0, 1, 1})));
    CHECK(std::isinf(greatest_growth({0, 1, 0.5})));
}

TEST_CASE("what would grow too fast is done as far as it does not") {
    const auto distances = layer(1e-4, 1.2, 40);
    const double fade = 0.02;
    for (const double factor : {0.01, 0.1, 0.5, 2.0, 30.0, 1e4}) {
        const double logarithm = std::log(factor);
        const double part = part_of_factor(distances, factor, fade, 1.3);
        CHECK(greatest_growth(scaled_distances(distances, part * logarithm, fade)) <= 1.3);
        if (part < 1) {
            const auto more = scaled_distances(distances, (part + 1e-6) * logarithm, fade);
            CHECK(greatest_growth(more) > 1.3);
        }
    }
    CHECK(part_of_factor(distances, 2, fade, 1.3) == 1);
    CHECK(part_of_factor(distances, 0.01, fade, 1.3) < 0.8);
    CHECK(part_of_factor(distances, 0.01, fade, 3) == 1);
    // A line that grows faster already may do so a little more; one without a point to move cannot.
    CHECK(part_of_factor(layer(1e-4, 1.5, 20), 1.01, fade, 1.3) > 0);
    CHECK(part_of_factor(distances, 2, 1e-4, 1.3) == 0);
}

TEST_CASE("a line between two walls is moved in its near half only") {
    CHECK(fade_on_line(0.03, 1) == 0.03);
    CHECK(fade_on_line(0.03, 0.04) == 0.02);
}
