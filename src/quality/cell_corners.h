// SPDX-License-Identifier: Apache-2.0
// The corners of a cell, each with its Jacobian and with what the boundary of its zone makes of it.
#pragma once

#include <array>

#include "core/field.h"
#include "core/orientation.h"
#include "core/vec3.h"

namespace hexweave {

struct CellCorner {
    Node node{};
    /// The determinant of the three edges that leave the corner in the cell, positive in a sound
    /// cell; of a surface cell, the area that its two edges span seen along the cell's normal.
    double jacobian = 0;
    double scaled_jacobian = 0;  ///< over the product of the edges' lengths
    bool at_pole = false;        ///< an edge within the zone's boundary has no length
    /// Flat (scaled Jacobian zero to 1e-9) where two sides of the zone meet at more than 150
    /// degrees.
    bool flat = false;
    bool inside = false;  ///< its node is not on the zone's boundary

    bool counted_apart() const { return at_pole || flat; }
    /// Not at a pole, not flat, and its scaled Jacobian is not above 1e-9.
    bool folds() const;
};

/// Eight corners of a block's cell, four of a surface cell; corner c lies at the high end of axis a
/// where bit a of c is set.
struct CellCorners {
    std::array<CellCorner, 8> corners;
    int count = 8;

    const CellCorner* begin() const { return corners.data(); }
    const CellCorner* end() const { return corners.data() + count; }
};

/// The unit normal that the cells of a surface zone are measured against: +z where the grid has two
/// dimensions; that of the plane where the zone lies in one (to the round-off of single precision),
/// to the side on which its boundary encloses a positive area. Zero for a surface in space, each
/// cell of which is measured against its own mean normal, and for a block.
Vec3 zone_plane(const PointField& points, int physical_dimension);

/// `plane`: as zone_plane gives it.
CellCorners cell_corners(const PointField& x, const Node& cell, const Vec3& plane);

}  // namespace hexweave
