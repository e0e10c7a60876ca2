// SPDX-License-Identifier: Apache-2.0
// The table of the format: families of curves.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

const Keys further{"transforms", "any_curve"};

KeyFormat chord() {
    return {"chord", {length()}, "1", "length from nose to tail", "chord: 0.61"};
}

KeyFormat side() {
    return {"side",
            {words({"upper", "lower", "whole"})},
            "whole",
            "`upper` and `lower` run from the nose to the tail; `whole` from the tail over the "
            "lower side to the nose and back over the upper",
            "side: upper"};
}

KeyFormat normal() {
    return {"normal", {point(Quantity::none)}, "[0, 0, 1]", "of its plane", "normal: [1, 0, 0]"};
}

std::vector<MappingFormat> lines() {
    const ValueForm points = list({point()}, 2);
    return {
        {"any_curve",
         "What every curve may have.",
         {{"reverse", {truth()}, "false", "runs it the other way", "reverse: true"}}},
        {"point_file",
         "Points of a file: a line has two or three numbers, `#` begins a comment.",
         {{"file", {file()}, key_required, "a text file", "file: points.dat"}}},
        {"curve_line",
         "A straight line.",
         {{"line", {pair(point())}, key_required, "its ends", "line: [[0, 0], [1, 0.5]]"}},
         further},
        {"curve_polyline",
         "Straight pieces.",
         {{"polyline",
           {points, mapping("point_file")},
           key_required,
           "their ends",
           "polyline: [[0, 0], [1, 0], [1, 1]]"}},
         further},
        {"curve_spline",
         "An interpolating cubic spline; closed when the last point is the first.",
         {{"spline",
           {points, mapping("point_file")},
           key_required,
           "points on it",
           "spline: {file: points.dat}"}},
         further},
        {"curve_formula",
         "A curve by formulas.",
         {{"formula",
           {list({formula("t")}, 2, 3)},
           key_required,
           "x, y and, where it is not 0, z",
           "formula: [cos(t), 2 * sin(t)]"},
          {"range", {pair(number())}, key_required, "where t begins and ends", "range: [0, pi]"}},
         further},
        {"curve_of",
         "Another curve, to transform.",
         {{"of", {name("curve")}, key_required, "which", "of: root"}},
         further},
    };
}

std::vector<MappingFormat> conics() {
    const KeyFormat center{"center", {point()}, key_required, "its centre", "center: [0, 0]"};
    const KeyFormat radius{"radius", {length()}, key_required, "its radius", "radius: 20"};
    return {
        {"curve_circle",
         "A circle: from the direction +x on, counter-clockwise.",
         {{"circle",
           {mapping("circle")},
           key_required,
           "its centre and radius",
           "circle: {center: [0, 0], radius: 20}"}},
         further},
        {"circle", "A circle.", {center, radius, normal()}},
        {"curve_arc",
         "A part of a circle.",
         {{"arc",
           {mapping("arc"), mapping("arc_through")},
           key_required,
           "its circle and angles, or three points",
           "arc: {center: [0, 0], radius: 2, from: 0, to: pi / 2}"}},
         further},
        {"arc",
         "A part of a circle, by angles.",
         {center,
          radius,
          {"from", {number(Quantity::angle)}, key_required, "where it begins", "from: 0"},
          {"to",
           {number(Quantity::angle)},
           key_required,
           "where it ends; clockwise where that is less",
           "to: pi / 2"},
          normal()}},
        {"arc_through",
         "A part of a circle, through three points.",
         {{"through",
           {list({point()}, 3, 3)},
           key_required,
           "its begin, a point between, and its end",
           "through: [[1, 0], [0, 1], [-1, 0]]"}}},
        {"curve_ellipse",
         "An ellipse: from the end of its first axis on, counter-clockwise.",
         {{"ellipse",
           {mapping("ellipse")},
           key_required,
           "its centre and axes",
           "ellipse: {center: [0, 0], semi_axes: [2, 1]}"}},
         further},
        {"ellipse",
         "An ellipse.",
         {center,
          {"semi_axes", {pair(length())}, key_required, "half of each axis", "semi_axes: [2, 1]"},
          {"angle", {number(Quantity::angle)}, "0", "of the first axis from x", "angle: pi / 6"},
          normal()}},
    };
}

