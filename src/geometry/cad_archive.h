// SPDX-License-Identifier: Apache-2.0
// The contents of a CAD file as bytes, to be handed from process to process of one program.
#pragma once

#include <string>

#include "geometry/cad.h"

namespace hexweave {

std::string pack(const CadResult& result);

/// Precondition: pack() made the bytes.
CadResult unpack(const std::string& bytes);

}  // namespace hexweave
