// SPDX-License-Identifier: Apache-2.0
#include "bench/pipeline.h"

#include <chrono>

#include "blocks/transfinite_block.h"
#include "elliptic/fold_count.h"
#include "elliptic/untangle.h"
#include "faces/transfinite_face.h"

namespace hexweave::bench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Finished finish(Problem& problem, const EllipticOptions& options) {
    Finished finished;
    const auto begin = Clock::now();
    finished.solve = solve_elliptic(problem.points, problem.parameters, options);
    finished.solve_seconds = seconds_since(begin);
    finished.elliptic = problem.points;
    const auto middle = Clock::now();
    finished.solve.untangling = untangle(problem.points, [&] {
        PointField transfinite = problem.points;
        if (transfinite.extent().nk == 1) {
            interpolate_face(transfinite, problem.parameters);
        } else {
            interpolate_block(transfinite, problem.parameters);
        }
        return transfinite;
    });
    finished.untangle_seconds = seconds_since(middle);
    if (finished.solve.untangling) finished.solve.folded_after = count_folded(problem.points);
    return finished;
}

}  // namespace hexweave::bench
