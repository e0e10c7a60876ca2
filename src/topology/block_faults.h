// SPDX-License-Identifier: Apache-2.0
// Why the faces of a block do not fit together, or fit in several ways: the messages.
#pragma once

#include <array>
#include <vector>

#include "topology/block_orientation.h"
#include "topology/draft.h"

namespace hexweave {

/// The six sides as the user names them.
using BlockSideEntries = std::array<BlockSideEntry, 6>;

/// Reports the sides whose own faces have no arrangement; whether there are any.
bool report_misfits(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                    const FacesOfBlock& faces);

/// Reports why no arrangements fit: sides without a common edge, 'axes' that contradict the edges,
/// or sides that share edges pair by pair but do not close.
void report_unclosed(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                     const FacesOfBlock& faces);

/// Reports that several arrangements fit, with the 'axes' that decide; which of them make the block
/// right-handed is told.
void report_ambiguous(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                      const std::vector<BlockArrangement>& solutions,
                      const std::vector<bool>& right_handed);

}  // namespace hexweave
