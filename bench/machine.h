// SPDX-License-Identifier: Apache-2.0
// What the machine can do, and what this process takes of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hexweave::bench {

/// The processor's name and the compiler and flags of this build, for the head of the report.
std::string processor_name();
std::string build_description();

/// Bytes per second of a[n] = b[n] + f c[n] (24 bytes an iteration) on one thread, the best of
/// several passes over arrays of `working_set` bytes in all.
double triad_bandwidth(std::size_t working_set);

/// The growth of this process's peak resident memory since construction.
class PeakMemory {
public:
    PeakMemory();
    /// 0 where the system does not say.
    double bytes() const;

private:
    double before_ = 0;
};

/// Large arrays go back to the system when they are freed, so that peaks can be told apart.
void return_freed_memory();

/// What came of a program that was run and waited for.
struct ProgramRun {
    int exit_code = -1;
    double seconds = 0;
    double peak_bytes = 0;
};

/// Runs a program, its outputs discarded.
ProgramRun run_program(const std::vector<std::string>& arguments);

}  // namespace hexweave::bench
