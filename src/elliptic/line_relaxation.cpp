// SPDX-License-Identifier: Apache-2.0
#include "elliptic/line_relaxation.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"
#include "core/vectorized.h"
#include "elliptic/lanes.h"

namespace hexweave {

namespace {

/// Rows whose lines along k are relaxed together: few, so that they stay in cache on the way back.
constexpr int strip_rows = 2;

/// Rough nanoseconds per node of a sweep, for the decision whether threads are worth waking.
constexpr int cost_of_node = 10;

/// One colour's nodes of one row: pointers to the first of them, and how to reach the others.
struct ColourRow {
    const float* stencils;
    const float* residuals;
    float* corrections;
    std::ptrdiff_t length;  ///< from one component to the next
    std::ptrdiff_t previous;
    std::ptrdiff_t next;
    std::ptrdiff_t stride_j;  ///< in corrections
    std::ptrdiff_t stride_k;
    int count;
};

ColourRow colour_row(Level& level, const RowSegment& segment, int j, int k) {
    return {level.stencils.row(j, k) + segment.first,
            level.residuals.row(j, k) + segment.first,
            level.corrections.row(j, k) + segment.first,
            level.shape.length(),
            segment.previous,
            segment.next,
            level.corrections.stride_j(),
            level.corrections.stride_k(),
            segment.count};
}

/// The operator without the nodes of the line along `axis` itself, applied to the corrections v
/// whose stencil numbers start at c (each `length` after the last).
template <int axes, int axis>
[[gnu::always_inline]] inline Lanes off_line_part(const float* c, std::ptrdiff_t length,
                                                  const float* v, const ColourRow& d) {
    constexpr int mixed = StencilLayout<axes>::mixed;
    constexpr int first = StencilLayout<axes>::first;
    const auto stencil = [=](int n) __attribute__((always_inline)) {
        return load_lanes(c + n * length);
    };
    const auto at = [=](std::ptrdiff_t offset) __attribute__((always_inline)) {
        return load_lanes(v + offset);
    };
    const float* const before = unrelated(v + d.previous);
    const auto at_previous = [=](std::ptrdiff_t offset) __attribute__((always_inline)) {
        return load_lanes(before + offset);
    };
    const auto at_next = [=](std::ptrdiff_t offset) __attribute__((always_inline)) {
        return load_lanes(before + offset + 1);
    };
    const std::ptrdiff_t j = d.stride_j;
    Lanes sum = stencil(mixed) * ((at_next(j) - at_next(-j)) - (at_previous(j) - at_previous(-j)));
    if constexpr (axis != 0) {
        sum += stencil(0) * (at_next(0) + at_previous(0)) +
               stencil(first) * (at_next(0) - at_previous(0));
    }
    if constexpr (axis != 1) {
        sum += stencil(1) * (at(j) + at(-j)) + stencil(first + 1) * (at(j) - at(-j));
    }
    if constexpr (axes == 3) {
        const std::ptrdiff_t k = d.stride_k;
        sum +=
            stencil(mixed + 1) * ((at_next(k) - at_next(-k)) - (at_previous(k) - at_previous(-k)));
        sum += stencil(mixed + 2) * ((at(j + k) - at(j - k)) - (at(k - j) - at(-j - k)));
        if constexpr (axis != 2) {
            sum += stencil(2) * (at(k) + at(-k)) + stencil(first + 2) * (at(k) - at(-k));
        }
    }
    return sum;
}

/// Asks for what the elimination in the next layer will read around node m, once per cache line:
/// rows of one colour are too short for the machine to see them coming.
[[gnu::always_inline]] inline void prefetch_next_layer(const ColourRow& d, int m) {
    constexpr int floats_per_cache_line = 16;
    if (m % floats_per_cache_line != 0) return;
    const std::ptrdiff_t stencils_stride_k = d.stride_k / 3 * StencilLayout<3>::size;
    for (std::ptrdiff_t n = 0; n < StencilLayout<3>::size; ++n) {
        __builtin_prefetch(d.stencils + m + n * d.length + stencils_stride_k);
    }
    for (std::ptrdiff_t n = 0; n < 3; ++n) {
        __builtin_prefetch(d.residuals + m + n * d.length + d.stride_k);
        const float* const ahead = d.corrections + m + n * d.length + 2 * d.stride_k;
        __builtin_prefetch(ahead);
        __builtin_prefetch(ahead + d.stride_j);
    }
}

/// One step of the elimination along a line that crosses rows: d <- (l d- - rhs) / (1 - l u-) in
/// place of the corrections, and the upper factor u / (1 - l u-). `back` leads to the node before.
template <int axes, int components, int axis>
HEXWEAVE_VECTORIZED void eliminate_across(const ColourRow& row, std::ptrdiff_t back,
                                          const float* upper_before, float* upper) {
    constexpr int first = StencilLayout<axes>::first;
    const ColourRow d = row;
    for (int m = 0; m < d.count; m += lane_count) {
        if constexpr (axis == 2) prefetch_next_layer(d, m);
        const float* const c = unrelated(d.stencils + m);
        const Lanes second = load_lanes(c + axis * d.length);
        const Lanes slope = load_lanes(c + (first + axis) * d.length);
        const Lanes below = second - slope;
        const Lanes inverse = 1.0F / (1.0F - below * load_lanes(upper_before + m));
        for (std::ptrdiff_t n = 0; n < components; ++n) {
            float* const v = unrelated(d.corrections + n * d.length + m);
            const Lanes right = load_lanes(d.residuals + n * d.length + m) -
                                off_line_part<axes, axis>(c, d.length, v, d);
            store_lanes(v, (below * load_lanes(v - back) - right) * inverse);
        }
        store_lanes(upper + m, (second + slope) * inverse);
    }
}

template <int components>
HEXWEAVE_VECTORIZED void substitute_across(const ColourRow& row, std::ptrdiff_t ahead,
                                           const float* upper) {
    for (int m = 0; m < row.count; m += lane_count) {
        for (std::ptrdiff_t n = 0; n < components; ++n) {
            float* const v = row.corrections + n * row.length + m;
            store_lanes(v, load_lanes(v) + load_lanes(upper + m) * load_lanes(v + ahead));
        }
    }
}

/// The lines along j of one colour in layer k, side by side.
template <int axes, int components>
void relax_rows(Level& level, const RowSegment& segment, int k) {
    const int nodes = level.extent.nj;
    const std::ptrdiff_t stride = level.corrections.stride_j();
    std::vector<float> upper(
        static_cast<std::size_t>(nodes) * static_cast<std::size_t>(segment.count), 0.0F);
    for (int j = 1; j < nodes - 1; ++j) {
        float* const own = upper.data() + static_cast<std::ptrdiff_t>(j) * segment.count;
        eliminate_across<axes, components, 1>(colour_row(level, segment, j, k), stride,
                                              own - segment.count, own);
    }
    for (int j = nodes - 3; j > 0; --j) {
        substitute_across<components>(
            colour_row(level, segment, j, k), stride,
            upper.data() + static_cast<std::ptrdiff_t>(j) * segment.count);
    }
}

/// The lines along j in layer k, colour by colour; on a face several threads share a colour.
template <int axes, int components>
void relax_layer_across(Level& level, int k) {
    for (const RowSegment& segment : level.shape.segments()) {
        const int cost = level.extent.nj * lane_count * cost_of_node;
        parallel_blocks(segment.count / lane_count, cost, [&](int begin, int end) {
            RowSegment part = segment;
            part.first += begin * lane_count;
            part.count = (end - begin) * lane_count;
            relax_rows<axes, components>(level, part, k);
        });
    }
}

/// Rows that are transposed together.
constexpr int group_rows = lane_count / 2;

/// What the elimination of lines along i needs: below, upper and the right hand sides, `numbers` of
/// them, of one batch of lines as [number][node][lane], and of a group of rows as they are stored.
struct TransposedLines {
    static constexpr int numbers = 5;

