// SPDX-License-Identifier: Apache-2.0
// Boundaries, parameters and start grids for the tests of the elliptic solver, made without the
// code under test, and the difference of two grids in cells.
#pragma once

#include <functional>
#include <vector>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave::shapes {

/// A face or block as the solver is given it.
struct Problem {
    PointField points;
    ParameterField parameters;
};

/// A map of the unit square or cube of index fractions (i / (ni - 1), ...).
using Map = std::function<Vec3(double xi, double eta, double zeta)>;
/// The map at every node.
PointField sample(const Extent& extent, const Map& map);
ParameterField sample_parameters(const Extent& extent, const Map& map);

/// Normalized arc length on the edges of a face, the straight-line map inside.
ParameterField straight_line_parameters(const PointField& points);
/// Interior nodes by transfinite interpolation with the parameters as blending coordinates.
void interpolate(PointField& points, const ParameterField& parameters);
/// Interior nodes anywhere in the box from `low` to `high`, in no order (the same every time).
void scatter(PointField& points, const Vec3& low, const Vec3& high);

/// n + 1 positions from 0 to 1 with geometrically growing intervals, the first one `first`.
std::vector<double> geometric(int n, double first);

/// The region above a meandering wall with overhangs of `angle` radians: points thick at the wall
/// (first cell 1e-4 of the height), interior by transfinite interpolation.
Problem meander(int ni, int nj, double angle);
/// An O-block round a slender ellipse: cut along a straight line from its rear end to the far
/// circle of 20 chords; first cell `first` of the radius. Interior by transfinite interpolation.
Problem ring(int ni, int nj, double first);
/// A minimal surface over a quarter of an annulus, with a boundary that leaves every plane; the
/// first cells at jmin `first` of the lines' length.
Problem clustered_saddle(int ni, int nj, double first);
/// A bent and twisted block above a bumpy floor, with first cells `first` of the height at kmin.
Problem clustered_block(const Extent& extent, double first);
/// A cube with deeply waved faces, uniform, `n` nodes along each axis; interior by transfinite
/// interpolation.
Problem wavy_cube(int n);
/// Folds the interior of a block: large smooth displacements that vanish on its boundary.
void fold(Problem& problem);

/// A one-to-one map of the unit square (cube) onto itself that is neither uniform nor a product:
/// grid lines lean, intervals grow, mixed derivatives do not vanish.
Vec3 leaning(double xi, double eta, double zeta);

/// Annulus sector between radii 1 and 3, a quarter turn, one high: s = log r / log 3, t and u are
/// harmonic, so (xi, eta, zeta) -> annulus(leaning(...)) solves the grid equations of parameters
/// leaning(...) exactly. Planar for u = 0.
Vec3 annulus(const Vec3& s);

/// Every node of the grid as the solver sees it.
std::vector<Vec3> nodes_of(const PointField& points);
std::vector<Vec3> nodes_of(const ParameterField& parameters);

/// The largest distance of two grids at interior nodes over the shortest of the node's grid lines
/// to its neighbours in `reference`: in cells, and never fewer than along any axis.
double difference_in_cells(const PointField& grid, const PointField& reference);

}  // namespace hexweave::shapes
