// SPDX-License-Identifier: Apache-2.0
// A one-to-one interface as either of its two zones sees it.
#pragma once

#include "core/multiblock.h"

namespace hexweave {

/// The same interface with its own box running forwards along every axis; the donor's box carries
/// the reversal.
Interface forwards(Interface interface);

/// The same interface seen from its donor: zone and donor change places. Its box runs forwards.
Interface other_side(const Interface& interface);

}  // namespace hexweave
