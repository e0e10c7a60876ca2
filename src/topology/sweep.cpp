// SPDX-License-Identifier: Apache-2.0
#include "topology/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/coordinate.h"
#include "topology/boundaries.h"
#include "topology/counting.h"
#include "topology/revolution.h"
#include "topology/sample.h"
#include "topology/spacing_fit.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr double near_to = 1e-9;  // a plane, of the grid's size

Sweep extrusion(const SweepEntry& entry, const Vec3& along, Diagnostics& diagnostics) {
    Sweep sweep;
    sweep.whole = {{}, {}, along};
    sweep.reversed = along.z < 0;
    sweep.length = norm(along);
    sweep.law = UniformLaw{};
    if (!entry.spacing) return sweep;
    const SpacingEntry& law = entry.spacing->value;
    if (std::holds_alternative<LikeLaw>(law)) {
        diagnostics.error(entry.spacing->place, "the layers of 'extrude' are like no edge",
                          "give them a law of their own");
    }
    if (const auto* tanh = std::get_if<TanhLaw>(&law)) sweep.law = *tanh;
    if (const auto* geometric = std::get_if<GeometricLaw>(&law)) sweep.law = *geometric;
    if (const auto* points = std::get_if<ExplicitLaw>(&law)) sweep.law = *points;
    return sweep;
}

/// Sets the cells of a sweep that has its law, and checks that the law fits them.
void count_layers(Network& network, const SweepEntry& entry, const std::string& what,
                  const CountRules& rules, Sweep& sweep, Diagnostics& diagnostics) {
    constexpr std::int64_t most = std::numeric_limits<int>::max() - 1;
    sweep.single = entry.cells.value == 1;
    const LayerCount layers = raise_layers(entry, rules, diagnostics);
    if (layers.cells > most) {
        diagnostics.error(entry.cells.place, fmt::format("'{}' has {}: more than a CGNS zone can "
                                                         "hold",
                                                         what, cells_text(layers.cells)));
        return;
    }
    sweep.cells = static_cast<int>(layers.cells);
    sweep.refinement = layers.refinement;
    if (sweep.cells != entry.cells.value || rules.family) {
        network.topology.adjusted_counts.push_back(
            {sweep_layers, entry.cells.value, layers.asked, sweep.cells});
    }
    const std::string misfit =
        spacing_misfit(sweep.law, sweep.cells / sweep.refinement, sweep.length);
    if (!misfit.empty()) {
        diagnostics.error(entry.spacing->place,
                          fmt::format("the spacing of '{}' does not fit: {}", what, misfit),
                          spacing_hint(sweep.law, sweep.cells / sweep.refinement, sweep.length));
    }
}

/// Whether the images of an interface are images in every layer.
bool keeps(const Sweep& sweep, const Periodicity& periodicity) {
    const Vec3& turn = sweep.whole.angle;
    if (turn != Vec3{}) {
        return periodicity.angle == Vec3{} && cross(periodicity.translation, turn) == Vec3{};
    }
    return periodicity.angle == Vec3{} ||
           (sweep.whole.translation.x == 0 && sweep.whole.translation.y == 0);
}

void check_periodic(const Network& network, const Sweep& sweep, Diagnostics& diagnostics) {
    for (const PeriodicInterface& interface : network.topology.periodic) {
        if (keeps(sweep, interface.periodicity)) continue;
        diagnostics.error(
            interface.place,
            fmt::format("periodic interface {} is none in the swept grid", quoted(interface.name)),
            sweep.whole.angle != Vec3{}
                ? "a revolution keeps translations along its axis"
                : "an extrusion off the direction of z keeps translations, but no rotations");
    }
}

std::optional<int> boundary_named(const Topology& topology, const std::string& name) {
    for (std::size_t b = 0; b < topology.boundaries.size(); ++b) {
        if (topology.boundaries[b].family.name == name) return static_cast<int>(b);
    }
    return std::nullopt;
}

/// The boundary of a name, or -1 after an error.
int find_boundary(const Topology& topology, const Name& name, Diagnostics& diagnostics) {
    if (name.value.empty()) return -1;
    const std::optional<int> found = boundary_named(topology, name.value);
    if (found) return *found;
    std::vector<std::string> known;
    for (const Boundary& b : topology.boundaries) known.push_back(b.family.name);
    const std::string nearest = nearest_name(name.value, known);
    diagnostics.error(name.place, fmt::format("unknown boundary {}", quoted(name.value)),
                      nearest.empty() ? "give it an entry in 'boundaries', with its 'type'"
                                      : fmt::format("did you mean {}?", quoted(nearest)));
    return -1;
}

}  // namespace

void place_sweep(Network& network, const Case& c, const CountRules& rules,
                 Diagnostics& diagnostics) {
    if (!c.sweep) return;
    const SweepEntry& entry = *c.sweep;
    const auto* turn = std::get_if<RotationEntry>(&entry.map);
    const std::string what = turn != nullptr ? "revolve" : "extrude";
    if (!network.topology.planar || network.three_dimensional) {
        diagnostics.error(entry.place,
                          fmt::format("'{}' needs a planar grid: faces in z = 0, no blocks", what),
                          "leave it out, or draw the faces in the plane");
        return;
    }
    Sweep sweep = turn != nullptr ? revolution(network, entry, *turn, diagnostics)
                                  : extrusion(entry, std::get<Vec3>(entry.map), diagnostics);
    count_layers(network, entry, what, rules, sweep, diagnostics);
    check_turn(sweep, entry, diagnostics);
    sweep.joined = entry.periodic || sweep.full_turn;
    check_periodic(network, sweep, diagnostics);
    network.topology.sweep = sweep;
}

