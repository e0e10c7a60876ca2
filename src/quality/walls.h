// SPDX-License-Identifier: Apache-2.0
// The first cells at the walls: how upright they stand and how high they are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// The first intervals of the grid lines that leave a family of walls. Heights are their lengths,
/// at every node of its patches (those without length, of poles, do not count). Angles are degrees
/// from the wall's normal (in a surface grid: from its normal within the surface; in a zone one
/// cell thick: within the section), at every node but those on the ends of patches, where edges
/// give the line, and those where a side is collapsed, which has no normal; nodes beside an end,
/// where a grid line may be squeezed by a corner, are counted apart.
struct WallMeasure {
    std::string family;
    std::size_t nodes = 0;  ///< at which angles are measured, not beside an end; 0: none are
    double mean_angle = 0;
    double greatest_angle = 0;
    Vec3 worst_place;
    double greatest_angle_beside_ends = 0;
    double least_height = 0;
    double median_height = 0;
    double greatest_height = 0;
};

/// Whether the type of a family is BCWall or begins so.
bool is_wall(const Family& family);

/// One measure for every family that is a wall, of its patches that count; of all by default.
std::vector<WallMeasure> measure_walls(
    const MultiblockGrid& grid,
    const std::function<bool(const BoundaryPatch&)>& counts = [](const auto&) { return true; });
/// One for every family.
std::vector<WallMeasure> measure_boundaries(const MultiblockGrid& grid);

}  // namespace hexweave
