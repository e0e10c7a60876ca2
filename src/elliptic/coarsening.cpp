// SPDX-License-Identifier: Apache-2.0
#include "elliptic/coarsening.h"

#include <algorithm>
#include <cmath>

namespace hexweave {

namespace {

/// An axis whose parameter's steps vary more than this is stretched; below it, all are coarsened.
constexpr double stretched = 100;

/// Without boundary layers the equations of a face are well-behaved on very coarse grids too, and
/// what is left to the coarsest takes long there if it has many nodes.
constexpr int least_nodes_of_even_faces = 5;

/// Cells so much longer than the shortest are not yet to be made longer still. Beside a stretched
/// axis the order counts, and most on the finest level; further down it would only cost memory.
constexpr double alike_on_finest = 1.02;
constexpr double alike = 1.7;

/// How many lines across each axis are looked at.
constexpr int samples = 8;

/// Calls visit(row, here, other row, there) for the pairs of neighbours on a sample of the lines
/// along `axis`, boundary lines included.
template <class Visit>
void for_neighbours(const Level& level, const RowArray<double>& values, int axis, Visit&& visit) {
    const std::array<int, 3> nodes{level.extent.ni, level.extent.nj, level.extent.nk};
    const auto first = static_cast<std::size_t>((axis + 1) % 3);
    const auto second = static_cast<std::size_t>((axis + 2) % 3);
    const auto along = static_cast<std::size_t>(axis);
    for (int a = 0; a < samples; ++a) {
        for (int b = 0; b < samples; ++b) {
            std::array<int, 3> node{};
            node[first] = (nodes[first] - 1) * (2 * a + 1) / (2 * samples);
            node[second] = (nodes[second] - 1) * (2 * b + 1) / (2 * samples);
            for (int n = 0; n + 1 < nodes[along]; ++n) {
                node[along] = n;
                const double* const row = values.row(node[1], node[2]);
                const std::ptrdiff_t here = level.shape.at(node[0]);
                node[along] = n + 1;
                visit(row, here, values.row(node[1], node[2]), level.shape.at(node[0]));
            }
        }
    }
}

/// The geometric mean of the distance to the next node along each axis.
std::array<double, 3> mean_steps(const Level& level) {
    const std::ptrdiff_t length = level.shape.length();
    std::array<double, 3> mean{};
    for (int axis = 0; axis < level.axes; ++axis) {
        double sum = 0;
        double count = 0;
        for_neighbours(
            level, level.points, axis,
            [&](const double* row, std::ptrdiff_t here, const double* other, std::ptrdiff_t there) {
                double square = 0;
                for (int c = 0; c < level.components; ++c) {
                    const double d = other[c * length + there] - row[c * length + here];
                    square += d * d;
                }
                if (!(square > 0)) return;
                sum += 0.5 * std::log(square);
                count += 1;
            });
        mean[static_cast<std::size_t>(axis)] = count > 0 ? std::exp(sum / count) : 0;
    }
    return mean;
}

/// The largest over the smallest step of each parameter along its own axis.
std::array<double, 3> spreads(const Level& level) {
    std::array<double, 3> result{};
    for (int axis = 0; axis < level.axes; ++axis) {
        const std::ptrdiff_t component = axis * static_cast<std::ptrdiff_t>(level.shape.length());
        double smallest = 1;
        double largest = 0;
        for_neighbours(
            level, level.parameters, axis,
            [&](const double* row, std::ptrdiff_t here, const double* other, std::ptrdiff_t there) {
                const double step = other[component + there] - row[component + here];
                smallest = std::min(smallest, step);
                largest = std::max(largest, step);
            });
        result[static_cast<std::size_t>(axis)] = largest / std::max(smallest, 1e-30);
    }
    return result;
}

/// The axes that may be coarsened at all.
std::array<bool, 3> coarsened_axes(const Level& finest) {
    if (finest.axes == 2) return {true, true, false};
    const std::array<double, 3> spread = spreads(finest);
    const auto widest = std::max_element(spread.begin(), spread.end());
    std::array<bool, 3> axes{true, true, true};
    if (*widest > stretched) axes[static_cast<std::size_t>(widest - spread.begin())] = false;
    return axes;
}

}  // namespace

std::vector<std::array<bool, 3>> plan_coarsening(const Level& finest, int least_nodes) {
    const std::array<double, 3> spread = spreads(finest);
    const bool is_stretched = *std::max_element(spread.begin(), spread.end()) > stretched;
    if (finest.axes == 2 && !is_stretched) {
        least_nodes = std::min(least_nodes, least_nodes_of_even_faces);
    }
    const std::array<bool, 3> allowed = coarsened_axes(finest);
    std::array<double, 3> steps = mean_steps(finest);
    std::array<int, 3> nodes{finest.extent.ni, finest.extent.nj, finest.extent.nk};
    std::vector<std::array<bool, 3>> plan;
    for (;;) {
        std::array<bool, 3> halved{};
        double shortest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            halved[axis] = allowed[axis] && halved_count(nodes[axis]) >= least_nodes;
            if (halved[axis] && (shortest == 0 || steps[axis] < shortest)) shortest = steps[axis];
        }
        if (halved == std::array<bool, 3>{}) return plan;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (finest.axes == 3 &&
                steps[axis] > (is_stretched && plan.empty() ? alike_on_finest : alike) * shortest)
                halved[axis] = false;
            if (!halved[axis]) continue;
            steps[axis] *= 2;
            nodes[axis] = halved_count(nodes[axis]);
        }
        plan.push_back(halved);
    }
}

}  // namespace hexweave
