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

std::vector<double> fractions_of(const UniformLaw& /*law*/, int cells, double /*length*/) {
    return uniform_fractions(cells);
}

std::vector<double> fractions_of(const TanhLaw& law, int cells, double length) {
    if (law.natural) {
        return held_tanh_fractions(cells, (law.start ? *law.start : *law.end) / length,
                                   law.natural->size / length, law.natural->within / length,
                                   law.end.has_value());
    }
    return tanh_fractions(cells, over(law.start, length), over(law.end, length));
}

std::vector<double> fractions_of(const GeometricLaw& law, int cells, double length) {
    if (law.ratio) return geometric_fractions(cells, *law.ratio);
    return geometric_fractions(cells, over(law.start, length), over(law.end, length));
}

std::vector<double> fractions_of(const ExplicitLaw& law, int cells, double /*length*/) {
    std::vector<double> values = law.values;
    if (law.formula) {
        values.clear();
        for (int i = 0; i <= cells; ++i) {
            values.push_back(law.formula(static_cast<double>(i) / cells));
        }
    }
    values.front() = 0;
    values.back() = 1;
    return values;
}

std::vector<double> fractions_of(const SameAs& /*law*/, int cells, double /*length*/) {
    HEXWEAVE_ASSERT(false);
    return uniform_fractions(cells);
}

}  // namespace

std::vector<double> law_fractions(const SpacingLaw& law, int cells, double length) {
    return std::visit([&](const auto& chosen) { return fractions_of(chosen, cells, length); }, law);
}

}  // namespace hexweave
