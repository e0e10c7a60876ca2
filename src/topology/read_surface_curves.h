// SPDX-License-Identifier: Apache-2.0
// Curves that lie on a surface of the file.
#pragma once

#include "topology/read_shapes.h"
#include "topology/shapes.h"

namespace hexweave {

/// The curve of an entry that has a `surface`: a line of equal u or v, a side, the image of a
/// straight line of the parameters, or a curve through points.
MaybeCurve read_surface_curve(Shapes& shapes, const YamlNode& entry);

}  // namespace hexweave
