// SPDX-License-Identifier: Apache-2.0
#include "faces/map_inverse.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexweave {

namespace {

double cross(const SquarePoint& a, const SquarePoint& b) {
    return a.s * b.t - a.t * b.s;
}

SquarePoint operator-(const SquarePoint& a, const SquarePoint& b) {
    return {a.s - b.s, a.t - b.t};
}

/// The values at the corners of one cell.
struct Quad {
    SquarePoint p00;
    SquarePoint p10;
    SquarePoint p01;
    SquarePoint p11;

    Quad(const Field& s, const Field& t, int i, int j)
        : p00{s(i, j), t(i, j)},
          p10{s(i + 1, j), t(i + 1, j)},
          p01{s(i, j + 1), t(i, j + 1)},
          p11{s(i + 1, j + 1), t(i + 1, j + 1)} {}

    /// Twice the area.
    double area() const { return cross(p11 - p00, p01 - p10); }

    /// How far a value lies beyond the sides imin, imax, jmin, jmax: about in cells, positive
    /// outside.
    std::array<double, 4> beyond(const SquarePoint& q) const {
        const double scale = std::max(std::abs(area()) / 2, 1e-300);
        return {-cross(p00 - p01, q - p01) / scale, -cross(p11 - p10, q - p10) / scale,
                -cross(p10 - p00, q - p00) / scale, -cross(p01 - p11, q - p11) / scale};
    }

    /// alpha and beta of a value inside: a quadratic equation, solved without cancellation.
    std::array<double, 2> shares(const SquarePoint& q) const {
        const SquarePoint e = p10 - p00;
        const SquarePoint f = p01 - p00;
        const SquarePoint g = (p00 - p10) - (p01 - p11);
        const SquarePoint h = q - p00;
        const double a = cross(g, f);
        const double b = cross(e, f) + cross(h, g);
        const double c = cross(h, e);
        const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
        const double beta = inside(-2 * c / (b + root));
        const SquarePoint along{e.s + beta * g.s, e.t + beta * g.t};
        return {inside(cross(h, f) / cross(along, f)), beta};
    }

private:
    static double inside(double share) {
        return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
    }
};

CellPlace in_cell(const Quad& cell, int i, int j, const SquarePoint& wanted) {
    const auto [alpha, beta] = cell.shares(wanted);
    return {i, j, alpha, beta};
}

/// Rounding: so far outside, in cells, is inside.
constexpr double slack = 1e-10;

std::optional<CellPlace> walk(const Field& s, const Field& t, const SquarePoint& wanted,
                              const CellPlace& start) {
    const Extent e = s.extent();
    int i = std::clamp(start.i, 0, e.ni - 2);
    int j = std::clamp(start.j, 0, e.nj - 2);
    const int most_steps = 2 * (e.ni + e.nj);
    for (int step = 0; step < most_steps; ++step) {
        const Quad cell(s, t, i, j);
        const std::array<double, 4> beyond = cell.beyond(wanted);
        const bool inside =
            std::all_of(beyond.begin(), beyond.end(), [](double b) { return b <= slack; });
        if (inside && cell.area() > 0) return in_cell(cell, i, j, wanted);
        // Towards the side that it lies farthest beyond, where there is a cell.
        const std::array<bool, 4> open{i > 0, i<e.ni - 2, j> 0, j < e.nj - 2};
        std::size_t side = 4;
        double farthest = slack;
        for (std::size_t n = 0; n < 4; ++n) {
            if (!open.at(n) || !(beyond.at(n) > farthest)) continue;
            farthest = beyond.at(n);
            side = n;
        }
        if (side == 4) return std::nullopt;
        if (side < 2) i += side == 0 ? -1 : 1;
        if (side >= 2) j += side == 2 ? -1 : 1;
    }
    return std::nullopt;
}

/// The cell that the value is inside of, or beyond the sides of by least.
CellPlace among_all(const Field& s, const Field& t, const SquarePoint& wanted) {
    const Extent e = s.extent();
    double least = INFINITY;
    CellPlace best;
    for (int j = 0; j < e.nj - 1; ++j) {
        for (int i = 0; i < e.ni - 1; ++i) {
            const Quad cell(s, t, i, j);
            if (!(cell.area() > 0)) continue;
            const std::array<double, 4> beyond = cell.beyond(wanted);
            const double farthest = *std::max_element(beyond.begin(), beyond.end());
            if (farthest >= least) continue;
            least = farthest;
            best = in_cell(cell, i, j, wanted);
            if (least <= slack) return best;
        }
    }
    return best;
}

}  // namespace

double CellPlace::of(const Field& values) const {
    return between(between(values(i, j), values(i + 1, j), alpha),
                   between(values(i, j + 1), values(i + 1, j + 1), alpha), beta);
}

CellPlace place_of(const Field& s, const Field& t, const SquarePoint& wanted,
                   const CellPlace& start) {
    if (const std::optional<CellPlace> found = walk(s, t, wanted, start)) return *found;
    return among_all(s, t, wanted);
}

}  // namespace hexweave
