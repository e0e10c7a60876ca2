// SPDX-License-Identifier: Apache-2.0
#include "generate.h"

#include <chrono>
#include <utility>

#include "blocks/assemble.h"
#include "blocks/mirror_grid.h"
#include "blocks/sweep_grid.h"
#include "quality/measure.h"
#include "topology/levels.h"
#include "topology/resolve.h"

namespace hexweave {
namespace {

/// Runs one stage and notes the seconds it took.
template <class Stage>
auto timed(std::vector<StageTime>& times, const char* name, Stage&& stage) {
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    times.push_back({name, taken.count()});
    return result;
}

/// Counts the finished parts of a stage for `progress`.
std::function<void()> counter(const Progress& progress, const char* stage, std::size_t total) {
    progress(stage, 0, total);
    return [&progress, stage, total, done = std::size_t{0}]() mutable {
        progress(stage, ++done, total);
    };
}

template <class Grid>
std::vector<Grid> every_nth_of(const std::vector<Grid>& grids, int stride) {
    std::vector<Grid> result;
    result.reserve(grids.size());
    for (const Grid& grid : grids) result.push_back(every_nth(grid, stride));
    return result;
}

Solved every_nth(const Solved& solved, int stride) {
    return {every_nth_of(solved.edges, stride), every_nth_of(solved.faces, stride),
            every_nth_of(solved.blocks, stride), solved.stages};
}

}  // namespace

Topology read_topology(const std::shared_ptr<const SourceFile>& source,
                       const std::vector<Override>& overrides, Diagnostics& diagnostics) {
    const Case as_written = read_case(source, overrides, diagnostics);
    return resolve(as_written, diagnostics);
}

Solved solve(const Topology& topology, const Progress& progress) {
    Solved solved;
    solved.edges = timed(solved.stages, "edges", [&] { return make_edges(topology); });
    solved.faces = timed(solved.stages, "faces", [&] {
        return make_faces(topology, solved.edges,
                          counter(progress, "faces", topology.faces.size()));
    });
    solved.blocks = timed(solved.stages, "blocks", [&] {
        return make_blocks(topology, solved.faces,
                           counter(progress, "blocks", topology.blocks.size()));
    });
    return solved;
}

Generated finish(const Topology& topology, const Solved& solved) {
    std::vector<StageTime> times = solved.stages;
    MultiblockGrid grid = timed(times, "assemble", [&] {
        MultiblockGrid drawn = assemble(topology, solved.faces, solved.blocks);
        if (topology.mirror) drawn = with_mirror_image(drawn, *topology.mirror);
        return topology.sweep ? swept(drawn, *topology.sweep) : drawn;
    });
    Report report = timed(times, "measure", [&] {
        return measure(topology, solved.edges, solved.faces, solved.blocks, grid);
    });
    std::vector<Offender> offenders = find_offenders(report, solved.faces, solved.blocks);
    report.stages = std::move(times);
    return {std::move(grid), std::move(report), std::move(offenders)};
}

Generated finish(const Topology& topology, const Solved& solved, std::size_t level) {
    const GridFamily& family = *topology.family;
    const int stride = family.stride(level);
    const Topology own = at_level(topology, level);
    Generated made = stride == 1 ? finish(own, solved) : finish(own, every_nth(solved, stride));
    made.report.level = level_measure(family, level);
    return made;
}

Generated generate(const Topology& topology, const Progress& progress) {
    const Solved solved = solve(topology, progress);
    return topology.family ? finish(topology, solved, topology.family->wanted)
                           : finish(topology, solved);
}

}  // namespace hexweave
