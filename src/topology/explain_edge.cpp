// SPDX-License-Identifier: Apache-2.0
#include "topology/explain_edge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "topology/explain_counts.h"
#include "topology/names.h"
#include "topology/parallel_edges.h"
#include "topology/text.h"

namespace hexweave {

namespace {

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
    explain_cells(written, chains, edge, steps);
    explain_spacing(chains, edge, steps);
    explain_image(chains, edge, steps);
    return steps;
}

}  // namespace hexweave
