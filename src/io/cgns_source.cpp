// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/errors.h"
#include "io/grid_file.h"

namespace hexweave {
namespace {

/// What is amiss with a file that libcgns does not take for one of its own.
const char* why_no_cgns(const std::filesystem::path& path) {
    if (!file_begins_as_cgns(path)) return "it is not a CGNS file";
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    return file >= 0 ? "it is an HDF5 file, but no CGNS file" : "it is damaged or cut short";
}

}  // namespace

CgnsSource::CgnsSource(const std::filesystem::path& path, OtherParts parts)
    : path_(path), parts_(parts), file_(path, CG_MODE_READ) {
    if (!file_.is_open()) {
        int type = CG_FILE_NONE;
        if (cg_is_cgns(path_.c_str(), &type) != CG_OK) cannot_read(why_no_cgns(path_));
        damaged();
    }
    errors_.listen();
}

void CgnsSource::cannot_read(const std::string& fact) const {
    // Names in a damaged file may hold anything; a message is one line.
    std::string line = fact;
    const auto is_control = [](char c) {
        constexpr char first_printable = 0x20;
        constexpr char erase = 0x7f;
        return (c >= 0 && c < first_printable) || c == erase;
    };
    std::replace_if(line.begin(), line.end(), is_control, '?');
    throw UsageError(fmt::format("cannot read '{}': {}", path_.string(), line));
}

void CgnsSource::damaged() const {
    cannot_read(fmt::format("it is damaged ({})", cg_get_error()));
}

}  // namespace hexweave
