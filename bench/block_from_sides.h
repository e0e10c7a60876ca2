// SPDX-License-Identifier: Apache-2.0
// Blocks from edges and faces: what the pipeline does with a file, for shapes given by formulas.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "bench/problems.h"

namespace hexweave::bench {

/// A point of the unit square, or of a block's side, by the fractions of its two node counts.
using SurfaceMap = std::function<Vec3(double, double)>;

/// A face whose nodes are all given by `map` at (i / (ni - 1), j / (nj - 1)).
PointField sampled_face(int ni, int nj, const SurfaceMap& map);

/// The face between four edges, elliptic to 1e-8 of a cell. Edges meet at the corners.
/// Sets `sound` to false where the solve does not converge.
PointField solved_face(const std::vector<Vec3>& jmin, const std::vector<Vec3>& jmax,
                       const std::vector<Vec3>& imin, const std::vector<Vec3>& imax, bool& sound);

/// Row j (or column i) of a face.
std::vector<Vec3> row(const PointField& face, int j);
std::vector<Vec3> column(const PointField& face, int i);

/// The boundary of a block between its sides kmin and kmax, which have (ni, nj) nodes, and its four
/// straight or curved edges along k at the corners (imin,jmin), (imax,jmin), (imin,jmax),
/// (imax,jmax). The four side faces are solved.
PointField block_between(const PointField& kmin, const PointField& kmax,
                         const std::array<std::vector<Vec3>, 4>& rays, bool& sound);

/// Parameters from the boundary points, and the interior by transfinite interpolation. In a block,
/// edge functions take the exponent at ends where two sides meet flat, as the program finds them.
Problem start_grid(const std::string& name, PointField boundary, double flat_edge_exponent = 1);

}  // namespace hexweave::bench
