// SPDX-License-Identifier: Apache-2.0
#include "topology/corner_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexweave {

namespace {

using Order4 = std::array<std::size_t, 4>;

/// The three ways to join four corners in a ring, and each backwards.
constexpr std::array<Order4, 6> rings{
    {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}, {0, 3, 2, 1}, {0, 2, 3, 1}, {0, 3, 1, 2}}};

double area_of(const std::array<Vec3, 4>& p, const Order4& o) {
    return cross(p[o[2]] - p[o[0]], p[o[3]] - p[o[1]]).z / 2;
}

double length_round(const std::array<Vec3, 8>& p, const Order4& o) {
    double length = 0;
    for (std::size_t n = 0; n < 4; ++n) length += distance(p[o[n]], p[o[(n + 1) % 4]]);
    return length;
}

double length_of(const std::array<Vec3, 8>& p, const Order4& low, const Order4& high) {
    double length = length_round(p, low) + length_round(p, high);
    for (std::size_t n = 0; n < 4; ++n) length += distance(p[low[n]], p[high[n]]);
    return length;
}

}  // namespace

std::array<std::size_t, 4> order_round(const std::array<Vec3, 4>& corners) {
    return *std::max_element(rings.begin(), rings.end(), [&](const Order4& a, const Order4& b) {
        return area_of(corners, a) < area_of(corners, b);
    });
}

std::array<std::size_t, 8> order_of_hexahedron(const std::array<Vec3, 8>& corners) {
    Order4 low{};
    Order4 high{};
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t ring = 0; ring < 3; ++ring) {
        Order4 above{4, 5, 6, 7};
        do {
            const double length = length_of(corners, rings[ring], above);
            if (!(length < shortest * (1 - 1e-12))) continue;
            shortest = length;
            low = rings[ring];
            high = above;
        } while (std::next_permutation(above.begin(), above.end()));
    }
    const Vec3& origin = corners[low[0]];
    const double volume =
        triple(corners[low[1]] - origin, corners[low[3]] - origin, corners[high[0]] - origin);
    if (volume < 0) std::swap(low, high);
    return {low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]};
}

}  // namespace hexweave
