// SPDX-License-Identifier: Apache-2.0
#include "topology/explain_edge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "topology/names.h"
#include "topology/parallel_edges.h"
#include "topology/text.h"

namespace hexweave {

namespace {

struct Chains {
    const Topology& topology;
    ParallelEdges parallels;
    std::vector<const EdgeEntry*> entries;  ///< as topology.edges; null for a made edge

    const Edge& edge(int index) const { return topology.edges[static_cast<std::size_t>(index)]; }
    const EdgeEntry* entry(int index) const { return entries[static_cast<std::size_t>(index)]; }
    std::string name(int index) const { return quoted(edge(index).name); }
};

Chains chains_of(const Case& written, const Topology& topology) {
    Chains chains{topology, parallel_edges(topology), {}};
    for (const Edge& edge : topology.edges) {
        const auto found = std::find_if(
            written.edges.begin(), written.edges.end(),
            [&](const EdgeEntry& entry) { return !edge.made && entry.name.value == edge.name; });
        chains.entries.push_back(found == written.edges.end() ? nullptr : &*found);
    }
    return chains;
}

std::string cells_text(int cells) {
    return fmt::format("{} {}", cells, cells == 1 ? "cell" : "cells");
}

ExplanationStep course(const Chains& chains, int index) {
    const Edge& edge = chains.edge(index);
    const auto vertex = [&](int v) {
        const Vertex& known = chains.topology.vertices[static_cast<std::size_t>(v)];
        return fmt::format("{} {}", quoted(known.name), point_text(known.position));
    };
    if (edge.pole) {
        return {edge.place,
                fmt::format("a pole: all its points are vertex {}", vertex(edge.start))};
    }
    const EdgeEntry* entry = chains.entry(index);
    std::string way = "a straight line";
    if (entry != nullptr && entry->along) {
        way = fmt::format("{} curve {}, parameter {} to {}",
                          edge.to < edge.from ? "against" : "along", quoted(entry->along->value),
                          number_text(edge.from), number_text(edge.to));
    } else if (entry != nullptr && !entry->surfaces.empty()) {
        way = fmt::format("on surface {}", quoted(entry->surfaces.front().value));
    } else if (edge.made) {
        way = "a straight line that nobody drew, made between two corners";
    }
    return {edge.place,
            fmt::format("runs from vertex {} to vertex {}: {}, length {}", vertex(edge.start),
                        vertex(edge.end), way, number_text(edge.length))};
}

/// The place where an edge says how many cells it has.
std::optional<Place> count_place(const EdgeEntry* entry) {
    if (entry == nullptr) return std::nullopt;
    if (entry->cells) return entry->cells->place;
    if (!entry->spacing) return std::nullopt;
    const auto* points = std::get_if<ExplicitLaw>(&entry->spacing->value);
    if (points == nullptr || points->values.empty()) return std::nullopt;
    return entry->spacing->place;
}

/// Steps across faces from an edge on; `what` of the one is that of the other.
void add_crossings(const Chains& chains, int from, const std::vector<Crossing>& crossings,
                   const std::string& what, std::vector<ExplanationStep>& steps) {
    int edge = from;
    for (const Crossing& crossing : crossings) {
        steps.push_back(
            {place_of(chains.topology, crossing),
             fmt::format("  {}, {} has the {} of {}", text_of(chains.topology, crossing),
                         chains.name(edge), what, chains.name(crossing.edge))});
        edge = crossing.edge;
    }
}

/// The faces on whose sides of several edges an edge, or one parallel to it, stands: their sums
/// give its count.
void add_sums(const Chains& chains, int index, std::vector<ExplanationStep>& steps) {
    const std::vector<int> groups = parallel_groups(chains.parallels);
    const int own = groups[static_cast<std::size_t>(index)];
    const auto holds = [&](const std::vector<EdgeUse>& side) {
        return std::any_of(side.begin(), side.end(), [&](const EdgeUse& use) {
            return groups[static_cast<std::size_t>(use.edge)] == own;
        });
    };
    const auto sum = [&](const std::vector<EdgeUse>& side) {
        std::string text;
        for (const EdgeUse& use : side) {
            text += fmt::format("{}{} ({})", text.empty() ? "" : " + ", chains.name(use.edge),
                                chains.edge(use.edge).cells);
        }
        return text;
    };
    for (const Face& face : chains.topology.faces) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto& low = face.sides[2 * axis];
            const auto& high = face.sides[2 * axis + 1];
            if (low.size() == 1 && high.size() == 1) continue;
            if (!holds(low) && !holds(high)) continue;
            steps.push_back(
                {face.place, fmt::format("  opposite sides of face {} are equal: {} = {}",
                                         quoted(face.name), sum(low), sum(high))});
        }
    }
}

