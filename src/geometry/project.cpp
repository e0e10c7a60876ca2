// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/curve.h"
#include "geometry/root.h"

namespace hexweave {

namespace {

constexpr int samples_of_a_curve = 256;
constexpr int least_samples_of_a_piece = 4;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The ends of a curve's smooth pieces, ascending.
std::vector<double> piece_ends(const Curve& curve) {
    std::vector<double> ends{curve.begin};
    ends.insert(ends.end(), curve.breaks.begin(), curve.breaks.end());
    ends.push_back(curve.end);
    return ends;
}

/// A step into the piece from a to b that is sure to stay off its ends after rounding.
double step_inside(double a, double b) {
    return std::max(1e-12 * (b - a), 8 * epsilon * std::max(std::abs(a), std::abs(b)));
}

/// The search for the nearest point: candidates come in, the nearest (the first of equals) stays.
class NearestSearch {
public:
    NearestSearch(const Curve& curve, const Vec3& point) : curve_(curve), point_(point) {}

    /// Half the rate of change of the squared distance.
    double slope(double t) const { return dot(curve_.position(t) - point_, curve_.derivative(t)); }

    void consider(double t) {
        const Vec3 position = curve_.position(t);
        const double distance_to = distance(position, point_);
        if (found_ && distance_to >= best_.distance) return;
        best_ = {t, position, distance_to};
        found_ = true;
    }

    /// An end of a piece counts when leaving it on either side does not come nearer, or when the
    /// point is there, to rounding. `before` and `after` are the slopes just beside it; 0 where the
    /// curve ends.
    void consider_end(double t, double before, double after) {
        const Vec3 position = curve_.position(t);
        const double rounding = 4 * epsilon * (norm(position) + norm(point_));
        if ((before <= 0 && after >= 0) || distance(position, point_) <= rounding) consider(t);
    }

    /// Every minimum of the distance inside the piece from a to b that its samples show: where the
    /// slope goes from negative to positive.
    void search_piece(double a, double b, int samples) {
        double left = a;
        double left_slope = slope(a);
        for (int k = 1; k <= samples; ++k) {
            const double right = k == samples ? b : a + (b - a) * k / samples;
            const double right_slope = slope(right);
            if (left_slope < 0 && right_slope >= 0) {
                consider(bracketed_root([&](double t) { return slope(t); }, left, right));
            }
            left = right;
            left_slope = right_slope;
        }
    }

    const CurvePoint& best() const { return best_; }

private:
    const Curve& curve_;
    Vec3 point_;
    CurvePoint best_;
    bool found_ = false;
};

}  // namespace

CurvePoint project(const Curve& curve, const Vec3& p) {
    NearestSearch search(curve, p);
    const std::vector<double> ends = piece_ends(curve);
    const std::size_t pieces = ends.size() - 1;
    const int samples =
        std::max(least_samples_of_a_piece, samples_of_a_curve / static_cast<int>(pieces));
    std::vector<double> inner_begin(pieces);
    std::vector<double> inner_end(pieces);
    for (std::size_t k = 0; k < pieces; ++k) {
        const double step = step_inside(ends[k], ends[k + 1]);
        inner_begin[k] = ends[k] + step;
        inner_end[k] = ends[k + 1] - step;
    }
    for (std::size_t k = 0; k <= pieces; ++k) {
        const bool at_seam = curve.closed && k == 0;
        if (curve.closed && k == pieces) break;
        const double before = k > 0     ? search.slope(inner_end[k - 1])
                              : at_seam ? search.slope(inner_end.back())
                                        : 0;
        const double after = k < pieces ? search.slope(inner_begin[k]) : 0;
        search.consider_end(ends[k], before, after);
    }
    for (std::size_t k = 0; k < pieces; ++k) {
        search.search_piece(inner_begin[k], inner_end[k], samples);
    }
    return search.best();
}

}  // namespace hexweave
