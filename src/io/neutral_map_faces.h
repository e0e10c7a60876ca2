// SPDX-License-Identifier: Apache-2.0
// Faces, directions and words of the neutral map file, as its reader and its writer know them.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "core/orientation.h"

namespace hexweave {

/// What comments of ours begin with.
inline constexpr const char* map_comment = "# hexweave: ";

/// The type of an interface whose two sides are not the same points: a word of ours, for programs
/// that know it not must not join them.
inline constexpr const char* periodic_word = "PERIODIC";

/// A face in the file's order: number 1 is the first of map_faces.
struct MapFace {
    Side side = Side::kmin;
    std::size_t primary = 0;  ///< axis
    std::size_t secondary = 1;
};
inline constexpr std::array<MapFace, 6> map_faces{{{Side::kmin, 0, 1},
                                                   {Side::kmax, 0, 1},
                                                   {Side::imin, 1, 2},
                                                   {Side::imax, 1, 2},
                                                   {Side::jmin, 2, 0},
                                                   {Side::jmax, 2, 0}}};

/// A type in the spelling in which words are compared: "one-to-one" is ONE_TO_ONE.
inline std::string map_word(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
        return c == '-' ? '_' : static_cast<char>(std::toupper(c));
    });
    return text;
}

}  // namespace hexweave
