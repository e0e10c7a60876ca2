// SPDX-License-Identifier: Apache-2.0
#include "io/offender_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/vtk.h"

namespace hexweave {

namespace {

/// "wing.offenders" for "wing.cgns"; "case.offenders" for the folder "case/".
std::filesystem::path folder_beside(std::filesystem::path grid) {
    if (!grid.has_filename()) grid = grid.parent_path();
    return grid.replace_extension(".offenders");
}

const char* kind_name(bool is_block) {
    return is_block ? "block" : "face";
}

}  // namespace

std::vector<OffenderFile> write_offenders(const std::vector<Offender>& offenders,
                                          const std::string& units,
                                          const std::filesystem::path& grid_path,
                                          OutputFiles& files) {
    std::vector<OffenderFile> written;
    if (offenders.empty()) return written;
    const std::filesystem::path folder = folder_beside(grid_path);
    files.make_folder(folder);
    for (const Offender& offender : offenders) {
        const std::string kind = kind_name(offender.is_block);
        const std::filesystem::path path = folder / fmt::format("{}-{}.vts", kind, offender.name);
        const CellMarks& marks = offender.marks;
        files.write(files.stage(path), [&](const auto& temporary) {
            write_vtk_grid(offender.points,
                           {{"Name", kind + " " + offender.name}, {"Units", units}},
                           {{"scaled_jacobian", marks.scaled_jacobian},
                            {"folded", marks.folded},
                            {"worst", marks.worst}},
                           temporary);
        });
        written.push_back({offender.name, offender.is_block, path.string()});
    }
    return written;
}

std::string offender_lines(const std::vector<OffenderFile>& files) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t n = 0; n < std::min(files.size(), most); ++n) {
        text += fmt::format("see {} for the worst cells of {} '{}'\n", files[n].path,
                            kind_name(files[n].is_block), files[n].name);
    }
    if (files.size() > most) {
        text += fmt::format("and {} more beside it\n", files.size() - most);
    }
    return text;
}

}  // namespace hexweave
