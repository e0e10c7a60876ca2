// SPDX-License-Identifier: Apache-2.0
// Faces and blocks that ended folded or unconverged as VTK files beside the grid, one each, with
// values at the cells to colour by.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/output_files.h"
#include "quality/offenders.h"

namespace hexweave {

/// One such file that was written.
struct OffenderFile {
    std::string name;
    bool is_block = false;
    std::string path;
};

/// "wing.offenders" for "wing.cgns"; "case.offenders" for the folder "case/".
std::filesystem::path offender_folder(std::filesystem::path grid);

/// Writes STEM.offenders/face-NAME.vts and block-NAME.vts, STEM that of the grid's path; makes no
/// folder where there are none. Files of such names that an earlier run left there go. Points, and
/// at the cells `scaled_jacobian`, `folded` and `worst`. `files` is to be committed after it.
/// Throws MachineError.
std::vector<OffenderFile> write_offenders(const std::vector<Offender>& offenders,
                                          const std::string& units,
                                          const std::filesystem::path& grid_path,
                                          OutputFiles& files);

/// A line for each of the first ones, and a count of the others; empty where there are none.
std::string offender_lines(const std::vector<OffenderFile>& files);

}  // namespace hexweave
