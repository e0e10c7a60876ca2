// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces: whether their edges lie on the surface that they name.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

/// Checks that the sampled edges of every face on surfaces are no farther from these than the face
/// allows, by default 1e-6 of their size, and that the boundary of a face on one surface does not
/// go round it. False when there are faults.
bool check_surface_faces(const Network& network, Diagnostics& diagnostics);

}  // namespace hexweave
