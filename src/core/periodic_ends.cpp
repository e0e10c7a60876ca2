// SPDX-License-Identifier: Apache-2.0
#include "core/periodic_ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/periodic_image.h"

namespace hexweave {
namespace {

PeriodicMap map_of(const std::optional<Periodicity>& periodic) {
    return periodic ? periodic_map(*periodic) : PeriodicMap{};
}

/// How far points of a box may be off when a file keeps the map in single precision. The farthest
/// corner speaks for all: a length that is small beside the grid is no length.
double rounding(const PeriodicMap& map, const PointBox& box) {
    double greatest = 0;
    for (const Vec3& corner : box.corners()) {
        greatest =
            std::max(greatest, image_rounding(map, corner, std::numeric_limits<float>::epsilon()));
    }
    return greatest;
}

bool leads_back(const TwoEnds& ends, const PointBox& box) {
    const PeriodicMap there = map_of(ends.first.periodic);
    const PeriodicMap back = map_of(ends.second.periodic);
    const double near = rounding(there, box);
    const auto corners = box.corners();
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        return distance(image(back, image(there, corner)), corner) <= near;
    });
}

std::string end_text(const GridOutline& grid, const Interface& end) {
    return fmt::format("'{}' of zone '{}' is {}", end.name,
                       grid.zones[static_cast<std::size_t>(end.zone)].name, to_text(end.periodic));
}

}  // namespace

bool same_periodicity(const std::optional<Periodicity>& a, const std::optional<Periodicity>& b,
                      const PointBox& box) {
    if (!a || !b) return a.has_value() == b.has_value();
    const PeriodicMap first = periodic_map(*a);
    const PeriodicMap second = periodic_map(*b);
    const double near = rounding(first, box);
    const auto corners = box.corners();
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        return distance(image(first, corner), image(second, corner)) <= near;
    });
}

std::string to_text(const std::optional<Periodicity>& periodic) {
    if (!periodic) return "not periodic";
    const auto vector = [](const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); };
    return fmt::format("periodic by rotation {} about {} and translation {}",
                       vector(periodic->angle), vector(periodic->center),
                       vector(periodic->translation));
}

std::vector<std::string> contradictions(const GridOutline& grid, const PointBox& box) {
    std::vector<std::string> found;
    for (const TwoEnds& ends : grid.ends_apart) {
        if (leads_back(ends, box)) continue;
        found.push_back(fmt::format(
            "the two ends of an interface contradict each other: {}, {}; the one is not the way "
            "back of the other",
            end_text(grid, ends.first), end_text(grid, ends.second)));
    }
    return found;
}

}  // namespace hexweave
