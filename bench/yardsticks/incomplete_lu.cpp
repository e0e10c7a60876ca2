// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/incomplete_lu.h"

#include <algorithm>

namespace hexweave::bench {

namespace {

using Entry = float;

/// How far the neighbours of a stencil lie, along each axis.
using Step = std::array<int, 3>;

/// The neighbours before the centre, by ascending offset; those after it are their mirror images,
/// so entry e and entry (last - e) of a row face each other across the centre.
template <int axes>
struct Shape;

template <>
struct Shape<2> {
    static constexpr std::size_t half = 4;
    static constexpr std::array<Step, half> before{
        {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 0, 0}}};
};

template <>
struct Shape<3> {
    static constexpr std::size_t half = 9;
    static constexpr std::array<Step, half> before{{{0, -1, -1},
                                                    {-1, 0, -1},
                                                    {0, 0, -1},
                                                    {1, 0, -1},
                                                    {0, 1, -1},
                                                    {-1, -1, 0},
                                                    {0, -1, 0},
                                                    {1, -1, 0},
                                                    {-1, 0, 0}}};
};

template <int axes>
constexpr std::size_t row_size = 2 * Shape<axes>::half + 1;

template <int axes>
constexpr Step step_of(std::size_t entry) {
    constexpr std::size_t half = Shape<axes>::half;
    if (entry == half) return {0, 0, 0};
    if (entry < half) return Shape<axes>::before[entry];
    const Step s = Shape<axes>::before[2 * half - entry];
    return {-s[0], -s[1], -s[2]};
}

/// The elimination of row p by row q = p + step(lower) changes entry `target` of row p by the
/// product of entry `lower` of row p and entry `upper` of row q.
struct Update {
    std::size_t upper = 0;
    std::size_t target = 0;
};

/// The updates of all lower entries one after the other; those of entry l are
/// [begin[l], begin[l + 1]). Products that fall outside the pattern are dropped: no fill.
template <int axes>
struct Updates {
    std::array<std::size_t, Shape<axes>::half + 1> begin{};
    std::array<Update, Shape<axes>::half * Shape<axes>::half> all{};
};

template <int axes>
constexpr Updates<axes> make_updates() {
    constexpr std::size_t half = Shape<axes>::half;
    Updates<axes> updates;
    std::size_t count = 0;
    for (std::size_t lower = 0; lower < half; ++lower) {
        updates.begin[lower] = count;
        const Step a = step_of<axes>(lower);
        for (std::size_t upper = half + 1; upper < row_size<axes>; ++upper) {
            const Step b = step_of<axes>(upper);
            for (std::size_t target = lower + 1; target < row_size<axes>; ++target) {
                const Step c = step_of<axes>(target);
                if (c[0] == a[0] + b[0] && c[1] == a[1] + b[1] && c[2] == a[2] + b[2]) {
                    updates.all[count++] = {upper, target};
                }
            }
        }
    }
    updates.begin[half] = count;
    return updates;
}

template <int axes>
std::array<std::ptrdiff_t, row_size<axes>> entry_offsets(const Strides& d) {
    std::array<std::ptrdiff_t, row_size<axes>> offsets{};
    for (std::size_t e = 0; e < row_size<axes>; ++e) {
        const Step s = step_of<axes>(e);
        offsets[e] = s[0] * d[0] + s[1] * d[1] + s[2] * d[2];
    }
    return offsets;
}

/// The coefficient with which the stencil takes the neighbour at `step`, times -1.
constexpr double entry_value(const Stencil& c, const Step& step) {
    std::array<std::size_t, 3> moved{};
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (step[axis] != 0) moved[count++] = axis;
    }
    if (count == 0) return 1;
    if (count == 1) return -(c.second[moved[0]] + step[moved[0]] * c.first[moved[0]]);
    const std::size_t plane = moved[0] + moved[1] - 1;
    return -step[moved[0]] * step[moved[1]] * c.mixed[plane];
}

/// A pivot this small would let the preconditioner amplify; the centre of the stencil is 1.
constexpr Entry least_pivot = 0.05F;

template <int axes>
void factor_rows(const NodeLattice& lattice, const Stencils& stencils, Entry* rows) {
    static constexpr Updates<axes> updates = make_updates<axes>();
    constexpr std::size_t half = Shape<axes>::half;
    const auto offsets = entry_offsets<axes>(lattice.strides);
    constexpr auto size = static_cast<std::ptrdiff_t>(row_size<axes>);
    for_interior(lattice, [&](std::size_t p) {
        Entry* row = rows + p * row_size<axes>;
        for (std::size_t e = 0; e < row_size<axes>; ++e) {
            row[e] = static_cast<Entry>(entry_value(stencils[p], step_of<axes>(e)));
        }
        for (std::size_t lower = 0; lower < half; ++lower) {
            const Entry* above = row + offsets[lower] * size;
            row[lower] *= above[half];
            for (std::size_t u = updates.begin[lower]; u < updates.begin[lower + 1]; ++u) {
                row[updates.all[u].target] -= row[lower] * above[updates.all[u].upper];
            }
        }
        row[half] = 1 / std::max(row[half], least_pivot);
    });
}

template <int axes>
void solve_rows(const NodeLattice& lattice, const Entry* rows, const Nodes& right_hand_side,
                Nodes& result) {
    constexpr std::size_t half = Shape<axes>::half;
    const auto offsets = entry_offsets<axes>(lattice.strides);
    for_interior(lattice, [&](std::size_t p) {
        const Entry* row = rows + p * row_size<axes>;
        Vec3 sum = right_hand_side[p];
        for (std::size_t e = 0; e < half; ++e) sum -= row[e] * (result.data() + p)[offsets[e]];
        result[p] = sum;
    });
    for_interior_backwards(lattice, [&](std::size_t p) {
        const Entry* row = rows + p * row_size<axes>;
        Vec3 sum = result[p];
        // The neighbour solved just before comes last, so that the processor need not wait for it.
        for (std::size_t e = row_size<axes> - 1; e > half; --e) {
            sum -= row[e] * (result.data() + p)[offsets[e]];
        }
        result[p] = row[half] * sum;
    });
}

}  // namespace

IncompleteLu::IncompleteLu(const NodeLattice& lattice)
    : lattice_(lattice),
      rows_(lattice.extent.nodes() * (lattice.axes == 2 ? row_size<2> : row_size<3>)) {}

void IncompleteLu::factor(const Stencils& stencils) {
    if (lattice_.axes == 2) {
        factor_rows<2>(lattice_, stencils, rows_.data());
    } else {
        factor_rows<3>(lattice_, stencils, rows_.data());
    }
}

void IncompleteLu::solve(const Nodes& right_hand_side, Nodes& result) const {
    if (lattice_.axes == 2) {
        solve_rows<2>(lattice_, rows_.data(), right_hand_side, result);
    } else {
        solve_rows<3>(lattice_, rows_.data(), right_hand_side, result);
    }
}

}  // namespace hexweave::bench
