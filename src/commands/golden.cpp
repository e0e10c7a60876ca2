// SPDX-License-Identifier: Apache-2.0
#include "commands/golden.h"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <list>

#include "commands/case_files.h"
#include "commands/compare.h"
#include "commands/level_grids.h"
#include "commands/progress.h"
#include "generate.h"
#include "io/cgns.h"
#include "io/comparison_text.h"
#include "io/output_files.h"
#include "io/report_text.h"
#include "topology/levels.h"

namespace hexweave {
namespace {

namespace fs = std::filesystem;

/// A golden grid that is about to change, and the line that will say so.
struct Change {
    OutputFiles files;
    std::string path;
    std::string line;
};

class Update {
public:
    Update(const std::string& folder, const CaseOptions& options, Outcome& outcome)
        : folder_(folder),
          options_(options),
          outcome_(outcome),
          out_(options.json == "-" ? stderr : stdout) {
        if (!fs::is_directory(folder)) {
            throw UsageError(fmt::format("--golden: no such folder '{}'", folder));
        }
        if (options.level == every_level) {
            throw UsageError("--golden keeps one grid of a config: name its level");
        }
    }

    /// Refuses golden grids that would overwrite a config or one another.
    void require_own_files(const std::vector<std::string>& configs) {
        FileUses uses;
        for (const std::string& config : configs) {
            if (config == "-") {
                throw UsageError("--golden: a golden grid is named after its config's file");
            }
            uses.read.push_back({"the config", config});
            uses.written.push_back({"the golden grid of '" + config + "'", golden_of(config)});
        }
        require_apart(std::move(uses), options_, outcome_);
    }

    /// Makes one grid and compares it with the golden one.
    void make(const std::string& config) {
        CaseOptions options = options_;
        options.config = config;
        outcome_.diagnostics = {};  // those of another case have been told
        outcome_.grids.clear();
        const CaseGrids resolved = read_grids(options, outcome_);
        const Topology& topology = resolved.grids.front().solved;
        const fs::path path = golden_of(config);
        OutputFiles files;
        const fs::path staged = files.stage(path);
        const Generated made = generate(topology, make_progress(options_.quiet));
        outcome_.report = made.report;
        if (!made.report.sound()) {
            sound_ = false;
            fmt::print(stderr, "{}: {}\n", config, verdict(made.report));
            return;
        }
        files.write(staged, [&made](const auto& temporary) { write_cgns(made.grid, temporary); });
        compare(path, staged, std::move(files), verdict(made.report));
    }

    /// Puts the new golden grids into their places.
    ExitCode finish() {
        if (!sound_) {
            fmt::print(stderr,
                       "hexweave: error: not every grid is sound; no golden grid changed\n");
            return ExitCode::not_sound;
        }
        for (Change& change : changes_) {
            change.files.commit();
            outcome_.outputs.push_back(change.path);
            fmt::print(out_, "{}\n", change.line);
        }
        return ExitCode::done;
    }

private:
    fs::path golden_of(const std::string& config) const {
        const std::string level = options_.level.empty() ? "" : "." + options_.level;
        return folder_ / (fs::path(config).stem().string() + level + ".cgns");
    }

    void compare(const fs::path& path, const fs::path& staged, OutputFiles files,
                 const std::string& soundness) {
        const std::string shown = path.string();
        if (!fs::exists(path)) {
            changes_.push_back(
                {std::move(files), shown, fmt::format("{}: new; {}", shown, soundness)});
            return;
        }
        const GridComparison found = compare_files(staged.string(), shown, {});
        const std::string result = verdict(found);
        if (found.same()) {
            if (!options_.quiet) fmt::print(out_, "{}: unchanged; {}\n", shown, result);
            return;
        }
        if (!options_.quiet) fmt::print(out_, "{}:\n{}", shown, to_text(found));
        changes_.push_back(
            {std::move(files), shown, fmt::format("{}: updated; {}", shown, result)});
    }

    fs::path folder_;
    const CaseOptions& options_;
    Outcome& outcome_;
    std::FILE* out_;
    std::list<Change> changes_;
    bool sound_ = true;
};

}  // namespace

ExitCode update_goldens(const std::string& folder, const std::vector<std::string>& configs,
                        const CaseOptions& options, Outcome& outcome) {
    if (configs.size() > 1 && !options.json.empty()) {
        outcome.json_refused = true;
        throw UsageError("--json tells of one case: with --golden, run each config alone for it");
    }
    Update update(folder, options, outcome);
    update.require_own_files(configs);
    for (const std::string& config : configs) update.make(config);
    return update.finish();
}

}  // namespace hexweave
