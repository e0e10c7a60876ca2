// SPDX-License-Identifier: Apache-2.0
// What is wrong with the layout of a text that is not YAML: of the line where the parser gave up,
// and of the one before it, which is as often at fault.
#pragma once

#include <optional>

#include "core/diagnostics.h"
#include "topology/source_text.h"

namespace hexweave {

/// A colon without a space behind it, or lines that are indented differently; nothing where the
/// lines about `offset` show neither.
std::optional<Diagnostic> layout_fault(const SourcePlaces& places, std::size_t offset);

}  // namespace hexweave
