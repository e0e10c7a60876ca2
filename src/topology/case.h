// SPDX-License-Identifier: Apache-2.0
// The case as written: what the YAML file says, with every expression evaluated and every entry
// knowing its place in the file. Nothing is resolved yet: names are still names.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/diagnostics.h"
#include "core/grid_output.h"
#include "core/orientation.h"
#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/surface.h"
#include "topology/gate.h"

namespace hexweave {

template <class T>
struct Located {
    T value{};
    Place place;
};

/// A name where it is defined or used.
using Name = Located<std::string>;

/// A use of an edge that may be written `-edge`.
struct SignedName {
    std::string value;
    bool reversed = false;
    bool sign_given = false;  ///< written with `-` (or `+`): no inference
    Place place;
};

struct Parameter {
    Name name;
    double value = 0;
    bool overridden = false;  ///< by --set
};

/// The shape is null where it could not be built (a diagnostic says why); names still resolve.
struct CurveEntry {
    Name name;
    std::shared_ptr<const Curve> shape;
    bool used_by_curve = false;  ///< another curve, or a surface, is made of it
};

/// Likewise.
struct SurfaceEntry {
    Name name;
    std::shared_ptr<const Surface> shape;
    bool used_by_surface = false;  ///< another surface, or a curve, is made of it
};

struct OnCurve {
    Name curve;
    double at = 0;  ///< fraction of the curve's arc length
};

/// A place on a surface: its parameters; or the point of one or several surfaces nearest to
/// another.
struct OnSurface {
    std::vector<Name> surfaces;
    std::variant<SurfaceParameters, Vec3> where;
    Place place;  ///< of `where`
};

struct VertexEntry {
    Name name;
    std::variant<Vec3, OnCurve, OnSurface> where;
};

/// Spacing laws. Sizes are arc length along the edge, in the file's units; fractions run from 0 to
/// 1 over the edge, in its own direction.
struct UniformLaw {};
/// Vinokur's tanh: absolute first and last cell, either free.
struct TanhLaw {
    /// Where the asked cell is that of a held wall: the law's own cell is `size`, and the points
    /// nearer than `within` are moved such that the asked one is met. [lengths]
    struct Natural {
        double size = 0;
        double within = 0;
    };

