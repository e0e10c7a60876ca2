// SPDX-License-Identifier: Apache-2.0
// What is told of edges that lead another way than they should, where the order is right in which
// they are named.
#pragma once

#include <array>
#include <set>
#include <string>

#include "core/diagnostics.h"
#include "topology/crossings.h"
#include "topology/draft.h"

namespace hexweave {

/// Where crossings are told: each pair of edges once, however many faces it is in.
struct CrossingFaults {
    const Network& network;
    Diagnostics& diagnostics;
    std::set<std::array<int, 2>> told{};
};

/// Reports that edges of a face cross. `order`: what to write where it is their order that is at
/// fault; empty where it is not.
void tell_crossing(CrossingFaults& faults, const Face& face, const EdgeCrossing& crossing,
                   const std::string& order);

/// What to look at where corners are listed in order and yet lead the wrong way round: of these
/// edges the one that goes the longest way.
std::string corners_in_order(const Network& network, const std::set<int>& edges);

}  // namespace hexweave
