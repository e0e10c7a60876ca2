// SPDX-License-Identifier: Apache-2.0
// What a solve came to: returned, never printed and lost.
#pragma once

#include <optional>
#include <vector>

#include "core/vec3.h"

namespace hexweave {

enum class SolveStatus {
    algebraic,      ///< nothing was solved, as asked
    converged,      ///< the estimated remaining displacement is below the tolerance, or is rounding
    not_converged,  ///< the cycles ran out; the best iterate was kept
    diverged,       ///< the iterates left the range of numbers; the best iterate was kept
};

/// What the solver fell back on, in the order in which it is tried.
enum class Safeguard {
    damping,          ///< cycles with relaxed corrections
    anderson_picard,  ///< accelerated Picard steps with multigrid as the linear solver
    krylov_picard,    ///< damped Picard steps with a Krylov solver
};

/// Where and how far points were moved to turn folded cells the right way round.
struct Untangling {
    long folded_before = 0;  ///< cells, of the elliptic grid
    long points_moved = 0;
    double largest_move = 0;      ///< distance
    Vec3 place;                   ///< of the largest move
    int patches = 0;              ///< regions that were worked on
    int rounds = 0;               ///< how often a patch had to grow
    bool whole_grid = false;      ///< patches were not enough: every interior point was free
    std::optional<Vec3> left_at;  ///< a node of the first cell that is still folded
};

/// How the passes that make a grid orthogonal at its boundary ended.
enum class OrthogonalityEnd {
    all_passes,           ///< as many as were asked, or more
    edges_not_converged,  ///< the harmonic edge functions were not found
    not_converged,        ///< the grid of the next pass (before the first, the grid itself)
    folded,               ///< likewise: it has folded cells
};

/// What was done to make grid lines meet sides at right angles. The grid is that of the last pass
/// that ended well; with none, of the straight-line map.
struct Orthogonality {
    int passes = 0;
    int passes_asked = 0;
    int edge_cycles = 0;  ///< multigrid cycles for the edge functions, all passes
    /// Intervals of edges, in the last pass, whose edge function had to be kept from decreasing:
    /// the grid was slanting too much there. While there are some, more passes are made than asked.
    int limited = 0;
    OrthogonalityEnd end = OrthogonalityEnd::all_passes;
};

struct SolveResult {
    SolveStatus status = SolveStatus::algebraic;
    int cycles = 0;
    double tolerance = 0;     ///< asked, in cells
    double displacement = 0;  ///< of the last cycle, in cells
    double rate = 0;          ///< by which the displacement fell in each of the last cycles
    /// Displacement of every cycle, in cells; on a surface, of every pass of several cycles.
    std::vector<double> history;
    std::vector<Safeguard> safeguards;  ///< those entered, in order
    /// Where it did not converge, the cycle whose grid was kept, counted from 1: the one with the
    /// fewest folded cells and, among those, the smallest displacement. 0: the start grid.
    std::optional<int> kept_cycle;
    long folded_before = 0;  ///< folded cells of the start grid
    long folded_after = 0;   ///< of the finished one
    std::optional<Untangling> untangling;
    std::optional<Orthogonality> orthogonality;  ///< where it was asked for
};

const char* status_name(SolveStatus status);
const char* safeguard_name(Safeguard safeguard);
/// "all passes done", "the grid is folded", ...
const char* orthogonality_end_name(OrthogonalityEnd end);

}  // namespace hexweave
