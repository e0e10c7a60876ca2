// SPDX-License-Identifier: Apache-2.0
#include "io/graph_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/topology_layout.h"

namespace hexweave {

Polyline link_line(const PagePoint& a, const PagePoint& b, int earlier) {
    constexpr int pieces = 32;
    const bool loop = a == b;
    if (!loop && earlier == 0) return {a, b};
    const PagePoint d{b.x - a.x, b.y - a.y};
    const int rank = (earlier + 1) / 2;  // bent lines come in pairs, to either side
    const double bend = 0.16 * rank * (earlier % 2 == 0 ? 1 : -1);
    const double size = 34 + 12 * earlier;
    Polyline line;
    for (int n = 0; n <= pieces; ++n) {
        const double t = static_cast<double>(n) / pieces;
        const double angle = 2 * std::numbers::pi * t;
        const double arch = 4 * t * (1 - t) * bend;
        line.push_back(
            loop ? PagePoint{a.x + size * std::sin(angle), a.y - size * (1 - std::cos(angle))}
                 : PagePoint{a.x + t * d.x - arch * d.y, a.y + t * d.y + arch * d.x});
    }
    return line;
}

std::vector<Polyline> dashes(const Polyline& line) {
    constexpr double dash = 7;
    constexpr double gap = 4;
    constexpr int corners = 4;  // of a dash of a bent line
    const double length = line_length(line);
    const int count = static_cast<int>(std::ceil(length / (dash + gap)));
    std::vector<Polyline> pieces;
    for (int d = 0; d < count; ++d) {
        const double from = d * (dash + gap);
        Polyline& piece = pieces.emplace_back();
        for (int n = 0; n <= corners; ++n) {
            const double at = std::min(length, from + dash * n / corners);
            piece.push_back(point_on(line, at / length).at);
        }
    }
    return pieces;
}

}  // namespace hexweave
