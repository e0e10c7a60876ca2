// SPDX-License-Identifier: Apache-2.0
// The table of the format: the case as a whole, its solver, gates and boundaries.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

std::vector<ValueForm> mappings(const Keys& names) {
    std::vector<ValueForm> list;
    for (const std::string_view name : names) list.push_back(mapping(name));
    return list;
}

std::vector<ValueForm> curve_forms() {
    return mappings({"curve_line", "curve_polyline", "curve_spline", "curve_circle", "curve_arc",
                     "curve_ellipse", "curve_naca", "curve_airfoil", "curve_formula", "curve_nurbs",
                     "curve_cad", "curve_of", "curve_of_equal_u", "curve_of_equal_v",
                     "curve_of_side", "curve_of_line", "curve_of_points"});
}

std::vector<ValueForm> surface_forms() {
    return mappings({"surface_formula", "surface_plane", "surface_sphere", "surface_cylinder",
                     "surface_cone", "surface_ruled", "surface_revolution", "surface_extrusion",
                     "surface_control_points", "surface_nurbs", "surface_cad", "surface_of"});
}

MappingFormat the_case() {
    return {
        "case",
        "The whole file.",
        {{"hexweave", {words({"1"})}, key_required, "version of the format", "hexweave: 1"},
         {"title", {text()}, "", "a line of text, written to the grid", "title: RAE 2822"},
         {"units", {words({"m", "mm", "cm", "in", "ft"})}, "m", "unit of all lengths", "units: mm"},
         {"include",
          {file(), mapping("include"), list({file(), mapping("include")})},
          "",
          "other files, whose sections are merged with those of this one; relative to its folder",
          "include: part.yaml"},
         {"parameters",
          {entries("parameter", {number()})},
          "",
          "names for expressions, in order; `--set NAME=EXPR` replaces one before the others "
          "are computed",
          "parameters: {chord: 2, wall: 1e-5 * chord}"},
         {"curves",
          {entries("curve", curve_forms())},
          "",
          "shapes of edges",
          "curves: {nose: {circle: {center: [0, 0], radius: 1}}}"},
         {"surfaces",
          {entries("surface", surface_forms())},
          "",
          "shapes that faces, edges and vertices lie on",
          "surfaces: {ball: {sphere: {center: [0, 0, 0], radius: 1}}}"},
         {"vertices",
          {entries("vertex", {point(), mapping("vertex_point"), mapping("vertex_on_curve"),
                              mapping("vertex_on_surface")})},
          "",
          "named points",
          "vertices: {a: [0, 0], b: [1, 0]}"},
         {"edges",
          {entries("edge", {mapping("edge"), mapping("pole")})},
          "",
          "lines between vertices, with points on them",
          "edges: {south: {from: a, to: b, cells: 40}}"},
         {"faces",
          {entries("face", {mapping("face"), mapping("face_by_corners")}, 32)},
          "",
          "four sides of edges, or four corners",
          "faces: {square: {corners: [a, b, c, d]}}"},
         {"blocks",
          {entries("block", {mapping("block"), mapping("block_by_corners")}, 32)},
          "the faces are the grid",
          "six sides of faces, or eight corners",
          "blocks: {box: {corners: [a, b, c, d, e, f, g, h]}}"},
         {"boundaries",
          {entries("boundary", {mapping("boundary")}, 32)},
          "",
          "families of free sides",
          "boundaries: {wall: {type: BCWall, sides: [south]}}"},
         {"periodic",
          {entries("interface", {mapping("periodic")}, 32)},
          "",
          "sides that are images of others by translation or rotation",
          "periodic: {pitch: {from: lower, to: upper, translate: [0, 0.5]}}"},
         {"levels",
          {mapping("levels")},
          "",
          "the family of grids that the file describes",
          "levels: {names: [coarse, medium, fine]}"},
         {"level",
          {text()},
          "`medium` with `levels`, else the counts as written",
          "which grid of the family is made; `--level NAME` comes before it",
          "level: fine"},
         {"multiple_of",
          {count()},
          "1",
          "the cells of every edge are raised to the next multiple: of 2^n for n coarser grids of "
          "a "
          "multigrid solver",
          "multiple_of: 8"},
         {"extrude",
          {mapping("extrude")},
          "",
          "makes a planar grid one of blocks, along a vector",
          "extrude: {along: [0, 0, 1], cells: 1}"},
         {"revolve",
          {mapping("revolve")},
          "",
          "makes a planar grid one of blocks, about an axis",
          "revolve: {axis: [1, 0, 0], angle: pi / 2, cells: 12}"},
         {"mirror",
          {mapping("mirror_copy")},
          "",
          "sets the mirror image of the whole grid beside it",
          "mirror: {at: symmetry}"},
         {"components",
          {entries("component", {mapping("component")})},
          "",
          "parts of a topology, to be used by instances",
          "components: {plate: {vertices: {a: [0, 0], b: [1, 0]}}}"},
         {"instances",
          {entries("instance", {mapping("instance")})},
          "",
          "components where they are used, moved and joined",
          "instances: {upper: {of: strip, translate: [0, 1]}}"},
         {"solver",
          {mapping("solver")},
          "",
          "how far faces and blocks are solved",
          "solver: {tolerance: 1e-4}"},
         {"require",
          {mapping("gates")},
          "",
          "limits that the whole grid must keep",
          "require: {min_angle: 20}"},
         {"output",
          {mapping("output")},
          "`cgns`, under the name of the file",
          "files to write, by format; `-o FILE` replaces them",
          "output: {cgns: wing.cgns}"}}};
}

