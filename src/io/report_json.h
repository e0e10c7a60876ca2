// SPDX-License-Identifier: Apache-2.0
// The outcome of a run as programs read it: one JSON object, schema version 1 (docs/json.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "io/offender_files.h"
#include "io/planned_grid.h"
#include "quality/report.h"
#include "topology/case.h"

namespace hexweave {

/// What a command came to; the report is absent when no grid was made.
struct Outcome {
    std::string command;  ///< "run" or "check"
    std::string config;   ///< as named on the command line
    int exit_code = 0;
    bool json_refused = false;            ///< this is not to be written: its file is another's
    std::vector<std::string> outputs;     ///< files that were written
    std::vector<OffenderFile> offenders;  ///< likewise, of what ended folded or unconverged
    Diagnostics diagnostics;
    std::string failure;                ///< what the machine failed at; empty when it did not
    std::vector<PlannedGrid> grids;     ///< that were resolved
    std::optional<Report> report;       ///< of the finest, where several levels were made
    std::vector<Report> levels{};       ///< of each, coarsest first, where several were made
    std::vector<Parameter> parameters;  ///< of the case, where it could be read
};

/// Indented by two spaces, ends with a newline. Numbers that are not finite are null.
std::string to_json(const Outcome& outcome);

}  // namespace hexweave
