// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"

#include <algorithm>

#include "core/every_nth.h"
#include "core/largest_first.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/fold_count.h"
#include "elliptic/untangle.h"
#include "faces/face_boundary.h"
#include "faces/flat_corners.h"
#include "faces/folded_start.h"
#include "faces/harmonic_iteration.h"
#include "faces/orthogonal_face.h"
#include "faces/patched_face.h"
#include "faces/straight_line_map.h"
#include "faces/surface_face.h"
#include "faces/transfinite_face.h"

namespace hexweave {

namespace {

void set_plane(PointField& points, const AxisPlane& plane) {
    Field& coordinate = plane.axis == 0 ? points.x : plane.axis == 1 ? points.y : points.z;
    coordinate = Field(points.extent(), plane.value);
}

EllipticOptions options_of(const Face& face) {
    return {face.solve.tolerance, face.solve.maximum_cycles};
}

void make_orthogonal_where_asked(FaceGrid& grid, const Face& face, const ParameterField& parameters,
                                 const FaceSolver& solve) {
    const auto& sides = face.orthogonal;
    if (std::none_of(sides.begin(), sides.end(), [](bool asked) { return asked; })) return;
    make_orthogonal(grid.points, parameters, sides, orthogonal_passes(sides, grid.flat_corners),
                    options_of(face), grid.solve, solve);
}

/// A planar face or a minimal surface.
void fill_minimal(FaceGrid& grid, const Face& face, const ParameterField& parameters) {
    interpolate_face(grid.points, parameters);
    if (face.solve.method == Method::elliptic) {
        if (face.solve.start_folded) fold_interior(grid.points);
        grid.solve = solve_elliptic(grid.points, parameters, options_of(face));
        grid.solve.untangling = untangle(grid.points, [&] {
            PointField transfinite = grid.points;
            interpolate_face(transfinite, parameters);
            return transfinite;
        });
        if (grid.solve.untangling) grid.solve.folded_after = count_folded(grid.points);
        make_orthogonal_where_asked(grid, face, parameters, solve_elliptic);
    } else {
        grid.solve.folded_before = count_folded(grid.points);
    }
    grid.heights = hold_heights(grid.points, face.solve.heights);
}

/// A face whose points are bound to its surface or surfaces; `grid` has its start.
void fill_bound(FaceGrid& grid, const Face& face, const ParameterField& parameters,
                const BoundFace& bound) {
    if (face.solve.method == Method::elliptic) {
        const FaceSolver solve = [&](PointField& points, const ParameterField& wanted,
                                     const EllipticOptions& options) {
            SolveResult result = solve_bound(points, wanted, options, bound);
            result.untangling = untangle_bound(points, wanted, bound);
            if (result.untangling) result.folded_after = count_folded(points);
            return result;
        };
        grid.solve = solve(grid.points, parameters, options_of(face));
        make_orthogonal_where_asked(grid, face, parameters, solve);
    } else {
        grid.solve.folded_before = count_folded(grid.points);
    }
    grid.heights = hold_heights(grid.points, face.solve.heights);
    if (!grid.heights.empty()) bound.project(grid.points);
}

void fill_on_surface(FaceGrid& grid, const Face& face, const ParameterField& parameters) {
    if (!face.patches.empty()) {
        PatchedFace patched(face.patches, grid.points, parameters, face.solve.start_folded);
        grid.off_surface = patched.off_surface();
        fill_bound(grid, face, parameters, patched.bound());
        return;
    }
    SurfaceFace on_surface(*face.surface, grid.points, parameters, face.solve.start_folded);
    on_surface.evaluate_interior(grid.points);
    grid.off_surface = on_surface.off_surface();
    fill_bound(grid, face, parameters, on_surface.bound());
}

/// A face that is an edge, or a vertex.
void fill_collapsed(PointField& points, const std::array<bool, 2>& collapsed) {
    const Extent e = points.extent();
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            points.set(i, j, 0, points(collapsed[0] ? 0 : i, collapsed[1] ? 0 : j));
        }
    }
}

FaceGrid make_face(const Face& face, const std::vector<EdgeGrid>& edges, bool planar) {
    FaceGrid grid;
    grid.points = face_boundary(face, edges);
    if (face.is_collapsed()) {
        fill_collapsed(grid.points, face.collapsed);
        return grid;
    }
    grid.flat_corners = flat_corners(grid.points, planar);
    const bool algebraic = face.solve.method == Method::algebraic;
    const double exponent = algebraic ? 1 : face.solve.flat_edge_exponent;
    const ParameterField parameters =
        straight_line_map(grid.points, corner_exponents(grid.flat_corners, exponent));
    if (face.is_on_surface()) {
        fill_on_surface(grid, face, parameters);
    } else {
        fill_minimal(grid, face, parameters);
    }
    if (algebraic || !grid.heights.empty()) grid.solve.folded_after = count_folded(grid.points);
    if (planar) set_plane(grid.points, {2, 0.0});
    if (face.plane) set_plane(grid.points, *face.plane);
    return grid;
}

/// A face that is the image of another one: its inner points are carried over, its boundary is that
/// of its edges, which are images too.
FaceGrid image_of_face(const Topology& topology, const Face& face, const FaceGrid& of,
                       const std::vector<EdgeGrid>& edges) {
    FaceGrid grid;
    grid.points = face_boundary(face, edges);
    const PeriodicMap map = image_map(topology, *face.image);
    const Extent e = grid.points.extent();
    for (int j = 1; j + 1 < e.nj; ++j) {
        for (int i = 1; i + 1 < e.ni; ++i) {
            const Node n = map_node(face.image->orientation, {i, j, 0}, of.points.extent());
            grid.points.set(i, j, 0, image(map, of.points(n[0], n[1])));
        }
    }
    grid.flat_corners = flat_corners(grid.points, false);
    return grid;
}

}  // namespace

std::vector<FaceGrid> make_faces(const Topology& topology, const std::vector<EdgeGrid>& edges,
                                 const std::function<void()>& done) {
    std::vector<std::size_t> sizes;
    for (const Face& face : topology.faces) sizes.push_back(face.extent().nodes());
    std::vector<FaceGrid> grids(topology.faces.size());
    largest_first(sizes, done, [&](std::size_t index) {
        const Face& face = topology.faces[index];
        if (!face.image) grids[index] = make_face(face, edges, topology.planar);
    });
    for (std::size_t index = 0; index < grids.size(); ++index) {
        const Face& face = topology.faces[index];
        if (!face.image) continue;
        const FaceGrid& of = grids[static_cast<std::size_t>(face.image->of)];
        grids[index] = image_of_face(topology, face, of, edges);
    }
    return grids;
}

FaceGrid every_nth(const FaceGrid& grid, int stride) {
    return {every_nth(grid.points, stride), grid.solve,
            every_nth(grid.points, grid.heights, stride), grid.off_surface, grid.flat_corners};
}

}  // namespace hexweave
