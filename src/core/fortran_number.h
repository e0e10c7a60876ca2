// SPDX-License-Identifier: Apache-2.0
// Numbers as C and Fortran programs write them into text files.
#pragma once

#include <optional>
#include <string_view>

namespace hexweave {

struct FortranNumber {
    double value = 0;
    bool out_of_range = false;  ///< more than a double holds: the value is zero or infinite
};

/// 1.5, +2, 1.5D+01; nothing where the word is no number.
std::optional<FortranNumber> fortran_number(std::string_view word);

}  // namespace hexweave