    std::vector<float> lines;
    std::vector<float> rows;
    std::ptrdiff_t size;    ///< of one number in `lines`
    std::ptrdiff_t length;  ///< of one number of one row in `rows`

    explicit TransposedLines(const RowShape& shape)
        : size(2 * lane_count * std::max(shape.segments()[0].count, shape.segments()[1].count)),
          length(shape.length()) {
        lines.assign(static_cast<std::size_t>(size * numbers), 0.0F);
        rows.assign(static_cast<std::size_t>(length * numbers * group_rows), 0.0F);
    }

    float* line(std::ptrdiff_t number) { return lines.data() + number * size; }
    float* row(std::ptrdiff_t row, std::ptrdiff_t number) {
        return rows.data() + (row * numbers + number) * length;
    }
};

template <int axes, int components>
HEXWEAVE_VECTORIZED void right_hand_side_along(const ColourRow& nodes, float* scratch) {
    constexpr int first = StencilLayout<axes>::first;
    const ColourRow d = nodes;
    for (int m = 0; m < d.count; m += lane_count) {
        const float* const c = unrelated(d.stencils + m);
        const Lanes second = load_lanes(c);
        const Lanes slope = load_lanes(c + first * d.length);
        store_lanes(scratch + m, second - slope);
        store_lanes(scratch + d.length + m, second + slope);
        for (std::ptrdiff_t n = 0; n < components; ++n) {
            store_lanes(scratch + (2 + n) * d.length + m,
                        load_lanes(d.residuals + n * d.length + m) -
                            off_line_part<axes, 0>(c, d.length,
                                                   unrelated(d.corrections + n * d.length + m), d));
        }
    }
}

template <int components>
HEXWEAVE_VECTORIZED void solve_along(int ni, TransposedLines& t) {
    float* const lower = t.line(0);
    float* const upper = t.line(1);
    for (std::ptrdiff_t i = 1; i < ni - 1; ++i) {
        const std::ptrdiff_t here = i * lane_count;
        const Lanes below = load_lanes(lower + here);
        const Lanes inverse = 1.0F / (1.0F - below * load_lanes(upper + here - lane_count));
        for (std::ptrdiff_t n = 0; n < components; ++n) {
            float* const v = t.line(2 + n) + here;
            store_lanes(v, (below * load_lanes(v - lane_count) - load_lanes(v)) * inverse);
        }
        store_lanes(upper + here, load_lanes(upper + here) * inverse);
    }
    for (std::ptrdiff_t i = ni - 3; i > 0; --i) {
        const std::ptrdiff_t here = i * lane_count;
        for (std::ptrdiff_t n = 0; n < components; ++n) {
            float* const v = t.line(2 + n) + here;
            store_lanes(v, load_lanes(v) + load_lanes(upper + here) * load_lanes(v + lane_count));
        }
    }
}

/// The rows of a group, each `stride` after the one before, become the lanes from `lane` on.
template <int numbers>
HEXWEAVE_VECTORIZED void rows_to_lines(const RowShape& shape, int lane, TransposedLines& t) {
    const auto segments = shape.segments();
    for (int parity = 0; parity < 2; ++parity) {
        const RowSegment segment = segments[static_cast<std::size_t>(parity)];
        for (int number = 0; number < numbers; ++number) {
            for (int m = 0; m < segment.count; m += group_rows) {
                const std::ptrdiff_t from = segment.first + m;
                float* const to = t.line(number) + (2 * m + parity) * lane_count + lane;
                transpose({t.row(0, number) + from, t.row(1, number) + from,
                           t.row(2, number) + from, t.row(3, number) + from},
                          {to, to + 2 * lane_count, to + 4 * lane_count, to + 6 * lane_count});
            }
        }
    }
}

/// And back, the solution alone.
template <int components>
HEXWEAVE_VECTORIZED void lines_to_rows(const RowShape& shape, int lane, TransposedLines& t) {
    const auto segments = shape.segments();
    for (int parity = 0; parity < 2; ++parity) {
        const RowSegment segment = segments[static_cast<std::size_t>(parity)];
        for (int number = 2; number < 2 + components; ++number) {
            for (int m = 0; m < segment.count; m += group_rows) {
                const std::ptrdiff_t to = segment.first + m;
                const float* const from = t.line(number) + (2 * m + parity) * lane_count + lane;
                transpose(
                    {from, from + 2 * lane_count, from + 4 * lane_count, from + 6 * lane_count},
                    {t.row(0, number) + to, t.row(1, number) + to, t.row(2, number) + to,
                     t.row(3, number) + to});
            }
        }
    }
}

/// Lines along i through the rows j, j + 2, .. j + 2 (lanes - 1) of layer k.
template <int axes, int components>
void relax_along(Level& level, int j, int lanes, int k, TransposedLines& t) {
    const auto segments = level.shape.segments();
    for (int first = 0; first < lanes; first += group_rows) {
        for (int lane = first; lane < std::min(first + group_rows, lanes); ++lane) {
            for (const RowSegment& segment : segments) {
                right_hand_side_along<axes, components>(colour_row(level, segment, j + 2 * lane, k),
                                                        t.row(lane - first, 0) + segment.first);
            }
        }
        rows_to_lines<2 + components>(level.shape, first, t);
    }
    solve_along<components>(level.extent.ni, t);
    const std::ptrdiff_t length = level.shape.length();
    for (int first = 0; first < lanes; first += group_rows) {
        lines_to_rows<components>(level.shape, first, t);
        for (int lane = first; lane < std::min(first + group_rows, lanes); ++lane) {
            const float* const solution = t.row(lane - first, 2);
            std::copy(solution, solution + components * length,
                      level.corrections.row(j + 2 * lane, k));
        }
    }
}

/// The lines along i in layer k, colour by colour; on a face several threads share a colour.
template <int axes, int components>
void relax_layer_along(Level& level, int k) {
    const int last = level.extent.nj - 2;
    for (const int first : {1, 2}) {
        const int lines = (last - first) / 2 + 1;
        const int batches = last < first ? 0 : (lines + lane_count - 1) / lane_count;
        const int cost = level.extent.ni * lane_count * cost_of_node;
        parallel_blocks(batches, cost, [&](int begin, int end) {
            TransposedLines transposed(level.shape);
            for (int batch = begin; batch < end; ++batch) {
                const int done = batch * lane_count;
                relax_along<axes, components>(level, first + 2 * done,
                                              std::min(lane_count, lines - done), k, transposed);
            }
        });
    }
}

/// Calls task(k) for the interior layers of one parity.
template <class Task>
void for_layers(const Level& level, int parity, Task&& task) {
    const int first = 2 - parity;
    const int count = (level.last_k() - first + 2) / 2;
    const int cost = level.extent.ni * level.extent.nj * cost_of_node;
    parallel_blocks(count, cost, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) task(first + 2 * n);
    });
}

