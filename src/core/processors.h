// SPDX-License-Identifier: Apache-2.0
// How many processors this process may use.
#pragma once

namespace hexweave {

/// The least of the processors that the scheduler lets the process run on and the share that its
/// control group allows (cgroup v1 and v2, rounded up); at least 1.
int available_processors();

/// The threads to use: `asked` where positive, else OMP_NUM_THREADS where set, else all available;
/// never more than available_processors().
int choose_threads(int asked);

}  // namespace hexweave
