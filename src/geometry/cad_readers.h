// SPDX-License-Identifier: Apache-2.0
// IGES and STEP by Open CASCADE. Inside the module of CAD files only.
#pragma once

#include <stdexcept>
#include <string>

#include "geometry/cad.h"
#include "geometry/cad_text.h"
#include "geometry/length_units.h"

namespace hexweave {

/// What is wrong with a file, in words.
struct CadFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The contents of a file, its entities in ascending order. Throws CadFault, or what Open CASCADE
/// throws.
CadFile read_iges(const CadText& text);
CadFile read_step(const CadText& text);

/// Makes Open CASCADE convert lengths to that unit.
void convert_lengths_to(const LengthUnit& unit);

}  // namespace hexweave
