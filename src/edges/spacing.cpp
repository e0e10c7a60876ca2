// SPDX-License-Identifier: Apache-2.0
#include "edges/spacing.h"

#include <optional>

#include "core/assert.h"
#include "geometry/stretching.h"
#include "geometry/wall_scaling.h"

namespace hexweave {

namespace {

std::optional<double> over(const std::optional<double>& size, double length) {
    return size ? std::optional(*size / length) : std::nullopt;
}

/// What a law is asked for: its own cells, the edge's length, and the intervals of each cell.
struct Asked {
    int cells;
    double length;
    int refinement;
};

std::vector<double> fractions_of(const UniformLaw& /*law*/, const Asked& asked) {
    return uniform_fractions(asked.cells, asked.refinement);
}

std::vector<double> fractions_of(const TanhLaw& law, const Asked& asked) {
    const auto [cells, length, refinement] = asked;
    if (law.natural) {
        return held_tanh_fractions(cells, (law.start ? *law.start : *law.end) / length,
                                   law.natural->size / length, law.natural->within / length,
                                   law.end.has_value(), refinement);
    }
    return tanh_fractions(cells, over(law.start, length), over(law.end, length), refinement);
}

std::vector<double> fractions_of(const GeometricLaw& law, const Asked& asked) {
    const auto [cells, length, refinement] = asked;
    if (law.ratio) return ratio_fractions(cells, *law.ratio, refinement);
    return geometric_fractions(cells, over(law.start, length), over(law.end, length), refinement);
}

std::vector<double> fractions_of(const ExplicitLaw& law, const Asked& asked) {
    std::vector<double> values = law.values;
    if (law.formula) {
        const int intervals = asked.cells * asked.refinement;
        values.clear();
        for (int i = 0; i <= intervals; ++i) {
            values.push_back(law.formula(static_cast<double>(i) / intervals));
        }
    }
    HEXWEAVE_ASSERT(law.formula || asked.refinement == 1);
    values.front() = 0;
    values.back() = 1;
    return values;
}

std::vector<double> fractions_of(const SameAs& /*law*/, const Asked& asked) {
    HEXWEAVE_ASSERT(false);
    return uniform_fractions(asked.cells);
}

}  // namespace

std::vector<double> law_fractions(const SpacingLaw& law, int cells, double length, int refinement) {
    const Asked asked{cells, length, refinement};
    return std::visit([&](const auto& chosen) { return fractions_of(chosen, asked); }, law);
}

}  // namespace hexweave
