// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "topology/counting.h"
#include "topology/face_frame.h"

namespace hexweave {

namespace {

bool lists_points(const std::optional<Located<SpacingEntry>>& spacing) {
    if (!spacing) return false;
    const auto* points = std::get_if<ExplicitLaw>(&spacing->value);
    return points != nullptr && points->values.size() > 1;
}

/// Whether the edge's count is that of the points that it lists.
bool lists_points(const EdgeEntry* entry) {
    return entry != nullptr && lists_points(entry->spacing);
}

/// By group: the first edge that lists its points, else the first that is given a count, else the
/// first.
std::vector<int> spokesmen(const Counting& counting) {
    std::vector<int> edges(counting.groups.size(), -1);
    const auto rank = [&](int edge) {
        const auto e = static_cast<std::size_t>(edge);
        return lists_points(counting.network.edge_entries[e]) ? 2 : counting.given[e] ? 1 : 0;
    };
    for (std::size_t e = 0; e < counting.group_of.size(); ++e) {
        int& edge = edges[static_cast<std::size_t>(counting.group_of[e])];
        if (edge < 0 || rank(static_cast<int>(e)) > rank(edge)) edge = static_cast<int>(e);
    }
    return edges;
}

/// What the counts in the file are multiplied with, and of what they are then multiples, before
/// they are refined: in a nested family, such that the coarsest level has what all are to have.
struct Scale {
    double factor = 1;
    std::int64_t multiple = 1;
    int refinement = 1;
};

Scale scale_of(const CountRules& rules) {
    Scale scale;
    if (rules.multiple_of) scale.multiple = rules.multiple_of->value;
    if (!rules.family) return scale;
    const GridFamily& family = *rules.family;
    if (!family.nested()) {
        scale.factor = family.times_medium(family.level);
        return scale;
    }
    scale.multiple = common_multiple(scale.multiple * std::llround(1 / family.times_medium(0)), 1);
    scale.refinement = static_cast<int>(std::lround(family.times_medium(family.level)));
    return scale;
}

std::vector<WantedCount> wanted_counts(const Counting& counting, const std::vector<int>& spokesmen,
                                       const Scale& scale) {
    std::vector<WantedCount> wanted;
    for (std::size_t g = 0; g < spokesmen.size(); ++g) {
        const auto edge = static_cast<std::size_t>(spokesmen[g]);
        wanted.push_back({static_cast<double>(counting.groups[g].cells) * scale.factor,
                          scale.multiple, lists_points(counting.network.edge_entries[edge])});
    }
    for (std::size_t e = 0; e < counting.group_of.size(); ++e) {
        const EdgeEntry* entry = counting.network.edge_entries[e];
        if (entry == nullptr || !entry->multiple_of) continue;
        WantedCount& own = wanted[static_cast<std::size_t>(counting.group_of[e])];
        own.multiple = common_multiple(own.multiple, entry->multiple_of->value);
    }
    return wanted;
}

/// Points that are listed, for `cells` of them, cannot become more, nor others.
void check_listed(const std::string& lister, const Place& place, std::int64_t cells,
                  std::int64_t multiple, const Scale& scale, Diagnostics& diagnostics) {
    if (scale.refinement > 1 || scale.factor != 1) {
        diagnostics.error(
            place,
            fmt::format("{} lists its points, which are those of the level 'medium' only", lister),
            "give a formula in t, which fits any count");
    } else if (cells % multiple != 0) {
        diagnostics.error(
            place,
            fmt::format("{} lists the points of {}, which is not a multiple of {}", lister,
                        cells_text(cells), multiple),
            "list as many as that takes, or give a formula in t, which fits any count");
    }
}

void check_listed(const Counting& counting, const std::vector<WantedCount>& wanted,
                  const std::vector<int>& spokesmen, const Scale& scale) {
    for (std::size_t g = 0; g < wanted.size(); ++g) {
        if (!wanted[g].fixed) continue;
        const auto edge = static_cast<std::size_t>(spokesmen[g]);
        check_listed("edge " + counting.edge_name(spokesmen[g]),
                     counting.network.edge_entries[edge]->spacing->place, counting.groups[g].cells,
                     wanted[g].multiple, scale, counting.diagnostics);
    }
}

void report_unbalanced(const Counting& counting, const SumEquation& equation) {
    const std::size_t low = 2 * equation.axis;
    counting.diagnostics.error(
        counting.network.face(equation.face).place,
        fmt::format("no multiples were found that make {} and {} of face {} equal",
                    side_name(all_sides[low]), side_name(all_sides[low + 1]),
                    counting.face_name(equation.face)),
        "write counts on its edges that are multiples and add up");
}

}  // namespace

std::vector<AdjustedCount> adjust_counts(Counting& counting,
                                         const std::vector<SumEquation>& equations,
                                         const CountRules& rules) {
    const std::vector<int> edges = spokesmen(counting);
    const Scale scale = scale_of(rules);
    const std::vector<WantedCount> wanted = wanted_counts(counting, edges, scale);
    check_listed(counting, wanted, edges, scale);
    const RaisedCounts raised = raise_counts(wanted, equations);
    if (raised.unequal) report_unbalanced(counting, equations[*raised.unequal]);
    std::vector<AdjustedCount> adjusted;
    for (std::size_t g = 0; g < wanted.size(); ++g) {
        GroupCount& count = counting.groups[g];
        const std::int64_t written = count.cells;
        count.cells = raised.cells[g] * scale.refinement;
        if (count.cells == written && !rules.family) continue;
        adjusted.push_back({counting.network.edge(edges[g]).name, static_cast<int>(written),
                            wanted[g].asked * scale.refinement, static_cast<int>(count.cells)});
    }
    return adjusted;
}

LayerCount raise_layers(const SweepEntry& entry, const CountRules& rules,
                        Diagnostics& diagnostics) {
    const int written = entry.cells.value;
    if (written == 1) return {};
    const Scale scale = scale_of(rules);
    const bool listed = lists_points(entry.spacing);
    if (listed) {
        check_listed("the sweep", entry.spacing->place, written, scale.multiple, scale,
                     diagnostics);
    }
    const double asked = listed ? written : written * scale.factor;
    const RaisedCounts raised = raise_counts({{asked, scale.multiple, listed}}, {});
    return {raised.cells.front() * scale.refinement, asked * scale.refinement, scale.refinement};
}

}  // namespace hexweave
