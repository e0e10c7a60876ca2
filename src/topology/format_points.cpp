// SPDX-License-Identifier: Apache-2.0
// The table of the format: vertices, edges and their spacings.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

std::vector<MappingFormat> vertices() {
    return {
        {"vertex_point",
         "A point, where something is said of it besides.",
         {{"point", {point()}, key_required, "its coordinates", "point: [1, 0]"}}},
        {"vertex_on_curve",
         "A place on a curve.",
         {{"curve", {name("curve")}, key_required, "which", "curve: root"},
          {"at",
           {number(Quantity::fraction, {.at_least = 0, .at_most = 1})},
           key_required,
           "of the curve's arc length",
           "at: 0.25"}}},
        {"vertex_on_surface",
         "A place on a surface.",
         {{"surface",
           {name("surface"), list({name("surface")})},
           key_required,
           "which; several with `near`",
           "surface: wing"},
          {"at", {pair(number())}, "", "u and v of the surface", "at: [0.25, 0.5]"},
          {"near",
           {point()},
           "",
           "a point whose nearest one on the surface is meant",
           "near: [0.3, 0.5, 0.1]"}},
         {},
         {{"at", "near"}}},
    };
}

std::vector<KeyFormat> edge_keys() {
    return {
        {"from", {name("vertex")}, key_required, "where it begins", "from: a"},
        {"to", {name("vertex")}, key_required, "where it ends", "to: b"},
        {"along",
         {name("curve")},
         "a straight line",
         "its curve; both vertices must lie on it",
         "along: root"},
        {"surface",
         {name("surface"), list({name("surface")})},
         "",
         "that it is put onto",
         "surface: wing"},
        {"gap",
         {length()},
         "1e-6 of the surface's size, 1e-9 of the grid's for a plane",
         "how far its ends may be off its surface, it off its plane",
         "surface: wing, gap: 1e-4"},
        {"plane", {axis_plane()}, "", "that its points are put exactly on", "plane: \"z = 0\""},
        {"through", {point()}, "", "picks the way on a closed curve", "through: [0, 1]"},
        {"cells",
         {count()},
         "those of opposite sides",
         "how many; one mention fixes all that are opposite",
         "cells: 40"},
        {"multiple_of",
         {count()},
         "1",
         "its cells, and those of the edges opposite, are raised to the next multiple",
         "multiple_of: 8"},
        {"spacing",
         {words({"uniform"}), mapping("spacing"), mapping("spacing_like"),
          mapping("spacing_positions"), mapping("spacing_parameters")},
         "that of the nearest parallel edge, else uniform",
         "how its points are placed",
         "spacing: {start: 1e-5, end: 0.1}"},
    };
}

std::vector<MappingFormat> edges() {
    return {
        {"edge", "A line between two vertices, with points on it.", edge_keys()},
        {"pole",
         "An edge collapsed to a vertex.",
         {{"at", {name("vertex")}, key_required, "the vertex", "at: a"},
          {"cells", {count()}, "those of opposite sides", "how many", "cells: 16"}}},
    };
}

std::vector<MappingFormat> spacings() {
    return {
        {"spacing",
         "A law with first and last cells, as arc lengths.",
         {{"start", {length()}, "free", "first cell", "start: 1e-5"},
          {"end", {length()}, "free", "last cell", "end: 0.1"},
          {"natural",
           {length()},
           "",
           "first cell of the law that points follow from the distance `within` on",
           "start: 1e-5, natural: 1.2e-6, within: 0.03"},
          {"within",
           {length()},
           "",
           "how far from the wall points are moved to meet `start` (`end`)",
           "start: 1e-5, natural: 1.2e-6, within: 0.03"},
          {"law",
           {words({"tanh", "geometric", "uniform"})},
           "tanh",
           "`tanh` meets one or both cells, `geometric` has a constant ratio",
           "law: geometric, start: 1e-5"},
          {"ratio",
           {number(Quantity::none, positive)},
           "",
           "of each cell to the one before, of the law `geometric`",
           "law: geometric, ratio: 1.2"}}},
        {"spacing_like",
         "The fractions of another edge.",
         {{"like",
           {signed_name("edge")},
           key_required,
           "which; matched at a common vertex, else start to start; `-` reverses",
           "like: south"}}},
        {"spacing_positions",
         "Points where they are wanted, by fractions of the arc length.",
         {{"positions",
           {list({number(Quantity::fraction)}, 2), formula("t")},
           key_required,
           "from 0 to 1, or a formula of t = index / cells",
           "positions: t^2"}}},
        {"spacing_parameters",
         "Points where they are wanted, by fractions of the curve's own parameter.",
         {{"parameters",
           {list({number(Quantity::fraction)}, 2), formula("t")},
           key_required,
           "from 0 to 1, or a formula of t = index / cells",
           "parameters: [0, 0.2, 0.5, 1]"}}},
    };
}

}  // namespace

std::vector<MappingFormat> formats_of_points() {
    std::vector<MappingFormat> all;
    for (const auto part : {vertices, edges, spacings}) {
        for (MappingFormat& format : part()) all.push_back(std::move(format));
    }
    return all;
}

}  // namespace hexweave
