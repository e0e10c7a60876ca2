// SPDX-License-Identifier: Apache-2.0
// What a CAD file holds, for people and for programs.
#pragma once

#include <string>

#include "geometry/cad.h"

namespace hexweave {

/// A line or two per surface and curve and, when asked for, one per edge. `name` is the file's.
std::string to_text(const CadFile& file, const std::string& name, bool with_edges);

/// The same as one JSON object, edges included (docs/json.md).
std::string to_json(const CadFile& file, const std::string& name);

}  // namespace hexweave