void resolve_sweep_ends(Network& network, const Case& c, Diagnostics& diagnostics) {
    Topology& topology = network.topology;
    if (!topology.sweep) return;
    Sweep& sweep = *topology.sweep;
    for (std::size_t end = 0; end < 2; ++end) {
        const std::optional<Name>& name = c.sweep->ends[end];
        if (name && sweep.full_turn) {
            diagnostics.error(name->place, "a full turn has no ends",
                              "leave 'start' and 'end' out: the last plane is the first one");
        } else if (name) {
            find_boundary(topology, *name, diagnostics);
            sweep.ends[end] = name->value;
        }
    }
    if (sweep.joined || (c.sweep->ends[0] && c.sweep->ends[1])) return;
    const bool both = !c.sweep->ends[0] && !c.sweep->ends[1];
    diagnostics.warning(
        c.sweep->place,
        fmt::format("no boundary is said for {}", both               ? "the ends of the sweep"
                                                  : c.sweep->ends[0] ? "its end"
                                                                     : "its start"),
        fmt::format("written as family '{}', UserDefined; say 'start' and 'end', or "
                    "'periodic: true'",
                    unassigned_family));
    if (!boundary_named(topology, unassigned_family)) {
        topology.boundaries.push_back({{unassigned_family, "UserDefined"}, {}, {}});
    }
    for (std::size_t end = 0; end < 2; ++end) {
        if (!c.sweep->ends[end]) sweep.ends[end] = unassigned_family;
    }
}

namespace {

/// Whether the whole grid is on one side of a plane that is not its own.
bool lies_beside(const Topology& topology, const AxisPlane& plane) {
    constexpr int intervals = 32;
    AxisReach reach;
    const auto enter = [&](Vec3 p) { include(reach, coordinate(p, plane.axis) - plane.value); };
    for (const Vertex& v : topology.vertices) enter(v.position);
    for (const Edge& e : topology.edges) {
        for (const Vec3& p : sample_edge(e, intervals)) enter(p);
    }
    const double near = near_to * topology.size;
    return (reach.low >= -near) != (reach.high <= near);
}

/// Zones and families of copies have names that CGNS can hold, and that no other has.
void check_copied_names(const Network& network, const MirrorEntry& entry,
                        Diagnostics& diagnostics) {
    constexpr std::size_t longest = 32;
    const Topology& topology = network.topology;
    std::vector<std::string> taken;
    for (const Boundary& b : topology.boundaries) taken.push_back(b.family.name);
    for (const Face& f : topology.faces) taken.push_back(f.name);
    for (const Block& b : topology.blocks) taken.push_back(b.name);
    const auto check = [&](const std::string& name, const Place& place) {
        const std::string copy = name + mirror_suffix;
        if (copy.size() > longest) {
            diagnostics.error(place,
                              fmt::format("the mirror image of {} would have a name of {} "
                                          "bytes, more than the {} that CGNS can hold",
                                          quoted(name), copy.size(), longest),
                              "give it a shorter name");
        } else if (std::find(taken.begin(), taken.end(), copy) != taken.end()) {
            diagnostics.error(place,
                              fmt::format("the mirror image of {} would have the name {}, "
                                          "which is taken",
                                          quoted(name), quoted(copy)),
                              "rename one of them");
        }
    };
    if (topology.is_3d()) {
        for (const Block& b : topology.blocks) check(b.name, b.place);
    } else {
        for (const Face& f : topology.faces) check(f.name, f.place);
    }
    if (!entry.families_apart) return;
    for (const Boundary& b : topology.boundaries) check(b.family.name, entry.place);
}

}  // namespace

void resolve_mirror(Network& network, const Case& c, Diagnostics& diagnostics) {
    if (!c.mirror) return;
    const MirrorEntry& entry = *c.mirror;
    const int at = find_boundary(network.topology, entry.at, diagnostics);
    if (at < 0) return;
    const Boundary& boundary = network.topology.boundaries[static_cast<std::size_t>(at)];
    // The side that it lacks may be the one that is at fault.
    if (boundary.sides.empty() && !network.intact) return;
    const bool own_plane = boundary.plane && boundary.plane->axis == 2 && network.topology.planar;
    if (!boundary.plane || boundary.sides.empty() || own_plane) {
        diagnostics.error(entry.at.place,
                          fmt::format("boundary {} has no {}", quoted(entry.at.value),
                                      own_plane        ? "plane across the grid"
                                      : boundary.plane ? "sides"
                                                       : "plane"),
                          "the image is made at a boundary whose sides are on its 'plane: \"y = "
                          "0\"'");
        return;
    }
    if (!lies_beside(network.topology, *boundary.plane)) {
        diagnostics.error(entry.at.place,
                          "the grid lies on both sides of the plane that it is mirrored at",
                          "its image would overlap it: draw the one side only");
    }
    const std::optional<Sweep>& sweep = network.topology.sweep;
    if (sweep && sweep->whole.angle != Vec3{} &&
        (boundary.plane->axis == 0 ? sweep->whole.angle.x : sweep->whole.angle.y) == 0) {
        diagnostics.error(entry.at.place,
                          "a grid that is mirrored at a plane along the axis of "
                          "'revolve' lies on both sides of it",
                          "turn it farther instead");
    }
    const bool ends_there =
        sweep && (sweep->ends[0] == entry.at.value || sweep->ends[1] == entry.at.value);
    if (ends_there) {
        diagnostics.error(entry.at.place,
                          "an end of the sweep is in the boundary that 'mirror' takes away",
                          "give the end a boundary of its own");
    }
    check_copied_names(network, entry, diagnostics);
    network.topology.mirror = MirrorCopy{*boundary.plane, at, entry.families_apart};
}

}  // namespace hexweave
