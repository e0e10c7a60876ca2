// SPDX-License-Identifier: Apache-2.0
#include "faces/held_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/every_nth.h"
#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "faces/movable_line.h"
#include "faces/wall_frame.h"

namespace hexweave {

namespace {

/// Of node n off the wall.
double height_at(const PointField& points, const WallFrame& wall, int a, int b, int n) {
    return distance(points[wall.offset(a, b, 0)], points[wall.offset(a, b, n)]);
}

/// Distances along the wall's own grid lines, from the end at index 0, node by node.
struct WallLengths {
    Field along_a;
    Field along_b;
    double shorter = 0;  ///< the lesser of the mean lengths of the lines along a and along b

    WallLengths(const PointField& points, const WallFrame& wall)
        : along_a(wall.nodes()), along_b(wall.nodes()) {
        double sum_a = 0;
        double sum_b = 0;
        for (int b = 0; b < wall.count_b; ++b) {
            for (int a = 0; a < wall.count_a; ++a) {
                const Vec3 here = points[wall.offset(a, b, 0)];
                if (a > 0) {
                    along_a(a, b) =
                        along_a(a - 1, b) + distance(points[wall.offset(a - 1, b, 0)], here);
                }
                if (b > 0) {
                    along_b(a, b) =
                        along_b(a, b - 1) + distance(points[wall.offset(a, b - 1, 0)], here);
                }
            }
            sum_a += along_a(wall.count_a - 1, b);
        }
        for (int a = 0; a < wall.count_a; ++a) sum_b += along_b(a, wall.count_b - 1);
        const double mean_a = sum_a / wall.count_b;
        const double mean_b = sum_b / wall.count_a;
        shorter = wall.is_line() ? mean_a : std::min(mean_a, mean_b);
    }
};

/// 1 at a neighbouring side, 0 from `fade` away from it.
double nearness(double distance, double fade) {
    const double x = std::min(distance / fade, 1.0);
    return 1 - x * x * (3 - 2 * x);
}

/// The heights to aim at: as asked, but as they are on the neighbouring sides, which are fixed, and
/// from the one to the other within the fade distance: a Boolean sum of the logarithms.
Field targets(const PointField& points, const WallFrame& wall, const WallLengths& lengths,
              const HeldSide& held) {
    const Field& asked = held.asked;
    const double fade = held.fade;
    const int last_a = wall.count_a - 1;
    const int last_b = wall.count_b - 1;
    const auto excess = [&](int a, int b) {
        const double height = height_at(points, wall, a, b, held.first);
        return height > 0 ? std::log(height / asked(a, b)) : 0;  // none at a pole
    };
    Field result(wall.nodes());
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            const std::array<double, 2> near_a{
                nearness(lengths.along_a(a, b), fade),
                nearness(lengths.along_a(last_a, b) - lengths.along_a(a, b), fade)};
            double sum = near_a[0] * excess(0, b) + near_a[1] * excess(last_a, b);
            if (!wall.is_line()) {
                const std::array<double, 2> near_b{
                    nearness(lengths.along_b(a, b), fade),
                    nearness(lengths.along_b(a, last_b) - lengths.along_b(a, b), fade)};
                for (std::size_t end_b = 0; end_b < 2; ++end_b) {
                    const int at_b = end_b == 0 ? 0 : last_b;
                    sum += near_b[end_b] * (excess(a, at_b) - near_a[0] * excess(0, at_b) -
                                            near_a[1] * excess(last_a, at_b));
                }
            }
            result(a, b) = asked(a, b) * std::exp(sum);
        }
    }
    return result;
}

/// Takes back the lines at cells that are folded now and were not `before`: half of their way, and
/// after some rounds all of it.
void take_back_folds(PointField& points, const WallFrame& wall, std::vector<MovableLine>& lines,
                     const std::set<Node>& before) {
    constexpr int halvings = 6;
    for (int round = 0;; ++round) {
        std::set<std::array<int, 2>> at_fold;
        for (const FoldedCell& folded : folded_cells(points)) {
            if (before.count(folded.cell) > 0) continue;
            const int a = folded.cell[static_cast<std::size_t>(wall.axes[0])];
            const int b = folded.cell[static_cast<std::size_t>(wall.axes[1])];
            for (const int i : {a, a + 1}) {
                for (const int j : {b, b + 1}) at_fold.insert({i, j});
            }
        }
        bool changed = false;
        for (MovableLine& line : lines) {
            if (line.part == 0 || at_fold.count({line.a, line.b}) == 0) continue;
            line.part = round < halvings ? 0.5 * line.part : 0;
            line.stop = Stop::folds;
            move_line(points, wall, line);
            changed = true;
        }
        if (!changed) return;
    }
}

StoppedLines count_stopped(const std::vector<MovableLine>& lines) {
    StoppedLines stopped;
    for (const MovableLine& line : lines) {
        stopped.growth += line.stop == Stop::growth;
        stopped.fade += line.stop == Stop::fade;
        stopped.folds += line.stop == Stop::folds;
    }
    return stopped;
}