    std::optional<double> start;
    std::optional<double> end;
    std::optional<Natural> natural{};  ///< at the one end that is given
};
/// Each cell is `ratio` times the one before. Either the ratio, or the first cell, or the last.
struct GeometricLaw {
    std::optional<double> ratio;
    std::optional<double> start;
    std::optional<double> end;
};
/// Points where the user says: cells + 1 values from 0 to 1, or a formula of t = index / cells.
/// Fractions of the arc length, or, when `of_parameter`, of the curve's parameter over the edge.
struct ExplicitLaw {
    std::vector<double> values;
    std::function<double(double)> formula;
    bool of_parameter = false;
};
/// The fractions of another edge.
struct LikeLaw {
    SignedName edge;
};
using SpacingEntry = std::variant<UniformLaw, TanhLaw, GeometricLaw, ExplicitLaw, LikeLaw>;

/// A plane given as "x = 0", "y = expr" or "z = expr".
struct AxisPlane {
    int axis = 0;
    double value = 0;
};

struct EdgeEntry {
    Name name;
    Name from;
    Name to;
    std::optional<Name> along;     ///< a straight line where absent
    std::vector<Name> surfaces{};  ///< that it is put onto
    std::optional<double> gap{};   ///< how far its ends may be off them, it off its plane
    std::optional<Located<AxisPlane>> plane{};  ///< that it is put onto
    std::optional<Located<Vec3>> through;       ///< picks the way on a closed curve
    std::optional<Located<int>> cells;
    std::optional<Located<int>> multiple_of{};  ///< that its cells are raised to
    std::optional<Located<SpacingEntry>> spacing;
    bool pole = false;  ///< collapsed to the vertex that is both `from` and `to`
};

enum class Method { elliptic, algebraic };

/// First heights held at a side of a face or block.
struct HeldHeights {
    std::optional<double> height;  ///< from the edges that leave the side where absent
    double fade = 0.03;            ///< of the side's length: how far from it points are moved
    double growth = 1.3;           ///< ratio of neighbouring cells that may not be exceeded for it
    int first = 1;                 ///< the node, counted from the side, that is at the height
};
using HeightRequests = std::array<std::optional<HeldHeights>, 6>;  ///< indexed by Side

/// How a face or block is to be made.
struct MethodEntry {
    Method method = Method::elliptic;
    std::optional<double> tolerance;  ///< displacement in cells; the global one where absent
    std::optional<double> flat_edge_exponent;  ///< the global one where absent
    HeightRequests heights{};
    std::vector<Gate> gates{};
};

/// Four sides (imin, imax, jmin, jmax), each an edge or several in a row; or four corner vertices
/// in the order (imin,jmin), (imax,jmin), (imax,jmax), (imin,jmax).
struct FaceEntry {
    Name name;
    std::variant<std::array<std::vector<SignedName>, 4>, std::array<Name, 4>> shape;
    MethodEntry how;
    std::array<bool, 4> orthogonal{};  ///< by side: grid lines meet it at right angles
    std::vector<Name> surfaces{};      ///< a minimal surface (planar) where empty
    std::optional<double> gap{};       ///< how far its edges may be off them
};

/// A face on a block's side; `axes`, when given, are the side's two axes in the face's own (signed,
/// 1 = i, 2 = j).
struct FaceUseEntry {
    Name face;
    std::optional<std::array<int, 2>> axes;
};

/// The faces on one side of a block: one; or a strip, of which is to be found along which of the
/// side's axes it runs; or rows along the side's first axis, listed along its second.
struct BlockSideEntry {
    std::vector<FaceUseEntry> faces;  ///< row by row
    int columns = 1;                  ///< faces in a row
    bool strip = false;
    Place place;
};

/// Six sides (imin imax jmin jmax kmin kmax), or eight corner vertices in the order of the CGNS
/// hexahedron.
struct BlockEntry {
    Name name;
    std::variant<std::array<BlockSideEntry, 6>, std::array<Name, 8>> shape;
    MethodEntry how;
};

struct BoundaryEntry {
    Name name;
    Name type;  ///< a CGNS BCType name
    std::vector<Name> sides;
    std::optional<Located<AxisPlane>> plane;
    bool lacks_sides = false;  ///< it is an end of a sweep
};

/// A turn about an axis.
struct RotationEntry {
    Vec3 axis;
    Vec3 center;
    double angle = 0;  ///< in radians, right-handed about the axis
};

/// Sides `to` that are the images of the sides `from`, moved by the vector or turned.
struct PeriodicEntry {
    Name name;
    std::vector<Name> from;
    std::vector<Name> to;
    Located<std::variant<Vec3, RotationEntry>> map;
};

/// A planar grid that is moved along a vector or turned about an axis through space.
struct SweepEntry {
    Place place;
    std::variant<Vec3, RotationEntry> map;
    Located<int> cells;
    std::optional<Located<SpacingEntry>> spacing{};
    std::array<std::optional<Name>, 2> ends{};  ///< boundaries of the start and the end
    bool periodic = false;                      ///< the ends are joined
};

/// A mirror image beside the whole grid, joined with it at a symmetry plane.
struct MirrorEntry {
    Place place;
    Name at;                      ///< a boundary with a plane
    bool families_apart = false;  ///< the image has families of its own
};

struct SolverEntry {
    double tolerance = 1e-3;  ///< displacement in cells
    int maximum_cycles = 200;
    bool start_folded = false;  ///< for tests of robustness: begin from a grid folded on purpose
    std::optional<double> flat_edge_exponent;  ///< of edge functions where two sides meet flat
};

/// The family of grids that a file describes, coarsest first; its counts are those of `medium`.
struct LevelsEntry {
    double factor = 2;
    std::vector<std::string> names{"coarse", "medium", "fine"};
    Place place{};  ///< without a file where the file does not say
};

/// Where a component is used.
struct InstanceEntry {
    Name name;  ///< qualified
    Name component;
};

/// A part of an instance that has become what its port is joined to.
struct JoinedPart {
    std::string kind;  ///< "vertex", "edge" or "face"
    std::string name;
    std::string outside;  ///< what it is now
    bool reversed = false;
    Place place;  ///< of the word that joins it
};

/// An entry that is written but not in the case, for its condition does not hold.
struct LeftOutEntry {
    std::string section;  ///< the key: "edges"
    std::string name;     ///< in full
    Place when;
};

struct Case {
    std::shared_ptr<const SourceFile> source;
    std::string title;
    std::string units = "m";
    std::vector<Parameter> parameters;
    std::vector<CurveEntry> curves;
    std::vector<SurfaceEntry> surfaces;
    std::vector<VertexEntry> vertices;
    std::vector<EdgeEntry> edges;
    std::vector<FaceEntry> faces;
    std::vector<BlockEntry> blocks;
    std::vector<BoundaryEntry> boundaries;
    std::vector<PeriodicEntry> periodic;
    std::optional<SweepEntry> sweep;
    std::optional<MirrorEntry> mirror;
    SolverEntry solver;
    std::vector<Gate> gates;
    LevelsEntry levels;
    Name level;                               ///< to be made; empty: medium, if there are levels
    std::optional<Located<int>> multiple_of;  ///< that the cells of every edge are raised to
    std::vector<GridOutput> outputs;
    std::vector<Name> files;  ///< that were read besides it: paths, and where they are named
    std::vector<InstanceEntry> instances;
    std::vector<JoinedPart> joined;
    std::vector<LeftOutEntry> left_out;      ///< for messages about names that are not there
    std::vector<std::string> lost_sections;  ///< keys of those that could not be read
    std::vector<std::string> lost_scopes;    ///< "root." of instances that could not be made
    std::string provenance;                  ///< version, hash of the config, overrides
};

}  // namespace hexweave
