// SPDX-License-Identifier: Apache-2.0
// The files that a command reads and those that it is to write, looked at together before any work:
// no output may be one of the inputs or another output, and each must have a place. Every command
// that writes a file asks here first.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/diagnostics.h"

namespace hexweave {

struct FileUse {
    enum class Kind {
        file,
        folder,  ///< made where it is not there; other things may stand in it
        pieces   ///< likewise, and any file `.vts` in it may be written
    };

    std::string role;  ///< what it is to the command: "the config", "-o", "--json"
    std::filesystem::path path;
    Place place{};  ///< where a config names it; nowhere for the command line
    Kind kind = Kind::file;
};

/// A folder to be made stands before what is to stand in it.
struct FileUses {
    std::vector<FileUse> read;
    std::vector<FileUse> written;
};

/// Why `output` cannot be written, and the other use that is in its way, if it is that.
struct FileFault {
    std::string message;
    FileUse output;
    FileUse other{};

    /// Whether this is about the file of a role.
    bool concerns(const std::string& role) const {
        return output.role == role || other.role == role;
    }
};

/// Every output without a place (see output_place.h), every one that is an input or another output,
/// be it under another name, by a link or by a hard link. Makes nothing. Throws MachineError where
/// the system refuses.
std::vector<FileFault> file_faults(const FileUses& uses);

/// Unless there are none, throws InputError with all that have a place in a config, else UsageError
/// with the first.
void refuse(const std::vector<FileFault>& faults);

/// Both of these.
inline void require_apart(const FileUses& uses) {
    refuse(file_faults(uses));
}

}  // namespace hexweave
