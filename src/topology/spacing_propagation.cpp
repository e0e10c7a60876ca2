// SPDX-License-Identifier: Apache-2.0
#include "topology/spacing_propagation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "topology/law_equality.h"
#include "topology/spacing_fit.h"

namespace hexweave {

namespace {

enum class State { open, visiting, done };

/// An edge seen along or against another one's direction.
struct Oriented {
    int edge = 0;
    bool reversed = false;

    friend bool operator<(const Oriented& a, const Oriented& b) {
        return std::pair(a.edge, a.reversed) < std::pair(b.edge, b.reversed);
    }
};

struct Laws {
    Network& network;
    const ParallelEdges& parallels;
    Diagnostics& diagnostics;
    std::vector<std::optional<Oriented>> like;  ///< the edge that the user says it is like
    std::vector<State> state;
    std::vector<Oriented> root;  ///< the edge whose own law, being none of another's, it takes
    std::vector<bool> faulty;

    const EdgeEntry* entry(int edge) const {
        return network.edge_entries[static_cast<std::size_t>(edge)];
    }
    std::string name(int edge) const { return quoted(network.edge(edge).name); }
    /// Whether the user gave the edge a law.
    bool has_law(int edge) const { return entry(edge) != nullptr && entry(edge)->spacing; }
};

/// Whether 'like' runs against the edge: told by its sign, or by the ends that share a vertex.
bool like_is_reversed(const Edge& edge, const Edge& target, const SignedName& name, bool spelled) {
    if (name.sign_given) return name.reversed != spelled;
    const bool along = edge.start == target.start || edge.end == target.end;
    const bool against = edge.start == target.end || edge.end == target.start;
    if (along || against) return against && !along;
    return spelled;
}

void find_like(Laws& laws, int edge) {
    if (!laws.has_law(edge)) return;
    const auto* like = std::get_if<LikeLaw>(&laws.entry(edge)->spacing->value);
    if (like == nullptr) return;
    const auto e = static_cast<std::size_t>(edge);
    laws.faulty[e] = true;  // until the edge it names is found to fit
    const SignedName& name = like->edge;
    const std::optional<NamedEdge> target = find_edge(laws.network.edge_names, name.value);
    if (!target) {
        if (!name.value.empty()) {
            laws.network.edge_names.tell_unknown({name.value, name.place}, laws.diagnostics);
        }
        return;
    }
    if (target->edge < 0) return;
    const Edge& own = laws.network.edge(edge);
    const Edge& other = laws.network.edge(target->edge);
    if (own.cells != other.cells && own.cells > 0 && other.cells > 0) {
        laws.diagnostics.error(
            name.place,
            fmt::format("edge {} has {} cells and cannot be like edge {}, which has {}",
                        quoted(own.name), own.cells, quoted(other.name), other.cells),
            "'like' takes the points of an edge of as many cells");
        return;
    }
    laws.like[e] = Oriented{target->edge, like_is_reversed(own, other, name, target->reversed)};
    laws.faulty[e] = false;
}

void report_circle(Laws& laws, int edge) {
    std::string path = laws.name(edge);
    int next = edge;
    std::set<int> seen;
    while (seen.insert(next).second && laws.like[static_cast<std::size_t>(next)]) {
        next = laws.like[static_cast<std::size_t>(next)]->edge;
        path += " -> " + laws.name(next);
    }
    laws.diagnostics.error(
        laws.has_law(edge) ? laws.entry(edge)->spacing->place : laws.network.edge(edge).place,
        fmt::format("spacings go round in a circle: {}", path),
        "give one of these edges a law of its own");
}

/// Follows 'like' to its end.
int end_of_likes(const Laws& laws, int edge) {
    std::set<int> seen;
    while (seen.insert(edge).second) {
        const auto& like = laws.like[static_cast<std::size_t>(edge)];
        if (!like) return edge;
        edge = like->edge;
    }
    return edge;
}

/// The nearest parallel edges with a law of their own, all equally many faces away. An edge that is
/// like 'edge' itself has none for it.
std::vector<Oriented> nearest_laws(const Laws& laws, int edge) {
    std::set<Oriented> seen{{edge, false}};
    std::vector<Oriented> front{{edge, false}};
    while (!front.empty()) {
        std::set<Oriented> next;
        std::vector<Oriented> found;
        for (const Oriented& here : front) {
            for (const Crossing& c : laws.parallels[static_cast<std::size_t>(here.edge)]) {
                const Oriented there{c.edge, here.reversed != c.reversed};
                if (!seen.insert(there).second) continue;
                next.insert(there);
                if (laws.has_law(c.edge) && end_of_likes(laws, c.edge) != edge) {
                    found.push_back(there);
                }
            }
        }
        if (!found.empty()) return found;
        front.assign(next.begin(), next.end());
    }
    return {};
}

Oriented root_of(Laws& laws, int edge);

/// The edge that a periodic edge without a law has it from: what it is the image of, or else its
/// image where that has one.
std::optional<Oriented> periodic_source(const Laws& laws, int edge) {
    const std::optional<ImageOf>& image = laws.network.edge(edge).image;
    if (image) return Oriented{image->of, image->reversed()};
    for (const Crossing& c : laws.parallels[static_cast<std::size_t>(edge)]) {
        if (c.interface >= 0 && laws.has_law(c.edge) && end_of_likes(laws, c.edge) != edge) {
            return Oriented{c.edge, c.reversed};
        }
    }
    return std::nullopt;
}

Oriented root_through(Laws& laws, const Oriented& source) {
    const Oriented root = root_of(laws, source.edge);
    return {root.edge, root.reversed != source.reversed};
}

bool same_root_distribution(const Laws& laws, const Oriented& a, const Oriented& b) {
    if (a.edge == b.edge) return a.reversed == b.reversed;
    const Edge& edge_a = laws.network.edge(a.edge);
    const Edge& edge_b = laws.network.edge(b.edge);
    return same_distribution(turned(edge_a.law, a.reversed), edge_a.length,
                             turned(edge_b.law, b.reversed), edge_b.length);
}

/// The law of an edge that has none: that of the nearest parallel edges, which must agree.
Oriented inherited(Laws& laws, int edge) {
    std::vector<Oriented> sources = nearest_laws(laws, edge);
    if (sources.empty()) return {edge, false};
    std::sort(sources.begin(), sources.end(), [&](const Oriented& a, const Oriented& b) {
        return std::pair(laws.network.edge(a.edge).name, a.reversed) <
               std::pair(laws.network.edge(b.edge).name, b.reversed);
    });
    const Oriented root = root_through(laws, sources.front());
    for (const Oriented& other : sources) {
        const Oriented other_root = root_through(laws, other);
        const bool known = !laws.faulty[static_cast<std::size_t>(sources.front().edge)] &&
                           !laws.faulty[static_cast<std::size_t>(other.edge)];
        if (!known || same_root_distribution(laws, root, other_root)) continue;
        const int first = sources.front().edge;
        Diagnostic& error = laws.diagnostics.error(
            laws.network.edge(edge).place,
            fmt::format("the spacing of edge {} is undecided: {} and {} are equally near and "
                        "differ",
                        laws.name(edge), laws.name(first), laws.name(other.edge)),
            fmt::format("say which: 'spacing: {{like: {}}}', or give it a law of its own",
                        laws.network.edge(first).name));
        for (const int source : {first, other.edge}) {
            error.notes.push_back({laws.entry(source)->spacing->place,
                                   fmt::format("the spacing of {}", laws.name(source))});
        }
        laws.faulty[static_cast<std::size_t>(edge)] = true;
        break;
    }
    return root;
}

Oriented root_of(Laws& laws, int edge) {
    const auto e = static_cast<std::size_t>(edge);
    if (laws.state[e] == State::done) return laws.root[e];
    if (laws.state[e] == State::visiting) {
        report_circle(laws, edge);
        laws.faulty[e] = true;
        laws.root[e] = {edge, false};
        laws.state[e] = State::done;
        return laws.root[e];
    }
    laws.state[e] = State::visiting;
    Oriented root{edge, false};
    if (laws.like[e]) {
        root = root_through(laws, *laws.like[e]);
        if (laws.faulty[static_cast<std::size_t>(laws.like[e]->edge)]) laws.faulty[e] = true;
    } else if (!laws.has_law(edge) && !laws.network.edge(edge).pole) {
        const std::optional<Oriented> source = periodic_source(laws, edge);
        root = source ? root_through(laws, *source) : inherited(laws, edge);
    }
    if (laws.state[e] == State::visiting) {
        laws.root[e] = root;
        laws.state[e] = State::done;
    }
    return laws.root[e];
}

void report_image(Laws& laws, int edge, int origin) {
    const auto interface = static_cast<std::size_t>(laws.network.edge(edge).image->interface);
    Diagnostic& error = laws.diagnostics.error(
        laws.has_law(edge) ? laws.entry(edge)->spacing->place : laws.network.edge(edge).place,
        fmt::format("edge {} has another spacing than edge {}, whose image it is", laws.name(edge),
                    laws.name(origin)),
        "give a law to one of them only: the other one takes it over");
    if (laws.has_law(origin)) {
        error.notes.push_back({laws.entry(origin)->spacing->place,
                               fmt::format("the spacing of {}", laws.name(origin))});
    }
    error.notes.push_back(
        {laws.network.topology.periodic[interface].place, "the periodic interface"});
}

/// Reports images whose law is another than that of what they are the image of; gives the others
/// its very points.
void take_over_images(Laws& laws) {
    for (std::size_t e = 0; e < laws.root.size(); ++e) {
        Oriented origin{static_cast<int>(e), false};
        while (const std::optional<ImageOf>& image = laws.network.edge(origin.edge).image) {
            origin = {image->of, image->reversed() != origin.reversed};
        }
        if (origin.edge == static_cast<int>(e) || laws.network.edge(origin.edge).pole) continue;
        const Oriented root = root_through(laws, origin);
        const bool known = !laws.faulty[e] && !laws.faulty[static_cast<std::size_t>(origin.edge)];
        if (known && !same_root_distribution(laws, laws.root[e], root)) {
            report_image(laws, static_cast<int>(e), origin.edge);
        }
        laws.root[e] = root;
    }
}

/// The law that an edge's own entry gives, but for 'like'.
void set_own_law(Edge& edge, const EdgeEntry* entry) {
    edge.law = UniformLaw{};
    if (entry == nullptr || !entry->spacing) return;
    const SpacingEntry& spacing = entry->spacing->value;
    if (const auto* tanh = std::get_if<TanhLaw>(&spacing)) {
        edge.law = *tanh;
        edge.asked_start = tanh->start;
        edge.asked_end = tanh->end;
    } else if (const auto* geometric = std::get_if<GeometricLaw>(&spacing)) {
        edge.law = *geometric;
        edge.asked_start = geometric->start;
        edge.asked_end = geometric->end;
    } else if (const auto* points = std::get_if<ExplicitLaw>(&spacing)) {
        edge.law = *points;
    }
}

void check_fit(const Edge& edge, const EdgeEntry* entry, Diagnostics& diagnostics) {
    if (entry == nullptr || !entry->spacing || edge.cells == 0) return;
    if (std::holds_alternative<SameAs>(edge.law)) return;
    const std::string misfit = spacing_misfit(edge.law, edge.cells / edge.refinement, edge.length);
    if (misfit.empty()) return;
    diagnostics.error(
        entry->spacing->place,
        fmt::format("the spacing of edge {} does not fit: {}", quoted(edge.name), misfit),
        spacing_hint(edge.law, edge.cells / edge.refinement, edge.length));
}

}  // namespace

void resolve_spacing(Network& network, const ParallelEdges& parallels, Diagnostics& diagnostics) {
    const std::size_t edges = network.topology.edges.size();
    Laws laws{network,
              parallels,
              diagnostics,
              std::vector<std::optional<Oriented>>(edges),
              std::vector<State>(edges, State::open),
              std::vector<Oriented>(edges),
              std::vector<bool>(edges)};
    for (std::size_t e = 0; e < edges; ++e) {
        set_own_law(network.topology.edges[e], network.edge_entries[e]);
        check_fit(network.topology.edges[e], network.edge_entries[e], diagnostics);
        find_like(laws, static_cast<int>(e));
    }
    for (std::size_t e = 0; e < edges; ++e) root_of(laws, static_cast<int>(e));
    take_over_images(laws);
    for (std::size_t e = 0; e < edges; ++e) {
        const Oriented& root = laws.root[e];
        if (root.edge != static_cast<int>(e)) {
            network.topology.edges[e].law = SameAs{root.edge, root.reversed};
        }
    }
}

}  // namespace hexweave
