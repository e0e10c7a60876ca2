// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/errors.h"

namespace hexweave {

CgnsSource::CgnsSource(const std::filesystem::path& path, OtherParts parts)
    : path_(path), parts_(parts), file_(path, CG_MODE_READ) {
    if (!file_.is_open()) {
        int type = CG_FILE_NONE;
        if (cg_is_cgns(path_.c_str(), &type) != CG_OK) cannot_read("it is not a CGNS file");
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
