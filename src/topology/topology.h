// SPDX-License-Identifier: Apache-2.0
// The topology as resolved: every name an index, every direction, orientation, cell count and
// spacing law known. A Topology exists only if it is valid; the stages that follow check nothing of
// the user's input again.
//
// Faces: corners run (imin,jmin), (imax,jmin), (imax,jmax), (imin,jmax).
//
//        jmax              Sides imin and imax run along increasing j, jmin and jmax along
//    3 --------- 2         increasing i.
//    |           |
//  imin  face   imax
//    |           |
//    0 --------- 1
//        jmin
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/diagnostics.h"
#include "core/grid_output.h"
#include "core/multiblock.h"
#include "core/orientation.h"
#include "core/periodic_image.h"
#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/surface.h"
#include "topology/case.h"

namespace hexweave {

struct Vertex {
    std::string name;
    Vec3 position;
    Place place;
};

/// The normalized arc-length distribution of another edge of as many cells, whose own law is not a
/// SameAs: one step leads to the law.
struct SameAs {
    int edge = 0;
    bool reversed = false;
};
using SpacingLaw = std::variant<UniformLaw, TanhLaw, GeometricLaw, ExplicitLaw, SameAs>;

/// Says that an edge (face) is the image of edge (face) `of` under the map of a periodic interface:
/// all its points are. `orientation` takes its own axes to those of the other one.
struct ImageOf {
    int of = 0;
    Orientation orientation;
    int interface = 0;  ///< of the topology
    bool back = false;  ///< under the inverse map

    bool reversed() const { return orientation.axes[0] < 0; }  ///< of an edge
};

/// A piece of a curve from vertex `start` to vertex `end`. `from` and `to` are curve parameters (to
/// < from where the edge runs against the curve; outside the range where it crosses the seam of a
/// closed one). The grid's end points are the vertices themselves, to the last bit.
struct Edge {
    std::string name;
    Place place;
    int start = 0;
    int end = 0;
    std::shared_ptr<const Curve> curve;
    double from = 0;
    double to = 1;
    double length = 0;
    int cells = 1;
    /// Cells for each of those that the law is determined with: 2, 4, ... in the finest grid of a
    /// nested family, where the law is continued between its points.
    int refinement = 1;
    SpacingLaw law;
    std::optional<double> asked_start;  ///< first cell asked by this edge's own law
    std::optional<double> asked_end;
    std::vector<AxisPlane> planes;  ///< that it lies on: its points are exactly there
    bool made = false;              ///< not drawn by the user: a straight edge between two corners
    bool pole = false;              ///< collapsed to one vertex: no length, all its points there
    bool on_axis = false;           ///< of the revolution of the grid, which collapses it
    std::optional<ImageOf> image;   ///< where its points are those of another edge, carried over
};

/// A vertex or an edge that was put onto a surface or a plane, and how far it was moved for that at
/// most.
struct PutOnSurface {
    std::string what;      ///< "vertex 'a'"
    std::string surfaces;  ///< "surface 'wing'", "plane z = 0"
    double distance = 0;
    Vec3 place;  ///< before
};

/// An edge as a part of a side. A pole has no direction: it is never reversed.
struct EdgeUse {
    int edge = 0;
    bool reversed = false;
    bool pole = false;

    friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

/// How a face or block is made.
struct SolveRequest {
    Method method = Method::elliptic;
    double tolerance = 1e-3;  ///< displacement in cells
    int maximum_cycles = 200;
    bool start_folded = false;
    /// Of edge functions at an end where two sides meet flat; 1 is the arc length.
    double flat_edge_exponent = 1;
    HeightRequests heights{};
    std::vector<Gate> gates{};
};

struct Face {
    std::string name;
    Place place;
    std::array<std::vector<EdgeUse>, 4> sides;  ///< indexed by Side::imin .. Side::jmax
    std::array<int, 4> corners{};               ///< vertices
    int cells_i = 1;
    int cells_j = 1;
    SolveRequest solve;
    std::array<bool, 4> orthogonal{};        ///< by side: grid lines meet it at right angles
    std::shared_ptr<const Surface> surface;  ///< that it lies on, where it is one
    std::vector<std::shared_ptr<const Surface>> patches;  ///< where there are several
    std::optional<AxisPlane>
        plane;  ///< the symmetry plane it lies on: its points are exactly there
    bool made = false;
    std::optional<ImageOf> image;  ///< where its points are those of another face, carried over
    /// Collapsed along i, along j: every grid line along that axis is one point. Along both, the
    /// face is a vertex; along one, an edge.
    std::array<bool, 2> collapsed{};

    bool is_collapsed() const { return collapsed[0] || collapsed[1]; }
    const std::vector<EdgeUse>& side(Side s) const { return sides[static_cast<std::size_t>(s)]; }
    Extent extent() const { return {cells_i + 1, cells_j + 1, 1}; }
    /// Otherwise it is a minimal surface.
    bool is_on_surface() const { return surface != nullptr || !patches.empty(); }
};

/// A face as a side of a block, or as a part of one: `orientation` takes the side's two tangential
/// axes (ascending) to the face's (i, j); `begin` is the side's node where the face begins.
struct FaceUse {
    int face = 0;
    Orientation orientation;
    std::array<int, 2> begin{};
};

/// A side of a block: one face, or a rectangular arrangement of several, row by row. Rows run along
/// the side's first tangential axis and follow each other along the second.
struct BlockSide {
    int columns = 1;  ///< faces in a row
    std::vector<FaceUse> faces{1};

