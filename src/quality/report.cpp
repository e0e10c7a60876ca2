// SPDX-License-Identifier: Apache-2.0
#include "quality/report.h"

#include <algorithm>
#include <numeric>

namespace hexweave {

LevelMeasure level_measure(const GridFamily& solved, std::size_t level) {
    return {solved.names[level], solved.factor, solved.names, solved.names[solved.level],
            solved.stride(level)};
}

std::size_t Report::folded() const {
    return std::accumulate(zones.begin(), zones.end(), std::size_t{0},
                           [](std::size_t sum, const ZoneMeasure& z) { return sum + z.folded; });
}

std::size_t Report::pole_corners() const {
    std::size_t sum = 0;
    for (const ZoneMeasure& z : zones) sum += z.pole_corners;
    return sum;
}

double Report::worst_scaled_jacobian() const {
    double worst = 1;
    for (const ZoneMeasure& z : zones) worst = std::min(worst, z.worst_scaled_jacobian);
    return worst;
}

AngleMeasure Report::angles() const {
    AngleMeasure all;
    for (const ZoneMeasure& z : zones) all.include(z.angles);
    return all;
}

std::size_t Report::mismatched() const {
    return std::accumulate(
        interfaces.begin(), interfaces.end(), std::size_t{0},
        [](std::size_t sum, const InterfaceMeasure& i) { return sum + i.mismatched; });
}

std::size_t Report::unconverged() const {
    const auto failed = [](const SolveMeasure& s) { return !s.has_converged(); };
    return static_cast<std::size_t>(std::count_if(solves.begin(), solves.end(), failed));
}

std::size_t Report::missed_gates() const {
    const auto missed = [](const GateResult& gate) { return !gate.met; };
    return static_cast<std::size_t>(std::count_if(gates.begin(), gates.end(), missed));
}

std::vector<const SolveMeasure*> Report::folded_faces() const {
    std::vector<const SolveMeasure*> found;
    if (zones.empty() || solves.empty() || !solves.back().is_block) return found;
    for (const SolveMeasure& s : solves) {
        if (!s.is_block && s.result.folded_after > 0) found.push_back(&s);
    }
    return found;
}

}  // namespace hexweave
