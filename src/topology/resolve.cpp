// SPDX-License-Identifier: Apache-2.0
#include "topology/resolve.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/memory.h"
#include "core/parallel.h"
#include "topology/boundaries.h"
#include "topology/counts.h"
#include "topology/draft.h"
#include "topology/handedness.h"
#include "topology/levels.h"
#include "topology/limits.h"
#include "topology/parallel_edges.h"
#include "topology/periodic.h"
#include "topology/spacing_propagation.h"
#include "topology/surface_faces.h"
#include "topology/sweep.h"
#include "topology/twin_vertices.h"

namespace hexweave {

namespace {

/// Names, places, directions and orientations.
Network connect(const Case& c, Diagnostics& diagnostics) {
    Draft draft(c, diagnostics);
    note_other_names(draft);
    place_vertices(draft);
    place_edges(draft);
    place_corners(draft);
    join_faces(draft);
    join_corner_blocks(draft);
    join_blocks(draft);
    warn_unused(draft);
    return sound_part(draft);
}

/// In a nested family the laws and heights, which are those of `medium`, are continued.
void refine(Topology& topology, const GridFamily& family) {
    const int refinement = static_cast<int>(std::lround(family.times_medium(family.level)));
    for (Edge& edge : topology.edges) edge.refinement = refinement;
    for (Face& face : topology.faces) refine_heights(face.solve.heights, family);
    for (Block& block : topology.blocks) refine_heights(block.solve.heights, family);
}

/// Resolves a case whose sizes are those of the level to be solved.
Topology resolve_scaled(const Case& c, const std::optional<GridFamily>& family,
                        Diagnostics& diagnostics) {
    if (c.faces.empty() && c.blocks.empty() && !diagnostics.has_errors()) {
        diagnostics.error(Place{c.source, 0, 0}, "the file describes no grid",
                          "give it 'faces', or 'blocks'");
    }
    Network network = connect(c, diagnostics);
    measure_extent(network.topology, network.three_dimensional);
    if (network.intact) warn_of_twin_vertices(network.topology, diagnostics);
    if (check_surface_faces(network, diagnostics)) {
        network.intact = check_handedness(network, diagnostics) && network.intact;
    }
    pair_periodic_sides(network, c, diagnostics);
    make_images(network, diagnostics);
    const ParallelEdges parallels = parallel_edges(network.topology);
    const CountRules rules{c.multiple_of, family};
    resolve_counts(network, parallels, rules, diagnostics);
    if (family && family->nested()) refine(network.topology, *family);
    resolve_spacing(network, parallels, diagnostics);
    place_sweep(network, c, rules, diagnostics);
    resolve_boundaries(network, c, diagnostics);
    resolve_planes(network, c, diagnostics);
    settle_images(network, diagnostics);
    resolve_sweep_ends(network, c, diagnostics);
    resolve_mirror(network, c, diagnostics);
    if (!diagnostics.has_errors() && check_zone_sizes(network.topology, diagnostics)) {
        check_memory(network.topology, threads(), available_memory(), diagnostics);
    }
    diagnostics.sort();
    if (diagnostics.has_errors()) throw InputError(diagnostics);

    Topology topology = std::move(network.topology);
    topology.title = c.title;
    topology.units = c.units;
    topology.provenance = c.provenance;
    topology.parameters = c.parameters;
    topology.gates = c.gates;
    topology.outputs = c.outputs;
    topology.family = family;
    return topology;
}

}  // namespace

Topology resolve(const Case& c, Diagnostics& diagnostics) {
    const std::optional<GridFamily> family = family_of(c);
    if (!family || family->nested()) return resolve_scaled(c, family, diagnostics);
    return resolve_scaled(scaled_to_level(c, *family), family, diagnostics);
}

}  // namespace hexweave
