// SPDX-License-Identifier: Apache-2.0
#include "quality/grid_comparison.h"

#include <fmt/format.h>

#include <utility>

#include "core/errors.h"
#include "core/periodic_ends.h"

namespace hexweave {
namespace {

void require_finite(const GridOutline& golden, const std::vector<ZoneSurvey>& surveys) {
    for (std::size_t n = 0; n < surveys.size(); ++n) {
        if (!surveys[n].not_finite) continue;
        const Node& node = *surveys[n].not_finite;
        throw UsageError(fmt::format(
            "cannot compare: node ({}, {}, {}) of zone '{}' of the golden grid has a coordinate "
            "that is not a finite number",
            node[0] + 1, node[1] + 1, node[2] + 1, golden.zones[n].name));
    }
}

void require_agreeing_ends(const GridOutline& golden, const PointBox& box) {
    const std::vector<std::string> found = contradictions(golden, box);
    if (found.empty()) return;
    throw UsageError(fmt::format("cannot compare: in the golden grid {}", found.front()));
}

/// The nodes of the candidate that a box of its golden counterpart covers, running forwards.
IndexBox covered(const Orientation& to_candidate, const IndexBox& box, const Extent& extent) {
    IndexBox result{map_node(to_candidate, box.begin, extent),
                    map_node(to_candidate, box.end, extent)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (result.begin[axis] > result.end[axis]) std::swap(result.begin[axis], result.end[axis]);
    }
    return result;
}

/// Compares two zones of the same numbers of nodes, reading one portion ahead.
ZoneDeviation compare_zone(const PointSource& candidate, const PointSource& golden,
                           const ZoneMatch& match, const Allowance& allowed) {
    const Extent& own = candidate.outline.zones[static_cast<std::size_t>(match.candidate)].extent;
    const Extent& other = golden.outline.zones[static_cast<std::size_t>(match.golden)].extent;
    const Orientation to_candidate = inverse(match.to_golden);
    const std::vector<Portion> portions =
        cut(other, std::min(candidate.piece_nodes, golden.piece_nodes));
    const auto ask = [&](const Portion& portion) {
        golden.ask(match.golden, portion.with_neighbours);
        candidate.ask(match.candidate, covered(to_candidate, portion.core, own));
    };
    ask(portions.front());
    ZoneDeviation found;
    for (std::size_t n = 0; n < portions.size(); ++n) {
        if (n + 1 < portions.size()) ask(portions[n + 1]);
        const Piece golden_piece = golden.take();
        const Piece candidate_piece = candidate.take();
        found = together(found, compare_points(portions[n], golden_piece, candidate_piece,
                                               to_candidate, own, allowed));
    }
    return found;
}

}  // namespace

ZoneDeviation GridComparison::all() const {
    ZoneDeviation found;
    for (const ZoneComparison& zone : zones) found = together(found, zone.deviation);
    return found;
}

bool GridComparison::same() const {
    return differences.empty() && all().beyond == 0;
}

GridComparison compare_grids(const PointSource& candidate, const PointSource& golden,
                             const ComparisonOptions& options) {
    const std::vector<ZoneSurvey> golden_survey = survey(golden);
    require_finite(golden.outline, golden_survey);
    const PointBox golden_box = box_of(golden_survey);
    require_agreeing_ends(golden.outline, golden_box);
    const Allowance allowed = allowance(options.tolerance, golden_box);
    const std::vector<ZoneMatch> matches =
        options.by_shape
            ? match_by_shape(candidate.outline, survey(candidate), golden.outline, golden_survey)
            : match_by_name(candidate.outline, golden.outline);

    GridComparison result;
    result.tolerance = options.tolerance;
    result.floor = allowed.floor;
    result.units = golden.outline.units;
    result.cell_dimension = candidate.outline.cell_dimension;
    result.differences = compare_outlines(candidate.outline, golden.outline, matches, golden_box);
    result.others = candidate.outline.others;
    result.golden_others = golden.outline.others;
    for (const ZoneMatch& match : matches) {
        const ZoneOutline& own = candidate.outline.zones[static_cast<std::size_t>(match.candidate)];
        const ZoneOutline& other = golden.outline.zones[static_cast<std::size_t>(match.golden)];
        if (!(own.extent == own_extent(match.to_golden, other.extent))) continue;
        result.zones.push_back({own.name, other.name, own.extent, match.to_golden,
                                compare_zone(candidate, golden, match, allowed)});
    }
    return result;
}

}  // namespace hexweave
