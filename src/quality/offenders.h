// SPDX-License-Identifier: Apache-2.0
// Faces and blocks that ended folded or unconverged, each alone, with its worst cells marked: what
// a user looks at to see where a solve went wrong. A face within a grid of blocks counts as well.
#pragma once

#include <string>
#include <vector>

#include "blocks/block_grid.h"
#include "core/field.h"
#include "faces/face_grid.h"
#include "quality/report.h"

namespace hexweave {

/// A value for every cell, i fastest.
struct CellMarks {
    /// The least of the cell's corners, those that are flat and poles apart. Of a face in a plane
    /// negative where a cell lies the wrong way round.
    std::vector<double> scaled_jacobian;
    std::vector<double> folded;  ///< 1 where the cell is, else 0
    std::vector<double> worst;   ///< 1 for the worst cell, to 10; 0 for the others
};

struct Offender {
    std::string name;
    bool is_block = false;
    PointField points;
    CellMarks marks;
};

/// Folded cells first, then those of the least scaled Jacobian.
CellMarks mark_cells(const PointField& points);

/// Those of `report.solves`, which hold the faces and then the blocks.
std::vector<Offender> find_offenders(const Report& report, const std::vector<FaceGrid>& faces,
                                     const std::vector<BlockGrid>& blocks);

}  // namespace hexweave
