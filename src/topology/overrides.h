// SPDX-License-Identifier: Apache-2.0
// Parameters that the command line gives other values: `--set chord=2`, and `--set slat.chord=2`
// for one of an instance, under its qualified name.
#pragma once

#include <vector>

#include "topology/case.h"
#include "topology/instances.h"
#include "topology/read_case.h"
#include "topology/read_values.h"

namespace hexweave {

/// Notes the overrides in `reading`, by name, each as a node of a source of its own, so that its
/// faults show the argument. Tells those given twice.
void note_overrides(Reading& reading, const std::vector<Override>& overrides);

/// Tells overrides of parameters that neither the case nor an instance has. Those of instances are
/// judged only where nothing else is wrong: else it may be the instance that could not be made.
void tell_unknown_overrides(Reading& reading, const std::vector<Parameter>& parameters,
                            const Instances& instances);

}  // namespace hexweave