std::vector<MappingFormat> sections() {
    return {
        {"curve_naca",
         "A NACA section of four or five digits.",
         {{"naca", {text()}, key_required, "the digits", "naca: \"0012\""},
          chord(),
          side(),
          {"trailing_edge",
           {words({"sharp", "blunt"})},
           "sharp",
           "whether the thickness at the tail is made zero",
           "trailing_edge: blunt"}},
         further},
        {"curve_airfoil",
         "A section by coordinates of a file, in Selig's or Lednicer's order.",
         {{"airfoil",
           {file()},
           key_required,
           "a text file; lines of header are skipped",
           "airfoil: section.dat"},
          {"chord",
           {length()},
           "that of the file",
           "scales it to this length from nose to tail",
           "chord: 0.61"},
          side(),
          {"close_trailing_edge",
           {truth()},
           "false",
           "joins the two ends at the tail, the gap taken from the whole section",
           "close_trailing_edge: true"},
          {"symmetric_half",
           {truth()},
           "false",
           "the file holds one side, the other is its mirror image",
           "airfoil: half.dat, symmetric_half: true"}},
         further},
    };
}

std::vector<MappingFormat> splines() {
    return {
        {"curve_nurbs",
         "A rational B-spline over its knots' own range.",
         {{"nurbs",
           {mapping("nurbs_curve")},
           key_required,
           "degree, knots and control points",
           "nurbs: {degree: 1, knots: [0, 0, 1, 1], control: [[0, 0], [1, 0]]}"}},
         further},
        {"nurbs_curve",
         "A rational B-spline.",
         {{"degree", {count()}, key_required, "of its polynomials", "degree: 1"},
          {"knots",
           {list({number()})},
           key_required,
           "one more than points and degree together",
           "knots: [0, 0, 1, 1]"},
          {"control",
           {list({point()})},
           key_required,
           "control points",
           "control: [[0, 0], [1, 0]]"},
          {"weights",
           {list({number(Quantity::none, positive)})},
           "all 1",
           "of the control points",
           "weights: [1, 0.7]"}}},
    };
}

std::vector<MappingFormat> on_surfaces() {
    const KeyFormat surface{"surface", {name("surface")}, key_required, "which", "surface: wing"};
    return {
        {"curve_of_equal_u",
         "A line of equal u of a surface.",
         {surface,
          {"u", {number()}, key_required, "its u", "u: 0.3"},
          {"v",
           {pair(number())},
           "that of the surface",
           "where v begins and ends; it may descend",
           "v: [0.8, 0.1]"}},
         further},
        {"curve_of_equal_v",
         "A line of equal v of a surface.",
         {surface,
          {"u",
           {pair(number())},
           "that of the surface",
           "where u begins and ends; it may descend",
           "u: [0.8, 0.1]"},
          {"v", {number()}, key_required, "its v", "v: 0.3"}},
         further},
        {"curve_of_side",
         "A side of a surface's rectangle.",
         {surface,
          {"side", {words({"umin", "umax", "vmin", "vmax"})}, key_required, "which", "side: umin"}},
         further},
        {"curve_of_line",
         "A line on a surface that is straight in its parameters.",
         {surface,
          {"line",
           {pair(list({number()}, 2, 3))},
           key_required,
           "its ends: [u, v], or a point [x, y, z] that is put on the surface",
           "line: [[0.1, 0.2], [0.5, 0.9]]"}},
         further},
        {"curve_of_points",
         "A curve on a surface: its u and v are splines through those of points.",
         {surface,
          {"points",
           {list({point()}, 2), mapping("point_file")},
           key_required,
           "the nearest points of the surface are meant; none may be farther than 1 % of its size",
           "points: [[0.1, 0.1, 0], [0.5, 0.2, 0], [0.9, 0.6, 0]]"},
          {"corner",
           {truth()},
           "false",
           "whether a closed curve has a corner where it closes",
           "points: [[0.1, 0.1, 0], [0.9, 0.1, 0], [0.5, 0.9, 0], [0.1, 0.1, 0]], corner: true"}},
         further},
    };
}

}  // namespace

std::vector<MappingFormat> formats_of_curves() {
    std::vector<MappingFormat> all;
    for (const auto part : {lines, conics, sections, splines, on_surfaces}) {
        for (MappingFormat& format : part()) all.push_back(std::move(format));
    }
    return all;
}

}  // namespace hexweave
