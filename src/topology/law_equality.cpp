// SPDX-License-Identifier: Apache-2.0
#include "topology/law_equality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

bool close(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

bool close(const std::optional<double>& a, const std::optional<double>& b) {
    constexpr double rounding = 1e-12;  // an expression may reach one size in two ways
    if (!a || !b) return a.has_value() == b.has_value();
    return close(*a, *b, rounding);
}

bool close(const std::optional<TanhLaw::Natural>& a, const std::optional<TanhLaw::Natural>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return close(std::optional(a->size), std::optional(b->size)) &&
           close(std::optional(a->within), std::optional(b->within));
}

bool equal_lengths(double a, double b) {
    constexpr double tolerance = 1e-9;
    return close(a, b, tolerance);
}

struct SameDistribution {
    double length_a;
    double length_b;

    bool operator()(const UniformLaw& /*a*/, const UniformLaw& /*b*/) const { return true; }
    bool operator()(const TanhLaw& a, const TanhLaw& b) const {
        const bool absolute = a.start || a.end;
        return close(a.start, b.start) && close(a.end, b.end) && close(a.natural, b.natural) &&
               (!absolute || equal_lengths(length_a, length_b));
    }
    bool operator()(const GeometricLaw& a, const GeometricLaw& b) const {
        const bool absolute = a.start || a.end;
        return close(a.ratio, b.ratio) && close(a.start, b.start) && close(a.end, b.end) &&
               (!absolute || equal_lengths(length_a, length_b));
    }
    bool operator()(const ExplicitLaw& a, const ExplicitLaw& b) const {
        if (a.formula || b.formula || a.of_parameter || b.of_parameter) return false;
        return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                          [](double x, double y) { return std::abs(x - y) <= 1e-12; });
    }
    template <class A, class B>
    bool operator()(const A& /*a*/, const B& /*b*/) const {
        return false;
    }
};

}  // namespace

SpacingLaw turned(const SpacingLaw& law, bool reversed) {
    if (!reversed) return law;
    SpacingLaw result = law;
    if (auto* tanh = std::get_if<TanhLaw>(&result)) {
        std::swap(tanh->start, tanh->end);
    } else if (auto* geometric = std::get_if<GeometricLaw>(&result)) {
        std::swap(geometric->start, geometric->end);
        if (geometric->ratio) geometric->ratio = 1 / *geometric->ratio;
    } else if (auto* points = std::get_if<ExplicitLaw>(&result)) {
        std::reverse(points->values.begin(), points->values.end());
        for (double& value : points->values) value = 1 - value;
    }
    return result;
}

bool same_distribution(const SpacingLaw& a, double length_a, const SpacingLaw& b, double length_b) {
    return std::visit(SameDistribution{length_a, length_b}, a, b);
}

}  // namespace hexweave