MappingFormat include() {
    return {"include",
            "Another file, with other values of its parameters.",
            {{"file", {file()}, key_required, "which", "file: part.yaml"},
             {"set",
              {entries("parameter", {number()})},
              "those of the file",
              "values of its parameters, before the others are computed",
              "file: part.yaml, set: {length: 2}"},
             {"when",
              {number()},
              "always",
              "include it where this is not 0; an expression in the parameters of this file",
              "when: 2 > 1"}}};
}

MappingFormat any_entry() {
    return {"any_entry",
            "What may stand at every entry of a section.",
            {{"when",
              {number()},
              "always",
              "without which (0) the entry is not there; mostly a comparison",
              "when: 2 > 1"},
             {"repeat",
              {entries("index", {pair(number())})},
              "once",
              "an entry for each value of an index, from the first to the last, which expressions "
              "may use, and names in braces: `blade{i}`",
              "repeat: {i: [1, 0]}"}}};
}

MappingFormat levels() {
    return {"levels",
            "A family of grids, the counts in the file being those of `medium`. At a whole factor "
            "the finest is solved and the others are every 2nd, 4th, ... point of it; at any other "
            "each is solved, its cells at walls scaled like its counts.",
            {{"factor",
              {number(Quantity::none, {.above = 1, .at_most = 4})},
              "2",
              "of the cells along an edge, from each level to the next",
              "factor: 1.5"},
             {"names",
              {list({text()}, 2, 8)},
              "[coarse, medium, fine]",
              "of the levels, coarsest first; `medium` must be one",
              "names: [coarse, medium, fine, extra_fine]"}}};
}

MappingFormat solver() {
    return {"solver",
            "How far faces and blocks are solved.",
            {{"tolerance",
              {number(Quantity::none, positive)},
              "1e-3",
              "the displacement that may remain, in cells",
              "tolerance: 1e-4"},
             {"maximum_cycles", {count()}, "200", "most cycles of one solve", "maximum_cycles: 50"},
             {"start",
              {words({"transfinite", "folded"})},
              "transfinite",
              "the grid that solving begins from; `folded` is a test of robustness",
              "start: folded"},
             {"flat_edge_exponent",
              {number(Quantity::none, {.above = 0, .at_most = 1})},
              "0.7 in grids of blocks, else 1",
              "exponent of edge functions where two sides meet flat",
              "flat_edge_exponent: 0.8"}}};
}

MappingFormat gates() {
    return {"gates",
            "Limits that a grid, a face or a block must keep; where one is missed the grid is "
            "written, and the exit code is 1.",
            {{"min_scaled_jacobian",
              {number(Quantity::none, {.above = 0, .below = 1})},
              "",
              "least scaled Jacobian of a corner of a cell",
              "min_scaled_jacobian: 0.2"},
             {"min_angle",
              {number(Quantity::degrees, {.above = 0, .below = 90})},
              "",
              "least angle of a cell",
              "min_angle: 20"},
             {"max_angle",
              {number(Quantity::degrees, {.above = 90, .below = 180})},
              "",
              "greatest angle of a cell",
              "max_angle: 160"},
             {"max_skewness",
              {number(Quantity::none, {.above = 0, .below = 1})},
              "",
              "greatest abs(angle - 90) / 90",
              "max_skewness: 0.8"},
             {"max_growth",
              {number(Quantity::none, {.above = 1})},
              "",
              "greatest ratio of neighbouring intervals on a grid line",
              "max_growth: 1.3"},
             {"max_wall_angle",
              {number(Quantity::degrees, {.above = 0, .below = 90})},
              "",
              "by which lines leave a wall off its normal, but beside its ends",
              "max_wall_angle: 20"},
             {"wall_spacing_error",
              {number(Quantity::none, positive)},
              "",
              "relative error of the cells asked at ends of edges and, all over walls, of heights",
              "wall_spacing_error: 0.1"}}};
}

MappingFormat boundary() {
    return {"boundary",
            "A family of free sides.",
            {{"type",
              {words({"BCWall",
                      "BCWallViscous",
                      "BCWallInviscid",
                      "BCWallViscousHeatFlux",
                      "BCWallViscousIsothermal",
                      "BCSymmetryPlane",
                      "BCSymmetryPolar",
                      "BCFarfield",
                      "BCInflow",
                      "BCInflowSubsonic",
                      "BCInflowSupersonic",
                      "BCOutflow",
                      "BCOutflowSubsonic",
                      "BCOutflowSupersonic",
                      "BCTunnelInflow",
                      "BCTunnelOutflow",
                      "BCExtrapolate",
                      "BCDegenerateLine",
                      "BCDegeneratePoint",
                      "BCAxisymmetricWedge"})},
              key_required,
              "boundary condition, as CGNS calls it",
              "type: BCWallViscous"},
             {"sides",
              {name("edge"), name("face"), list({name("edge"), name("face")})},
              "required, but for an end of `extrude` or `revolve`",
              "its edges in a grid of faces, its faces in a grid of blocks",
              "sides: [upper, lower]"},
             {"plane",
              {axis_plane()},
              "",
              "puts the points of a symmetry plane exactly there",
              "plane: \"z = 0\""}}};
}

}  // namespace

std::vector<MappingFormat> formats_of_case() {
    return {the_case(), format_of_component(the_case()),
            include(),  any_entry(),
            levels(),   solver(),
            gates(),    boundary()};
}

}  // namespace hexweave