/// What was made of the count of an edge, or of one parallel to it, where it is not as written.
const AdjustedCount* adjustment(const Chains& chains, int index) {
    const std::vector<int> groups = parallel_groups(chains.parallels);
    for (const AdjustedCount& adjusted : chains.topology.adjusted_counts) {
        for (std::size_t e = 0; e < groups.size(); ++e) {
            if (groups[e] != groups[static_cast<std::size_t>(index)]) continue;
            if (chains.topology.edges[e].name == adjusted.edge) return &adjusted;
        }
    }
    return nullptr;
}

/// Why a count is not as written: the level, the multiples asked for, or sums over sides.
void explain_raise(const Case& written, const Chains& chains, int index,
                   std::vector<ExplanationStep>& steps) {
    const AdjustedCount* adjusted = adjustment(chains, index);
    if (adjusted == nullptr) return;
    const Place& here = chains.edge(index).place;
    if (adjusted->asked != adjusted->written) {
        const GridFamily& family = *chains.topology.family;
        steps.push_back(
            {here, fmt::format("  at level {} {} times as many: {:.6g}",
                               quoted(family.names[family.level]),
                               number_text(family.times_medium(family.level)), adjusted->asked)});
    }
    if (!adjusted->raised()) return;
    steps.push_back(
        {here, fmt::format("  raised from {:.6g} to {}", adjusted->asked, adjusted->got)});
    const auto asked = [&](const std::optional<Located<int>>& multiple) {
        if (!multiple) return;
        steps.push_back({multiple->place,
                         fmt::format("  a multiple of {} is asked for here", multiple->value)});
    };
    asked(written.multiple_of);
    const std::vector<int> groups = parallel_groups(chains.parallels);
    for (std::size_t e = 0; e < groups.size(); ++e) {
        if (groups[e] != groups[static_cast<std::size_t>(index)]) continue;
        if (chains.entries[e] != nullptr) asked(chains.entries[e]->multiple_of);
    }
}

/// Where an edge has its count from, as it is written in the file.
void explain_cells(const Chains& chains, int index, std::vector<ExplanationStep>& steps) {
    const Edge& edge = chains.edge(index);
    const AdjustedCount* adjusted = adjustment(chains, index);
    const int cells = adjusted != nullptr ? adjusted->written : edge.cells;
    if (const auto own = count_place(chains.entry(index))) {
        steps.push_back({*own, fmt::format("{}: said here", cells_text(cells))});
        return;
    }
    std::vector<bool> givers(chains.entries.size());
    for (std::size_t e = 0; e < givers.size(); ++e) {
        givers[e] = count_place(chains.entries[e]).has_value();
    }
    const auto chain = shortest_chain(chains.parallels, index, givers);
    if (!chain) {
        steps.push_back({edge.place, cells_text(cells) + ": by sums over sides"});
        add_sums(chains, index, steps);
        return;
    }
    const int giver = chain->back().edge;
    steps.push_back(
        {edge.place, fmt::format("{}: as edge {}", cells_text(cells), chains.name(giver))});
    add_crossings(chains, index, *chain, "cells", steps);
    steps.push_back({*count_place(chains.entry(giver)),
                     fmt::format("  {} says {}", chains.name(giver), cells_text(cells))});
}

std::string sizes_text(const std::optional<double>& start, const std::optional<double>& end) {
    const auto size = [](const char* label, const std::optional<double>& value) {
        return fmt::format("{} cell {}", label, value ? number_text(*value) : "free");
    };
    return size("first", start) + ", " + size("last", end);
}

