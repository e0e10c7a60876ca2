// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/interface_sides.h"
#include "io/cgns_source.h"

namespace hexweave {
namespace {

/// CGNS counts from 1 and lists all of begin, then all of end.
IndexBox to_box(const cgsize_t* range, int cell_dimension) {
    IndexBox box;
    const auto dimension = static_cast<std::size_t>(cell_dimension);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        box.begin[axis] = static_cast<int>(range[axis] - 1);
        box.end[axis] = static_cast<int>(range[axis + dimension] - 1);
    }
    return box;
}

bool is_permutation(const Orientation& orientation, int cell_dimension) {
    std::array<bool, 3> seen{};
    for (const int other : orientation.axes) {
        if (other == 0 || other < -3 || other > 3) return false;
        seen[static_cast<std::size_t>(std::abs(other) - 1)] = true;
    }
    return seen[0] && seen[1] && seen[2] && (cell_dimension == 3 || orientation.axes[2] == 3);
}

/// Whether the transform carries the one box onto the other.
bool boxes_agree(const Interface& interface) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int other = interface.orientation.axes[axis];
        const auto across = static_cast<std::size_t>(std::abs(other) - 1);
        const int own = interface.box.end[axis] - interface.box.begin[axis];
        const int donor = interface.donor_box.end[across] - interface.donor_box.begin[across];
        if (donor != (other > 0 ? own : -own)) return false;
    }
    return true;
}

Interface read_interface(const CgnsSource& source, const GridOutline& grid, int zone, int number) {
    CgnsName name{};
    CgnsName donor{};
    std::array<cgsize_t, 6> range{};
    std::array<cgsize_t, 6> donor_range{};
    std::array<int, 3> transform{1, 2, 3};
    source.check(cg_1to1_read(source.file(), CgnsSource::base(), zone_of(grid, zone).number, number,
                              name.data(), donor.data(), range.data(), donor_range.data(),
                              transform.data()));
    const std::string what =
        fmt::format("interface '{}' of zone '{}'", name.data(), zone_of(grid, zone).name);
    const auto place =
        std::find_if(grid.zones.begin(), grid.zones.end(),
                     [&](const ZoneOutline& candidate) { return candidate.name == donor.data(); });
    if (place == grid.zones.end()) {
        source.cannot_read(
            fmt::format("{} leads to '{}', which is not in the file", what, donor.data()));
    }
    const int donor_zone = static_cast<int>(place - grid.zones.begin());
    const Interface result{name.data(),
                           zone,
                           to_box(range.data(), grid.cell_dimension),
                           donor_zone,
                           to_box(donor_range.data(), grid.cell_dimension),
                           Orientation{transform},
                           read_periodicity(source, grid, zone, number)};
    if (!is_permutation(result.orientation, grid.cell_dimension)) {
        source.cannot_read(fmt::format("{} has no valid Transform", what));
    }
    if (!lies_in(result.box, zone_of(grid, zone).extent) ||
        !lies_in(result.donor_box, place->extent)) {
        source.cannot_read(fmt::format("{} lies outside its zones", what));
    }
    if (!boxes_agree(result)) {
        source.cannot_read(fmt::format("{} joins ranges of different sizes", what));
    }
    return forwards(result);
}

/// Whether two readings are the same joint seen from the same side; names do not count, nor what
/// carries one side onto the other.
bool same_joint(const Interface& a, const Interface& b) {
    return a.zone == b.zone && a.donor == b.donor && a.box == b.box && a.donor_box == b.donor_box &&
           a.orientation == b.orientation;
}

}  // namespace

void read_interfaces(const CgnsSource& source, GridOutline& grid) {
    std::vector<TwoEnds> awaited;  // those read on their first side, and what the second is to say
    for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
        int count = 0;
        source.check(
            cg_n1to1(source.file(), CgnsSource::base(), zone_of(grid, zone).number, &count));
        for (int number = 1; number <= count; ++number) {
            const Interface found = read_interface(source, grid, zone, number);
            const auto same =
                std::find_if(awaited.begin(), awaited.end(),
                             [&](const TwoEnds& ends) { return same_joint(ends.second, found); });
            if (same == awaited.end()) {
                awaited.push_back({found, other_side(found)});
                grid.interfaces.push_back(found);
                continue;
            }
            if (!(same->second.periodic == found.periodic)) {
                grid.ends_apart.push_back({same->first, found});
            }
            awaited.erase(same);
        }
    }
}

}  // namespace hexweave
