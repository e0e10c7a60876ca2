// SPDX-License-Identifier: Apache-2.0
// What can go wrong outside the input: the machine's failures, told with the path they concern.
#pragma once

#include <stdexcept>
#include <string>

namespace hexweave {

/// Exit codes of every command (design: scripts and CI depend on them).
enum class ExitCode : int {
    done = 0,
    not_sound = 1,      ///< the grid was made and written but is folded, not converged, ...
    wrong_input = 2,    ///< the input or the command line is wrong; nothing written
    machine_failed = 3  ///< disk full, no permission, out of memory; nothing written
};

/// The machine failed: a file could not be written, the disk is full, memory ran out. The message
/// names the path and the reason; exit code 3.
struct MachineError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file given on the command line is not what the command needs (missing, not CGNS); exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace hexweave