    int rows() const { return static_cast<int>(faces.size()) / columns; }
    const FaceUse& at(int column, int row) const {
        const auto index = [](int n) { return static_cast<std::size_t>(n); };
        return faces[index(column) + index(row) * index(columns)];
    }
};

struct Block {
    std::string name;
    Place place;
    std::array<BlockSide, 6> sides;
    std::array<int, 8> corners{};  ///< vertices in the order of the CGNS hexahedron
    Extent extent;                 ///< nodes
    SolveRequest solve;

    const BlockSide& side(Side s) const { return sides[static_cast<std::size_t>(s)]; }
};

/// A named part of the boundary: edges in two dimensions, faces in three. `plane` for a symmetry
/// plane.
struct Boundary {
    Family family;
    std::vector<int> sides;
    std::optional<AxisPlane> plane;
};

/// Two sides of the grid (edges in two dimensions, faces in three) of which `to` is the image of
/// `from`; `orientation` takes the axes of `to` to those of `from`.
struct PeriodicPair {
    int from = 0;
    int to = 0;
    Orientation orientation;
};

/// Sides that are joined though they lie apart: a map carries the one onto the other.
struct PeriodicInterface {
    std::string name;
    Place place;
    Periodicity periodicity;
    std::vector<PeriodicPair> pairs;
};

/// How a planar grid is swept into space: layer by layer along a vector or about an axis.
struct Sweep {
    Periodicity whole;  ///< what carries the first plane, z = 0, onto the last
    int cells = 1;
    bool single = false;  ///< one cell is asked for, and had at every level
    int refinement = 1;   ///< cells of the solved level for each that the law is determined with
    int stride = 1;       ///< and for each of this level
    SpacingLaw law;
    double length = 1;      ///< that the law is for
    bool reversed = false;  ///< k runs from the last plane to the first, for right-handed blocks
    std::array<std::string, 2> ends;  ///< boundaries of the first and the last plane
    bool joined = false;              ///< the two ends are, and have no boundary
    bool full_turn = false;           ///< they are the same plane
};

/// What stands for a sweep where counts of edges are listed; no edge can be called so.
inline constexpr const char* sweep_layers = "layers of the sweep";

/// What the names of zones and families of mirror images end in.
inline constexpr const char* mirror_suffix = "_mirror";

/// The mirror image that the whole grid is to have beside it.
struct MirrorCopy {
    AxisPlane plane;
    int boundary = 0;  ///< whose sides lie on the plane: they become interfaces
    bool families_apart = false;
};

/// The cells of an edge, and of those parallel to it, or of a sweep, where they are others than the
/// file says: for a level, for a multiple, or for the sums over the sides of a face.
struct AdjustedCount {
    std::string edge;  ///< or `sweep_layers`
    int written = 0;   ///< as in the file
    double asked = 0;  ///< the same times the level's factor
    int got = 0;

    /// More than the level asks for.
    bool raised() const { return got > asked * (1 + 1e-9); }
};

/// The family of grids that a topology is one of.
struct GridFamily {
    double factor = 2;               ///< of the cells along an edge, from level to level
    std::vector<std::string> names;  ///< coarsest first
    std::size_t medium = 0;          ///< the level whose counts stand in the file
    std::size_t wanted = 0;          ///< the one that was asked for
    std::size_t level = 0;           ///< the one that the topology's counts are of

    /// Whether the coarser levels are every n-th point of the finest.
    bool nested() const;
    /// The cells along an edge at a level, over those in the file.
    double times_medium(std::size_t of) const;
    /// Cells of the topology's level to each of a nested level that is not finer.
    int stride(std::size_t to) const;
};

struct Topology {
    std::string title;
    std::string units;
    std::string provenance;
    std::vector<Parameter> parameters;  ///< with their values, for the record
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Block> blocks;
    std::vector<Boundary> boundaries;  ///< covers every free side; `unassigned` added where needed
    std::vector<PeriodicInterface> periodic;
    std::optional<Sweep> sweep;
    std::optional<MirrorCopy> mirror;
    std::vector<AdjustedCount> adjusted_counts;  ///< in a family, of every chain of edges
    std::optional<GridFamily> family;
    std::vector<PutOnSurface> put_on_surface;
    std::vector<Gate> gates;          ///< on the whole grid
    std::vector<GridOutput> outputs;  ///< as the file names them
    bool planar = true;               ///< no blocks and every point in z = 0
    /// The greatest distance between vertices or sampled edge points: the scale of tolerances.
    double size = 1;

    bool is_3d() const { return !blocks.empty(); }
    /// Of the zone that a face makes: as thick as its sweep.
    Extent zone_extent(const Face& face) const {
        return {face.cells_i + 1, face.cells_j + 1, sweep ? sweep->cells + 1 : 1};
    }
    std::size_t cells() const {
        std::size_t sum = 0;
        if (is_3d()) {
            for (const Block& b : blocks) sum += b.extent.cells();
        } else {
            for (const Face& f : faces) sum += zone_extent(f).cells();
        }
        return mirror ? 2 * sum : sum;
    }
};

/// The map that an image is made with.
inline PeriodicMap image_map(const Topology& topology, const ImageOf& image) {
    const Periodicity& forth =
        topology.periodic[static_cast<std::size_t>(image.interface)].periodicity;
    return periodic_map(image.back ? backwards(forth) : forth);
}

}  // namespace hexweave
