// SPDX-License-Identifier: Apache-2.0
// The table of the format: families of surfaces.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

const Keys further{"any_surface", "transforms"};

std::vector<MappingFormat> parameters() {
    return {
        {"any_surface",
         "What every surface may have; `range` works first, then `swap`, then `reverse`.",
         {{"range",
           {mapping("surface_range")},
           "the whole",
           "a part of it, along a closed parameter across the seam too",
           "range: {u: [0.2, 0.8]}"},
          {"swap", {truth()}, "false", "u is called v, and v u", "swap: true"},
          {"reverse",
           {words({"u", "v", "uv"})},
           "",
           "runs these parameters the other way",
           "reverse: u"}}},
        {"surface_range",
         "A part of a surface.",
         {{"u", {pair(number())}, "the whole", "where u begins and ends", "u: [0.2, 0.8]"},
          {"v", {pair(number())}, "the whole", "where v begins and ends", "v: [0, 0.5]"}}},
    };
}

std::vector<MappingFormat> plain_surfaces() {
    const KeyFormat from{"from", {point()}, key_required, "an end of the axis", "from: [0, 0, 0]"};
    const KeyFormat to{"to", {point()}, key_required, "the other end", "to: [0, 0, 2]"};
    const KeyFormat radius{"radius", {length()}, key_required, "its radius", "radius: 1"};
    return {
        {"surface_plane",
         "A parallelogram: point + u U + v V, where u and v run from 0 to 1.",
         {{"plane",
           {mapping("plane")},
           key_required,
           "a corner and two sides",
           "plane: {point: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0]}"}},
         further},
        {"plane",
         "A parallelogram.",
         {{"point", {point()}, key_required, "its corner", "point: [0, 0, 0]"},
          {"u", {point()}, key_required, "the side along u", "u: [1, 0, 0]"},
          {"v", {point()}, key_required, "the side along v", "v: [0, 1, 0]"}}},
        {"surface_sphere",
         "A sphere: u is the longitude from 0 to 2 pi, v the latitude.",
         {{"sphere",
           {mapping("sphere")},
           key_required,
           "its centre and radius",
           "sphere: {center: [0, 0, 0], radius: 1}"}},
         further},
        {"sphere",
         "A sphere.",
         {{"center", {point()}, key_required, "its centre", "center: [0, 0, 0]"},
          radius,
          {"axis", {point(Quantity::none)}, "[0, 0, 1]", "to the north pole", "axis: [1, 0, 0]"}}},
        {"surface_cylinder",
         "A cylinder: u is the angle about the axis, v runs from 0 to 1 along it.",
         {{"cylinder",
           {mapping("cylinder")},
           key_required,
           "its axis and radius",
           "cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1}"}},
         further},
        {"cylinder", "A cylinder.", {from, to, radius}},
        {"surface_cone",
         "A cone: u is the angle about the axis, v runs from 0 to 1 along it.",
         {{"cone",
           {mapping("cone")},
           key_required,
           "its axis and two radii",
           "cone: {from: [0, 0, 0], to: [0, 0, 2], radii: [1, 0.5]}"}},
         further},
        {"cone",
         "A cone.",
         {from,
          to,
          {"radii",
           {pair(number(Quantity::length, {.at_least = 0}))},
           key_required,
           "at the two ends",
           "radii: [1, 0.5]"}}},
    };
}

