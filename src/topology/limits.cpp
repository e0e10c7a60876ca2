// SPDX-License-Identifier: Apache-2.0
#include "topology/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "topology/names.h"
#include "topology/sample.h"

namespace hexweave {

namespace {

/// Bytes of a node: three coordinates of 8, once in the grid and once in what is written and
/// measured.
constexpr double held_bytes = 24 * 2;
/// What is held besides for a node of a zone in flight: parameters, and the levels of the solver
/// with their points, stencils and corrections. Measured, of a whole run less an empty one and with
/// what is held: 225 bytes a node of a block of 1.6 million, 160 to 190 of a face. The last
/// safeguards take two to three times as much; they are for hard shapes, not for large ones.
constexpr double workspace_bytes = 210;

/// A block, or a face of a grid without blocks.
struct ZoneSize {
    std::string kind;
    std::string name;
    Place place;
    Extent extent;

    double nodes() const {
        return static_cast<double>(extent.ni) * static_cast<double>(extent.nj) *
               static_cast<double>(extent.nk);
    }
};

std::vector<ZoneSize> zones_of(const Topology& topology) {
    std::vector<ZoneSize> zones;
    for (const Block& b : topology.blocks) zones.push_back({"block", b.name, b.place, b.extent});
    if (topology.is_3d()) return zones;
    for (const Face& f : topology.faces) {
        zones.push_back({"face", f.name, f.place, topology.zone_extent(f)});
    }
    return zones;
}

std::string extent_text(const Extent& extent) {
    if (extent.nk == 1) return fmt::format("{} x {}", extent.ni, extent.nj);
    return fmt::format("{} x {} x {}", extent.ni, extent.nj, extent.nk);
}

/// The greatest distance between two of the points. Points far from the middle come first, so that
/// most pairs need not be looked at: no pair is farther apart than the sum of its distances from
/// the middle.
double greatest_distance(const std::vector<Vec3>& points) {
    const Box box = box_around(points);
    const Vec3 middle = (box.low + box.high) / 2;
    struct FromMiddle {
        double radius;
        Vec3 point;
    };
    std::vector<FromMiddle> sorted;
    sorted.reserve(points.size());
    for (const Vec3& p : points) sorted.push_back({distance(p, middle), p});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const FromMiddle& a, const FromMiddle& b) { return a.radius > b.radius; });
    double greatest = 0;
    for (std::size_t a = 0; a < sorted.size(); ++a) {
        for (std::size_t b = a + 1; b < sorted.size(); ++b) {
            if (sorted[a].radius + sorted[b].radius <= greatest) break;
            greatest = std::max(greatest, distance(sorted[a].point, sorted[b].point));
        }
        if (2 * sorted[a].radius <= greatest) break;
    }
    return greatest;
}

/// Whether a surface lies in the plane z = 0, by samples.
bool is_in_plane(const Surface& surface) {
    constexpr int samples = 16;
    for (int j = 0; j <= samples; ++j) {
        for (int i = 0; i <= samples; ++i) {
            const auto at = [](const std::array<double, 2>& range, int n) {
                return range[0] + (range[1] - range[0]) * n / samples;
            };
            const SurfaceParameters node{at(surface.range_u, i), at(surface.range_v, j)};
            if (evaluate(surface, node).z != 0) return false;
        }
    }
    return true;
}

}  // namespace

std::string memory_text(double bytes) {
    if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
    if (bytes < 1e9) return fmt::format("{:.3g} MB", bytes / 1e6);
    if (bytes < 1e12) return fmt::format("{:.3g} GB", bytes / 1e9);
    return fmt::format("{:.3g} TB", bytes / 1e12);
}

void measure_extent(Topology& topology, bool three_dimensional) {
    constexpr int intervals = 16;
    std::vector<Vec3> points;
    for (const Vertex& v : topology.vertices) points.push_back(v.position);
    for (const Edge& e : topology.edges) {
        const std::vector<Vec3> samples = sample_edge(e, intervals);
        points.insert(points.end(), samples.begin(), samples.end());
    }
    topology.size = greatest_distance(points);
    topology.planar = !three_dimensional && std::all_of(points.begin(), points.end(),
                                                        [](const Vec3& p) { return p.z == 0; });
    for (const Face& face : topology.faces) {
        if (face.surface && !is_in_plane(*face.surface)) topology.planar = false;
        for (const auto& patch : face.patches) {
            if (!is_in_plane(*patch)) topology.planar = false;
        }
    }
}

bool check_zone_sizes(const Topology& topology, Diagnostics& diagnostics) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    bool fit = true;
    for (const ZoneSize& zone : zones_of(topology)) {
        if (zone.nodes() <= most) continue;
        diagnostics.error(zone.place,
                          fmt::format("{} {} has {} nodes, {:.3g} in all: more than the 2147483647 "
                                      "that a CGNS zone can hold, and about {} of memory",
                                      zone.kind, quoted(zone.name), extent_text(zone.extent),
                                      zone.nodes(), memory_text(estimated_bytes(zone.nodes()))),
                          "give its edges fewer cells, or split it");
        fit = false;
    }
    return fit;
}

double estimated_bytes(double nodes) {
    return nodes * (held_bytes + workspace_bytes);
}

double estimated_bytes(const Topology& topology, int threads) {
    std::vector<double> nodes;
    double all = 0;
    for (const ZoneSize& zone : zones_of(topology)) {
        nodes.push_back(zone.nodes());
        all += zone.nodes();
    }
    std::sort(nodes.begin(), nodes.end(), std::greater<>());
    if (nodes.size() > static_cast<std::size_t>(threads)) {
        nodes.resize(static_cast<std::size_t>(threads));
    }
    double in_flight = 0;
    for (const double n : nodes) in_flight += n;
    return held_bytes * all + workspace_bytes * in_flight;
}

void check_memory(const Topology& topology, int threads, std::size_t available,
                  Diagnostics& diagnostics) {
    const double needed = estimated_bytes(topology, threads);
    if (needed <= static_cast<double>(available)) return;
    const std::vector<ZoneSize> zones = zones_of(topology);
    const auto largest = std::max_element(
        zones.begin(), zones.end(),
        [](const ZoneSize& a, const ZoneSize& b) { return a.nodes() < b.nodes(); });
    diagnostics.error(
        largest->place,
        fmt::format("this grid needs about {}; this machine has {}", memory_text(needed),
                    memory_text(static_cast<double>(available))),
        fmt::format("{} {} is the largest, with {} nodes: give its edges fewer cells",
                    largest->kind, quoted(largest->name), extent_text(largest->extent)));
}

}  // namespace hexweave
