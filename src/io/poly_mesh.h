// SPDX-License-Identifier: Apache-2.0
// A multiblock grid as one unstructured mesh of polyhedra, the way OpenFOAM keeps it: points, faces
// with an owner and, inside, a neighbour, and patches of boundary faces.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave {

/// What a patch of type "cyclic" says of the other half of its pair: its n-th face is the image of
/// this one's n-th, its first point that of this one's first.
struct CyclicHalf {
    std::string neighbour;
    Vec3 separation;  ///< from this half to the other, in metres, where `axis` is 0
    Vec3 axis;        ///< of a rotation, of length 1
    Vec3 centre;      ///< metres
};

/// Boundary faces begin .. begin + count - 1.
struct PolyPatch {
    std::string name;
    std::string type;  ///< "wall", "symmetryPlane", "symmetry", "wedge", "empty", "cyclic", "patch"
    std::size_t begin = 0;
    std::size_t count = 0;
    std::optional<CyclicHalf> cyclic{};
};

struct PolyMesh {
    std::vector<Vec3> points;               ///< metres
    std::vector<std::int32_t> face_points;  ///< of all faces; normals point out of the owner
    std::vector<std::size_t> face_begin;    ///< where each begins, and at the end where all end
    std::vector<std::int32_t> owner;        ///< a cell per face
    std::vector<std::int32_t> neighbour;    ///< a cell per inner face; greater than the owner
    std::vector<PolyPatch> patches;
    std::size_t cells = 0;
};

/// Cells are numbered zone by zone, i fastest; inner faces in upper-triangular order (by owner,
/// then by neighbour). Blocks are joined where interfaces are declared, whatever the coordinates;
/// nodes of a side that coincide to the bit (a collapsed side) become one point, and faces without
/// area vanish. A planar grid becomes one cell thick, one unit of length in z, with its two sides
/// in a patch `frontAndBack` of type `empty`. Patches are the families in their order, then
/// `defaultFaces` for sides that no patch covers; those without faces are left out. Walls become
/// `wall`, symmetry planes `symmetryPlane` (`symmetry` where not plane), others `patch`. Then come
/// the periodic interfaces, a pair of patches `NAME_from` and `NAME_to` of type `cyclic` for all
/// that have one map.
///
/// Throws UsageError when the grid is a curved surface, when a side is covered twice, when joined
/// points, or images, lie apart (by more than a hundredth of the shortest edge there), when a
/// periodic interface both turns and moves, or when there are more than 2^31 - 1 points or faces.
PolyMesh make_poly_mesh(const MultiblockGrid& grid);

}  // namespace hexweave
