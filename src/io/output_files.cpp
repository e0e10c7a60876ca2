// SPDX-License-Identifier: Apache-2.0
#include "io/output_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "core/errors.h"
#include "io/staged_signals.h"

namespace hexweave {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason) {
    throw MachineError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What a path is, without following a link; nothing when there is no such file. Throws
/// MachineError in the name of `given`.
std::optional<struct stat> look_at(const fs::path& path, const fs::path& given) {
    struct stat status = {};
    if (lstat(path.c_str(), &status) == 0) return status;
    if (errno == ENOENT) return std::nullopt;
    if (errno == ENOTDIR)
        cannot_write(given, fmt::format("'{}' is not a folder", folder_of(path).string()));
    cannot_write(given, error_reason(errno));
}

/// Follows links until something that is none, which need not exist.
fs::path follow_links(const fs::path& given) {
    constexpr int most_links = 40;
    fs::path path = given;
    for (int links = 0; links < most_links; ++links) {
        const auto status = look_at(path, given);
        if (!status || !S_ISLNK(status->st_mode)) return path;
        std::error_code error;
        const fs::path target = fs::read_symlink(path, error);
        if (error) cannot_write(given, error_reason(error.value()));
        path = target.is_absolute() ? target : folder_of(path) / target;
    }
    cannot_write(given, error_reason(ELOOP));
}

/// Throws MachineError unless `path` is a regular file that may be written, or nothing yet.
void require_replaceable(const fs::path& path, const fs::path& given) {
    const auto status = look_at(path, given);
    if (!status) {
        if (!path.has_filename()) cannot_write(given, "it names no file");
        return;
    }
    if (S_ISDIR(status->st_mode)) cannot_write(given, "it is a folder");
    if (!S_ISREG(status->st_mode)) cannot_write(given, "it is not a regular file");
    if (access(path.c_str(), W_OK) != 0) cannot_write(given, error_reason(errno));
}

void require_folder(const fs::path& path, const fs::path& given) {
    const fs::path folder = folder_of(path);
    struct stat status = {};
    if (stat(folder.c_str(), &status) == 0) {
        if (!S_ISDIR(status.st_mode)) {
            cannot_write(given, fmt::format("'{}' is not a folder", folder.string()));
        }
        return;
    }
    if (errno == ENOENT) cannot_write(given, fmt::format("no such folder '{}'", folder.string()));
    if (errno == ENOTDIR)
        cannot_write(given, fmt::format("'{}' is not in a folder", folder.string()));
    cannot_write(given, error_reason(errno));
}

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

std::string error_reason(int error_number) {
    std::string reason = std::strerror(error_number);
    if (reason.size() > 1 && std::islower(static_cast<unsigned char>(reason[1])) != 0) {
        reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    }
    return reason;
}

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
    struct stat status = {};
    if (stat(folder.c_str(), &status) == 0) {
        if (!S_ISDIR(status.st_mode)) cannot_write(folder, "it is not a folder");
        return;
    }
    require_folder(folder, folder);
    folders_.emplace_back(folder);
}

fs::path OutputFiles::stage(const fs::path& final_path) {
    const fs::path target = follow_links(final_path);
    require_folder(target, final_path);
    require_replaceable(target, final_path);
    const fs::path canonical = fs::canonical(folder_of(target)) / target.filename();
    for (const Staged& other : staged_) {
        if (other.final_path == canonical) {
            throw UsageError(
                fmt::format("two outputs would be written to '{}'", final_path.string()));
        }
    }
    staged_.push_back({TemporaryFile(canonical, final_path), final_path, canonical});
    return staged_.back().temporary.path();
}

void OutputFiles::discard(const fs::path& path) {
    require_folder(path, path);
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
