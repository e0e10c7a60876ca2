// SPDX-License-Identifier: Apache-2.0
// Which temporary files a signal must remove: a table that a signal handler may read, because
// nothing in it is ever allocated.
#pragma once

#include <filesystem>

namespace hexweave {

/// While one of these lives, a signal that would end the process waits. Not to be nested.
class SignalsHeld {
public:
    SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld();
};

/// Registers an absolute path for removal; returns its slot, or -1 when the table is full or the
/// path too long for it.
int register_temporary(const std::filesystem::path& absolute_path);
void forget_temporary(int slot);

}  // namespace hexweave
