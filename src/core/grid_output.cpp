// SPDX-License-Identifier: Apache-2.0
#include "core/grid_output.h"

#include <array>

namespace hexweave {
namespace {

struct Plot3dEnding {
    std::string_view ending;
    Plot3dForm form;
};
constexpr std::array<Plot3dEnding, 10> plot3d{{{".p3d", Plot3dForm::text},
                                               {".p2d", Plot3dForm::text},
                                               {".fmt", Plot3dForm::text},
                                               {".p3dfmt", Plot3dForm::text},
                                               {".p2dfmt", Plot3dForm::text},
                                               {".xyz", Plot3dForm::unformatted},
                                               {".x", Plot3dForm::unformatted},
                                               {".g", Plot3dForm::unformatted},
                                               {".grd", Plot3dForm::unformatted},
                                               {".ufmt", Plot3dForm::unformatted}}};

}  // namespace

std::optional<GridFormat> format_of_ending(std::string_view ending) {
    if (ending == ".cgns") return GridFormat::cgns;
    if (ending == ".vtm") return GridFormat::vtk;
    if (ending == ".foam") return GridFormat::openfoam;
    for (const Plot3dEnding& known : plot3d) {
        if (ending == known.ending) return GridFormat::plot3d;
    }
    return std::nullopt;
}

std::string plot3d_endings() {
    std::string list;
    for (const Plot3dEnding& known : plot3d) {
        list += (list.empty() ? "" : ", ") + std::string(known.ending);
    }
    return list;
}

std::string known_endings() {
    return ".cgns; Plot3D: " + plot3d_endings() + "; VTK: .vtm; OpenFOAM: .foam";
}

Plot3dForm plot3d_form_of_ending(std::string_view ending) {
    for (const Plot3dEnding& known : plot3d) {
        if (ending == known.ending) return known.form;
    }
    return Plot3dForm::unformatted;
}

}  // namespace hexweave
