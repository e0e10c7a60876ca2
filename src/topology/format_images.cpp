// SPDX-License-Identifier: Apache-2.0
// The table of the format: sides that are images of others.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

ValueForm sides() {
    return list({name("edge"), name("face")});
}

MappingFormat periodic() {
    return {"periodic",
            "Sides that are joined though they lie apart: those of `to` are the images of those of "
            "`from`, and get the very points of theirs, moved or turned.",
            {{"from",
              {name("edge"), name("face"), sides()},
              key_required,
              "edges in a grid of faces, faces in a grid of blocks",
              "from: [lower_in, lower_out]"},
             {"to",
              {name("edge"), name("face"), sides()},
              key_required,
              "as many; which is the image of which follows from where they are",
              "to: [upper_in, upper_out]"},
             {"translate", {point()}, "", "the way from `from` to `to`", "translate: [0, 0.5]"},
             {"rotate",
              {mapping("rotation")},
              "",
              "the turn from `from` to `to`",
              "rotate: {axis: [1, 0, 0], angle: 2 * pi / 36}"}},
            {},
            {{"translate", "rotate"}}};
}

MappingFormat rotation() {
    return {"rotation",
            "A turn about an axis, right-handed.",
            {{"axis",
              {point(Quantity::none)},
              "[0, 0, 1]",
              "along x, y or z, as files tell a turn by angles about these",
              "axis: [1, 0, 0]"},
             {"center", {point()}, "[0, 0, 0]", "a point of the axis", "center: [0, 1]"},
             {"angle", {number(Quantity::angle)}, key_required, "of the turn", "angle: pi / 6"}}};
}

KeyFormat cells() {
    return {"cells", {count()}, "1", "how many layers of cells", "cells: 12"};
}

/// What is said of the two ends of a sweep.
std::vector<KeyFormat> with_ends(std::vector<KeyFormat> keys) {
    keys.push_back({"start",
                    {name("boundary")},
                    "in family `unassigned`",
                    "the boundary of the plane that the sweep begins from",
                    "start: front"});
    keys.push_back({"end",
                    {name("boundary")},
                    "in family `unassigned`",
                    "the boundary of the plane that it ends at",
                    "end: back"});
    keys.push_back(
        {"periodic", {truth()}, "false", "joins the two ends as images", "periodic: true"});
    return keys;
}

MappingFormat extrude() {
    return {"extrude", "Blocks from the faces of a planar grid, moved along a vector.",
            with_ends({{"along",
                        {point()},
                        key_required,
                        "the way from the first plane to the last",
                        "along: [0, 0, 0.1]"},
                       cells(),
                       {"spacing",
                        {words({"uniform"}), mapping("spacing"), mapping("spacing_positions")},
                        "uniform",
                        "of the layers, as that of an edge",
                        "spacing: {start: 0.01}"}})};
}

MappingFormat revolve() {
    return {"revolve",
            "Blocks from the faces of a planar grid, turned about an axis in its plane. Edges on "
            "the axis become poles. A full turn joins its ends.",
            with_ends(
                {{"axis", {point(Quantity::none)}, key_required, "along x or y", "axis: [1, 0, 0]"},
                 {"center", {point()}, "[0, 0, 0]", "a point of the axis", "center: [0, 1]"},
                 {"angle",
                  {number(Quantity::angle)},
                  key_required,
                  "from the first plane to the last, right-handed about the axis",
                  "angle: 2 * pi"},
                 cells()})};
}

MappingFormat mirror_copy() {
    return {"mirror_copy",
            "The mirror image of the whole grid, zones `NAME_mirror`, beside it. The sides of one "
            "boundary become interfaces.",
            {{"at",
              {name("boundary")},
              key_required,
              "the boundary, all of whose sides lie on its `plane`",
              "at: symmetry"},
             {"families",
              {words({"shared", "apart"})},
              "shared",
              "whether the image is in the same families, or in `NAME_mirror`",
              "families: apart"}}};
}

}  // namespace

std::vector<MappingFormat> formats_of_images() {
    return {periodic(), rotation(), extrude(), revolve(), mirror_copy()};
}

}  // namespace hexweave
