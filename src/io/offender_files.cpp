// SPDX-License-Identifier: Apache-2.0
#include "io/offender_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/vtk.h"

namespace hexweave {

namespace {

/// Whether a file has a name that `write_offenders` gives, and is a file itself.
bool is_offender_file(const std::filesystem::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    const bool named = name.starts_with("face-") || name.starts_with("block-");
    return named && name.ends_with(".vts") &&
           entry.symlink_status().type() == std::filesystem::file_type::regular;
}

/// Has the files of an earlier run removed that this one does not write.
void discard_earlier(const std::filesystem::path& folder, const std::vector<OffenderFile>& written,
                     OutputFiles& files) {
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
        const bool current =
            std::any_of(written.begin(), written.end(),
                        [&](const OffenderFile& own) { return own.path == entry.path(); });
        if (!current && is_offender_file(entry)) files.discard(entry.path());
    }
}

const char* kind_name(bool is_block) {
    return is_block ? "block" : "face";
}

}  // namespace

std::filesystem::path offender_folder(std::filesystem::path grid) {
    if (!grid.has_filename()) grid = grid.parent_path();
    return grid.replace_extension(".offenders");
}

std::vector<OffenderFile> write_offenders(const std::vector<Offender>& offenders,
                                          const std::string& units,
                                          const std::filesystem::path& grid_path,
                                          OutputFiles& files) {
    std::vector<OffenderFile> written;
    const std::filesystem::path folder = offender_folder(grid_path);
    if (!offenders.empty()) files.make_folder(folder);
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
    discard_earlier(folder, written, files);
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