std::vector<MappingFormat> made_of_curves() {
    return {
        {"surface_ruled",
         "Straight lines between two curves, at equal shares of their parameters; u is that share, "
         "v runs from 0 to 1.",
         {{"ruled", {pair(name("curve"))}, key_required, "the curves", "ruled: [root, tip]"}},
         further},
        {"surface_revolution",
         "A curve turned about an axis: u is the angle, v the curve's parameter.",
         {{"revolution",
           {mapping("revolution")},
           key_required,
           "the curve and the axis",
           "revolution: {curve: root, axis: [1, 0, 0]}"}},
         further},
        {"revolution",
         "A curve turned about an axis.",
         {{"curve", {name("curve")}, key_required, "the curve", "curve: root"},
          {"axis",
           {point(Quantity::none)},
           key_required,
           "the direction of the axis",
           "axis: [1, 0, 0]"},
          {"center", {point()}, "[0, 0, 0]", "a point of the axis", "center: [0, -1, 0]"},
          {"angle",
           {number(Quantity::angle, {.above = 0})},
           "2 * pi",
           "how far it is turned",
           "angle: pi"}}},
        {"surface_extrusion",
         "A curve moved along: u is the curve's parameter, v runs from 0 to 1 along a vector, or "
         "is the other curve's parameter.",
         {{"extrusion",
           {mapping("extrusion")},
           key_required,
           "the curve and its way",
           "extrusion: {curve: root, along: [0, 0, 3]}"}},
         further},
        {"extrusion",
         "A curve moved along.",
         {{"curve", {name("curve")}, key_required, "the curve", "curve: root"},
          {"along",
           {point(), name("curve")},
           key_required,
           "a vector, or another curve",
           "along: [0, 0, 3]"}}},
        {"surface_of",
         "Another surface, to change.",
         {{"of", {name("surface")}, key_required, "which", "of: wing"}},
         further},
    };
}

std::vector<MappingFormat> free_forms() {
    const ValueForm rows = list({list({point()}, 2)}, 2);
    return {
        {"surface_formula",
         "A surface by formulas.",
         {{"formula",
           {list({formula("u and v")}, 3, 3)},
           key_required,
           "x, y and z",
           "formula: [u, v, 0.1 * u * v]"},
          {"u", {pair(number())}, key_required, "where u begins and ends", "u: [0, 1]"},
          {"v", {pair(number())}, key_required, "where v begins and ends", "v: [0, 1]"}},
         further},
        {"surface_control_points",
         "A bicubic surface through rows of points; u and v run from 0 to 1.",
         {{"control_points",
           {rows, mapping("point_rows_file")},
           key_required,
           "rows that run along u, or a file of them",
           "control_points: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0.2]]]"}},
         further},
        {"point_rows_file",
         "Rows of points of a file.",
         {{"file", {file()}, key_required, "a Plot3D text file of surfaces", "file: net.xyz"},
          {"block",
           {count()},
           "the only one",
           "which of the file's blocks, from 1 on",
           "block: 1"}}},
        {"surface_nurbs",
         "A rational B-spline over its knots' own ranges.",
         {{"nurbs",
           {mapping("nurbs_surface")},
           key_required,
           "degrees, knots and control points",
           "nurbs: {degree: [1, 1], knots: {u: [0, 0, 1, 1], v: [0, 0, 1, 1]}, control: [[[0, 0, "
           "0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0.2]]]}"}},
         further},
        {"nurbs_surface",
         "A rational B-spline.",
         {{"degree", {pair(count())}, key_required, "along u and v", "degree: [1, 1]"},
          {"knots",
           {mapping("nurbs_knots")},
           key_required,
           "along u and v",
           "knots: {u: [0, 0, 1, 1], v: [0, 0, 1, 1]}"},
          {"control",
           {rows},
           key_required,
           "rows of control points, which run along u",
           "control: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0.2]]]"},
          {"weights",
           {list({list({number(Quantity::none, positive)}, 2)}, 2)},
           "all 1",
           "of the control points, row by row",
           "weights: [[1, 1], [1, 0.7]]"}}},
        {"nurbs_knots",
         "Knots of a surface.",
         {{"u",
           {list({number()})},
           key_required,
           "one more than a row's points and the degree along u",
           "u: [0, 0, 1, 1]"},
          {"v",
           {list({number()})},
           key_required,
           "one more than the rows and the degree along v",
           "v: [0, 0, 1, 1]"}}},
    };
}

}  // namespace

std::vector<MappingFormat> formats_of_surfaces() {
    std::vector<MappingFormat> all;
    for (const auto part : {parameters, plain_surfaces, made_of_curves, free_forms}) {
        for (MappingFormat& format : part()) all.push_back(std::move(format));
    }
    return all;
}

}  // namespace hexweave
