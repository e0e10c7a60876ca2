// SPDX-License-Identifier: Apache-2.0
// Sets of nodes (or cells) of a grid as runs along i: what a patch is made of. Work on a set is in
// proportion to its runs, never to the grid.
#pragma once

#include <cstddef>
#include <vector>

#include "core/field.h"
#include "core/orientation.h"

namespace hexweave {

/// Members i = first ... last of row (j, k).
struct Run {
    int k = 0;
    int j = 0;
    int first = 0;
    int last = 0;

    friend bool operator==(const Run&, const Run&) = default;
    int length() const { return last - first + 1; }
};

/// Ascending in (k, j, first); no two of a row touch.
using Runs = std::vector<Run>;

/// Runs in that order, those that touch or overlap as one.
Runs merged(Runs runs);

/// How far a set grows along each axis.
struct Reach {
    Node below{};
    Node above{};
};

/// All members within reach of a member, clipped to low <= (i, j, k) <= high.
Runs grown(const Runs& runs, const Reach& reach, const Node& low, const Node& high);

/// The position of the run that holds (i, j, k), or that of the next one.
std::size_t find_run(const Runs& runs, int i, int j, int k);

/// The sets that are not connected: two members are, when they differ by at most one along every
/// axis.
std::vector<Runs> connected_parts(const Runs& runs);

std::size_t count_members(const Runs& runs);

/// The number of members before each run.
std::vector<int> run_starts(const Runs& runs);

}  // namespace hexweave
