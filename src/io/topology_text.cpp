// SPDX-License-Identifier: Apache-2.0
#include "io/topology_text.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/parallel.h"
#include "io/level_text.h"
#include "topology/limits.h"
#include "topology/text.h"

namespace hexweave {
namespace {

std::string zone_line(const std::string& name, const Extent& extent) {
    std::string nodes = fmt::format("{} x {}", extent.ni, extent.nj);
    if (extent.nk > 1) nodes += fmt::format(" x {}", extent.nk);
    return fmt::format("  {:<24} {:>16} nodes {:>12} cells\n", name, nodes, extent.cells());
}

std::string boundary_line(const Topology& topology, const Boundary& boundary) {
    std::string text = fmt::format("  {:<24} {:<20}", boundary.family.name, boundary.family.type);
    if (boundary.sides.empty()) text.erase(text.find_last_not_of(' ') + 1);
    for (const int side : boundary.sides) {
        const auto s = static_cast<std::size_t>(side);
        text += " " + (topology.is_3d() ? topology.faces[s].name : topology.edges[s].name);
    }
    return text + "\n";
}

/// The sides of zones that every edge (in 3D: face) is on: "jmin of upper".
std::vector<std::vector<std::string>> sides_of_zones(const Topology& topology) {
    std::vector<std::vector<std::string>> sides(topology.is_3d() ? topology.faces.size()
                                                                 : topology.edges.size());
    const auto enter = [&](int entity, Side side, const std::string& zone) {
        sides[static_cast<std::size_t>(entity)].push_back(
            fmt::format("{} of {}", side_name(side), zone));
    };
    for (const Block& block : topology.blocks) {
        for (const Side side : all_sides) {
            for (const FaceUse& use : block.side(side).faces) enter(use.face, side, block.name);
        }
    }
    if (topology.is_3d()) return sides;
    for (const Face& face : topology.faces) {
        for (const Side side : {Side::imin, Side::imax, Side::jmin, Side::jmax}) {
            for (const EdgeUse& use : face.side(side)) enter(use.edge, side, face.name);
        }
    }
    return sides;
}

/// What is on two sides of zones, or twice on those of one, joins them.
std::string interface_lines(const Topology& topology) {
    std::string text;
    const auto sides = sides_of_zones(topology);
    for (std::size_t n = 0; n < sides.size(); ++n) {
        if (sides[n].size() != 2) continue;
        const std::string& name =
            topology.is_3d() ? topology.faces[n].name : topology.edges[n].name;
        text += sides[n][0] == sides[n][1]
                    ? fmt::format("  {:<24} {}, with itself\n", name, sides[n][0])
                    : fmt::format("  {:<24} {}, {}\n", name, sides[n][0], sides[n][1]);
    }
    return text.empty() ? text : "interfaces:\n" + text;
}

std::string periodic_line(const Topology& topology, const PeriodicInterface& interface) {
    std::string text = fmt::format("  {:<24} {}:", interface.name, map_text(interface.periodicity));
    const auto name = [&](int side) {
        const auto s = static_cast<std::size_t>(side);
        return topology.is_3d() ? topology.faces[s].name : topology.edges[s].name;
    };
    for (const PeriodicPair& pair : interface.pairs) {
        text += fmt::format(" {} -> {}", name(pair.from), name(pair.to));
        if (&pair != &interface.pairs.back()) text += ',';
    }
    return text + "\n";
}

std::string sweep_line(const Topology& topology) {
    const Sweep& sweep = *topology.sweep;
    std::string text = fmt::format("swept by a {}, {} {}", map_text(sweep.whole), sweep.cells,
                                   sweep.cells == 1 ? "cell" : "cells");
    if (topology.family && sweep.single) text += " at every level";
    if (sweep.joined) return text + ", its ends joined\n";
    return text + fmt::format(", from {} to {}\n", sweep.ends[0], sweep.ends[1]);
}

std::string mirror_line(const Topology& topology) {
    const MirrorCopy& mirror = *topology.mirror;
    const auto at = static_cast<std::size_t>(mirror.boundary);
    return fmt::format("mirrored at {}, {} = {}: every zone twice\n",
                       topology.boundaries[at].family.name, "xyz"[mirror.plane.axis],
                       number_text(mirror.plane.value));
}

}  // namespace

std::string map_text(const Periodicity& periodicity) {
    const Vec3& t = periodicity.translation;
    if (t != Vec3{}) return "translation " + point_text(t);
    const Vec3& a = periodicity.angle;
    const char axis = a.x != 0 ? 'x' : a.y != 0 ? 'y' : 'z';
    return fmt::format("rotation about {} by {} through {}", axis, number_text(a.x + a.y + a.z),
                       point_text(periodicity.center));
}

std::string copies_text(const Topology& topology) {
    return (topology.sweep ? sweep_line(topology) : "") +
           (topology.mirror ? mirror_line(topology) : "");
}

std::string adjusted_counts_text(const Topology& topology) {
    std::string rows;
    for (const AdjustedCount& a : topology.adjusted_counts) {
        if (!a.raised()) continue;
        rows +=
            fmt::format("  {:<24} {:>10} {:>10.6g} {:>10}\n", a.edge, a.written, a.asked, a.got);
    }
    if (rows.empty()) return {};
    return fmt::format("{:<26} {:>10} {:>10} {:>10}\n", "cells raised, of edge", "written", "asked",
                       "got") +
           rows;
}

std::string to_text(const Topology& topology, const Topology& solved) {
    std::string text;
    if (topology.family) text = level_line(level_measure(*solved.family, topology.family->level));
    text += fmt::format("{} vertices, {} edges, {} faces, {} blocks; {} cells\n",
                        topology.vertices.size(), topology.edges.size(), topology.faces.size(),
                        topology.blocks.size(), topology.cells());
    text += "zones:\n";
    if (topology.is_3d()) {
        for (const Block& b : topology.blocks) text += zone_line(b.name, b.extent);
    } else {
        for (const Face& f : topology.faces) text += zone_line(f.name, topology.zone_extent(f));
    }
    text += interface_lines(topology);
    text += "boundaries:\n";
    for (const Boundary& b : topology.boundaries) text += boundary_line(topology, b);
    if (!topology.periodic.empty()) text += "periodic:\n";
    for (const PeriodicInterface& p : topology.periodic) text += periodic_line(topology, p);
    text += adjusted_counts_text(topology);
    text += copies_text(topology);
    text +=
        fmt::format("memory: about {} on {} {}\n", memory_text(estimated_bytes(solved, threads())),
                    threads(), threads() == 1 ? "thread" : "threads");
    return text;
}

}  // namespace hexweave
