// SPDX-License-Identifier: Apache-2.0
#include "io/output_place.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

#include "core/errors.h"

namespace hexweave {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void wrong_path(const fs::path& path, const std::string& reason) {
    throw UsageError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

/// For a path that the system refuses: its own fault, or the machine's.
[[noreturn]] void refuse(const fs::path& path, int error_number) {
    const bool of_the_path = error_number == ELOOP || error_number == ENAMETOOLONG;
    if (of_the_path) wrong_path(path, error_reason(error_number));
    cannot_write(path, error_reason(error_number));
}

/// What a path is, without following a link; nothing when there is no such file. Speaks of `given`.
std::optional<struct stat> look_at(const fs::path& path, const fs::path& given) {
    struct stat status = {};
    if (lstat(path.c_str(), &status) == 0) return status;
    if (errno == ENOENT) return std::nullopt;
    if (errno == ENOTDIR)
        wrong_path(given, fmt::format("'{}' is not a folder", folder_of(path).string()));
    refuse(given, errno);
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
        if (error) refuse(given, error.value());
        path = target.is_absolute() ? target : folder_of(path) / target;
    }
    refuse(given, ELOOP);
}

/// A regular file that may be written, or nothing yet.
void require_replaceable(const fs::path& path, const fs::path& given) {
    const auto status = look_at(path, given);
    if (!status) {
        if (!path.has_filename()) wrong_path(given, "it names no file");
        return;
    }
    if (S_ISDIR(status->st_mode)) wrong_path(given, "it is a folder");
    if (!S_ISREG(status->st_mode)) wrong_path(given, "it is not a regular file");
    if (access(path.c_str(), W_OK) != 0) refuse(given, errno);
}

void require_folder(const fs::path& path, const fs::path& given) {
    const fs::path folder = folder_of(path);
    struct stat status = {};
    if (stat(folder.c_str(), &status) == 0) {
        if (!S_ISDIR(status.st_mode))
            wrong_path(given, fmt::format("'{}' is not a folder", folder.string()));
        return;
    }
    if (errno == ENOENT) wrong_path(given, fmt::format("no such folder '{}'", folder.string()));
    if (errno == ENOTDIR)
        wrong_path(given, fmt::format("'{}' is not in a folder", folder.string()));
    refuse(given, errno);
}

}  // namespace

fs::path place_of_file(const fs::path& given) {
    const fs::path target = follow_links(given);
    require_folder(target, given);
    require_replaceable(target, given);
    return fs::canonical(folder_of(target)) / target.filename();
}

bool folder_is_missing(const fs::path& folder) {
    struct stat status = {};
    if (stat(folder.c_str(), &status) == 0) {
        if (!S_ISDIR(status.st_mode)) wrong_path(folder, "it is not a folder");
        return false;
    }
    require_folder(folder, folder);
    return true;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void cannot_write(const fs::path& path, const std::string& reason) {
    throw MachineError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

std::string error_reason(int error_number) {
    std::string reason = std::strerror(error_number);
    if (reason.size() > 1 && std::islower(static_cast<unsigned char>(reason[1])) != 0) {
        reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    }
    return reason;
}

}  // namespace hexweave
