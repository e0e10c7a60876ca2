// SPDX-License-Identifier: Apache-2.0
// Where a resolved entity has its cell count, spacing, direction and orientation from: a chain of
// names and places in the file, for `hexweave check --explain NAME`.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "topology/case.h"
#include "topology/topology.h"

namespace hexweave {

/// One fact about an entity, and the place in the file that it follows from.
struct ExplanationStep {
    Place place;
    std::string text;
};

/// An entity, and all that is known of it.
struct Explanation {
    std::string title;  ///< "edge 'wake'"
    std::vector<ExplanationStep> steps;
};

/// Every instance, part of a port, vertex, edge, face, block, boundary of this name (different
/// kinds may share one), made edges and faces in any spelling of their names. Empty where there is
/// none in the grid.
std::vector<Explanation> explain(const Case& written, const Topology& topology,
                                 const std::string& name);

/// What `explain` knows, each name once, sorted.
std::vector<std::string> explained_names(const Case& written, const Topology& topology);

/// As `check` prints it: the title, and a line for each step.
std::string to_text(const Explanation& explanation);

}  // namespace hexweave
