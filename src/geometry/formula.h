// SPDX-License-Identifier: Apache-2.0
// Curves by formula.
#pragma once

#include <functional>

#include "core/vec3.h"
#include "geometry/curve.h"

namespace hexweave {

/// The curve position(t), begin <= t <= end. Its derivative is taken by differences of eighth order
/// that never leave the range, accurate to about 1e-10 for a formula with up to some 40 waves over
/// the range. Closed when its ends coincide, to 1e-12 of its extent; then the end is taken to be
/// the start. Precondition: begin < end; the formula is finite and safe to call from several
/// threads at once.
Curve formula(std::function<Vec3(double)> position, double begin, double end);

}  // namespace hexweave
