// SPDX-License-Identifier: Apache-2.0
#include "quality/grid_quality.h"

#include <algorithm>
#include <limits>

#include "quality/cell_statistics.h"
#include "quality/lines_across.h"
#include "quality/measure.h"

namespace hexweave {

namespace {

/// Of all growth ratios along the lines of a zone.
void include_growth(const PointField& points, Histogram& histogram) {
    for_intervals(points, [&](std::size_t, double length, double next, const Vec3& node) {
        GrowthMeasure here;
        here.include(length, next, node);
        histogram.include(here.ratio);
    });
}

void merge(std::vector<Histogram>& all, const CellStatistics& cells) {
    all[0].include(cells.scaled_jacobian);
    all[1].include(cells.skewness.coarsened(all[1].limits));
    all[2].include(cells.aspect_ratio);
    all[3].include(cells.deviation);
}

void keep_worst(std::vector<WorstCell>& worst, const std::vector<WorstCell>& found,
                std::size_t count) {
    worst.insert(worst.end(), found.begin(), found.end());
    std::stable_sort(worst.begin(), worst.end(), is_worse);
    worst.resize(std::min(worst.size(), count));
}

std::size_t sum_of(const std::vector<ZoneQuality>& zones, std::size_t ZoneQuality::*member) {
    std::size_t sum = 0;
    for (const ZoneQuality& zone : zones) sum += zone.*member;
    return sum;
}

}  // namespace

bool is_worse(const WorstCell& a, const WorstCell& b) {
    const bool a_fails = a.verdict == JacobianVerdict::not_positive;
    const bool b_fails = b.verdict == JacobianVerdict::not_positive;
    return a_fails != b_fails ? a_fails : a.scaled_jacobian < b.scaled_jacobian;
}

std::size_t GridQuality::cells() const {
    std::size_t sum = 0;
    for (const ZoneQuality& zone : zones) sum += zone.measure.cells;
    return sum;
}

std::size_t GridQuality::folded() const {
    std::size_t sum = 0;
    for (const ZoneQuality& zone : zones) sum += zone.measure.folded;
    return sum;
}

std::size_t GridQuality::not_positive() const {
    return sum_of(zones, &ZoneQuality::not_positive);
}

std::size_t GridQuality::undecided() const {
    return sum_of(zones, &ZoneQuality::undecided);
}

std::size_t GridQuality::mismatched() const {
    std::size_t sum = 0;
    for (const InterfaceQuality& interface : interfaces) sum += interface.measure.mismatched;
    return sum;
}

bool GridQuality::sound() const {
    return folded() == 0 && not_positive() == 0 && mismatched() == 0;
}

void name_sides_where_nothing_is_named(MultiblockGrid& grid) {
    if (!grid.patches.empty()) return;
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
        const Extent e = grid.zones[z].points.extent();
        for (const Side side : all_sides) {
            const auto axis = static_cast<std::size_t>(side) / 2;
            if (e[static_cast<int>(axis)] == 1) continue;
            IndexBox box{{0, 0, 0}, {e.ni - 1, e.nj - 1, e.nk - 1}};
            const bool at_maximum = static_cast<std::size_t>(side) % 2 == 1;
            (at_maximum ? box.begin : box.end)[axis] = (at_maximum ? box.end : box.begin)[axis];
            const std::string name = grid.zones[z].name + ":" + std::string(side_name(side));
            grid.patches.push_back(
                {name, static_cast<int>(z), box, static_cast<int>(grid.families.size())});
            grid.families.push_back({name, ""});
        }
    }
}

GridQuality measure_quality(const MultiblockGrid& grid, int worst_count) {
    GridQuality quality;
    quality.title = grid.title;
    quality.units = grid.units;
    const CellStatistics empty;
    quality.histograms = {empty.scaled_jacobian,
                          empty.skewness.coarsened({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}),
                          empty.aspect_ratio, empty.deviation,
                          Histogram("growth", {1.1, 1.2, 1.3, 1.5, 2, 5})};
    for (const Zone& zone : grid.zones) {
        const CellStatistics cells = cell_statistics(zone, grid.physical_dimension, worst_count);
        merge(quality.histograms, cells);
        include_growth(zone.points, quality.histograms.back());
        keep_worst(quality.worst, cells.worst, static_cast<std::size_t>(worst_count));
        quality.zones.push_back(cells.quality);
        quality.zones.back().measure = measure_zone(zone, grid.physical_dimension);
        quality.zones.back().bends = measure_bends(zone.points);
    }
    for (const Interface& interface : grid.interfaces) {
        // CGNS files keep what carries periodic interfaces in single precision.
        constexpr double epsilon = std::numeric_limits<float>::epsilon();
        quality.interfaces.push_back(
            {measure_interface(grid, interface, epsilon), measure_bends(grid, interface)});
    }
    quality.boundaries = measure_boundaries(grid);
    return quality;
}

}  // namespace hexweave
