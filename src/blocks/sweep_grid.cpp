// SPDX-License-Identifier: Apache-2.0
#include "blocks/sweep_grid.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/assert.h"
#include "core/periodic_image.h"
#include "edges/spacing.h"

namespace hexweave {

namespace {

/// How far along the sweep its layers are, from 0 to 1: at a coarser level those of every n-th
/// layer of the finest, to the bit.
std::vector<double> layer_fractions(const Sweep& sweep) {
    const std::vector<double> finest = law_fractions(
        sweep.law, sweep.cells * sweep.stride / sweep.refinement, sweep.length, sweep.refinement);
    std::vector<double> fractions;
    for (std::size_t n = 0; n < finest.size(); n += static_cast<std::size_t>(sweep.stride)) {
        fractions.push_back(finest[n]);
    }
    return fractions;
}

/// The maps that lead from the planar grid to every layer, in the order of k. A full turn ends
/// where it began.
std::vector<PeriodicMap> layer_maps(const Sweep& sweep) {
    std::vector<PeriodicMap> maps;
    for (const double f : layer_fractions(sweep)) {
        const bool closing = f == 1 && sweep.full_turn;
        maps.push_back(closing ? PeriodicMap{}
                               : periodic_map({sweep.whole.center, f * sweep.whole.angle,
                                               f * sweep.whole.translation}));
    }
    if (sweep.reversed) return {maps.rbegin(), maps.rend()};
    return maps;
}

Zone swept(const Zone& planar, const std::vector<PeriodicMap>& maps) {
    const Extent e = planar.points.extent();
    HEXWEAVE_ASSERT(e.nk == 1);
    Zone zone{planar.name, PointField(Extent{e.ni, e.nj, static_cast<int>(maps.size())})};
    for (std::size_t k = 0; k < maps.size(); ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                zone.points.set(i, j, static_cast<int>(k), image(maps[k], planar.points(i, j)));
            }
        }
    }
    return zone;
}

/// The family of a name, which is there.
int family_named(const MultiblockGrid& grid, const std::string& name) {
    const auto found = std::find_if(grid.families.begin(), grid.families.end(),
                                    [&](const Family& family) { return family.name == name; });
    HEXWEAVE_ASSERT(found != grid.families.end());
    return static_cast<int>(found - grid.families.begin());
}

/// The patches of every zone at one end of the sweep.
void add_end(MultiblockGrid& grid, const Sweep& sweep, bool last) {
    const int family = family_named(grid, sweep.ends[last ? 1 : 0]);
    const Side side = last != sweep.reversed ? Side::kmax : Side::kmin;
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        const IndexBox box = side_box(side, grid.zones[zone].points.extent());
        grid.patches.push_back({last ? "end" : "start", static_cast<int>(zone), box, family});
    }
}

/// The interface from the one end of a zone to the other.
Interface between_ends(const MultiblockGrid& grid, int zone, const Sweep& sweep) {
    const Extent& extent = grid.zones[static_cast<std::size_t>(zone)].points.extent();
    Interface interface {
        "sweep", zone, side_box(Side::kmin, extent), zone, side_box(Side::kmax, extent), {}
    };
    if (!sweep.full_turn) {
        interface.periodic = sweep.reversed ? backwards(sweep.whole) : sweep.whole;
    }
    return interface;
}

}  // namespace

MultiblockGrid swept(const MultiblockGrid& planar, const Sweep& sweep) {
    const std::vector<PeriodicMap> maps = layer_maps(sweep);
    MultiblockGrid grid = planar;
    grid.cell_dimension = 3;
    grid.physical_dimension = 3;
    for (Zone& zone : grid.zones) zone = swept(zone, maps);
    for (Interface& interface : grid.interfaces) {
        interface.box.end[2] = sweep.cells;
        interface.donor_box.end[2] = sweep.cells;
    }
    for (BoundaryPatch& patch : grid.patches) patch.box.end[2] = sweep.cells;
    if (!sweep.joined) {
        add_end(grid, sweep, false);
        add_end(grid, sweep, true);
        return grid;
    }
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        grid.interfaces.push_back(between_ends(grid, static_cast<int>(zone), sweep));
    }
    return grid;
}

}  // namespace hexweave
