// SPDX-License-Identifier: Apache-2.0
// Which files a grid is written to: the format of each, its path, and what that format leaves open.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/diagnostics.h"

namespace hexweave {

enum class GridFormat { cgns, plot3d, vtk, openfoam };

/// How a Plot3D file holds its numbers: as text; as a Fortran program writes them unformatted, each
/// record between two 4-byte counts of its bytes; or as bare bytes one after the other.
enum class Plot3dForm { text, unformatted, stream };

enum class ByteOrder { little, big };

struct GridOutput {
    GridFormat format = GridFormat::cgns;
    std::string path;  ///< a file; for OpenFOAM the case's folder, or a file .foam in it
    Plot3dForm form = Plot3dForm::unformatted;
    ByteOrder byte_order = ByteOrder::little;
    Place place{};  ///< where a config names it; nowhere for the command line
};

/// The format that files with this ending (".cgns") have: nothing for an unknown one.
std::optional<GridFormat> format_of_ending(std::string_view ending);
/// ".cgns; .p3d, .p2d, ... for Plot3D; ...": for messages.
std::string known_endings();
/// The form that a Plot3D file with this ending has where nothing else is said.
Plot3dForm plot3d_form_of_ending(std::string_view ending);
/// ".p3d, .p2d, ...".
std::string plot3d_endings();

}  // namespace hexweave
