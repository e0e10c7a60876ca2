// SPDX-License-Identifier: Apache-2.0
#include "io/label_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/topology_layout.h"

namespace hexweave {
namespace {

constexpr double margin = 2;       // pixels around a text
constexpr double point_cost = 12;  // of a covered point of a line, in covered pixels of a label
constexpr double rank_cost = 6;    // of each place that would have been preferred

Frame box_around(const PagePoint& centre, const LabelText& label) {
    const double width = text_width(label.text, label.size, label.bold) / 2 + margin;
    const double height = label.size / 2 + margin;
    return {centre.x - width, centre.y - height, centre.x + width, centre.y + height};
}

double overlap(const Frame& a, const Frame& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0 && height > 0 ? width * height : 0;
}

}  // namespace

void LabelPlacement::avoid(const Polyline& line) {
    constexpr double step = 4;
    const int count = static_cast<int>(line_length(line) / step) + 1;
    for (int n = 0; n <= count; ++n) points_.push_back(point_on(line, double(n) / count).at);
}

double LabelPlacement::cost_at(const Frame& box) const {
    double cost = 20 * (box.width() * box.height() - overlap(box, frame_));
    for (const Placed& other : placed_) cost += 10 * overlap(box, other.box);
    for (const PagePoint& p : points_) {
        const bool covered = p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
        if (covered) cost += point_cost;
    }
    return cost;
}

void LabelPlacement::place(const LabelText& label, const std::vector<PagePoint>& centres) {
    if (label.text.empty() || centres.empty()) return;
    Frame best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < centres.size(); ++n) {
        const Frame box = box_around(centres[n], label);
        const double cost = cost_at(box) + rank_cost * static_cast<double>(n);
        if (cost >= least) continue;
        least = cost;
        best = box;
    }
    placed_.push_back({label, best});
}

void LabelPlacement::append_to(Drawing& drawing) const {
    for (const Placed& placed : placed_) {
        const Frame& b = placed.box;
        drawing.items.emplace_back(Fill{
            {{{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}}}, white});
    }
    for (const Placed& placed : placed_) {
        const PagePoint base{(placed.box.left + placed.box.right) / 2,
                             placed.box.bottom - margin - 0.18 * placed.label.size};
        drawing.items.emplace_back(Label{base, placed.label.text, placed.label.size, Anchor::middle,
                                         placed.label.colour, placed.label.bold});
    }
}

std::vector<PagePoint> places_around(const PagePoint& point, const LabelText& label) {
    const double x = text_width(label.text, label.size, label.bold) / 2 + 9;
    const double y = label.size / 2 + 8;
    std::vector<PagePoint> places;
    for (const PagePoint& way :
         {PagePoint{1, -0.8}, PagePoint{-1, -0.8}, PagePoint{1, 0.8}, PagePoint{-1, 0.8},
          PagePoint{1, 0}, PagePoint{-1, 0}, PagePoint{0, -1}, PagePoint{0, 1}, PagePoint{1.4, -2},
          PagePoint{-1.4, -2}, PagePoint{1.4, 2}, PagePoint{-1.4, 2}}) {
        places.push_back({point.x + x * way.x, point.y + y * way.y});
    }
    return places;
}

std::vector<PagePoint> places_beside(const Polyline& line, const LabelText& label) {
    const double width = text_width(label.text, label.size, label.bold) / 2 + 4;
    const double height = label.size / 2 + 4;
    std::vector<PagePoint> places;
    for (const double fraction : {0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82}) {
        const LinePoint p = point_on(line, fraction);
        const PagePoint across{-p.along.y, p.along.x};
        const double away = width * std::abs(across.x) + height * std::abs(across.y);
        for (const double side : {-away, away}) {
            places.push_back({p.at.x + side * across.x, p.at.y + side * across.y});
        }
    }
    return places;
}

}  // namespace hexweave
