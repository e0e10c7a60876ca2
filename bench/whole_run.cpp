// SPDX-License-Identifier: Apache-2.0
#include "bench/whole_run.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bench/machine.h"

namespace hexweave::bench {

namespace {

constexpr const char* config = R"(hexweave: 1
title: One block over a bump
units: m
parameters: {along: 128, across: 128, outwards: 96, wall: 1e-4}
curves:
  front: {formula: [t, 0, "0.2 * sin(pi * t)^2"], range: [0, 1]}
  back:  {formula: [t, 1, "0.1 * sin(pi * t)^2"], range: [0, 1]}
vertices:
  a0: [0, 0, 0]
  b0: [1, 0, 0]
  c0: [1, 1, 0]
  d0: [0, 1, 0]
  a1: [0, 0, 1]
  b1: [1, 0, 1]
  c1: [1, 1, 1]
  d1: [0, 1, 1]
edges:
  bump_front: {from: a0, to: b0, along: front, cells: along}
  bump_back:  {from: d0, to: c0, along: back}
  side:       {from: a0, to: d0, cells: across}
  rise:       {from: a0, to: a1, cells: outwards, spacing: {start: wall}}
blocks:
  block: {corners: [a0, b0, c0, d0, a1, b1, c1, d1]}
output: {cgns: block.cgns}
)";

ProgramRun run_with(const std::string& program, const std::filesystem::path& folder,
                    const std::vector<std::string>& settings) {
    std::vector<std::string> arguments{program, "run", (folder / "block.yaml").string(), "-j",
                                       "1",     "-o",  (folder / "block.cgns").string()};
    for (const std::string& setting : settings) {
        arguments.emplace_back("--set");
        arguments.push_back(setting);
    }
    return run_program(arguments);
}

}  // namespace

std::optional<WholeRun> measure_whole_run(const std::string& program) {
    namespace fs = std::filesystem;
    const fs::path folder =
        fs::temp_directory_path() / ("hexweave-bench-" + std::to_string(getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "block.yaml") << config;
    const ProgramRun empty =
        run_with(program, folder, {"along=2", "across=2", "outwards=2", "wall=0.4"});
    const ProgramRun full = run_with(program, folder, {});
    fs::remove_all(folder);
    // Whether the tiny grid is sound (exit code 1: it is not) does not matter.
    if (empty.exit_code > 1 || empty.exit_code < 0 || full.exit_code != 0) return std::nullopt;
    const double points = 129.0 * 129 * 97;
    return WholeRun{points, full.seconds, (full.peak_bytes - empty.peak_bytes) / points};
}

}  // namespace hexweave::bench
