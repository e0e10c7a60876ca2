// SPDX-License-Identifier: Apache-2.0
// Heights held at one side of a face or block: after the solve the points near the side move along
// the grid lines that leave it, until the first cells are as high as asked.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/field.h"
#include "core/orientation.h"
#include "topology/case.h"

namespace hexweave {

/// Lines that leave a side and stop short of the height asked, by what stops them.
struct StoppedLines {
    int growth = 0;  ///< cells on them would grow faster than they may
    int fade = 0;    ///< their first cell reaches beyond the fade distance
    int folds = 0;   ///< cells beside them would fold
};

/// What was asked of one side: a height for every node of it, over the side's own two axes (a face
/// has one: the second extent is 1).
struct HeldSide {
    Side side = Side::jmin;
    double fade = 0;  ///< the distance from the side at which points stay as they are
    Field asked;
    std::optional<double> height{};  ///< asked everywhere; that of the edges where absent
    int first = 1;                   ///< the node off the side whose height is meant
    StoppedLines stopped{};
};

/// The heights asked of node `first` off a side: everywhere the given one; or else, from those on
/// the lines that leave the side's corners (the edges of the face or block), interpolated linearly
/// in the logarithm of the height over the side's normalized arc lengths.
Field asked_heights(const PointField& points, Side side, const std::optional<double>& height,
                    int first = 1);

/// What is asked of the grid of every `stride`-th point of these. A height that is given is that of
/// node `held.first`; node `stride` is asked that times the ratio of the two heights on the lines
/// that leave the corners, as their laws say, interpolated likewise.
HeldSide every_nth(const PointField& points, const HeldSide& held, int stride);
std::vector<HeldSide> every_nth(const PointField& points, const std::vector<HeldSide>& held,
                                int stride);

/// Moves interior points of a face or block along the grid lines that leave `side`. Boundary points
/// stay: where the first cell on one of the neighbouring sides is not as asked, lines beside it
/// begin with that side's height and come to the asked one within the fade distance along the wall.
/// Away from the wall the factors of neighbouring lines are smoothed (see FactorLayer).
/// A line moves less than asked, or not at all, where its points would not ascend or would grow
/// faster than request.growth (see feasible_part), and where cells would fold that did not before.
HeldSide hold_heights(PointField& points, Side side, const HeldHeights& request);

/// All sides asked for, in order.
std::vector<HeldSide> hold_heights(PointField& points, const HeightRequests& requests);

/// The first cell's height over the asked one, at a node of a side.
struct HeightRatio {
    double value = 1;
    Vec3 place;  ///< of the node
};

/// That of every node (a, b) of the side that counts, in ascending order.
std::vector<HeightRatio> height_ratios(const PointField& points, const HeldSide& held,
                                       const std::function<bool(int, int)>& counts);
std::vector<HeightRatio> height_ratios(const PointField& points, const HeldSide& held);

}  // namespace hexweave
