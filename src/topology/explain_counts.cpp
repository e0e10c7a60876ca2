// SPDX-License-Identifier: Apache-2.0
#include "topology/explain_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <variant>

#include "topology/names.h"
#include "topology/text.h"

namespace hexweave {

namespace {

/// The place where an edge says how many cells it has.
std::optional<Place> count_place(const EdgeEntry* entry) {
    if (entry == nullptr) return std::nullopt;
    if (entry->cells) return entry->cells->place;
    if (!entry->spacing) return std::nullopt;
    const auto* points = std::get_if<ExplicitLaw>(&entry->spacing->value);
    if (points == nullptr || points->values.empty()) return std::nullopt;
    return entry->spacing->place;
}

/// What was made of the count of an edge, or of one parallel to it, where it is not as written.
const AdjustedCount* adjustment(const Chains& chains, int index) {
    for (const AdjustedCount& adjusted : chains.topology.adjusted_counts) {
        for (std::size_t e = 0; e < chains.groups.size(); ++e) {
            if (chains.groups[e] != chains.group(index)) continue;
            if (chains.topology.edges[e].name == adjusted.edge) return &adjusted;
        }
    }
    return nullptr;
}

/// The cells of an edge as the file has them, before a level or a multiple changes them.
int written_cells(const Chains& chains, int index) {
    const AdjustedCount* adjusted = adjustment(chains, index);
    return adjusted != nullptr ? adjusted->written : chains.edge(index).cells;
}

std::string sum_text(const Chains& chains, const std::vector<EdgeUse>& side) {
    std::string text;
    for (const EdgeUse& use : side) {
        text += fmt::format("{}{} ({})", text.empty() ? "" : " + ", chains.name(use.edge),
                            written_cells(chains, use.edge));
    }
    return text;
}

/// Opposite sides of a face, of which at least one is of several edges: their sums are equal.
struct Sum {
    const Face& face;
    std::size_t axis;

    const std::vector<EdgeUse>& low() const { return face.sides[2 * axis]; }
    const std::vector<EdgeUse>& high() const { return face.sides[2 * axis + 1]; }
    std::vector<int> edges() const {
        std::vector<int> all;
        for (const auto* side : {&low(), &high()}) {
            for (const EdgeUse& use : *side) all.push_back(use.edge);
        }
        return all;
    }
};

std::vector<Sum> sums_of(const Topology& topology) {
    std::vector<Sum> sums;
    for (const Face& face : topology.faces) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const Sum sum{face, axis};
            if (sum.low().size() > 1 || sum.high().size() > 1) sums.push_back(sum);
        }
    }
    return sums;
}

/// Tells of counts, each group of parallel edges once.
class CountTelling {
public:
    CountTelling(const Chains& chains, std::vector<ExplanationStep>& steps)
        : chains_(chains), steps_(steps), sums_(sums_of(chains.topology)) {
        givers_.resize(chains.entries.size());
        for (std::size_t e = 0; e < givers_.size(); ++e) {
            givers_[e] = count_place(chains.entries[e]).has_value();
        }
        find_sums();
    }

    /// The heading of an edge that was asked about, and what follows from it.
    void tell_of(int edge) {
        const std::string cells = cells_text(written_cells(chains_, edge));
        if (const auto own = count_place(chains_.entry(edge))) {
            steps_.push_back({*own, cells + ": said here"});
            return;
        }
        const auto chain = shortest_chain(chains_.parallels, edge, givers_);
        const std::string whence =
            chain ? "as edge " + chains_.name(chain->back().edge) : "by sums over sides";
        steps_.push_back({chains_.edge(edge).place, fmt::format("{}: {}", cells, whence)});
        follow(edge);
    }

