// SPDX-License-Identifier: Apache-2.0
#include "elliptic/displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/vec3.h"
#include "elliptic/lanes.h"

namespace hexweave {

namespace {

constexpr double least_sine = 0.02;

/// 1 / value with |value| no less than `least`; 0 where both are zero.
[[gnu::always_inline]] inline double guarded_inverse(double value, double least) {
    const double size = std::max(std::abs(value), least);
    return size > 0 ? 1 / size : 0;
}

[[gnu::always_inline]] inline double largest_of(double a, double b, double c) {
    return std::max(std::max(std::abs(a), std::abs(b)), std::abs(c));
}

[[gnu::always_inline]] inline double cells_on_face(const Vec3& a1, const Vec3& a2, const Vec3& d) {
    const Vec3 normal = cross(a1, a2);
    const double area = std::sqrt(dot(normal, normal));
    const double inverse = guarded_inverse(area, least_sine * std::sqrt(dot(a1, a1) * dot(a2, a2)));
    const double to_unit = guarded_inverse(area, 0);
    const double scale = inverse * to_unit;
    return largest_of(scale * dot(cross(a2, normal), d), scale * dot(cross(normal, a1), d),
                      std::sqrt(inverse) * to_unit * dot(normal, d));
}

[[gnu::always_inline]] inline double cells_in_block(const Vec3& a1, const Vec3& a2, const Vec3& a3,
                                                    const Vec3& d) {
    const Vec3 b1 = cross(a2, a3);
    const double lengths = std::sqrt(dot(a1, a1) * dot(a2, a2) * dot(a3, a3));
    const double inverse = guarded_inverse(dot(a1, b1), least_sine * lengths);
    return inverse * largest_of(dot(b1, d), dot(cross(a3, a1), d), dot(cross(a1, a2), d));
}

/// The largest displacement of one segment of a row, and 0, or NaN when any number was not finite.
struct Largest {
    double size = 0;
    double check = 0;
};

template <int axes, int components>
Largest largest_of_segment(const double* x, const float* moved, std::ptrdiff_t length,
                           const RowSegment& segment, std::ptrdiff_t stride_j,
                           std::ptrdiff_t stride_k) {
    const auto half_difference = [=](std::ptrdiff_t p, std::ptrdiff_t up, std::ptrdiff_t down)
        __attribute__((always_inline)) {
        Vec3 v{0.5 * (x[p + up] - x[p + down]), 0.5 * (x[p + length + up] - x[p + length + down]),
               0};
        if constexpr (components == 3) {
            v.z = 0.5 * (x[p + 2 * length + up] - x[p + 2 * length + down]);
        }
        return v;
    };
    // A maximum for each lane: one for all would keep the loop from being vectorized.
    std::array<double, lane_count> size{};
    std::array<double, lane_count> check{};
    for (int group = 0; group < segment.count; group += lane_count) {
        for (std::ptrdiff_t lane = 0; lane < lane_count; ++lane) {
            const std::ptrdiff_t p = segment.first + group + lane;
            Vec3 d{static_cast<double>(moved[p]), static_cast<double>(moved[p + length]), 0};
            if constexpr (components == 3) d.z = static_cast<double>(moved[p + 2 * length]);
            const Vec3 a1 = half_difference(p, segment.next, segment.previous);
            const Vec3 a2 = half_difference(p, stride_j, -stride_j);
            double cells = 0;
            if constexpr (axes == 2) {
                cells = cells_on_face(a1, a2, d);
            } else {
                cells = cells_in_block(a1, a2, half_difference(p, stride_k, -stride_k), d);
            }
            const auto at = static_cast<std::size_t>(lane);
            size[at] = cells > size[at] ? cells : size[at];
            check[at] += 0 * (cells + d.x + d.y + d.z);
        }
    }
    Largest whole;
    for (std::size_t lane = 0; lane < size.size(); ++lane) {
        whole.size = std::max(whole.size, size[lane]);
        whole.check += check[lane];
    }
    return whole;
}

template <int axes, int components>
double largest(const Level& level, const RowArray<float>& displacements) {
    const Extent& e = level.extent;
    const auto segments = level.shape.segments();
    const int rows = e.nj - 2;
    const int layers = level.last_k() - level.first_k() + 1;
    std::vector<Largest> of_rows(static_cast<std::size_t>(rows * layers));
    parallel_blocks(rows * layers, e.ni * 8, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const int j = 1 + n % rows;
            const int k = level.first_k() + n / rows;
            Largest& result = of_rows[static_cast<std::size_t>(n)];
            for (const RowSegment& segment : segments) {
                const Largest part = largest_of_segment<axes, components>(
                    level.points.row(j, k), displacements.row(j, k), level.shape.length(), segment,
                    level.points.stride_j(), level.points.stride_k());
                result.size = std::max(result.size, part.size);
                result.check += part.check;
            }
        }
    });
    Largest whole;
    for (const Largest& row : of_rows) {
        whole.size = std::max(whole.size, row.size);
        whole.check += row.check;
    }
    return whole.check == 0 ? whole.size : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double largest_displacement(const Level& level, const RowArray<float>& displacements) {
    if (level.axes == 3) return largest<3, 3>(level, displacements);
    if (level.components == 3) return largest<2, 3>(level, displacements);
    return largest<2, 2>(level, displacements);
}

}  // namespace hexweave
