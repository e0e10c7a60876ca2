// SPDX-License-Identifier: Apache-2.0
// The faults that yaml-cpp finds, in the words of someone who writes a case.
#pragma once

#include <yaml-cpp/exceptions.h>

#include <optional>

#include "core/diagnostics.h"
#include "topology/source_text.h"

namespace hexweave {

/// Tells a syntax error; `inside` says which bracket is still open there.
void tell_syntax_error(const YAML::Exception& fault, const SourcePlaces& places,
                       const std::optional<Note>& inside, Diagnostics& diagnostics);

}  // namespace hexweave
