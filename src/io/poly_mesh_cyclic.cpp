// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/errors.h"
#include "core/periodic_image.h"
#include "io/poly_mesh_parts.h"

namespace hexweave {
namespace {

bool same_map(const Periodicity& a, const Periodicity& b) {
    return a.center == b.center && a.angle == b.angle && a.translation == b.translation;
}

/// Of length 1; 0 where nothing turns.
Vec3 axis_of_turn(const Periodicity& periodicity) {
    if (periodicity.angle == Vec3{}) return {};
    const auto& rows = periodic_map(periodicity).rows;
    const Vec3 twist{rows[2].y - rows[1].z, rows[0].z - rows[2].x, rows[1].x - rows[0].y};
    // A half turn has no sense, and its matrix no twist.
    const Vec3 axis = norm(twist) > 1e-9 ? twist : periodicity.angle;
    return axis / norm(axis);
}

/// The map of an interface. Files keep translations in single precision, coarser than cells at a
/// wall: the nodes tell them better.
Periodicity exact_map(const MultiblockGrid& grid, const Interface& interface) {
    Periodicity map = *interface.periodic;
    if (map.angle != Vec3{}) return map;
    const auto at = [&](int zone, const Node& n) {
        return grid.zones[static_cast<std::size_t>(zone)].points(n[0], n[1], n[2]);
    };
    const Vec3 own = at(interface.zone, interface.box.begin);
    const Vec3 donor = at(interface.donor, interface.donor_box.begin);
    if (own + map.translation != donor) map.translation = donor - own;
    return map;
}

}  // namespace

std::vector<CyclicPair> cyclic_pairs(const MultiblockGrid& grid) {
    std::vector<CyclicPair> pairs;
    for (std::size_t n = 0; n < grid.interfaces.size(); ++n) {
        const Interface& interface = grid.interfaces[n];
        if (!interface.periodic) continue;
        const Periodicity& map = *interface.periodic;
        if (map.angle != Vec3{} && map.translation != Vec3{}) {
            throw UsageError(fmt::format(
                "an OpenFOAM mesh cannot hold this grid: interface '{}' both turns and moves",
                interface.name));
        }
        const auto own = std::find_if(pairs.begin(), pairs.end(), [&](const CyclicPair& pair) {
            return same_map(map, pair.periodicity) || runs_back(pair, interface);
        });
        if (own != pairs.end()) {
            own->interfaces.push_back(n);
        } else {
            pairs.push_back({interface.name.substr(0, interface.name.find('-')), map, {n}});
            pairs.back().exact = exact_map(grid, interface);
        }
    }
    return pairs;
}

bool runs_back(const CyclicPair& pair, const Interface& interface) {
    return same_map(backwards(pair.periodicity), *interface.periodic);
}

std::array<CyclicHalf, 2> cyclic_halves(const CyclicPair& pair, double metres) {
    const Periodicity& map = pair.exact;
    const Vec3 axis = axis_of_turn(map);
    const Vec3 centre = metres * map.center;
    const Vec3 way = metres * map.translation;
    return {CyclicHalf{"", way, axis, centre}, CyclicHalf{"", Vec3{} - way, axis, centre}};
}

}  // namespace hexweave
