// SPDX-License-Identifier: Apache-2.0
#include "topology/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/vec3.h"
#include "topology/sample.h"

namespace hexweave {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The points of a side in its direction, without the last one.
void append_side(std::vector<Vec3>& loop, const std::vector<EdgeUse>& uses, const EdgeLookup& edge,
                 int intervals) {
    for (const EdgeUse& use : uses) {
        if (use.pole) continue;
        std::vector<Vec3> points = sample_edge(edge(use.edge), intervals);
        if (use.reversed) std::reverse(points.begin(), points.end());
        loop.insert(loop.end(), points.begin(), points.end() - 1);
    }
}

std::vector<Vec3> outline(const FrameSides& sides, const EdgeLookup& edge, int intervals) {
    std::vector<Vec3> loop;
    append_side(loop, sides[2], edge, intervals);
    append_side(loop, sides[1], edge, intervals);
    append_side(loop, backwards(sides[3]), edge, intervals);
    append_side(loop, backwards(sides[0]), edge, intervals);
    return loop;
}

/// Of a closed polygon in the plane; nothing at a corner of 180 degrees, whose sense is not known.
std::optional<int> turns_of(const std::vector<Vec3>& loop) {
    constexpr double cusp = 0.999 * pi;
    double turned = 0;
    for (std::size_t n = 0; n < loop.size(); ++n) {
        const Vec3& here = loop[(n + 1) % loop.size()];
        const Vec3 before = here - loop[n];
        const Vec3 after = loop[(n + 2) % loop.size()] - here;
        if (here.z != 0 || norm(before) == 0 || norm(after) == 0) return std::nullopt;
        const double angle = std::atan2(cross(before, after).z, dot(before, after));
        if (!(std::abs(angle) < cusp)) return std::nullopt;
        turned += angle;
    }
    return static_cast<int>(std::lround(turned / (2 * pi)));
}

bool turns_once(const FrameSides& sides, const EdgeLookup& edge) {
    return outline_turns(sides, edge) == 1;
}

/// The vertex in which a use begins.
int beginning(const EdgeUse& use, const EdgeLookup& edge) {
    return use.reversed ? edge(use.edge).end : edge(use.edge).start;
}

}  // namespace

EdgeLookup edges_of(const Topology& topology) {
    return [&topology](int index) -> const Edge& {
        return topology.edges[static_cast<std::size_t>(index)];
    };
}

std::optional<int> outline_turns(const FrameSides& sides, const EdgeLookup& edge) {
    // What two samplings agree on is no matter of the sampling.
    const std::optional<int> coarse = turns_of(outline(sides, edge, 50));
    return coarse == turns_of(outline(sides, edge, 170)) ? coarse : std::nullopt;
}

std::optional<Rerouted> reroute(const FrameSides& sides, const EdgeLookup& edge) {
    for (std::size_t s = 0; s < 4; ++s) {
        for (std::size_t first = 0; first < sides[s].size(); ++first) {
            for (std::size_t last = first; last < sides[s].size(); ++last) {
                EdgeUse back = sides[s][last];
                back.reversed = !back.reversed;
                if (beginning(sides[s][first], edge) != beginning(back, edge)) continue;
                FrameSides tried = sides;
                const auto begin = tried[s].begin() + static_cast<std::ptrdiff_t>(first);
                const auto end = tried[s].begin() + static_cast<std::ptrdiff_t>(last) + 1;
                const std::vector<EdgeUse> turned = backwards(std::vector<EdgeUse>(begin, end));
                std::copy(turned.begin(), turned.end(), begin);
                if (turns_once(tried, edge)) return Rerouted{s, tried[s]};
            }
        }
    }
    return std::nullopt;
}

std::string chain_text(const std::vector<EdgeUse>& uses, const EdgeLookup& edge) {
    std::string text;
    for (const EdgeUse& use : uses) {
        const Edge& e = edge(use.edge);
        // Of an edge between two vertices the direction follows from its neighbours.
        const char* sign = e.start != e.end ? "" : use.reversed ? "-" : "+";
        text += (text.empty() ? "" : ", ") + (sign + e.name);
    }
    return uses.size() == 1 ? text : "[" + text + "]";
}

}  // namespace hexweave
