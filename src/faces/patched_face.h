// SPDX-License-Identifier: Apache-2.0
// Faces that run over several surfaces, as over the patches of a CAD model: every point is a point
// of one of them, and where one ends and the next begins does not show in the grid.
#pragma once

#include <memory>
#include <vector>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/harmonic_iteration.h"
#include "faces/map_inverse.h"
#include "faces/off_surface.h"
#include "geometry/surface_set.h"

namespace hexweave {

/// The nodes of a face on several surfaces: for every node the surface that it is on, and its
/// parameters there.
class PatchedFace {
public:
    /// Interpolates the interior of `points` transfinitely between the boundary nodes, which lie on
    /// the surfaces, with `parameters` as blending coordinates, and moves it to the nearest points
    /// of the surfaces; each from its neighbour's place and from those of the boundary nodes across
    /// from it.
    PatchedFace(const std::vector<std::shared_ptr<const Surface>>& surfaces, PointField& points,
                const ParameterField& parameters, bool start_folded = false);

    /// How far the boundary nodes are off the surfaces.
    const OffSurface& off_surface() const { return off_; }

    /// For the solve and untangling; valid as long as this object stays where it is. Nodes move in
    /// space and then to the nearest surface: parameters of a cell beside a pole lead elsewhere.
    BoundFace bound();

private:
    void place_boundary(const PointField& points);
    void place_interior(PointField& points);
    void project_interior(PointField& points);
    double move_nodes(PointField& points, const Field& s, const Field& t,
                      const ParameterField& wanted);
    PatchPoint moved_to(const PointField& points, const CellPlace& place) const;
    PatchPoint& at(int i, int j) { return nodes_[extent_.offset(i, j)]; }
    const PatchPoint& at(int i, int j) const { return nodes_[extent_.offset(i, j)]; }

    SurfaceSet surfaces_;
    Extent extent_;
    std::vector<PatchPoint> nodes_;
    std::vector<PatchPoint> kept_;
    OffSurface off_;
};

}  // namespace hexweave
