// SPDX-License-Identifier: Apache-2.0
// Behind the one document of a file nothing may follow.
#pragma once

#include <yaml-cpp/parser.h>

#include "core/diagnostics.h"
#include "topology/source_text.h"

namespace hexweave {

/// Tells whatever follows the document that was parsed: yaml-cpp drops it without a word unless it
/// is asked for. False where there is something.
bool check_nothing_follows(YAML::Parser& parser, const SourcePlaces& places,
                           Diagnostics& diagnostics);

}  // namespace hexweave
