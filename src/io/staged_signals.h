// SPDX-License-Identifier: Apache-2.0
// Which temporary files and folders a signal must remove: a table that a signal handler may read,
// because nothing in it is ever freed.
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

/// Registers the absolute path of a file, or of a folder that goes when it is empty then, for
/// removal; returns its slot, or -1 when the path is too long.
int register_temporary(const std::filesystem::path& absolute_path);
void forget_temporary(int slot);

}  // namespace hexweave
