// SPDX-License-Identifier: Apache-2.0
// What is asked of the solver, and the sizes at which it is asked.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/field.h"

namespace hexweave::bench {

struct Case {
    std::string problem;
    Extent extent;
};

/// How many times faster than the best of each family, to 1e-4 of a cell. 0: nothing is asked.
struct Demand {
    Case where;
    double hypre = 0;
    double slor = 0;
    double ilu = 0;

    double of(const std::string& family) const {
        return family == "hypre" ? hypre : family == "SLOR" ? slor : ilu;
    }
};

inline const std::vector<Demand> demands{
    {{"A", {513, 257, 1}}, 8, 30, 30},   {{"B17", {513, 257, 1}}, 35, 25, 50},
    {{"W", {129, 65, 49}}, 20, 8, 6},    {{"OO", {129, 65, 49}}, 20, 8, 6},
    {{"W", {129, 129, 97}}, 20, 15, 10},
};

/// Sizes besides, at which the full bench compares too.
inline const std::vector<Case> further_cases{
    {"A", {129, 65, 1}},    {"A", {257, 129, 1}},    {"A", {1025, 513, 1}}, {"B17", {129, 65, 1}},
    {"B17", {257, 129, 1}}, {"B17", {1025, 513, 1}}, {"W", {65, 65, 49}},   {"OO", {33, 33, 33}},
    {"OO", {129, 129, 97}}, {"C", {65, 65, 65}},
};

/// Cycles to 1e-4 of a cell at every size: at most this many.
inline constexpr int most_cycles_asked = 10;
inline const std::vector<Case> cycle_cases{
    {"A", {33, 17, 1}},    {"A", {65, 33, 1}},     {"A", {129, 65, 1}},    {"A", {257, 129, 1}},
    {"A", {513, 257, 1}},  {"A", {1025, 513, 1}},  {"B17", {33, 17, 1}},   {"B17", {65, 33, 1}},
    {"B17", {129, 65, 1}}, {"B17", {257, 129, 1}}, {"B17", {513, 257, 1}}, {"B17", {1025, 513, 1}},
    {"W", {33, 33, 33}},   {"W", {65, 65, 49}},    {"W", {129, 65, 49}},   {"W", {129, 129, 97}},
    {"OO", {33, 33, 33}},  {"OO", {65, 65, 49}},   {"OO", {129, 65, 49}},  {"OO", {129, 129, 97}},
    {"C", {33, 33, 33}},   {"C", {65, 65, 65}},    {"C", {129, 129, 129}},
};

/// No folded cell at the end, from either start. B19 has more than one discrete solution: to
/// converge, unfolded, is what is asked there.
inline const std::vector<Case> fold_cases{
    {"A", {257, 129, 1}},    {"B17", {257, 129, 1}}, {"B19", {129, 65, 1}}, {"B19", {257, 129, 1}},
    {"Scherk", {65, 65, 1}}, {"W", {65, 65, 49}},    {"OO", {33, 33, 33}},  {"OO", {129, 65, 49}},
    {"C", {33, 33, 33}},     {"C", {65, 65, 65}},
};

/// Untangling in patches: parts of the solve's time and of the points, and how much larger the size
/// ratio may be where points moved.
inline constexpr double most_untangling_cost = 0.05;
inline constexpr double most_points_moved = 0.02;
inline constexpr double seam_slack = 1.05;

/// Time of a cycle on a block over that of its memory traffic, gain of a second thread, and bytes
/// of a whole run per point.
inline const Case large_block{"W", {129, 129, 97}};
inline constexpr double most_over_bandwidth = 3;
inline constexpr double least_gain_of_two_threads = 1.8;
inline constexpr double most_bytes_of_run = 250;

}  // namespace hexweave::bench
