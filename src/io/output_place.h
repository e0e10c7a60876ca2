// SPDX-License-Identifier: Apache-2.0
// Where a file or folder that is to be written would stand, looked at without making anything. A
// path that cannot be meant (no such folder, a folder where a file must be) is wrong input, a
// UsageError; what the system refuses (no permission) is a MachineError. Both name the path.
#pragma once

#include <filesystem>
#include <string>

namespace hexweave {

/// The place of a file: links are followed, its folder has none and exists. The file there is
/// regular and may be replaced, or there is none yet. Throws UsageError, MachineError.
std::filesystem::path place_of_file(const std::filesystem::path& given);

/// Whether a folder has yet to be made. Throws UsageError when something else has its name, or when
/// there is no folder that it could be made in; MachineError.
bool folder_is_missing(const std::filesystem::path& folder);

/// The folder that a path stands in: "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Throws MachineError: "cannot write 'PATH': REASON".
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& reason);

/// The reason of a failed system call in lower case: "permission denied".
std::string error_reason(int error_number);

}  // namespace hexweave
