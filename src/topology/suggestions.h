// SPDX-License-Identifier: Apache-2.0
// What a word that is not known was meant to be, for the hint of its message.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "topology/format_table.h"

namespace hexweave {

/// The known word that is spelled like it, means the same ("feet" for "ft"), or begins with it
/// ("wall" for "BCWall"); empty where there is none.
std::string meant_word(const std::string& word, const Keys& known);

/// "did you mean 'x'?", or else "LABEL a, b, c".
std::string suggestion(const std::string& word, const Keys& known, std::string_view label);

/// How a key is written: "as in 'start: 1e-5' (first cell)".
std::string usage_of(const KeyFormat& key);
/// How keys are written that stand together.
std::string usage_of(const std::vector<const KeyFormat*>& keys);

}  // namespace hexweave
