// SPDX-License-Identifier: Apache-2.0
// The problems on which solvers are compared: boundary points from formulas, parameters and start
// grid as the program makes them. All are right-handed: A, W and OO are mirrored, so that their
// first axis runs from the trailing to the leading edge, as they were first drawn.
#pragma once

#include <optional>
#include <string>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave::bench {

/// A face or block as the solver is given it.
struct Problem {
    std::string name;
    PointField points;  ///< boundary and start grid
    ParameterField parameters;
};

enum class Start {
    transfinite,
    folded,  ///< turned inside out on purpose
};

struct ProblemOptions {
    Start start = Start::transfinite;
    double first_cell = 0;          ///< at the wall, in the problem's own unit; 0: its standard one
    double flat_edge_exponent = 1;  ///< of edge functions where two sides of a block meet flat
};

/// By name:
///   A       2D  half an O-block round NACA 0012, closed trailing edge; far field at 20 chords,
///               first cell 1e-5
///   B12-B19 2D  meander ("sine-generated") wall of 1.2 ... 1.9 radians, with overhangs; first
///               cell 1e-4
///   Scherk  2D  in space: the boundary of z = log(cos x / cos y) over |x|, |y| <= 1.2
///   W       3D  O-H block over the upper side of a swept tapered wing, far field at 10 chords,
///               first cell 1e-5 local chord
///   OO      3D  O-O block round the same wing with a rounded tip, far field a quarter of a sphere;
///               three side faces in the plane z = 0 meet at 180 degrees
///   C       3D  wavy cube, uniform
/// `extent` counts points; nk is 1 for the faces. Side faces of W and OO are solved by the
/// program's own method to 1e-8 of a cell. Nothing where the name is none of these, the extent does
/// not suit it, or a side face does not converge.
std::optional<Problem> make_problem(const std::string& name, const Extent& extent,
                                    const ProblemOptions& options = {});

/// Whether the name is of a problem in three dimensions.
bool is_block(const std::string& name);

}  // namespace hexweave::bench
