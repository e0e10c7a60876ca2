// SPDX-License-Identifier: Apache-2.0
#include "topology/periodic_remedy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <variant>

#include "topology/periodic_match.h"

namespace hexweave {

namespace {

constexpr double near_image = 1e-9;  // of the grid's size

/// The mean place of the vertices of some sides: an image has the image of it.
Vec3 middle(const Network& network, const std::vector<int>& sides) {
    std::set<int> vertices;
    const auto add = [&](const Edge& edge) { vertices.insert({edge.start, edge.end}); };
    for (const int side : sides) {
        if (!network.three_dimensional) {
            add(network.edge(side));
            continue;
        }
        for (const auto& uses : network.face(side).sides) {
            for (const EdgeUse& use : uses) add(network.edge(use.edge));
        }
    }
    Vec3 sum;
    for (const int vertex : vertices) {
        sum += network.topology.vertices[static_cast<std::size_t>(vertex)].position;
    }
    return sum / static_cast<double>(vertices.size());
}

bool pairs_all(const Network& network, const Periodicity& periodicity, const std::vector<int>& from,
               const std::vector<int>& to) {
    const PeriodicMap map = periodic_map(periodicity);
    SideMatcher matcher(network, map);
    return std::all_of(from.begin(), from.end(), [&](int side) {
        return std::any_of(to.begin(), to.end(), [&](int other) {
            return matcher.ways(side, other).front().distance <= near_image * network.topology.size;
        });
    });
}

/// A number as it can be written to be met exactly enough.
std::string exact(double value, double size) {
    return fmt::format("{:.12g}", std::abs(value) <= near_image * size ? 0.0 : value);
}

/// A part of half a turn is written as that, else of a full one.
std::string angle_text(double angle) {
    const char* sign = angle < 0 ? "-" : "";
    for (const int halves : {1, 2}) {
        const double whole = halves * std::numbers::pi;
        const double parts = std::round(whole / std::abs(angle));
        if (std::abs(whole / parts - std::abs(angle)) > 1e-10) continue;
        if (parts == 1) return fmt::format("{}pi", sign);
        return fmt::format("{}{}pi / {}", sign, halves == 1 ? "" : "2 * ", parts);
    }
    return fmt::format("{:.15g}", angle);
}

/// The angle about an axis from one place to another.
double angle_between(const Vec3& axis, const Vec3& a, const Vec3& b) {
    return std::atan2(triple(axis, a, b), dot(a, b) - dot(a, axis) * dot(b, axis));
}

}  // namespace

std::string map_that_pairs(const Network& network, const PeriodicEntry& entry,
                           const std::vector<int>& from, const std::vector<int>& to) {
    const Vec3 start = middle(network, from);
    const Vec3 end = middle(network, to);
    if (const auto* turn = std::get_if<RotationEntry>(&entry.map.value)) {
        const double angle = angle_between(turn->axis, start - turn->center, end - turn->center);
        if (!pairs_all(network, {turn->center, angle * turn->axis, {}}, from, to)) return {};
        return fmt::format("angle: {}", angle_text(angle));
    }
    const Vec3 way = end - start;
    if (!pairs_all(network, {{}, {}, way}, from, to)) return {};
    const double size = network.topology.size;
    const std::string third = network.topology.planar ? "" : ", " + exact(way.z, size);
    return fmt::format("translate: [{}, {}{}]", exact(way.x, size), exact(way.y, size), third);
}

}  // namespace hexweave
