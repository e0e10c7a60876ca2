// SPDX-License-Identifier: Apache-2.0
// The files that the commands on a config read and write: `run`, `check` and `graph`.
#pragma once

#include <string>
#include <vector>

#include "commands/case_options.h"
#include "core/grid_output.h"
#include "io/file_uses.h"
#include "topology/case.h"
#include "topology/topology.h"

namespace hexweave {

/// The config, and the files that it names.
std::vector<FileUse> files_of_case(const CaseOptions& options, const Case& written);

/// Refuses outputs as the other require_apart, the file of --json among them; notes in the outcome
/// where it is that one which must not be written.
void require_apart(FileUses uses, const CaseOptions& options, Outcome& outcome);

/// Reads the config, and refuses a --json that would overwrite what was read.
Case read_case_of(const CaseOptions& options, Outcome& outcome);

/// Where the grid of a topology goes: `given` (each an -o), else what the file's `output` says,
/// else the config's stem, in the names of levels where --level asks for it; nowhere for a config
/// from standard input that does not say. Throws UsageError for a name of no format.
std::vector<GridOutput> outputs_of(const CaseOptions& options,
                                   const std::vector<std::string>& given, const Topology& topology);

/// The files that one grid is written to, and the folder of what ends folded or unconverged.
std::vector<FileUse> files_of_outputs(const std::vector<GridOutput>& outputs,
                                      const std::string& role);

/// An output under a name of its level: "wing.cgns" as "wing.fine.cgns", the folder "wing" as
/// "wing.fine".
GridOutput output_of_level(GridOutput output, const std::string& level);

}  // namespace hexweave