    /// The way from an edge to what the file says.
    void follow(int edge) {
        if (!told_.insert(chains_.group(edge)).second) return;
        if (const auto chain = shortest_chain(chains_.parallels, edge, givers_)) {
            const int giver = chain->empty() ? edge : chain->back().edge;
            add_crossings(chains_, edge, *chain, "cells", steps_);
            steps_.push_back({*count_place(chains_.entry(giver)),
                              fmt::format("  {} says {}", chains_.name(giver),
                                          cells_text(written_cells(chains_, giver)))});
            return;
        }
        const auto found = sum_of_group_.find(chains_.group(edge));
        if (found == sum_of_group_.end()) {
            tell_all_sums(edge);
        } else {
            tell_sum(edge, found->second);
        }
    }

private:
    /// Which sum gives each group that nobody states: those with one unknown group, until none is
    /// left.
    void find_sums() {
        std::set<int> known;
        for (std::size_t e = 0; e < givers_.size(); ++e) {
            if (givers_[e]) known.insert(chains_.groups[e]);
        }
        for (bool more = true; more;) {
            more = false;
            for (const Sum& sum : sums_) {
                std::set<int> unknown;
                for (const int edge : sum.edges()) {
                    if (known.count(chains_.group(edge)) == 0) unknown.insert(chains_.group(edge));
                }
                if (unknown.size() != 1) continue;
                sum_of_group_.emplace(*unknown.begin(), sum);
                known.insert(*unknown.begin());
                more = true;
            }
        }
    }

    void tell(const Sum& sum) {
        steps_.push_back(
            {sum.face.place,
             fmt::format("  opposite sides of face {} are equal: {} = {}", quoted(sum.face.name),
                         sum_text(chains_, sum.low()), sum_text(chains_, sum.high()))});
    }

    void tell_sum(int edge, const Sum& sum) {
        std::vector<bool> targets(chains_.groups.size());
        for (const int other : sum.edges()) {
            targets[static_cast<std::size_t>(other)] = chains_.group(other) == chains_.group(edge);
        }
        add_crossings(chains_, edge, *shortest_chain(chains_.parallels, edge, targets), "cells",
                      steps_);
        tell(sum);
        for (const int other : sum.edges()) follow(other);
    }

    /// Where several sums only together give the count.
    void tell_all_sums(int edge) {
        for (const Sum& sum : sums_) {
            const std::vector<int> edges = sum.edges();
            const bool holds = std::any_of(edges.begin(), edges.end(), [&](int other) {
                return chains_.group(other) == chains_.group(edge);
            });
            if (!holds) continue;
            tell(sum);
            for (const int other : edges) follow(other);
        }
    }

    const Chains& chains_;
    std::vector<ExplanationStep>& steps_;
    std::vector<Sum> sums_;
    std::vector<bool> givers_;  ///< edges that state a count
    std::map<int, Sum> sum_of_group_;
    std::set<int> told_;  ///< groups
};

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
    for (std::size_t e = 0; e < chains.groups.size(); ++e) {
        if (chains.groups[e] != chains.group(index)) continue;
        if (chains.entries[e] != nullptr) asked(chains.entries[e]->multiple_of);
    }
}

}  // namespace

std::string cells_text(int cells) {
    return fmt::format("{} {}", cells, cells == 1 ? "cell" : "cells");
}

void explain_cells(const Case& written, const Chains& chains, int edge,
                   std::vector<ExplanationStep>& steps) {
    CountTelling(chains, steps).tell_of(edge);
    explain_raise(written, chains, edge, steps);
}

void explain_cells_along(const Case& written, const Chains& chains, const std::string& axis,
                         const std::vector<EdgeUse>& edges, const Place& place,
                         std::vector<ExplanationStep>& steps) {
    int cells = 0;
    for (const EdgeUse& use : edges) cells += chains.edge(use.edge).cells;
    std::string whose;
    for (const EdgeUse& use : edges) {
        whose += (whose.empty() ? "" : " + ") + chains.name(use.edge);
        if (edges.size() > 1) whose += fmt::format(" ({})", chains.edge(use.edge).cells);
    }
    steps.push_back({place, fmt::format("{} along {}: {}", cells_text(cells), axis, whose)});
    CountTelling telling(chains, steps);
    for (const EdgeUse& use : edges) {
        telling.follow(use.edge);
        explain_raise(written, chains, use.edge, steps);
    }
}

}  // namespace hexweave
