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

}  // namespace

std::vector<MappingFormat> formats_of_images() {
    return {periodic(), rotation()};
}

}  // namespace hexweave
