// SPDX-License-Identifier: Apache-2.0
#include "blocks/assemble.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "core/assert.h"

namespace hexweave {

namespace {

/// Where a face bounds a block, or an edge a face. `box` runs forwards; `orientation` takes the
/// side's two tangential axes to the entity's (i, j). An edge is an entity of one axis: in two
/// dimensions the second tangential axis is k, one node thick.
struct Use {
    int zone = 0;
    Side side = Side::imin;
    IndexBox box;
    Orientation orientation;
};

/// The uses of every entity: edges in two dimensions, faces in three.
using Uses = std::vector<std::vector<Use>>;

Uses uses_of_edges(const Topology& topology) {
    Uses uses(topology.edges.size());
    for (std::size_t zone = 0; zone < topology.faces.size(); ++zone) {
        const Face& face = topology.faces[zone];
        for (const Side side : {Side::imin, Side::imax, Side::jmin, Side::jmax}) {
            const auto along = static_cast<std::size_t>(tangential_axes(side)[0]);
            IndexBox box = side_box(side, face.extent());
            for (const EdgeUse& use : face.side(side)) {
                const auto edge = static_cast<std::size_t>(use.edge);
                box.end[along] = box.begin[along] + topology.edges[edge].cells;
                uses[edge].push_back({static_cast<int>(zone), side, box,
                                      Orientation{{use.reversed ? -1 : 1, 2, 3}}});
                box.begin[along] = box.end[along];
            }
        }
    }
    return uses;
}

Uses uses_of_faces(const Topology& topology) {
    Uses uses(topology.faces.size());
    for (std::size_t zone = 0; zone < topology.blocks.size(); ++zone) {
        const Block& block = topology.blocks[zone];
        for (const Side side : all_sides) {
            for (const FaceUse& use : block.side(side).faces) {
                const auto face = static_cast<std::size_t>(use.face);
                const Extent own = own_extent(use.orientation, topology.faces[face].extent());
                IndexBox box = side_box(side, block.extent);
                for (std::size_t n = 0; n < 2; ++n) {
                    const auto axis = static_cast<std::size_t>(tangential_axes(side)[n]);
                    box.begin[axis] = use.begin[n];
                    box.end[axis] = use.begin[n] + own[static_cast<int>(n)] - 1;
                }
                uses[face].push_back({static_cast<int>(zone), side, box, use.orientation});
            }
        }
    }
    return uses;
}

/// The interface between two uses of one entity. The axis across it keeps its direction where a
/// min side meets a max side: one zone goes on where the other ends.
Interface join(const Use& own, const Use& donor, std::string name) {
    const Orientation across = compose(own.orientation, inverse(donor.orientation));
    Interface result{std::move(name), own.zone, own.box, donor.zone, donor.box, {}};
    const auto own_axes = tangential_axes(own.side);
    const auto donor_axes = tangential_axes(donor.side);
    for (std::size_t n = 0; n < 2; ++n) {
        const bool reversed = across.axes[n] < 0;
        const auto m = static_cast<std::size_t>(reversed ? -across.axes[n] : across.axes[n]) - 1;
        const int axis = donor_axes[m] + 1;
        result.orientation.axes[static_cast<std::size_t>(own_axes[n])] = reversed ? -axis : axis;
        const auto d = static_cast<std::size_t>(donor_axes[m]);
        if (reversed) std::swap(result.donor_box.begin[d], result.donor_box.end[d]);
    }
    const int normal = axis_of(donor.side) + 1;
    result.orientation.axes[static_cast<std::size_t>(axis_of(own.side))] =
        is_max(own.side) != is_max(donor.side) ? normal : -normal;
    return result;
}

/// The interface between the uses of two sides of which one is the image of the other.
Interface join_periodic(const Use& from, const Use& to, const PeriodicPair& pair,
                        const Periodicity& periodicity, std::string name) {
    Use donor = to;
    donor.orientation = compose(to.orientation, pair.orientation);
    Interface result = join(from, donor, std::move(name));
    result.periodic = periodicity;
    return result;
}

/// The names of interfaces and patches: those of the entities, cut to the 32 bytes of a CGNS name
/// and told apart by a hash of the whole name (FNV-1a) where they are longer.
std::string short_name(const std::string& name, std::set<std::string>& taken) {
    constexpr std::size_t longest = 32;
    constexpr std::size_t digits = 8;
    if (name.size() <= longest && taken.insert(name).second) return name;
    std::string hashed = name;
    while (true) {
        std::uint32_t hash = 2166136261U;
        for (const char c : hashed) {
            hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
        }
        std::string result = name.substr(0, longest - digits - 1) + "-";
        for (std::size_t digit = digits; digit-- > 0;) {
            result += "0123456789abcdef"[(hash >> (4 * digit)) & 15U];
        }
        if (taken.insert(result).second) return result;
        hashed += '+';
    }
}

/// The interfaces between sides and their images: of the name of the periodic interface, or of it
/// and of the side where it has several. Returns how many sides they join.
std::size_t add_periodic(const Topology& topology, const Uses& uses, std::set<std::string>& taken,
                         MultiblockGrid& grid) {
    std::size_t joined = 0;
    for (const PeriodicInterface& interface : topology.periodic) {
        for (const PeriodicPair& pair : interface.pairs) {
            const auto from = static_cast<std::size_t>(pair.from);
            const std::string& side =
                topology.is_3d() ? topology.faces[from].name : topology.edges[from].name;
            const std::string name =
                interface.pairs.size() == 1 ? interface.name : interface.name + "-" + side;
            grid.interfaces.push_back(
                join_periodic(uses[from][0], uses[static_cast<std::size_t>(pair.to)][0], pair,
                              interface.periodicity, short_name(name, taken)));
            joined += 2;
        }
    }
    return joined;
}

std::vector<Zone> zones(const Topology& topology, const std::vector<FaceGrid>& faces,
                        const std::vector<BlockGrid>& blocks) {
    std::vector<Zone> result;
    if (topology.is_3d()) {
        for (std::size_t n = 0; n < blocks.size(); ++n) {
            result.push_back({topology.blocks[n].name, blocks[n].points});
        }
    } else {
        for (std::size_t n = 0; n < faces.size(); ++n) {
            result.push_back({topology.faces[n].name, faces[n].points});
        }
    }
    return result;
}

}  // namespace

MultiblockGrid assemble(const Topology& topology, const std::vector<FaceGrid>& faces,
                        const std::vector<BlockGrid>& blocks) {
    MultiblockGrid grid;
    grid.title = topology.title;
    grid.units = topology.units;
    grid.provenance = topology.provenance;
    grid.cell_dimension = topology.is_3d() ? 3 : 2;
    grid.physical_dimension = !topology.is_3d() && topology.planar ? 2 : 3;
    grid.zones = zones(topology, faces, blocks);

    const Uses uses = topology.is_3d() ? uses_of_faces(topology) : uses_of_edges(topology);
    std::set<std::string> taken;
    std::vector<std::string> names;
    [[maybe_unused]] std::size_t free_sides = 0;
    for (std::size_t n = 0; n < uses.size(); ++n) {
        names.push_back(
            short_name(topology.is_3d() ? topology.faces[n].name : topology.edges[n].name, taken));
        HEXWEAVE_ASSERT(uses[n].size() <= 2);
        if (uses[n].size() == 1) ++free_sides;
        if (uses[n].size() == 2) {
            grid.interfaces.push_back(join(uses[n][0], uses[n][1], names[n]));
        }
    }
    free_sides -= add_periodic(topology, uses, taken, grid);
    for (const Boundary& boundary : topology.boundaries) {
        const int family = static_cast<int>(grid.families.size());
        grid.families.push_back(boundary.family);
        for (const int side : boundary.sides) {
            const auto n = static_cast<std::size_t>(side);
            HEXWEAVE_ASSERT(uses[n].size() == 1);
            grid.patches.push_back({names[n], uses[n][0].zone, uses[n][0].box, family});
        }
    }
    HEXWEAVE_ASSERT(grid.patches.size() == free_sides);
    return grid;
}

}  // namespace hexweave
