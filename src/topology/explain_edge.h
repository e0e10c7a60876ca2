// SPDX-License-Identifier: Apache-2.0
// The chain by which an edge has its cells and its spacing, for `explain`.
#pragma once

#include <vector>

#include "topology/explain.h"

namespace hexweave {

/// How an edge runs, its cells, its spacing: steps in that order.
std::vector<ExplanationStep> explain_edge(const Case& written, const Topology& topology, int edge);

}  // namespace hexweave
