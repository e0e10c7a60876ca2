// SPDX-License-Identifier: Apache-2.0
#include "faces/factor_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace hexweave {

namespace {

constexpr int cost = 30;  // of a node, for parallel_blocks

/// A line along the wall: values, coefficients of diffusion, and the length of the interval before
/// each node.
struct AlongWall {
    std::vector<double> values;
    std::vector<double> diffusion;
    std::vector<double> intervals;

    explicit AlongWall(int count)
        : values(static_cast<std::size_t>(count)),
          diffusion(static_cast<std::size_t>(count)),
          intervals(static_cast<std::size_t>(count)) {}
};

/// Half of the two couplings of a node to its neighbours, from the lengths to both. Neighbours far
/// nearer than the smoothing reaches (at a pole: no distance off) are as good as one point.
std::array<double, 2> couplings(double diffusion, double before, double after) {
    constexpr double as_good_as_none = 1e-6;
    const double least = as_good_as_none * std::sqrt(diffusion);
    before = std::max(before, least);
    after = std::max(after, least);
    return {2 * diffusion / (before * (before + after)),
            2 * diffusion / (after * (before + after))};
}

/// (1 - diffusion d^2/ds^2) new = old between ends that stay, by elimination: every new value is a
/// mean of old ones, with positive weights.
void diffuse(AlongWall& line) {
    const std::size_t last = line.values.size() - 1;
    std::vector<double> towards_next(line.values.size(), 0.0);
    for (std::size_t m = 1; m < last; ++m) {
        if (line.diffusion[m] == 0) continue;
        const auto [before, after] =
            couplings(line.diffusion[m], line.intervals[m], line.intervals[m + 1]);
        const double pivot = 1 + after + before * (1 - towards_next[m - 1]);
        towards_next[m] = after / pivot;
        line.values[m] = (line.values[m] + before * line.values[m - 1]) / pivot;
    }
    for (std::size_t m = last; m-- > 1;) {
        line.values[m] += towards_next[m] * line.values[m + 1];
    }
}

/// One line of the layer, whose node m is node (a, b) of the wall.
template <class NodeAt>
void smooth_line(FactorLayer& layer, const PointField& points, const WallFrame& wall, int n,
                 int count, NodeAt&& node_at) {
    AlongWall line(count);
    Vec3 before;
    for (int m = 0; m < count; ++m) {
        const auto [a, b] = node_at(m);
        const auto at = static_cast<std::size_t>(m);
        const Vec3 here = points[wall.offset(a, b, n)];
        line.values[at] = layer.log_factors(a, b);
        line.diffusion[at] = 0.25 * layer.widening(a, b);
        line.intervals[at] = m == 0 ? 0.0 : distance(before, here);
        before = here;
    }
    diffuse(line);
    for (int m = 1; m + 1 < count; ++m) {
        const auto [a, b] = node_at(m);
        layer.log_factors(a, b) = line.values[static_cast<std::size_t>(m)];
    }
}

void smooth_along_a(FactorLayer& layer, const PointField& points, const WallFrame& wall, int n) {
    parallel_blocks(wall.count_b, cost * wall.count_a, [&](int begin, int end) {
        for (int b = begin; b < end; ++b) {
            smooth_line(layer, points, wall, n, wall.count_a, [b](int m) {
                return std::array<int, 2>{m, b};
            });
        }
    });
}

void smooth_along_b(FactorLayer& layer, const PointField& points, const WallFrame& wall, int n) {
    parallel_blocks(wall.count_a, cost * wall.count_b, [&](int begin, int end) {
        for (int a = begin; a < end; ++a) {
            smooth_line(layer, points, wall, n, wall.count_b, [a](int m) {
                return std::array<int, 2>{a, m};
            });
        }
    });
}

}  // namespace

void smooth_along_wall(FactorLayer& layer, const PointField& points, const WallFrame& wall, int n) {
    if (wall.is_line()) return smooth_along_a(layer, points, wall, n);
    FactorLayer other = layer;
    smooth_along_a(layer, points, wall, n);
    smooth_along_b(layer, points, wall, n);
    smooth_along_b(other, points, wall, n);
    smooth_along_a(other, points, wall, n);
    for (std::size_t m = 0; m < wall.nodes().nodes(); ++m) {
        layer.log_factors[m] = 0.5 * (layer.log_factors[m] + other.log_factors[m]);
    }
}

}  // namespace hexweave
