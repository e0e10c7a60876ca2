// SPDX-License-Identifier: Apache-2.0
// Files that appear whole under their final names or not at all, several together or none. While
// they are being written they stand beside their final places under temporary names, which are
// removed on failure and on SIGINT, SIGTERM and SIGHUP.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hexweave {

/// A file that is removed when this object ends, and when a signal ends the process.
class TemporaryFile {
public:
    /// Creates an empty file `.NAME.tmp.PID` in the folder of `neighbour`, whose file name is NAME.
    /// Throws MachineError in the name of `shown`, the path as the user knows it.
    TemporaryFile(const std::filesystem::path& neighbour, const std::filesystem::path& shown);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile(TemporaryFile&& other) noexcept;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    TemporaryFile& operator=(TemporaryFile&&) = delete;
    ~TemporaryFile();

    const std::filesystem::path& path() const { return path_; }
    /// The file is no longer temporary: it has been renamed.
    void release();

private:
    std::filesystem::path path_;
    int slot_ = -1;  ///< place in the table that the signal handler reads; -1: none
};

/// A folder that is removed when this object ends, and when a signal ends the process, if it is
/// empty then.
class TemporaryFolder {
public:
    /// Creates it; throws MachineError in the name of `path`.
    explicit TemporaryFolder(const std::filesystem::path& path);
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return path_; }
    /// The folder is to stay.
    void release();

private:
    std::filesystem::path path_;
    int slot_ = -1;
};

class OutputFiles {
public:
    OutputFiles() = default;
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles(OutputFiles&&) noexcept = default;
    OutputFiles& operator=(const OutputFiles&) = delete;
    OutputFiles& operator=(OutputFiles&&) = delete;
    /// Inner folders go before those around them.
    ~OutputFiles();

    /// Makes the folder unless it is there; with a failure, or without `commit`, it goes again.
    /// Throws UsageError when something else has the name or the folder around it is missing,
    /// MachineError when it cannot be made.
    void make_folder(const std::filesystem::path& folder);

    /// The temporary path to write `final_path` to. A link is followed: the file that it points to
    /// gets replaced, the link stays. Throws, naming the path and the reason, UsageError when its
    /// folder is missing, when the path is a folder or a device, or when the same file is staged
    /// twice; MachineError when the folder or an existing file may not be written.
    std::filesystem::path stage(const std::filesystem::path& final_path);

    /// Calls writer(temporary) for a path that `stage` gave. A MachineError that names the
    /// temporary path is thrown on in the name that the user gave.
    void write(const std::filesystem::path& temporary,
               const std::function<void(const std::filesystem::path&)>& writer) const;

    /// Has `commit` remove a file, and then its folder where that is left empty.
    void discard(const std::filesystem::path& path);

    /// Flushes every staged file to the disk, renames all of them into place and flushes their
    /// folders; what is to be removed goes with them. Throws MachineError when one of these steps
    /// fails; no final path has changed then.
    ///
    /// What is guaranteed: each single file is replaced in one step, whatever happens. Several
    /// files are replaced together unless the machine stops or the process is killed (SIGKILL)
    /// between two renames; other signals wait. Taking back a rename that succeeded needs the
    /// former file, kept as a hard link meanwhile; on a file system without hard links it cannot be
    /// taken back.
    void commit();

private:
    struct Staged {
        TemporaryFile temporary;
        std::filesystem::path given_path;  ///< as the user wrote it, for messages
        std::filesystem::path final_path;  ///< links followed
    };
    std::vector<TemporaryFolder> folders_;  // outlive what stands in them
    std::vector<Staged> staged_;
    std::vector<std::filesystem::path> discarded_;
};

/// Makes SIGINT, SIGTERM and SIGHUP remove the temporary files before they end the process (which
/// then ends by that signal: 130 or 143 in a shell); one that is ignored, as under nohup, stays so.
/// A file that exceeds the process's size limit becomes a MachineError instead of a signal. Called
/// once, by main.
void remove_staged_files_on_signals();

}  // namespace hexweave
