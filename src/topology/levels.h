// SPDX-License-Identifier: Apache-2.0
// Families of grids from one file: the counts in it are those of the level `medium`. At a whole
// factor the finest level is solved and the others are every 2nd, 4th, ... point of it; at any
// other each level is solved on its own, its cells at walls scaled like its counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "topology/case.h"
#include "topology/topology.h"

namespace hexweave {

/// The level whose counts stand in the file.
inline constexpr const char* middle_level = "medium";
/// What stands for every level on the command line.
inline constexpr const char* every_level = "all";

/// The family that a case is of, its level the one to be solved: nothing where the case names
/// neither levels nor a level.
std::optional<GridFamily> family_of(const Case& c);

/// The case with its first cells, ratios and heights as they are at the level to be solved.
Case scaled_to_level(const Case& c, const GridFamily& family);

/// Marks heights as those of the level `medium` in the finest grid: of the node where its first
/// cell ends.
void refine_heights(HeightRequests& heights, const GridFamily& family);

/// The topology of one level of a family, of that of the level that is solved: fewer cells, the
/// level named in the provenance. Precondition: the same level, or nested and not finer.
Topology at_level(const Topology& solved, std::size_t level);

}  // namespace hexweave
