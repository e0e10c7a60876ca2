// SPDX-License-Identifier: Apache-2.0
// Open CASCADE's surfaces and curves as ours. Inside the module of CAD files only.
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <array>

#include "geometry/cad.h"

namespace hexweave {

/// Fills type, net and ranges of a face, or its fault. `box` is the rectangle of parameters around
/// the face. A B-spline surface stays as it is; of any other, the part in the rectangle is
/// converted without loss: its parameters begin and end as they did.
void set_surface(CadFace& face, const Handle(Geom_Surface) & surface,
                 const std::array<std::array<double, 2>, 2>& box);

/// Fills type and polygon of a curve from parameter `begin` to `end`, or its fault.
void set_curve(CadCurve& curve, const Handle(Geom_Curve) & shape, double begin, double end);

}  // namespace hexweave
