// SPDX-License-Identifier: Apache-2.0
// The table of the format: what curves and surfaces share: transforms, and CAD files.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

namespace {

KeyFormat scale() {
    return {"scale",
            {number(), list({number()}, 2, 3)},
            "",
            "a factor, or one for each axis",
            "scale: 0.5"};
}

KeyFormat rotate() {
    return {"rotate", {number(Quantity::angle)}, "", "an angle", "rotate: pi / 2"};
}

KeyFormat axis() {
    return {"axis",
            {point(Quantity::none)},
            "[0, 0, 1]",
            "of the rotation",
            "rotate: pi / 2, axis: [1, 0, 0]"};
}

KeyFormat translate() {
    return {"translate", {point()}, "", "a way to go", "translate: [1, 2, 0]"};
}

KeyFormat mirror() {
    return {
        "mirror", {mapping("mirror")}, "", "a plane to mirror at", "mirror: {normal: [0, 1, 0]}"};
}

KeyFormat about(std::string_view with) {
    return {"about", {point()}, "[0, 0, 0]", "the point that stays where it is", with};
}

/// A key that must be there.
KeyFormat demanded(KeyFormat key) {
    key.absent = key_required;
    return key;
}

KeyFormat cad_units(std::string_view example) {
    return {"units",
            {words({"m", "mm", "cm", "in", "ft", "km", "mi", "mil", "um", "uin"})},
            "that of the file",
            "unit of the file's lengths, where its own is wrong or missing",
            example};
}

std::vector<MappingFormat> transforms() {
    std::vector<ValueForm> items;
    for (const std::string_view map :
         {"transform_scale", "transform_rotate", "transform_translate", "transform_mirror"}) {
        items.push_back(mapping(map));
    }
    return {
        {"transforms",
         "Transforms of a curve or surface: one of them as a key, or several in a list.",
         {{"transform",
           {list(items, 0)},
           "",
           "several, applied in the order written",
           "transform: [{scale: 0.5}, {rotate: pi / 2, axis: [1, 0, 0]}, {translate: [1, 2]}]"},
          scale(),
          rotate(),
          translate(),
          mirror(),
          about("scale: 2, about: [1, 0]"),
          axis()}},
        {"transform_scale",
         "Scaling, in a list of transforms.",
         {demanded(scale()), about("scale: 2, about: [1, 0]")}},
        {"transform_rotate",
         "Rotation, in a list of transforms.",
         {demanded(rotate()), axis(), about("rotate: pi, about: [1, 0]")}},
        {"transform_translate", "Translation, in a list of transforms.", {demanded(translate())}},
        {"transform_mirror", "Mirroring, in a list of transforms.", {demanded(mirror())}},
        {"mirror",
         "A plane to mirror at.",
         {{"normal", {point(Quantity::none)}, key_required, "of the plane", "normal: [0, 1, 0]"},
          {"about", {point()}, "[0, 0, 0]", "a point of the plane", "about: [0, 2, 0]"}}},
    };
}

MappingFormat curve_of_cad() {
    return {"curve_cad",
            "A curve of a CAD file, or an edge of a surface of it.",
            {{"cad",
              {file()},
              key_required,
              "an IGES or STEP file; `hexweave geometry FILE` lists what it holds",
              "cad: wing.igs, entity: 5"},
             {"entity",
              {count()},
              "the only one",
              "IGES: the number of the entity's first directory line; STEP: the n of #n",
              "cad: wing.igs, entity: 5"},
             {"label",
              {text()},
              "",
              "instead of `entity`: the label in the file",
              "cad: wing.igs, label: RIM"},
             {"name",
              {text()},
              "",
              "instead of `entity`: the name in the file",
              "cad: wing.igs, name: lid, edge: 1"},
             {"face",
              {count()},
              "the only one",
              "of a body of several faces: which",
              "cad: wing.igs, entity: 1, face: 1, edge: 2"},
             {"edge",
              {count()},
              "the only one",
              "of a surface or composite curve: which of its edges",
              "cad: wing.igs, entity: 1, edge: 2"},
             cad_units("cad: wing.igs, entity: 5, units: mm")},
            {"transforms", "any_curve"}};
}

MappingFormat surface_of_cad() {
    return {"surface_cad",
            "A surface of a CAD file.",
            {{"cad",
              {file()},
              key_required,
              "an IGES or STEP file; `hexweave geometry FILE` lists what it holds",
              "cad: wing.igs, entity: 1"},
             {"entity",
              {count()},
              "the only one",
              "IGES: the number of the entity's first directory line; STEP: the n of #n",
              "cad: wing.igs, entity: 1"},
             {"label",
              {text()},
              "",
              "instead of `entity`: the label in the file",
              "cad: wing.igs, label: PATCH"},
             {"name",
              {text()},
              "",
              "instead of `entity`: the name in the file",
              "cad: wing.igs, name: lid"},
             {"face",
              {count()},
              "the only one",
              "of a body of several faces: which",
              "cad: wing.igs, entity: 1, face: 1"},
             cad_units("cad: wing.igs, entity: 1, units: mm")},
            {"any_surface", "transforms"}};
}

}  // namespace

std::vector<MappingFormat> formats_of_shapes() {
    std::vector<MappingFormat> all = transforms();
    all.push_back(curve_of_cad());
    all.push_back(surface_of_cad());
    return all;
}

}  // namespace hexweave
