// SPDX-License-Identifier: Apache-2.0
// How long the text of a case may be (what is longer is not a case, or points that belong into
// files of their own), and the names in it.
#pragma once

#include <cstddef>

namespace hexweave {

inline constexpr std::size_t longest_text = std::size_t{16} << 20U;  ///< bytes
inline constexpr std::size_t longest_name_given = 200;               ///< bytes

}  // namespace hexweave
