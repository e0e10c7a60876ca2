// SPDX-License-Identifier: Apache-2.0
#include "io/output_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "core/errors.h"
#include "io/output_place.h"
#include "io/staged_signals.h"

namespace hexweave {
namespace {

namespace fs = std::filesystem;

/// Flushes a file, or the entries of a folder, to the disk. Some file systems cannot flush a folder
/// and say so with EINVAL.
void flush(const fs::path& path, const fs::path& given) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) cannot_write(given, error_reason(errno));
    const int error = fsync(descriptor) == 0 ? 0 : errno;
    if (close(descriptor) != 0) cannot_write(given, error_reason(errno));
    if (error != 0 && error != EINVAL) cannot_write(given, error_reason(error));
}

/// The hidden name beside `path` under which something stands for a while. Long names are cut, so
/// that the longest name that a file system allows (255 bytes) can still be written.
fs::path hidden_name(const fs::path& path, const std::string& purpose, int attempt) {
    constexpr std::size_t longest = 200;
    std::string name = fmt::format(".{}.{}.{}", path.filename().string().substr(0, longest),
                                   purpose, static_cast<long>(getpid()));
    if (attempt > 0) name += fmt::format(".{}", attempt);
    return folder_of(path) / name;
}

// A file of a hidden name that is there already is not ours (a killed process of the same number
// may have left it); another name is tried, this many times.
constexpr int most_attempts = 100;

/// A second name for the file at `path`; empty when the file system cannot give one.
fs::path keep_former(const fs::path& path) {
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        fs::path backup = hidden_name(path, "old", attempt);
        if (link(path.c_str(), backup.c_str()) == 0) return backup;
        if (errno != EEXIST) break;
    }
    return {};
}

/// Renames one at a time, remembering how to take each one back.
class Replacement {
public:
    Replacement() = default;
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    /// Takes back everything unless `keep` was called.
    ~Replacement() { std::for_each(steps_.rbegin(), steps_.rend(), take_back); }

    void replace(const fs::path& temporary, const fs::path& path, const fs::path& given) {
        Step step{path, {}, true};
        if (struct stat status = {}; stat(path.c_str(), &status) == 0) {
            constexpr mode_t permissions = 07777;
            static_cast<void>(chmod(temporary.c_str(), status.st_mode & permissions));
            step = {path, keep_former(path), false};
        }
        if (std::rename(temporary.c_str(), path.c_str()) != 0) {
            const int error = errno;
            if (!step.backup.empty()) unlink(step.backup.c_str());
            cannot_write(given, error_reason(error));
        }
        steps_.push_back(std::move(step));
    }

    void remove(const fs::path& path) {
        Step step{path, keep_former(path), false};
        if (unlink(path.c_str()) != 0) {
            const int error = errno;
            if (!step.backup.empty()) unlink(step.backup.c_str());
            throw MachineError(
                fmt::format("cannot remove '{}': {}", path.string(), error_reason(error)));
        }
        steps_.push_back(std::move(step));
    }

    void keep() {
        for (const Step& step : steps_) {
            if (!step.backup.empty()) unlink(step.backup.c_str());
        }
        steps_.clear();
    }

private:
    struct Step {
        fs::path path;
        fs::path backup;  ///< empty: there is none
        bool was_absent;
    };

    static void take_back(const Step& step) {
        if (!step.backup.empty()) {
            static_cast<void>(std::rename(step.backup.c_str(), step.path.c_str()));
        } else if (step.was_absent) {
            unlink(step.path.c_str());
        }
    }

    std::vector<Step> steps_;
};

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& neighbour, const fs::path& shown) {
    const SignalsHeld held;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        path_ = hidden_name(fs::absolute(neighbour), "tmp", attempt);
        const int descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno == EEXIST) continue;
        if (descriptor < 0) cannot_write(shown, error_reason(errno));
        close(descriptor);
        slot_ = register_temporary(path_);
        if (slot_ >= 0) return;
        unlink(path_.c_str());
        cannot_write(shown, "too long a path");
    }
    cannot_write(
        shown, fmt::format("temporary files of former runs are in the way: '{}'", path_.string()));
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : path_(std::move(other.path_)), slot_(std::exchange(other.slot_, -1)) {}

TemporaryFile::~TemporaryFile() {
    if (slot_ < 0) return;
    unlink(path_.c_str());
    forget_temporary(slot_);
}

void TemporaryFile::release() {
    forget_temporary(std::exchange(slot_, -1));
}

TemporaryFolder::TemporaryFolder(const fs::path& path) {
    if (mkdir(path.c_str(), 0777) != 0) cannot_write(path, error_reason(errno));
    path_ = fs::canonical(path);
    slot_ = register_temporary(path_);
    if (slot_ >= 0) return;
    rmdir(path_.c_str());
    cannot_write(path, "too long a path");
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::move(other.path_)), slot_(std::exchange(other.slot_, -1)) {}

TemporaryFolder::~TemporaryFolder() {
    if (slot_ < 0) return;
    rmdir(path_.c_str());
    forget_temporary(slot_);
}

void TemporaryFolder::release() {
    forget_temporary(std::exchange(slot_, -1));
}

OutputFiles::~OutputFiles() {
    staged_.clear();
    while (!folders_.empty()) folders_.pop_back();
}

void OutputFiles::make_folder(const fs::path& folder) {
    if (folder_is_missing(folder)) folders_.emplace_back(folder);
}

fs::path OutputFiles::stage(const fs::path& final_path) {
    const fs::path place = place_of_file(final_path);
    for (const Staged& other : staged_) {
        if (other.final_path == place) {
            throw UsageError(
                fmt::format("two outputs would be written to '{}'", final_path.string()));
        }
    }
    staged_.push_back({TemporaryFile(place, final_path), final_path, place});
    return staged_.back().temporary.path();
}

void OutputFiles::discard(const fs::path& path) {
    discarded_.push_back(path);
}

void OutputFiles::write(const fs::path& temporary,
                        const std::function<void(const fs::path&)>& writer) const {
    try {
        writer(temporary);
    } catch (const MachineError& error) {
        std::string message = error.what();
        for (const Staged& staged : staged_) {
            const std::string hidden = staged.temporary.path().string();
            const std::size_t at = message.find(hidden);
            if (at == std::string::npos) continue;
            message.replace(at, hidden.size(), staged.given_path.string());
        }
        throw MachineError(message);
    }
}

void OutputFiles::commit() {
    for (const Staged& staged : staged_) flush(staged.temporary.path(), staged.given_path);
    const SignalsHeld held;
    Replacement replacement;
    std::set<fs::path> folders;
    for (const Staged& staged : staged_) {
        replacement.replace(staged.temporary.path(), staged.final_path, staged.given_path);
        folders.insert(folder_of(staged.final_path));
    }
    for (const fs::path& path : discarded_) {
        replacement.remove(path);
        folders.insert(folder_of(path));
    }
    for (const TemporaryFolder& made : folders_) folders.insert(folder_of(made.path()));
    for (const fs::path& folder : folders) flush(folder, folder);
    replacement.keep();
    for (Staged& staged : staged_) staged.temporary.release();
    staged_.clear();
    for (const fs::path& path : discarded_) rmdir(folder_of(path).c_str());  // where it is empty
    discarded_.clear();
    for (TemporaryFolder& made : folders_) made.release();
    folders_.clear();
}

}  // namespace hexweave
