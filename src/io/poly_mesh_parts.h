// SPDX-License-Identifier: Apache-2.0
// Steps on the way from a multiblock grid to one mesh: one number for nodes that are one point,
// what lies behind each side of a cell, and patches as OpenFOAM calls them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/poly_mesh.h"

namespace hexweave {

/// The grid between z = its own and z + 1, with both sides in a family `frontAndBack` of type
/// `empty`. Throws UsageError for a surface that is not flat in z.
MultiblockGrid one_cell_thick(const MultiblockGrid& planar);

/// Whether any patch has another type than its family.
bool has_types_of_patches(const MultiblockGrid& grid);

/// The same grid with such patches in families of their own, of the same name, for a patch of
/// OpenFOAM has one type.
MultiblockGrid with_types_of_families(const MultiblockGrid& grid);

/// Points of the mesh, and the point of every node.
struct PointNumbering {
    std::vector<Vec3> points;                 ///< in metres
    std::vector<std::size_t> first_node;      ///< of each zone
    std::vector<std::int32_t> point_of_node;  ///< zone by zone, i fastest

    std::int32_t at(std::size_t zone, const Extent& extent, const Node& n) const {
        return point_of_node[first_node[zone] + extent.offset(n[0], n[1], n[2])];
    }
};

PointNumbering number_points(const MultiblockGrid& grid);

/// A cell, or the boundary of a family (one past the last family: of none; two past it: of a
/// periodic interface).
struct SideLink {
    bool is_boundary = false;
    std::int32_t index = 0;
};

/// A side of a cell in a periodic interface, and the cell that has the image of this side.
struct CyclicFace {
    Node cell{};  ///< of the interface's own zone
    Side side = Side::imin;
    Node donor{};
};

struct SideLinks {
    std::size_t cells = 0;
    std::vector<std::vector<CyclicFace>> cyclic;              ///< by interface
    std::vector<std::int32_t> first_cell;                     ///< of each zone
    std::vector<Extent> extents;                              ///< of each zone, in cells
    std::vector<std::array<std::vector<SideLink>, 6>> sides;  ///< per zone and side, cell by cell

    std::int32_t cell(std::size_t zone, const Node& n) const;
    /// What lies behind a side of a cell.
    SideLink behind(std::size_t zone, const Node& n, Side side) const;
};

SideLinks link_sides(const MultiblockGrid& grid);

/// Periodic interfaces that one map, or its inverse, belongs to: they make one pair of patches.
struct CyclicPair {
    std::string name;
    Periodicity periodicity;              ///< as the interfaces say
    std::vector<std::size_t> interfaces;  ///< of the grid
    Periodicity exact{};                  ///< as their nodes lie
};

/// Throws UsageError for a map that turns and moves.
std::vector<CyclicPair> cyclic_pairs(const MultiblockGrid& grid);

/// The two halves of a pair: from the one to the other, and back.
std::array<CyclicHalf, 2> cyclic_halves(const CyclicPair& pair, double metres);

/// Whether the interface's own side belongs to the second half of the pair.
bool runs_back(const CyclicPair& pair, const Interface& interface);

/// The name as a word of OpenFOAM, not yet among `taken`.
std::string patch_name(const std::string& family, const std::vector<PolyPatch>& taken);

/// OpenFOAM's type for a CGNS type (others stay as they are when they are OpenFOAM's own).
std::string patch_type(const std::string& type, const PolyMesh& mesh, const PolyPatch& patch);

}  // namespace hexweave