std::set<Node> cells_of(const std::vector<FoldedCell>& folded) {
    std::set<Node> cells;
    for (const FoldedCell& cell : folded) cells.insert(cell.cell);
    return cells;
}

/// Heights at the corners of a wall, height_of(a, b), and between them by equal factors over equal
/// parts of its arc lengths.
template <class HeightOf>
Field between_corners(const PointField& points, const WallFrame& wall, HeightOf&& height_of) {
    const WallLengths lengths(points, wall);
    const int last_a = wall.count_a - 1;
    const int last_b = wall.count_b - 1;
    const std::array<double, 4> heights{height_of(0, 0), height_of(last_a, 0), height_of(0, last_b),
                                        height_of(last_a, last_b)};
    // At a pole there is no height: the greatest of the others stands for it.
    const double greatest = *std::max_element(heights.begin(), heights.end());
    std::array<double, 4> corners{};
    for (std::size_t c = 0; c < 4; ++c) {
        corners[c] = std::log(heights[c] > 0 ? heights[c] : greatest);
    }
    Field between(wall.nodes());
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            const double s = lengths.along_a(a, b) / lengths.along_a(last_a, b);
            const double t =
                wall.is_line() ? 0.0 : lengths.along_b(a, b) / lengths.along_b(a, last_b);
            between(a, b) = std::exp((1 - t) * ((1 - s) * corners[0] + s * corners[1]) +
                                     t * ((1 - s) * corners[2] + s * corners[3]));
        }
    }
    return between;
}

}  // namespace

Field asked_heights(const PointField& points, Side side, const std::optional<double>& height,
                    int first) {
    const WallFrame wall(points.extent(), side);
    if (height) return Field(wall.nodes(), *height);
    return between_corners(points, wall,
                           [&](int a, int b) { return height_at(points, wall, a, b, first); });
}

HeldSide every_nth(const PointField& points, const HeldSide& held, int stride) {
    const WallFrame wall(points.extent(), held.side);
    Field asked = held.asked;
    if (stride != held.first) {
        asked = between_corners(points, wall, [&](int a, int b) {
            const double height = height_at(points, wall, a, b, stride);
            const double at_first = height_at(points, wall, a, b, held.first);
            if (!held.height) return height;
            return at_first > 0 ? *held.height * height / at_first : 0.0;
        });
    }
    return {held.side, held.fade, every_nth(asked, stride), {}, 1, held.stopped};
}

std::vector<HeldSide> every_nth(const PointField& points, const std::vector<HeldSide>& held,
                                int stride) {
    std::vector<HeldSide> sides;
    sides.reserve(held.size());
    for (const HeldSide& side : held) sides.push_back(every_nth(points, side, stride));
    return sides;
}

HeldSide hold_heights(PointField& points, Side side, const HeldHeights& request) {
    const WallFrame wall(points.extent(), side);
    const WallLengths lengths(points, wall);
    HeldSide held{side, request.fade * lengths.shorter,
                  asked_heights(points, side, request.height, request.first), request.height,
                  request.first};
    const Field target = targets(points, wall, lengths, held);
    std::vector<std::array<int, 2>> inner;
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            if (!wall.fixed(a, b)) inner.push_back({a, b});
        }
    }
    const std::set<Node> before = cells_of(folded_cells(points));
    std::vector<MovableLine> lines(inner.size());
    parallel_for(inner.size(), [&](std::size_t n) {
        const auto [a, b] = inner[n];
        lines[n] = movable_line(points, wall, a, b, target(a, b), held.fade, request);
    });
    spread_outwards(points, wall, lines);
    parallel_for(lines.size(), [&](std::size_t n) {
        limit_growth(lines[n], request.growth);
        move_line(points, wall, lines[n]);
    });
    take_back_folds(points, wall, lines, before);
    held.stopped = count_stopped(lines);
    return held;
}

std::vector<HeldSide> hold_heights(PointField& points, const HeightRequests& requests) {
    std::vector<HeldSide> held;
    for (const Side side : all_sides) {
        const auto& request = requests[static_cast<std::size_t>(side)];
        if (request) held.push_back(hold_heights(points, side, *request));
    }
    return held;
}

std::vector<HeightRatio> height_ratios(const PointField& points, const HeldSide& held) {
    return height_ratios(points, held, [](int, int) { return true; });
}

std::vector<HeightRatio> height_ratios(const PointField& points, const HeldSide& held,
                                       const std::function<bool(int, int)>& counts) {
    const WallFrame wall(points.extent(), held.side);
    std::vector<HeightRatio> ratios;
    ratios.reserve(wall.nodes().nodes());
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            if (!counts(a, b)) continue;
            ratios.push_back({height_at(points, wall, a, b, held.first) / held.asked(a, b),
                              points[wall.offset(a, b, 0)]});
        }
    }
    std::stable_sort(ratios.begin(), ratios.end(),
                     [](const HeightRatio& a, const HeightRatio& b) { return a.value < b.value; });
    return ratios;
}

}  // namespace hexweave
