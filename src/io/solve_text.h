// SPDX-License-Identifier: Apache-2.0
// What became of the solves of faces and blocks, as people read it.
#pragma once

#include <string>

#include "quality/report.h"

namespace hexweave {

/// A row per solve, and lines below it on what is out of the ordinary: safeguards, the grid that
/// was kept, untangling, orthogonality that fell short, edges off their surface. With `verbose`
/// also what went well, where sides meet flat, and the convergence history.
std::string solve_table(const Report& report, bool verbose);

}  // namespace hexweave
