// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces: whether their edges lie on the surface that they name.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

/// Checks that the sampled edges of every face on a surface are no farther from it than 1e-6 of its
/// size, and that the face's boundary does not go round it. False when there are faults.
bool check_surface_faces(const Network& network, Diagnostics& diagnostics);

}  // namespace hexweave
