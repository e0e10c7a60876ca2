// SPDX-License-Identifier: Apache-2.0
// Work that may crash, in a process of its own.
#pragma once

#include <functional>
#include <string>

namespace hexweave {

/// What the work returned, or, in words, how its process ended before it did.
struct ChildResult {
    std::string bytes;
    std::string fault;
};

/// Runs the work in a copy of this process, whose output goes nowhere, and waits for it. It is
/// ended when it has used `most_seconds` of processor time. Throws MachineError when no process can
/// be had. Not to be called while other threads run.
ChildResult run_in_child(const std::function<std::string()>& work, int most_seconds);

}  // namespace hexweave
