// SPDX-License-Identifier: Apache-2.0
// The memory of a whole run of the program: a file in, a file out.
#pragma once

#include <optional>
#include <string>

namespace hexweave::bench {

struct WholeRun {
    double points = 0;
    double seconds = 0;
    double bytes_per_point = 0;  ///< peak, less that of a run with hardly any points
};

/// Runs `program` on one elliptic block with a curved wall and a boundary layer, 1.6 million points
/// (129 x 129 x 97), in a temporary folder. Nothing where it fails.
std::optional<WholeRun> measure_whole_run(const std::string& program);

}  // namespace hexweave::bench
