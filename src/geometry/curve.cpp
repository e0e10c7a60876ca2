// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve.h"

#include <algorithm>
#include <cmath>

namespace hexweave {

namespace {

/// A parameter of a closed curve brought into [begin, end]; both ends stay as they are.
double wrapped(const Curve& curve, double parameter) {
    if (!curve.closed || (parameter >= curve.begin && parameter <= curve.end)) return parameter;
    const double periods = std::floor((parameter - curve.begin) / curve.period());
    return std::clamp(parameter - periods * curve.period(), curve.begin, curve.end);
}

}  // namespace

Vec3 evaluate(const Curve& curve, double parameter) {
    return curve.position(wrapped(curve, parameter));
}

Vec3 evaluate_derivative(const Curve& curve, double parameter) {
    return curve.derivative(wrapped(curve, parameter));
}

std::vector<double> joints_between(const Curve& curve, double a, double b) {
    std::vector<double> joints;
    const auto add = [&](double parameter) {
        if (parameter > a && parameter < b) joints.push_back(parameter);
    };
    if (!curve.closed) {
        for (const double at : curve.breaks) add(at);
        return joints;
    }
    const double first = std::floor((a - curve.begin) / curve.period());
    for (double turn = first; curve.begin + turn * curve.period() < b; turn += 1) {
        add(curve.begin + turn * curve.period());
        for (const double at : curve.breaks) add(at + turn * curve.period());
    }
    return joints;
}

}  // namespace hexweave
