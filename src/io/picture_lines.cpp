// SPDX-License-Identifier: Apache-2.0
#include "io/picture_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hexweave {

namespace {

constexpr double straightness = 0.08;  ///< pixels that a simplified line may be off
constexpr double look = 1.5;           ///< pixels between two looks at whether a line is hidden
constexpr double speck = 0.3;          ///< pixels: shorter pieces are not drawn

/// Builds polylines from segments that follow one another or do not.
class Pen {
public:
    explicit Pen(std::vector<Polyline>& lines) : lines_(lines) {}

    void draw(const Sight& from, const Sight& to) {
        const PagePoint a{from.x, from.y};
        if (line_.empty() || !(line_.back() == a)) {
            lift();
            line_.push_back(a);
        }
        line_.push_back({to.x, to.y});
    }
    void lift() {
        if (line_.size() > 1 && extent() >= speck) {
            lines_.push_back(simplified(line_, straightness));
        }
        line_.clear();
    }

private:
    double extent() const {
        double far = 0;
        for (const PagePoint& point : line_) {
            far = std::max(far, std::hypot(point.x - line_[0].x, point.y - line_[0].y));
        }
        return far;
    }

    std::vector<Polyline>& lines_;
    Polyline line_;
};

Sight between(const Sight& a, const Sight& b, double f) {
    return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y), a.depth + f * (b.depth - a.depth)};
}

void draw_segment(const Sight& from, const Sight& to, const Sieve& sieve, Pen& pen) {
    const auto piece = clip(sieve.frame, from, to);
    if (!piece) return;
    const auto& [a, b] = *piece;
    if (sieve.raster == nullptr) {
        pen.draw(a, b);
        return;
    }
    const int looks = std::max(1, static_cast<int>(std::ceil(page_distance(a, b) / look)));
    Sight last = a;
    for (int n = 0; n < looks; ++n) {
        const Sight next = n + 1 == looks ? b : between(a, b, static_cast<double>(n + 1) / looks);
        if (sieve.raster->sees(between(last, next, 0.5))) pen.draw(last, next);
        last = next;
    }
}

/// A sheet with its two directions changed over, or as it is: node (along, line).
struct Lines {
    const SightSheet& sheet;
    bool along_i;

    int count() const { return along_i ? sheet.nj : sheet.ni; }
    int nodes() const { return along_i ? sheet.ni : sheet.nj; }
    const Sight& operator()(int along, int line) const {
        return along_i ? sheet(along, line) : sheet(line, along);
    }
};

/// The mean distance of a line's segment from the lines beside it, measured across the segment.
double local_spacing(const Lines& grid, int along, int line) {
    const Sight& a = grid(along, line);
    const Sight& b = grid(along + 1, line);
    const double length = page_distance(a, b);
    const Sight middle = between(a, b, 0.5);
    double sum = 0;
    for (const int beside : {line - 1, line + 1}) {
        const Sight other = between(grid(along, beside), grid(along + 1, beside), 0.5);
        const double dx = other.x - middle.x;
        const double dy = other.y - middle.y;
        sum += length > 0 ? std::abs((b.x - a.x) * dy - (b.y - a.y) * dx) / length
                          : std::hypot(dx, dy);
    }
    return sum / 2;
}

/// The tone of a line that has `room` times the room it needs, at least 1.
std::size_t tone(double room) {
    return room < 1.25 ? 2 : room < 1.6 ? 1 : 0;
}

void append_direction(const Lines& grid, const Sieve& sieve, double spacing, TonedLines& lines) {
    std::array<Pen, 3> pens{Pen(lines[0]), Pen(lines[1]), Pen(lines[2])};
    for (int line = 1; line + 1 < grid.count(); ++line) {
        const double needed = std::ldexp(spacing, -thinning_level(line, grid.count()));
        for (int along = 0; along + 1 < grid.nodes(); ++along) {
            const double room = local_spacing(grid, along, line) / needed;
            if (!(room >= 1)) continue;
            draw_segment(grid(along, line), grid(along + 1, line), sieve, pens[tone(room)]);
        }
        for (Pen& pen : pens) pen.lift();
    }
}

}  // namespace

int thinning_level(int line, int lines) {
    const auto from_first = static_cast<unsigned>(line);
    const auto to_last = static_cast<unsigned>(lines - 1 - line);
    return std::min(std::countr_zero(from_first), static_cast<int>(std::bit_width(to_last)) - 1);
}

TonedLines grid_lines(const SightSheet& sheet, const Sieve& sieve, double spacing) {
    TonedLines lines;
    append_direction({sheet, true}, sieve, spacing, lines);
    append_direction({sheet, false}, sieve, spacing, lines);
    return lines;
}

void append_line(const std::vector<Sight>& points, const Sieve& sieve,
                 std::vector<Polyline>& lines) {
    Pen pen(lines);
    for (std::size_t i = 1; i < points.size(); ++i) {
        draw_segment(points[i - 1], points[i], sieve, pen);
    }
    pen.lift();
}

}  // namespace hexweave
