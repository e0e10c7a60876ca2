// SPDX-License-Identifier: Apache-2.0
// How far the points of one zone are from those of another, in cells.
#pragma once

#include <cstddef>

#include "quality/point_source.h"

namespace hexweave {

/// How far a point may be off: `tolerance` of the local cell, whose size is the shortest of the
/// edges that meet at the golden grid's point (those no longer than `floor`, of poles, do not
/// count; `floor` where none does); never less than `floor`, a length. Lengths are multiplied by
/// `scale` before they are squared.
struct Allowance {
    double tolerance = 1e-4;
    double floor = 0;
    double scale = 1;
};

/// The allowance for a golden grid in this box: the floor is 4 machine epsilons of its diagonal.
/// Throws UsageError where the box is too large for double precision.
Allowance allowance(double tolerance, const PointBox& golden);

/// One deviation: its size, the candidate's node and the golden grid's point.
struct Deviation {
    double size = 0;
    Node node{};
    Vec3 place;
};

/// All deviations of a zone. A coordinate that is no finite number deviates infinitely.
struct ZoneDeviation {
    std::size_t points = 0;
    std::size_t beyond = 0;      ///< points farther off than allowed
    std::size_t not_finite = 0;  ///< of those, the ones that are no finite numbers
    Deviation in_cells;          ///< the largest in local cells
    Deviation in_length;         ///< the largest in length units
};

/// Both of two parts of a zone; of equal deviations that of the first.
ZoneDeviation together(const ZoneDeviation& first, const ZoneDeviation& second);

/// Compares the points of portion.core. `golden` covers portion.with_neighbours; `candidate` holds
/// the same nodes as the core, of a zone of extent `candidate_extent` whose axes `to_candidate`
/// gives.
ZoneDeviation compare_points(const Portion& portion, const Piece& golden, const Piece& candidate,
                             const Orientation& to_candidate, const Extent& candidate_extent,
                             const Allowance& allowed);

}  // namespace hexweave
