// SPDX-License-Identifier: Apache-2.0
// Entries of the table of the format in words, for its schema and its reference.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "topology/format_table.h"

namespace hexweave {

/// Whether what holds without the key is a value of it (`1e-3`, `tanh`), and not told in words.
bool has_literal_default(const KeyFormat& key);

/// The name of a mapping as people read it: "curve circle".
std::string format_title(std::string_view name);

/// How a mapping is named in a type: plainly, or as a link.
using MappingText = std::function<std::string(std::string_view name)>;

/// The forms of a key's value, with units: "length > 0 (`units`) or list of 2: number".
std::string type_of(const std::vector<ValueForm>& forms, const MappingText& mapping);

/// "First cell. Length > 0 (`units`). Without it: free."
std::string description_of(const KeyFormat& key);

}  // namespace hexweave
