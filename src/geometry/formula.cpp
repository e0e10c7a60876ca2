// SPDX-License-Identifier: Apache-2.0
#include "geometry/formula.h"

#include <algorithm>
#include <utility>

#include "geometry/differences.h"

namespace hexweave {

namespace {

/// Do the ends coincide, measured against how far the curve reaches?
bool ends_coincide(const std::function<Vec3(double)>& position, double begin, double end) {
    constexpr int samples = 16;
    const Vec3 first = position(begin);
    double reach = 0;
    for (int k = 1; k < samples; ++k) {
        reach = std::max(reach, distance(first, position(begin + (end - begin) * k / samples)));
    }
    return distance(first, position(end)) <= 1e-12 * reach;
}

}  // namespace

Curve formula(std::function<Vec3(double)> position, double begin, double end) {
    Curve curve;
    curve.begin = begin;
    curve.end = end;
    curve.closed = ends_coincide(position, begin, end);
    curve.derivative = [position, differences = Differences(begin, end)](double t) {
        return differences(position, t);
    };
    curve.position = std::move(position);
    if (curve.closed) {
        curve.position = [open = std::move(curve.position), begin, end](double t) {
            return open(t == end ? begin : t);
        };
    }
    return curve;
}

}  // namespace hexweave
