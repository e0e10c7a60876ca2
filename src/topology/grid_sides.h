// SPDX-License-Identifier: Apache-2.0
// The sides of the grid as boundaries and periodic interfaces see them: edges of faces, or faces of
// blocks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

struct GridSides {
    std::string kind;                     ///< "edge" or "face"
    std::string user;                     ///< "face" or "block"
    std::vector<std::vector<int>> users;  ///< for every side the faces (blocks) that have it
    std::vector<std::string> names;       ///< of the sides
    std::vector<Place> places;            ///< of the sides
    std::vector<std::string> names_of_users;
    std::vector<int> collapsed;  ///< 0, or by how many dimensions a side is less than the others
};

GridSides grid_sides(const Network& network);

/// "faces 'a' and 'b'": each once.
std::string users_text(const GridSides& sides, const std::vector<int>& users);

/// What sides are named for, as messages call it: "a boundary", "boundaries".
struct SideOwner {
    const char* one;
    const char* many;
};

/// The side of a name, which is one of the grid; nothing after an error, or where its own fault has
/// been told.
std::optional<int> find_side(const Network& network, const GridSides& sides, const Name& name,
                             const SideOwner& owner, Diagnostics& diagnostics);

}  // namespace hexweave
