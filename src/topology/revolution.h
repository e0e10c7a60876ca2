// SPDX-License-Identifier: Apache-2.0
// A planar grid turned about an axis in its plane.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

/// The turn, without its layers. Moves what is on the axis exactly there; reports a grid that lies
/// on both sides of it, and a turn that all but closes.
Sweep revolution(Network& network, const SweepEntry& entry, const RotationEntry& turn,
                 Diagnostics& diagnostics);

/// Reports layers that turn by half a turn or more, whose cells would be folded. Silent for an
/// extrusion.
void check_turn(const Sweep& sweep, const SweepEntry& entry, Diagnostics& diagnostics);

}  // namespace hexweave
