// SPDX-License-Identifier: Apache-2.0
#include "core/fortran_number.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

namespace hexweave {

std::optional<FortranNumber> fortran_number(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    std::string with_e;
    if (word.find_first_of("dD") != std::string_view::npos) {
        with_e = word;
        std::replace_if(
            with_e.begin(), with_e.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
        word = with_e;
    }
    FortranNumber number;
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, number.value);
    if (end != last || word.empty()) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        number.value = std::strtod(std::string(word).c_str(), nullptr);
        number.out_of_range = true;
    } else if (error != std::errc{}) {
        return std::nullopt;
    }
    return number;
}

}  // namespace hexweave
