// SPDX-License-Identifier: Apache-2.0
#include "generate.h"

#include <chrono>
#include <utility>

#include "blocks/assemble.h"
#include "blocks/block_grid.h"
#include "blocks/mirror_grid.h"
#include "blocks/sweep_grid.h"
#include "edges/edge_grid.h"
#include "faces/face_grid.h"
#include "quality/measure.h"
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

}  // namespace

Topology read_topology(const std::shared_ptr<const SourceFile>& source,
                       const std::vector<Override>& overrides, Diagnostics& diagnostics) {
    const Case as_written = read_case(source, overrides, diagnostics);
    return resolve(as_written, diagnostics);
}

Generated generate(const Topology& topology, const Progress& progress) {
    std::vector<StageTime> times;

    const auto edges = timed(times, "edges", [&] { return make_edges(topology); });
    const auto faces = timed(times, "faces", [&] {
        return make_faces(topology, edges, counter(progress, "faces", topology.faces.size()));
    });
    const auto blocks = timed(times, "blocks", [&] {
        return make_blocks(topology, faces, counter(progress, "blocks", topology.blocks.size()));
    });
    MultiblockGrid grid = timed(times, "assemble", [&] {
        MultiblockGrid drawn = assemble(topology, faces, blocks);
        if (topology.mirror) drawn = with_mirror_image(drawn, *topology.mirror);
        return topology.sweep ? swept(drawn, *topology.sweep) : drawn;
    });
    Report report =
        timed(times, "measure", [&] { return measure(topology, edges, faces, blocks, grid); });

    std::vector<Offender> offenders = find_offenders(report, faces, blocks);

    report.stages = std::move(times);
    return {std::move(grid), std::move(report), std::move(offenders)};
}

}  // namespace hexweave
