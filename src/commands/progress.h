// SPDX-License-Identifier: Apache-2.0
// Progress of a run: a bar per stage on a terminal, plain lines elsewhere, both on standard error.
#pragma once

#include "generate.h"

namespace hexweave {

/// Prints nothing when `quiet`. On a terminal one line is redrawn per stage; elsewhere a stage says
/// a line when it begins, so that a log shows where a long run is.
Progress make_progress(bool quiet);

}  // namespace hexweave
