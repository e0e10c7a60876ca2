// SPDX-License-Identifier: Apache-2.0
// Stage 1: the YAML file into a Case.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "topology/case.h"

namespace hexweave {

/// One `--set NAME=EXPR` of the command line.
struct Override {
    std::string name;
    std::string expression;
};

/// Reads and checks the syntax, keys, types and ranges of a file of format 1, evaluates its
/// expressions and builds its curves. Files that it names are found relative to `source->name`'s
/// folder (the working directory for standard input, named "<stdin>"). All faults go to
/// `diagnostics`; the Case is usable as far as it could be read, so that resolving may find more.
Case read_case(const std::shared_ptr<const SourceFile>& source,
               const std::vector<Override>& overrides, Diagnostics& diagnostics);

}  // namespace hexweave
