// SPDX-License-Identifier: Apache-2.0
#include "topology/curve_pieces.h"

#include <algorithm>
#include <cmath>

#include "topology/sample.h"

namespace hexweave {

namespace {

constexpr double coincidence = 1e-12;  // of the curve's size or parameter range

double wrapped(const Curve& curve, double parameter) {
    const double turns = std::floor((parameter - curve.begin) / curve.period());
    return parameter - turns * curve.period();
}

}  // namespace

double size_of(const Curve& curve) {
    constexpr int intervals = 64;
    std::vector<Vec3> points;
    for (int n = 0; n <= intervals; ++n) {
        points.push_back(evaluate(curve, curve.begin + curve.period() * n / intervals));
    }
    return box_around(points).diagonal();
}

std::vector<double> passings(const Curve& curve, double parameter) {
    if (curve.closed) return {wrapped(curve, parameter)};
    const double near = coincidence * size_of(curve);
    const Vec3 begin = evaluate(curve, curve.begin);
    const Vec3 end = evaluate(curve, curve.end);
    const bool at_joint =
        distance(begin, end) <= near && distance(evaluate(curve, parameter), begin) <= near;
    if (at_joint) return {curve.begin, curve.end};
    return {parameter};
}

std::vector<CurvePiece> pieces_between(const Curve& curve, const std::vector<double>& from,
                                       const std::vector<double>& to, bool same_point) {
    if (same_point) {
        if (curve.closed) return {{from.front(), from.front() + curve.period()}};
        if (from.size() == 2) return {{curve.begin, curve.end}};
        return {};
    }
    std::vector<CurvePiece> pieces;
    for (const double a : from) {
        for (const double b : to) {
            const double apart = std::abs(b - a) / curve.period();
            if (apart <= coincidence || (curve.closed && apart >= 1 - coincidence)) continue;
            pieces.push_back({a, b});
            if (curve.closed) {
                pieces.push_back({a, b > a ? b - curve.period() : b + curve.period()});
            }
        }
    }
    // The way in the curve's own direction comes first.
    std::stable_sort(pieces.begin(), pieces.end(), [](const CurvePiece& p, const CurvePiece& q) {
        return p.to > p.from && q.to < q.from;
    });
    return pieces;
}

bool passes(const Curve& curve, const CurvePiece& piece, double parameter) {
    const double low = std::min(piece.from, piece.to);
    const double high = std::max(piece.from, piece.to);
    const double margin = coincidence * curve.period();
    const auto within = [&](double p) { return p > low + margin && p < high - margin; };
    if (!curve.closed) return within(parameter);
    return within(parameter) || within(parameter - curve.period()) ||
           within(parameter + curve.period());
}

}  // namespace hexweave
