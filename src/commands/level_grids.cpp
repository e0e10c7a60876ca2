// SPDX-License-Identifier: Apache-2.0
#include "commands/level_grids.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "commands/case_files.h"
#include "topology/levels.h"
#include "topology/resolve.h"

namespace hexweave {
namespace {

/// Makes a level the one that the case is of.
void choose_level(Case& c, const std::string& level) {
    const std::vector<std::string>& known = c.levels.names;
    if (std::find(known.begin(), known.end(), level) == known.end()) {
        const std::string meant = nearest_name(level, known);
        throw UsageError(
            fmt::format("--level {}: the levels are {}, or all{}", level, fmt::join(known, ", "),
                        meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)));
    }
    c.level.value = level;
}

LevelGrids resolve_one(const Case& c, Diagnostics& diagnostics) {
    LevelGrids grids{resolve(c, diagnostics), {}};
    if (grids.solved.family) grids.levels = {grids.solved.family->wanted};
    return grids;
}

std::vector<LevelGrids> resolve_all(const Case& written, Diagnostics& diagnostics) {
    Case c = written;
    c.level.value = c.levels.names.back();
    std::vector<LevelGrids> grids{resolve_one(c, diagnostics)};
    const GridFamily& family = *grids.front().solved.family;
    if (family.nested()) {
        grids.front().levels.resize(family.names.size());
        std::iota(grids.front().levels.begin(), grids.front().levels.end(), std::size_t{0});
        return grids;
    }
    for (std::size_t level = family.names.size() - 1; level-- > 0;) {
        c.level.value = c.levels.names[level];
        grids.insert(grids.begin(), resolve_one(c, diagnostics));
    }
    return grids;
}

}  // namespace

std::vector<Topology> LevelGrids::topologies() const {
    if (levels.empty()) return {solved};
    std::vector<Topology> all;
    for (const std::size_t level : levels) all.push_back(at_level(solved, level));
    return all;
}

std::vector<LevelGrids> resolve_levels(const Case& written, const std::string& level,
                                       Diagnostics& diagnostics) {
    // What is wrong in the file is told first: its levels may be what could not be read.
    if (level.empty() || diagnostics.has_errors()) return {resolve_one(written, diagnostics)};
    if (level == every_level) return resolve_all(written, diagnostics);
    Case c = written;
    choose_level(c, level);
    return {resolve_one(c, diagnostics)};
}

CaseGrids read_grids(const CaseOptions& options, Outcome& outcome) {
    const Case written = read_case_of(options, outcome);
    std::vector<LevelGrids> grids = resolve_levels(written, options.level, outcome.diagnostics);
    outcome.parameters = grids.front().solved.parameters;
    settle_warnings(outcome.diagnostics, options);
    for (const LevelGrids& part : grids) {
        for (const Topology& topology : part.topologies()) {
            outcome.grids.push_back(planned_grid(topology, part.solved));
        }
    }
    return {files_of_case(options, written), std::move(grids)};
}

}  // namespace hexweave
