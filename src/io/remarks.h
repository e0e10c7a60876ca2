// SPDX-License-Identifier: Apache-2.0
// What ought to be known of a grid besides its verdict, with what to do about it.
#pragma once

#include <string>
#include <vector>

#include "quality/report.h"

namespace hexweave {

/// A warning: something that was asked was not got, or a face within a grid of blocks folds as a
/// surface; --strict makes it an error. Else a note: what might be better and was not asked for.
struct Remark {
    bool is_warning = false;
    std::string message;
    std::string hint;  ///< may be empty
};

/// Of faces that fold as surfaces within a grid of blocks; of heights that were to be held and are
/// more than a tenth off; of first heights at walls that edges ask and that are not held; of the
/// worst bend of grid lines across an interface, away from its ends.
std::vector<Remark> remarks(const Report& report);

bool has_warnings(const Report& report);

/// "warning: ..." or "note: ...", with the hint in a line of its own.
std::string to_text(const Remark& remark);

}  // namespace hexweave
