// SPDX-License-Identifier: Apache-2.0
// What was measured of a run: the numbers behind the printed report, the JSON, and the exit code.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/field.h"
#include "core/orientation.h"
#include "core/vec3.h"
#include "elliptic/solve_result.h"
#include "faces/held_side.h"
#include "faces/off_surface.h"
#include "quality/angles.h"
#include "quality/growth.h"
#include "quality/walls.h"
#include "topology/gate.h"
#include "topology/topology.h"

namespace hexweave {

/// First and last cell of one edge, asked and got; arc length along the edge. In a nested family
/// those of the level `medium`, whichever the grid is of: the law is asked for them.
struct SpacingMeasure {
    std::string edge;
    int cells = 0;
    double length = 0;
    std::optional<double> asked_start;
    std::optional<double> asked_end;
    double got_start = 0;
    double got_end = 0;
    double first = 0;  ///< of this grid
    double last = 0;
    Vec3 start_place;
    Vec3 end_place;
};

/// First heights at one side of a face or block over those asked there: at all of its nodes where
/// they are held; where they are not, at those on walls, asked by the edges that leave its corners.
struct HeightMeasure {
    Side side = Side::jmin;
    bool held = true;
    double least_asked = 0;
    double greatest_asked = 0;
    double least = 0;  ///< got over asked
    double median = 0;
    double greatest = 0;
    Vec3 least_place;
    Vec3 greatest_place;
    StoppedLines stopped{};      ///< where held
    std::size_t ends_amiss = 0;  ///< nodes at the ends of a held side, fixed, that are amiss

    /// Whether a height is more than a tenth off the asked one.
    bool is_amiss() const { return is_amiss(least) || is_amiss(greatest); }
    static bool is_amiss(double got_over_asked) {
        return got_over_asked < 0.9 || got_over_asked > 1.1;
    }
};

/// A solve of one face or block.
struct SolveMeasure {
    std::string name;
    bool is_block = false;
    Extent extent;
    SolveResult result;
    /// Vertices of a face, edges of a block, where two of its sides meet flat.
    std::vector<std::string> flat_at;
    std::vector<HeightMeasure> heights{};
    std::optional<OffSurface> off_surface{};  ///< of the edges of a face on surfaces

    /// Converged, or nothing was to be solved.
    bool has_converged() const {
        return result.status == SolveStatus::converged || result.status == SolveStatus::algebraic;
    }
    bool ended_well() const { return has_converged() && result.folded_after == 0; }
};

/// The cells of one zone, measured anew from its points.
struct ZoneMeasure {
    std::string name;
    Extent extent;
    std::size_t cells = 0;
    double worst_scaled_jacobian = 1;  ///< over all corners of all cells, flat corners apart
    Node worst_cell{};                 ///< zero-based
    Vec3 worst_place;
    /// The same over the corners whose vertex is no node of the zone's boundary, whose points are
    /// given; 1 where there is none.
    double worst_inside = 1;
    std::size_t folded = 0;
    std::size_t flat_corners = 0;
    std::size_t pole_corners = 0;  ///< where a leg within the zone's boundary has no length
    AngleMeasure angles;
    std::array<GrowthMeasure, 3> growth;  ///< along i, j and k
};

struct InterfaceMeasure {
    std::string name;
    /// Nodes that are not the same to the last bit on its two sides; of a periodic one, not the
    /// images to round-off.
    std::size_t mismatched = 0;
    GrowthMeasure growth;  ///< across it
    bool periodic = false;
    /// The greatest angle, in degrees, by which a grid line bends across it, but at its ends.
    double bend = 0;
    Vec3 bend_place{};
    std::array<std::string, 2> sides{};  ///< "imin of 'o'": of its zone and of its donor
    /// Both sides are of faces that were solved, and `orthogonal` is not asked at both.
    bool may_be_straightened = false;
};

/// A vertex or an edge that was put onto surfaces: how far it was from them at most, and where.
struct PutMeasure {
    std::string what;      ///< "vertex 'a'"
    std::string surfaces;  ///< "surface 'wing'"
    double distance = 0;
    Vec3 place;
};

/// A gate and what came of it.
struct GateResult {
    GateMeasure measure = GateMeasure::min_scaled_jacobian;
    double limit = 0;
    double got = 0;      ///< the worst; 0 where nothing was judged
    bool judged = true;  ///< whether there was anything to judge; if not, the gate is not met
    bool met = true;
    std::string subject;  ///< "face 'x'", "block 'y'"; empty for the whole grid
    std::string where;    ///< "zone 'z'", "edge 'e'"; empty where nothing was judged
    std::optional<Vec3> place;
    Place asked_at;
};

/// Which grid of a family was made.
struct LevelMeasure {
    std::string name;
    double factor = 2;
    std::vector<std::string> names;  ///< of the family, coarsest first
    std::string solved;              ///< the level that was solved
    int stride = 1;                  ///< of its points every so many-th is in this grid
};

/// A level of a family, of that of which the level that is solved.
LevelMeasure level_measure(const GridFamily& solved, std::size_t level);

struct StageTime {
    std::string stage;
    double seconds = 0;
};

struct Report {
    std::string title;
    std::optional<LevelMeasure> level;  ///< where the case is of a family
    std::size_t cells = 0;
    std::size_t nodes = 0;
    std::vector<ZoneMeasure> zones;
    std::vector<InterfaceMeasure> interfaces;
    std::vector<WallMeasure> walls;
    std::vector<SpacingMeasure> spacings;
    std::vector<SolveMeasure> solves;
    std::vector<PutMeasure> put_on_surface;
    std::vector<GateResult> gates;
    std::vector<StageTime> stages;

    std::size_t folded() const;
    std::size_t pole_corners() const;
    double worst_scaled_jacobian() const;
    AngleMeasure angles() const;  ///< of all zones
    std::size_t mismatched() const;
    std::size_t unconverged() const;
    std::size_t missed_gates() const;
    /// Faces of a grid of blocks that fold as surfaces. No cell of the grid need be folded for
    /// that: those of the blocks are judged on their own.
    std::vector<const SolveMeasure*> folded_faces() const;
    /// No folded cell, every solve converged, every interface the same on both sides, no gate
    /// missed.
    bool sound() const {
        return folded() == 0 && unconverged() == 0 && mismatched() == 0 && missed_gates() == 0;
    }
};

}  // namespace hexweave
