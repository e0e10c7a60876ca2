// SPDX-License-Identifier: Apache-2.0
// The door between the program and the module that holds Open CASCADE.
#pragma once

#include "geometry/cad.h"
#include "geometry/cad_text.h"

namespace hexweave {

using ReadPreparedCad = void(const CadText& text, CadResult& result);

/// The name of the module's one function, of the type above. It never throws.
inline constexpr const char* read_prepared_cad_name = "hexweave_read_prepared_cad";

}  // namespace hexweave
