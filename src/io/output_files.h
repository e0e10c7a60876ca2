// SPDX-License-Identifier: Apache-2.0
// Files that appear whole under their final names or not at all, several together or none. While
// they are being written they stand beside their final places under temporary names, which are
// removed on failure and on SIGINT, SIGTERM and SIGHUP.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hexweave {

class OutputFiles {
public:
    OutputFiles() = default;
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;
    /// Removes what was not committed.
    ~OutputFiles();

    /// The temporary path to write `final_path` to. Throws MachineError, naming the path and the
    /// reason, when its folder is missing or not writable, or when the path is a folder.
    std::filesystem::path stage(const std::filesystem::path& final_path);
    /// Flushes every staged file to the disk and renames all of them into place. Throws
    /// MachineError and leaves no final path changed when a flush fails.
    void commit();

private:
    struct Staged {
        std::filesystem::path temporary;
        std::filesystem::path final_path;
    };
    std::vector<Staged> staged_;
};

/// Makes SIGINT, SIGTERM and SIGHUP remove the staged files before they end the process (which then
/// ends by that signal: 130 or 143 in a shell). Called once, by main.
void remove_staged_files_on_signals();

}  // namespace hexweave
