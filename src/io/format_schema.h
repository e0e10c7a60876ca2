// SPDX-License-Identifier: Apache-2.0
// The table of the format as a JSON Schema, for editors (completion, hover texts, faults while
// typing) and for programs that write cases. It holds what a case looks like: keys, types, words,
// names, limits of literal numbers. What needs values (references, expressions, cell counts) is
// `hexweave check`'s.
#pragma once

#include <string>

namespace hexweave {

/// JSON Schema 2020-12 of a whole case, every mapping of the table a definition of its name.
std::string format_schema();

}  // namespace hexweave
