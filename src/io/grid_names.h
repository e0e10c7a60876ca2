// SPDX-License-Identifier: Apache-2.0
// What a user names of a grid, found in it, or told what there is.
#pragma once

#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/picture.h"

namespace hexweave {

/// "the grid has no zone 'wnig'; did you mean 'wing'?", or with a list of those that it has.
std::string unknown_in_grid(const std::string& kind, const std::string& name,
                            const std::vector<std::string>& known);

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& things) {
    std::vector<std::string> names;
    names.reserve(things.size());
    for (const Named& thing : things) names.push_back(thing.name);
    return names;
}

/// The zones in which an index plane lies: one, or all where it names none. Throws UsageError for
/// an unknown zone and for an index that a zone does not have.
std::vector<int> zones_of_plane(const MultiblockGrid& grid, const IndexPlane& plane);

}  // namespace hexweave