std::string law_text(const SpacingEntry& law) {
    struct Texts {
        std::string operator()(const UniformLaw&) const { return "uniform"; }
        std::string operator()(const TanhLaw& l) const {
            return "tanh law, " + sizes_text(l.start, l.end);
        }
        std::string operator()(const GeometricLaw& l) const {
            return "geometric law, " + (l.ratio ? fmt::format("ratio {}", number_text(*l.ratio))
                                                : sizes_text(l.start, l.end));
        }
        std::string operator()(const ExplicitLaw& l) const {
            return l.values.empty() ? "a formula" : "a list of positions";
        }
        std::string operator()(const LikeLaw& l) const {
            return fmt::format("like edge {}{}", quoted(l.edge.value),
                               l.edge.reversed ? ", against its direction" : "");
        }
    };
    return std::visit(Texts{}, law);
}

std::optional<int> edge_of_name(const Chains& chains, const std::string& name) {
    for (std::size_t e = 0; e < chains.topology.edges.size(); ++e) {
        if (chains.topology.edges[e].name == canonical_name(name)) return static_cast<int>(e);
    }
    return std::nullopt;
}

/// One edge's own law, or the way to that of the nearest parallel one; the edge that is next to be
/// looked at where that is not the end.
std::optional<int> explain_law(const Chains& chains, int index,
                               std::vector<ExplanationStep>& steps) {
    const EdgeEntry* entry = chains.entry(index);
    if (entry != nullptr && entry->spacing) {
        steps.push_back({entry->spacing->place, fmt::format("  {} says: {}", chains.name(index),
                                                            law_text(entry->spacing->value))});
        const auto* like = std::get_if<LikeLaw>(&entry->spacing->value);
        return like == nullptr ? std::nullopt : edge_of_name(chains, like->edge.value);
    }
    std::vector<bool> with_law(chains.entries.size());
    for (std::size_t e = 0; e < with_law.size(); ++e) {
        with_law[e] = chains.entries[e] != nullptr && chains.entries[e]->spacing.has_value();
    }
    const auto chain = shortest_chain(chains.parallels, index, with_law);
    if (!chain) return std::nullopt;
    add_crossings(chains, index, *chain, "spacing", steps);
    return chain->back().edge;
}

void explain_spacing(const Chains& chains, int index, std::vector<ExplanationStep>& steps) {
    const Edge& edge = chains.edge(index);
    if (edge.pole) return;
    const auto* same = std::get_if<SameAs>(&edge.law);
    if (same == nullptr && (chains.entry(index) == nullptr || !chains.entry(index)->spacing)) {
        steps.push_back({edge.place, "spacing: uniform, as no edge parallel to it has a law"});
        return;
    }
    const std::string whose =
        same == nullptr ? "its own"
                        : fmt::format("the fractions of edge {}{}", chains.name(same->edge),
                                      same->reversed ? ", reversed" : "");
    steps.push_back({edge.place, "spacing: " + whose});
    const int last = same == nullptr ? index : same->edge;
    std::optional<int> next = index;
    for (std::size_t n = 0; next && n < chains.entries.size(); ++n) {
        const int here = *next;
        next = explain_law(chains, here, steps);
        if (here == last) break;
    }
}

void explain_image(const Chains& chains, int index, std::vector<ExplanationStep>& steps) {
    const std::optional<ImageOf>& image = chains.edge(index).image;
    if (!image) return;
    const auto interface = static_cast<std::size_t>(image->interface);
    const PeriodicInterface& periodic = chains.topology.periodic[interface];
    steps.push_back({periodic.place,
                     fmt::format("its points are the image{} of those of edge {}{}, by {}",
                                 image->back ? ", backwards," : "", chains.name(image->of),
                                 image->reversed() ? ", reversed" : "", quoted(periodic.name))});
}

}  // namespace

std::vector<ExplanationStep> explain_edge(const Case& written, const Topology& topology, int edge) {
    const Chains chains = chains_of(written, topology);
    std::vector<ExplanationStep> steps{course(chains, edge)};
    explain_cells(chains, edge, steps);
    explain_raise(written, chains, edge, steps);
    explain_spacing(chains, edge, steps);
    explain_image(chains, edge, steps);
    return steps;
}

}  // namespace hexweave
