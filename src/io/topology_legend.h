// SPDX-License-Identifier: Apache-2.0
// What the lines in the drawing of a topology mean.
#pragma once

#include <vector>

#include "io/picture_drawing.h"
#include "topology/topology.h"

namespace hexweave {

/// Of the broad line under an edge at which a face is joined to itself.
inline constexpr Colour cut_colour{0.81, 0.81, 0.82};

/// By edge: whether a face is joined to itself there.
std::vector<bool> cut_edges(const Topology& topology);

/// Families, periodic interfaces and cuts, in rows that begin at `at` and end before `right`.
void append_legend(const Topology& topology, const PagePoint& at, double right, Drawing& drawing);

}  // namespace hexweave
