// SPDX-License-Identifier: Apache-2.0
// A multiblock grid without its points: what is known of a file before its coordinates are read.
#pragma once

#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave {

struct ZoneOutline {
    std::string name;
    Extent extent;
    int number = 0;  ///< in its file, from 1

    friend bool operator==(const ZoneOutline&, const ZoneOutline&) = default;
};

/// Nodes of a file, all of one kind, whose contents were not read.
struct OtherNodes {
    std::string kind;   ///< the CGNS label: "FlowSolution_t"
    std::string first;  ///< the path of the first: "/Base/wing/FlowSolution"
    std::size_t count = 0;
};

/// The two ends of one interface as a file has them, each seen from its own zone.
struct TwoEnds {
    Interface first;
    Interface second;
};

/// As MultiblockGrid, whose members of the same names say more.
struct GridOutline {
    std::string title;
    std::string units;
    int cell_dimension = 3;
    int physical_dimension = 3;
    std::vector<ZoneOutline> zones;
    std::vector<Interface> interfaces;
    std::vector<Family> families;
    std::vector<BoundaryPatch> patches;
    std::string provenance;
    std::vector<OtherNodes> others;
    /// Of those interfaces whose ends do not say, to the bit, that the one is the way back of the
    /// other; `interfaces` has their first ends.
    std::vector<TwoEnds> ends_apart;
};

}  // namespace hexweave
