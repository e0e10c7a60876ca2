// SPDX-License-Identifier: Apache-2.0
// The table of the format as a reference in Markdown: docs/reference.md, and its parts for a
// terminal.
#pragma once

#include <string>
#include <vector>

namespace hexweave {

/// All of it: each mapping after the one that first holds it, each key with type, unit, default and
/// example, and links between them.
std::string format_reference();

/// What the reference says of a key or a mapping: the keys of that name wherever they stand, the
/// mapping of that name ("curve circle", "curve_circle"), and what these keys hold directly. Empty:
/// there is none.
std::string format_reference_of(const std::string& topic);

/// The topics of `format_reference_of`.
std::vector<std::string> reference_topics();

}  // namespace hexweave
