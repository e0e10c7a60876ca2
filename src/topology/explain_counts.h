// SPDX-License-Identifier: Apache-2.0
// Where cells come from, as far back as what the file says: across faces from edge to edge, by
// sums over sides, and what a level or a multiple made of it.
#pragma once

#include <string>
#include <vector>

#include "topology/explain_chains.h"

namespace hexweave {

/// "1 cell", "12 cells"
std::string cells_text(int cells);

/// Where an edge has its cells from.
void explain_cells(const Case& written, const Chains& chains, int edge,
                   std::vector<ExplanationStep>& steps);

/// Where the cells along a chain of edges come from, each edge's own apart.
void explain_cells_along(const Case& written, const Chains& chains, const std::string& axis,
                         const std::vector<EdgeUse>& edges, const Place& place,
                         std::vector<ExplanationStep>& steps);

}  // namespace hexweave
