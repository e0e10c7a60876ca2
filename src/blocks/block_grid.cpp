// SPDX-License-Identifier: Apache-2.0
#include "blocks/block_grid.h"

#include <utility>

#include "blocks/bilinear_map.h"
#include "blocks/block_boundary.h"
#include "blocks/flat_edges.h"
#include "blocks/transfinite_block.h"
#include "core/every_nth.h"
#include "core/largest_first.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/fold_count.h"
#include "elliptic/untangle.h"
#include "faces/folded_start.h"

namespace hexweave {

namespace {

BlockGrid make_block(const Block& block, const std::vector<FaceGrid>& faces,
                     const BlockEdgeFunctions& functions) {
    BlockGrid grid;
    grid.points = block_boundary(block, faces);
    grid.flat_edges = functions.flat;
    const bool algebraic = block.solve.method == Method::algebraic;
    const auto exponents = algebraic ? PerBlockEdge<EndExponents>{} : functions.exponents;
    ParameterField parameters = bilinear_map(grid.points, exponents);
    interpolate_block(grid.points, parameters);
    if (algebraic) {
        grid.solve.folded_before = grid.solve.folded_after = count_folded(grid.points);
    } else {
        if (block.solve.start_folded) fold_interior(grid.points);
        grid.solve = solve_elliptic(grid.points, std::move(parameters),
                                    {block.solve.tolerance, block.solve.maximum_cycles});
        grid.solve.untangling = untangle(grid.points, [&] {
            PointField transfinite = grid.points;
            // Made anew: kept, the parameters would be a tenth of the memory of the solve.
            interpolate_block(transfinite, bilinear_map(transfinite, exponents));
            return transfinite;
        });
        if (grid.solve.untangling) grid.solve.folded_after = count_folded(grid.points);
    }
    grid.heights = hold_heights(grid.points, block.solve.heights);
    if (!grid.heights.empty()) grid.solve.folded_after = count_folded(grid.points);
    return grid;
}

}  // namespace

std::vector<BlockGrid> make_blocks(const Topology& topology, const std::vector<FaceGrid>& faces,
                                   const std::function<void()>& done) {
    std::vector<std::size_t> sizes;
    for (const Block& block : topology.blocks) sizes.push_back(block.extent.nodes());
    const std::vector<BlockEdgeFunctions> functions = block_edge_functions(topology, faces);
    std::vector<BlockGrid> grids(topology.blocks.size());
    largest_first(sizes, done, [&](std::size_t index) {
        grids[index] = make_block(topology.blocks[index], faces, functions[index]);
    });
    return grids;
}

BlockGrid every_nth(const BlockGrid& grid, int stride) {
    return {every_nth(grid.points, stride), grid.solve,
            every_nth(grid.points, grid.heights, stride), grid.flat_edges};
}

}  // namespace hexweave