/// Lines along i, then lines along j, layer by layer while they are in cache.
void relax_layers(Level& level) {
    for (int parity = 1; parity >= 0; --parity) {
        for_layers(level, parity, [&](int k) {
            relax_layer_along<3, 3>(level, k);
            relax_layer_across<3, 3>(level, k);
        });
    }
}

/// Lines along k of one colour through the rows first, first + 2, .. of `count`: layer by layer
/// over all of them, so that memory is read in its order.
template <int components>
void relax_columns(Level& level, const RowSegment& segment, int first, int count) {
    const int nodes = level.extent.nk;
    const std::ptrdiff_t stride = level.corrections.stride_k();
    const std::ptrdiff_t layer = static_cast<std::ptrdiff_t>(count) * segment.count;
    std::vector<float> upper(static_cast<std::size_t>(nodes * layer), 0.0F);
    for (int k = 1; k < nodes - 1; ++k) {
        for (int n = 0; n < count; ++n) {
            float* const own =
                upper.data() + k * layer + static_cast<std::ptrdiff_t>(n) * segment.count;
            eliminate_across<3, components, 2>(colour_row(level, segment, first + 2 * n, k), stride,
                                               own - layer, own);
        }
    }
    for (int k = nodes - 3; k > 0; --k) {
        for (int n = 0; n < count; ++n) {
            substitute_across<components>(
                colour_row(level, segment, first + 2 * n, k), stride,
                upper.data() + k * layer + static_cast<std::ptrdiff_t>(n) * segment.count);
        }
    }
}

