// SPDX-License-Identifier: Apache-2.0
#include "io/topology_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/picture.h"
#include "topology/sample.h"

namespace hexweave {
namespace {

constexpr int intervals = 128;         // of an edge's line
constexpr double smallest_part = 300;  // of the size: shorter edges do not make the focus
constexpr double focus_needed = 5;     // size of all, in radii of the smallest parts
constexpr double rings_outside = 2;    // radius of all on the page, beyond that of the focus

double distance_between(const PagePoint& a, const PagePoint& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// The lines in the view's plane, y upwards.
std::vector<Polyline> seen_edges(const Topology& topology) {
    const Camera camera = topology.planar ? Camera{} : look_from(isometric_view, std::nullopt);
    std::vector<Polyline> lines;
    for (const Edge& edge : topology.edges) {
        Polyline line;
        const Vec3& start = topology.vertices[static_cast<std::size_t>(edge.start)].position;
        const std::vector<Vec3> points =
            edge.pole ? std::vector<Vec3>{start} : sample_edge(edge, intervals);
        for (const Vec3& p : points) line.push_back({dot(p, camera.right), dot(p, camera.up)});
        lines.push_back(std::move(line));
    }
    return lines;
}

/// The lines of the shortest edges that are not specks: those that must not become a dot.
std::vector<const Polyline*> smallest_parts(const std::vector<Polyline>& lines) {
    double longest = 0;
    for (const Polyline& line : lines) longest = std::max(longest, line_length(line));
    double shortest = longest;
    for (const Polyline& line : lines) {
        const double length = line_length(line);
        if (length > longest / smallest_part) shortest = std::min(shortest, length);
    }
    std::vector<const Polyline*> parts;
    for (const Polyline& line : lines) {
        const double length = line_length(line);
        if (length > 0 && length <= 1.5 * shortest) parts.push_back(&line);
    }
    return parts;
}

PagePoint midst(const std::vector<const Polyline*>& lines) {
    PagePoint sum;
    double count = 0;
    for (const Polyline* line : lines) {
        for (const PagePoint& p : *line) {
            sum = {sum.x + p.x, sum.y + p.y};
            ++count;
        }
    }
    return {sum.x / std::max(count, 1.0), sum.y / std::max(count, 1.0)};
}

std::optional<Focus> focus_of(const std::vector<Polyline>& lines) {
    const std::vector<const Polyline*> parts = smallest_parts(lines);
    Focus focus{midst(parts), 0, 1};
    double size = 0;
    for (const Polyline* line : parts) {
        for (const PagePoint& p : *line) {
            focus.radius = std::max(focus.radius, distance_between(focus.centre, p));
        }
    }
    for (const Polyline& line : lines) {
        for (const PagePoint& p : line) size = std::max(size, distance_between(focus.centre, p));
    }
    if (!(size > focus_needed * focus.radius) || focus.radius == 0) return std::nullopt;
    focus.growth = rings_outside / std::log(size / focus.radius);
    return focus;
}

PagePoint drawn_nearer(const PagePoint& point, const Focus& focus) {
    const double r = distance_between(focus.centre, point) / focus.radius;
    const double radius = r <= 1 ? r : 1 + focus.growth * std::log(r);
    const double factor = r == 0 ? 0 : radius / r / focus.radius;
    return {factor * (point.x - focus.centre.x), factor * (point.y - focus.centre.y)};
}

/// Scales and moves all into the frame, and turns y downwards.
void fit(std::vector<Polyline>& lines, const Frame& frame) {
    const double infinite = std::numeric_limits<double>::infinity();
    PagePoint low{infinite, infinite};
    PagePoint high{-infinite, -infinite};
    for (const Polyline& line : lines) {
        for (const PagePoint& p : line) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    }
    const double scale = std::min(frame.width() / std::max(high.x - low.x, 1e-300),
                                  frame.height() / std::max(high.y - low.y, 1e-300));
    const PagePoint centre{(low.x + high.x) / 2, (low.y + high.y) / 2};
    for (Polyline& line : lines) {
        for (PagePoint& p : line) {
            p = {(frame.left + frame.right) / 2 + scale * (p.x - centre.x),
                 (frame.top + frame.bottom) / 2 - scale * (p.y - centre.y)};
        }
    }
}

bool is_inside(const Polyline& ring, const PagePoint& p) {
    bool inside = false;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        const PagePoint& a = ring[n];
        const PagePoint& b = ring[(n + 1) % ring.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

}  // namespace

TopologyLayout lay_out(const Topology& topology, const Frame& frame) {
    TopologyLayout layout;
    layout.edges = seen_edges(topology);
    layout.focus = focus_of(layout.edges);
    if (layout.focus) {
        for (Polyline& line : layout.edges) {
            for (PagePoint& p : line) p = drawn_nearer(p, *layout.focus);
        }
    }
    fit(layout.edges, frame);
    layout.vertices.resize(topology.vertices.size());
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        layout.vertices[static_cast<std::size_t>(topology.edges[e].start)] =
            layout.edges[e].front();
        layout.vertices[static_cast<std::size_t>(topology.edges[e].end)] = layout.edges[e].back();
    }
    return layout;
}

Polyline side_line(const std::vector<EdgeUse>& side, const TopologyLayout& layout) {
    Polyline line;
    for (const EdgeUse& use : side) {
        Polyline piece = layout.edges[static_cast<std::size_t>(use.edge)];
        if (use.reversed) std::reverse(piece.begin(), piece.end());
        line.insert(line.end(), piece.begin(), piece.end());
    }
    return line;
}

Polyline face_ring(const Face& face, const TopologyLayout& layout) {
    Polyline ring = side_line(face.side(Side::jmin), layout);
    const auto append = [&](Side side, bool backwards) {
        Polyline line = side_line(face.side(side), layout);
        if (backwards) std::reverse(line.begin(), line.end());
        ring.insert(ring.end(), line.begin(), line.end());
    };
    append(Side::imax, false);
    append(Side::jmax, true);
    append(Side::imin, true);
    return ring;
}

std::optional<PagePoint> widest_place(const Polyline& ring) {
    constexpr int steps = 40;
    PagePoint low = ring.front();
    PagePoint high = ring.front();
    for (const PagePoint& p : ring) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    std::optional<PagePoint> best;
    double room = 0;
    for (int n = 0; n < steps * steps; ++n) {
        const PagePoint p{low.x + (n % steps + 0.5) / steps * (high.x - low.x),
                          low.y + (n / steps + 0.5) / steps * (high.y - low.y)};
        if (!is_inside(ring, p)) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const PagePoint& q : ring) nearest = std::min(nearest, distance_between(p, q));
        if (nearest > room) {
            room = nearest;
            best = p;
        }
    }
    return best;
}

double line_length(const Polyline& line) {
    double length = 0;
    for (std::size_t n = 1; n < line.size(); ++n) length += distance_between(line[n - 1], line[n]);
    return length;
}

LinePoint point_on(const Polyline& line, double fraction) {
    double left = fraction * line_length(line);
    for (std::size_t n = 1; n < line.size(); ++n) {
        const PagePoint& a = line[n - 1];
        const PagePoint& b = line[n];
        const double step = distance_between(a, b);
        if (step == 0 || (left > step && n + 1 < line.size())) {
            left -= step;
            continue;
        }
        const PagePoint along{(b.x - a.x) / step, (b.y - a.y) / step};
        return {{a.x + left * along.x, a.y + left * along.y}, along};
    }
    return {line.front(), {1, 0}};
}

}  // namespace hexweave
