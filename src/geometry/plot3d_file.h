// SPDX-License-Identifier: Apache-2.0
// Surfaces of points as Plot3D text files hold them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/control_mesh.h"

namespace hexweave {

/// Either there is a mesh, or `error` says what is wrong (a fact, no full stop); `line` counts from
/// 1, 0 for the file as a whole.
struct Plot3dSurface {
    ControlMesh mesh;
    std::string error;
    int line = 0;
};

/// Reads one block, a surface, of a file: the number of blocks (1 where it is left out), the three
/// counts of points of each, of which that block has one of 1, then block after block all x, all y,
/// all z, the first count's index running fastest. Numbers are separated by blanks, line ends or
/// commas; 3*0.5 stands for three of them, and an exponent may be written with a D. `block` counts
/// from 1 on; it may be left open where there is one. Faults: anything else than a number, a number
/// that is not finite, no such block, counts of no surface, too few or too many numbers.
Plot3dSurface read_plot3d_surface(std::string_view text, std::optional<int> block = std::nullopt);

}  // namespace hexweave