template <int components>
void relax_columns(Level& level) {
    const int cost = level.extent.ni * level.extent.nk * cost_of_node * strip_rows;
    for (int parity = 1; parity >= 0; --parity) {
        const int first = 2 - parity;
        const int rows = (level.extent.nj - first) / 2;
        const int strips = (rows + strip_rows - 1) / strip_rows;
        parallel_blocks(strips, cost, [&](int begin, int end) {
            for (int strip = begin; strip < end; ++strip) {
                const int done = strip * strip_rows;
                const int count = std::min(strip_rows, rows - done);
                for (const RowSegment& segment : level.shape.segments()) {
                    relax_columns<components>(level, segment, first + 2 * done, count);
                }
            }
        });
    }
}

template <int components>
void relax_face(Level& level, int sweeps) {
    relax_layer_across<2, components>(level, 0);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        relax_layer_along<2, components>(level, 0);
        relax_layer_across<2, components>(level, 0);
    }
}

void relax_block(Level& level, int sweeps) {
    relax_columns<3>(level);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        relax_layers(level);
        relax_columns<3>(level);
    }
}

}  // namespace

void relax_lines(Level& level, int sweeps) {
    if (level.axes == 3) {
        relax_block(level, sweeps);
    } else if (level.components == 3) {
        relax_face<3>(level, sweeps);
    } else {
        relax_face<2>(level, sweeps);
    }
}

}  // namespace hexweave
