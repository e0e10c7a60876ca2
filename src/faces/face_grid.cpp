// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"

#include <algorithm>

#include "elliptic/elliptic_solver.h"
#include "elliptic/fold_count.h"
#include "elliptic/untangle.h"
#include "faces/face_boundary.h"
#include "faces/flat_corners.h"
#include "faces/folded_start.h"
#include "faces/largest_first.h"
#include "faces/orthogonal_face.h"
#include "faces/straight_line_map.h"
#include "faces/transfinite_face.h"

namespace hexweave {

namespace {

void set_plane(PointField& points, const AxisPlane& plane) {
    Field& coordinate = plane.axis == 0 ? points.x : plane.axis == 1 ? points.y : points.z;
    coordinate = Field(points.extent(), plane.value);
}

FaceGrid make_face(const Face& face, const std::vector<EdgeGrid>& edges, bool planar) {
    FaceGrid grid;
    grid.points = face_boundary(face, edges);
    grid.flat_corners = flat_corners(grid.points, planar);
    const bool algebraic = face.solve.method == Method::algebraic;
    const double exponent = algebraic ? 1 : face.solve.flat_edge_exponent;
    const ParameterField parameters =
        straight_line_map(grid.points, corner_exponents(grid.flat_corners, exponent));
    interpolate_face(grid.points, parameters);
    if (!algebraic) {
        if (face.solve.start_folded) fold_interior(grid.points);
        const EllipticOptions options{face.solve.tolerance, face.solve.maximum_cycles};
        grid.solve = solve_elliptic(grid.points, parameters, options);
        grid.solve.untangling = untangle(grid.points, [&] {
            PointField transfinite = grid.points;
            interpolate_face(transfinite, parameters);
            return transfinite;
        });
        if (grid.solve.untangling) grid.solve.folded_after = count_folded(grid.points);
        const auto& sides = face.orthogonal;
        if (std::any_of(sides.begin(), sides.end(), [](bool asked) { return asked; })) {
            make_orthogonal(grid.points, parameters, sides,
                            orthogonal_passes(sides, grid.flat_corners), options, grid.solve);
        }
    }
    grid.heights = hold_heights(grid.points, face.solve.heights);
    if (planar) set_plane(grid.points, {2, 0.0});
    if (face.plane) set_plane(grid.points, *face.plane);
    return grid;
}

}  // namespace

std::vector<FaceGrid> make_faces(const Topology& topology, const std::vector<EdgeGrid>& edges,
                                 const std::function<void()>& done) {
    std::vector<std::size_t> sizes;
    for (const Face& face : topology.faces) sizes.push_back(face.extent().nodes());
    std::vector<FaceGrid> grids(topology.faces.size());
    largest_first(sizes, done, [&](std::size_t index) {
        grids[index] = make_face(topology.faces[index], edges, topology.planar);
    });
    return grids;
}

}  // namespace hexweave
