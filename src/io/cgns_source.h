// SPDX-License-Identifier: Apache-2.0
// A CGNS file while it is read: the parts of the reader share it.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "core/multiblock.h"
#include "io/cgns_library.h"

namespace hexweave {

/// Room for a name that libcgns writes.
using CgnsName = std::array<char, longest_cgns_name + 1>;

/// An open file with one base. The functions below throw UsageError.
class CgnsSource {
public:
    explicit CgnsSource(const std::filesystem::path& path);

    int file() const { return file_; }
    static constexpr int base() { return 1; }

    [[noreturn]] void cannot_read(const std::string& fact) const;
    [[noreturn]] void damaged() const;
    /// Every function of libcgns answers with zero when it succeeds.
    void check(int answer) const {
        if (answer != CG_OK) damaged();
    }

private:
    std::filesystem::path path_;
    Hdf5Errors errors_;
    CgnsFile file_;
};

/// Adds the one-to-one interfaces of all zones of `grid`, each once, on the side that comes first.
void read_interfaces(const CgnsSource& source, MultiblockGrid& grid);

/// Adds the boundary conditions of all zones of `grid` as patches, and the families that the file
/// does not declare: one called like its type for each literal type without a family.
void read_patches(const CgnsSource& source, MultiblockGrid& grid);

}  // namespace hexweave
