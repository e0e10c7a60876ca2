// SPDX-License-Identifier: Apache-2.0
#include "commands/case_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "io/grid_file.h"
#include "io/offender_files.h"
#include "topology/levels.h"
#include "topology/read_case.h"

namespace hexweave {
namespace {

std::vector<GridOutput> outputs_named(const std::vector<std::string>& paths) {
    std::vector<GridOutput> outputs;
    for (const std::string& path : paths) {
        const auto output = output_by_name(path);
        if (!output) throw UsageError(unknown_ending(path));
        outputs.push_back(*output);
    }
    return outputs;
}

}  // namespace

std::vector<FileUse> files_of_case(const CaseOptions& options, const Case& written) {
    std::vector<FileUse> uses{{"the config", options.config}};
    for (const Name& file : written.files) uses.push_back({"the file", file.value, file.place});
    return uses;
}

void require_apart(FileUses uses, const CaseOptions& options, Outcome& outcome) {
    if (!options.json.empty() && options.json != "-") {
        uses.written.push_back({json_role, options.json});
    }
    const std::vector<FileFault> faults = file_faults(uses);
    outcome.json_refused = std::any_of(faults.begin(), faults.end(), [](const FileFault& fault) {
        return fault.concerns(json_role);
    });
    refuse(faults);
}

Case read_case_of(const CaseOptions& options, Outcome& outcome) {
    Case written =
        read_case(read_source(options.config), parse_overrides(options.set), outcome.diagnostics);
    require_apart({files_of_case(options, written), {}}, options, outcome);
    return written;
}

std::vector<GridOutput> outputs_of(const CaseOptions& options,
                                   const std::vector<std::string>& given,
                                   const Topology& topology) {
    std::vector<GridOutput> outputs = given.empty() ? topology.outputs : outputs_named(given);
    if (outputs.empty() && options.config != "-") {
        outputs = outputs_named({std::filesystem::path(options.config).stem().string() + ".cgns"});
    }
    const bool name_levels =
        options.level == every_level || (!options.level.empty() && given.empty());
    if (!name_levels) return outputs;
    const GridFamily& family = *topology.family;
    for (GridOutput& output : outputs) {
        output = output_of_level(std::move(output), family.names[family.level]);
    }
    return outputs;
}

std::vector<FileUse> files_of_outputs(const std::vector<GridOutput>& outputs,
                                      const std::string& role) {
    std::vector<FileUse> uses;
    for (const GridOutput& output : outputs) {
        const std::vector<FileUse> own = files_written(output, role);
        uses.insert(uses.end(), own.begin(), own.end());
    }
    if (outputs.empty()) return uses;
    const GridOutput& first = outputs.front();
    uses.push_back({"the folder of offenders", offender_folder(first.path), first.place,
                    FileUse::Kind::pieces});
    return uses;
}

GridOutput output_of_level(GridOutput output, const std::string& level) {
    const std::filesystem::path path(output.path);
    const std::filesystem::path folder = path.parent_path();
    if (output.format != GridFormat::openfoam) {
        output.path = (folder / path.stem()).string() + "." + level + path.extension().string();
    } else if (path.extension() == ".foam") {
        const std::string own = folder.empty() ? level : folder.string() + "." + level;
        output.path = (own / path.filename()).string();
    } else {
        output.path = (path.has_filename() ? path : folder).string() + "." + level;
    }
    return output;
}

}  // namespace hexweave
