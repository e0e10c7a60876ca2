// SPDX-License-Identifier: Apache-2.0
#include "quality/zone_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <tuple>

namespace hexweave {
namespace {

std::vector<Orientation> find_orientations(int cell_dimension) {
    std::vector<Orientation> found;
    std::array<int, 3> order{1, 2, 3};
    do {
        if (cell_dimension == 2 && order[2] != 3) continue;
        for (int signs = 0; signs < 8; ++signs) {
            if (cell_dimension == 2 && (signs & 4) != 0) continue;
            Orientation o{order};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if ((signs >> axis & 1) != 0) o.axes[axis] = -o.axes[axis];
            }
            found.push_back(o);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return found;
}

/// The place among the samples (four along each axis) of sample `n` of the candidate in the golden
/// zone. Reversing an axis exchanges first and last, second and third.
std::size_t mapped_sample(const Orientation& o, std::size_t n) {
    const Node own{static_cast<int>(n % 4), static_cast<int>(n / 4 % 4), static_cast<int>(n / 16)};
    const Extent samples{4, 4, 4};
    const Node other = map_node(o, own, samples);
    return samples.offset(other[0], other[1], other[2]);
}

/// As `distance`, for points of any size.
double far_between(const Vec3& a, const Vec3& b) {
    return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

/// The greatest distance between samples; stops where it exceeds `limit`. Samples of the candidate
/// that are no finite numbers say nothing of where its zone lies; infinite when none is left.
double sample_distance(const Orientation& o, const ZoneSurvey& candidate, const ZoneSurvey& golden,
                       double limit) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double greatest = -1;
    for (std::size_t n = 0; n < candidate.samples.size(); ++n) {
        if (!is_finite(candidate.samples[n])) continue;
        const double d = far_between(candidate.samples[n], golden.samples[mapped_sample(o, n)]);
        if (!(d <= limit)) return infinity;
        greatest = std::max(greatest, d);
    }
    return greatest < 0 ? infinity : greatest;
}

struct Pair {
    double distance = 0;
    bool other_name = false;
    ZoneMatch match;
};

/// The orientation in which two zones are nearest; an infinite distance where none is near.
Pair nearest(const GridOutline& candidate, const GridOutline& golden, const ZoneMatch& zones,
             const ZoneSurvey& own, const ZoneSurvey& other) {
    const ZoneOutline& a = candidate.zones[static_cast<std::size_t>(zones.candidate)];
    const ZoneOutline& b = golden.zones[static_cast<std::size_t>(zones.golden)];
    constexpr double near = 0.1;
    double limit = near * far_between(other.box.least, other.box.greatest);
    Pair best{std::numeric_limits<double>::infinity(), a.name != b.name, zones};
    if (far_between(own.box.least, other.box.least) > 2 * limit ||
        far_between(own.box.greatest, other.box.greatest) > 2 * limit) {
        return best;
    }
    for (const Orientation& o : all_orientations(candidate.cell_dimension)) {
        if (!(own_extent(o, b.extent) == a.extent)) continue;
        const double d = sample_distance(o, own, other, limit);
        if (d >= best.distance) continue;
        best.distance = limit = d;
        best.match.to_golden = o;
    }
    return best;
}

std::array<int, 3> sorted_extent(const Extent& extent) {
    std::array<int, 3> sorted{extent.ni, extent.nj, extent.nk};
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace

const std::vector<Orientation>& all_orientations(int cell_dimension) {
    static const std::vector<Orientation> of_faces = find_orientations(2);
    static const std::vector<Orientation> of_blocks = find_orientations(3);
    return cell_dimension == 2 ? of_faces : of_blocks;
}

std::vector<ZoneMatch> match_by_name(const GridOutline& candidate, const GridOutline& golden) {
    std::map<std::string, int> places;
    for (std::size_t n = 0; n < golden.zones.size(); ++n) {
        places[golden.zones[n].name] = static_cast<int>(n);
    }
    std::vector<ZoneMatch> matches;
    for (std::size_t n = 0; n < candidate.zones.size(); ++n) {
        const auto place = places.find(candidate.zones[n].name);
        if (place != places.end()) matches.push_back({static_cast<int>(n), place->second, {}});
    }
    return matches;
}

std::vector<ZoneMatch> match_by_shape(const GridOutline& candidate,
                                      const std::vector<ZoneSurvey>& candidate_surveys,
                                      const GridOutline& golden,
                                      const std::vector<ZoneSurvey>& golden_surveys) {
    std::map<std::array<int, 3>, std::vector<int>> alike;
    for (std::size_t n = 0; n < golden.zones.size(); ++n) {
        alike[sorted_extent(golden.zones[n].extent)].push_back(static_cast<int>(n));
    }
    std::vector<Pair> pairs;
    for (std::size_t n = 0; n < candidate.zones.size(); ++n) {
        for (const int other : alike[sorted_extent(candidate.zones[n].extent)]) {
            const Pair pair =
                nearest(candidate, golden, {static_cast<int>(n), other, {}}, candidate_surveys[n],
                        golden_surveys[static_cast<std::size_t>(other)]);
            if (pair.distance < std::numeric_limits<double>::infinity()) pairs.push_back(pair);
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.distance, a.other_name, a.match.candidate, a.match.golden) <
               std::tie(b.distance, b.other_name, b.match.candidate, b.match.golden);
    });
    std::vector<bool> taken(candidate.zones.size());
    std::vector<bool> golden_taken(golden.zones.size());
    std::vector<ZoneMatch> matches;
    for (const Pair& pair : pairs) {
        const auto own = static_cast<std::size_t>(pair.match.candidate);
        const auto other = static_cast<std::size_t>(pair.match.golden);
        if (taken[own] || golden_taken[other]) continue;
        taken[own] = golden_taken[other] = true;
        matches.push_back(pair.match);
    }
    std::sort(matches.begin(), matches.end(),
              [](const ZoneMatch& a, const ZoneMatch& b) { return a.candidate < b.candidate; });
    return matches;
}

}  // namespace hexweave
