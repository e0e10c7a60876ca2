// SPDX-License-Identifier: Apache-2.0
// The faults that yaml-cpp finds, in the words of someone who writes a case.
#pragma once

#include <yaml-cpp/exceptions.h>

#include <cstddef>
#include <optional>

#include "core/diagnostics.h"
#include "topology/source_text.h"

namespace hexweave {

/// Tells a syntax error; `inside` says which bracket is still open there.
void tell_syntax_error(const YAML::Exception& fault, const SourcePlaces& places,
                       const std::optional<Note>& inside, Diagnostics& diagnostics);

/// Tells a key that is longer than YAML allows, and ends before a ':' at `offset` or begins there:
/// yaml-cpp takes it for no key and finds other faults in what follows. False where there is none.
bool tell_long_key(std::size_t offset, const SourcePlaces& places, Diagnostics& diagnostics);

}  // namespace hexweave
