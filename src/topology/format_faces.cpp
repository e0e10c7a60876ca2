// SPDX-License-Identifier: Apache-2.0
// The table of the format: faces and blocks.
#include <array>
#include <string>

#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

constexpr std::array<std::string_view, 6> sides{"imin", "imax", "jmin", "jmax", "kmin", "kmax"};

KeyFormat tolerance() {
    return {"tolerance",
            {number(Quantity::none, positive)},
            "that of `solver`",
            "the displacement that may remain, in cells",
            "tolerance: 1e-4"};
}

KeyFormat flat_edge_exponent() {
    return {"flat_edge_exponent",
            {number(Quantity::none, {.above = 0, .at_most = 1})},
            "that of `solver`",
            "exponent of edge functions where two sides meet flat",
            "flat_edge_exponent: 0.8"};
}

KeyFormat heights(std::string_view format) {
    return {"heights",
            {mapping(format)},
            "",
            "sides at which first heights are held",
            "heights: {jmin: held}"};
}

KeyFormat method(std::string_view meaning) {
    return {"method", {words({"elliptic", "algebraic"})}, "elliptic", meaning, "method: algebraic"};
}

KeyFormat require() {
    return {
        "require", {mapping("gates")}, "", "limits that it must keep", "require: {min_angle: 20}"};
}

std::vector<MappingFormat> held_heights() {
    const ValueForm held = words({"held"});
    MappingFormat of_face{"face_heights", "Sides of a face at which first heights are held.", {}};
    MappingFormat of_block{"block_heights", "Sides of a block at which heights are held.", {}};
    static constexpr std::array<std::string_view, 6> examples{"imin: held", "imax: {height: 1e-5}",
                                                              "jmin: held", "jmax: held",
                                                              "kmin: held", "kmax: held"};
    for (std::size_t n = 0; n < sides.size(); ++n) {
        const KeyFormat key{
            sides[n], {held, mapping("held_height")}, "", "at this side", examples[n]};
        if (n < 4) of_face.keys.push_back(key);
        of_block.keys.push_back(key);
    }
    return {of_face,
            of_block,
            {"held_height",
             "How the first height is held at a side.",
             {{"height",
               {length()},
               "as the edges have it that leave the side",
               "the height asked everywhere",
               "height: 1e-5"},
              {"fade",
               {number(Quantity::fraction, {.above = 0, .at_most = 1})},
               "0.03",
               "how far from the wall points move, of the side's length",
               "fade: 0.05"},
              {"growth",
               {number(Quantity::none, {.above = 1})},
               "1.3",
               "ratio of neighbouring cells that may not be exceeded for it",
               "growth: 1.2"}}}};
}

std::vector<MappingFormat> faces() {
    MappingFormat by_sides{"face", "A face by its four sides.", {}, {"any_face"}};
    static constexpr std::array<std::string_view, 4> examples{
        "imin: west", "imax: east", "jmin: [south, -wake]", "jmax: north"};
    const ValueForm edge = signed_name("edge");
    for (std::size_t n = 0; n < examples.size(); ++n) {
        by_sides.keys.push_back({sides[n],
                                 {edge, list({edge})},
                                 key_required,
                                 "its edges: one, or several in a row; -edge runs backwards",
                                 examples[n]});
    }
    ValueForm some_sides = words({"imin", "imax", "jmin", "jmax"});
    ValueForm one_or_all = words({"imin", "imax", "jmin", "jmax", "all"});
    return {
        by_sides,
        {"face_by_corners",
         "A face by its four corners; edges that nobody drew are straight.",
         {{"corners",
           {list({name("vertex")}, 4, 4)},
           key_required,
           "in the order (imin,jmin), (imax,jmin), (imax,jmax), (imin,jmax)",
           "corners: [a, b, c, d]"}},
         {"any_face"}},
        {"any_face",
         "What every face may have.",
         {method("a minimal surface (planar where the edges are), or the surface named; or "
                 "transfinite interpolation"),
          tolerance(),
          flat_edge_exponent(),
          heights("face_heights"),
          {"surface",
           {name("surface"), words({"minimal"}), list({name("surface")})},
           "minimal",
           "that it lies on; of several every point is on the nearest, first the first",
           "surface: wing"},
          {"gap",
           {length()},
           "1e-6 of the surface's size",
           "how far its edges may be off its surface",
           "surface: wing, gap: 1e-4"},
          {"orthogonal",
           {one_or_all, list({some_sides})},
           "",
           "sides that grid lines meet at right angles",
           "orthogonal: [jmin, imax]"},
          require()}},
    };
}

std::vector<MappingFormat> blocks() {
    MappingFormat by_sides{"block", "A block by its six sides.", {}, {"any_block"}};
    const std::vector<ValueForm> face{name("face"), mapping("face_use")};
    static constexpr std::array<std::string_view, 6> examples{
        "imin: west",        "imax: {face: east, axes: [-j, i]}",          "jmin: south",
        "jmax: [wing, cap]", "kmin: [[floor1, floor2], [floor3, floor4]]", "kmax: top"};
    for (std::size_t n = 0; n < sides.size(); ++n) {
        by_sides.keys.push_back({sides[n],
                                 {face[0], face[1], list(face), list({list(face)})},
                                 key_required,
                                 "its faces: one, several beside each other, or rows of them along "
                                 "the side's first axis",
                                 examples[n]});
    }
    return {
        by_sides,
        {"block_by_corners",
         "A block by its eight corners; edges and faces that nobody drew are made.",
         {{"corners",
           {list({name("vertex")}, 8, 8)},
           key_required,
           "in the order of the CGNS hexahedron: four round kmin, the four above them",
           "corners: [a, b, c, d, e, f, g, h]"}},
         {"any_block"}},
        {"any_block",
         "What every block may have.",
         {method("solved like the faces, or transfinite interpolation"), tolerance(),
          flat_edge_exponent(), heights("block_heights"), require()}},
        {"face_use",
         "A face whose orientation would be ambiguous.",
         {{"face", {name("face")}, key_required, "which", "face: wing"},
          {"axes",
           {pair(words({"i", "j", "-i", "-j"}))},
           "as its edges tell",
           "the side's two axes in the face's own",
           "axes: [-j, i]"}}},
    };
}

}  // namespace

std::vector<MappingFormat> formats_of_faces() {
    std::vector<MappingFormat> all;
    for (const auto part : {faces, blocks, held_heights}) {
        for (MappingFormat& format : part()) all.push_back(std::move(format));
    }
    return all;
}

}  // namespace hexweave
