// SPDX-License-Identifier: Apache-2.0
#include "topology/counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "topology/counting.h"
#include "topology/face_frame.h"

namespace hexweave {

std::string cells_text(std::int64_t cells) {
    return fmt::format("{} {}", cells, cells == 1 ? "cell" : "cells");
}

namespace {

/// A count is given by 'cells', or by a list of points in the spacing.
Given given_count(const EdgeEntry* entry, Diagnostics& diagnostics) {
    if (entry == nullptr) return std::nullopt;
    if (!entry->spacing) return entry->cells;
    const auto* points = std::get_if<ExplicitLaw>(&entry->spacing->value);
    if (points == nullptr || points->values.size() < 2) return entry->cells;
    const int cells = static_cast<int>(points->values.size()) - 1;
    if (entry->cells && entry->cells->value != cells) {
        diagnostics
            .error(entry->cells->place,
                   fmt::format("edge {} has {}, but its spacing lists {} points, for {}",
                               quoted(entry->name.value), cells_text(entry->cells->value),
                               cells + 1, cells_text(cells)),
                   "leave 'cells' out: the list says it")
            .notes.push_back({entry->spacing->place, "the list is here"});
    }
    return Located<int>{cells, entry->spacing->place};
}

/// Notes that follow a chain of crossings, from an edge on.
void add_chain(const Counting& counting, int from, const std::vector<Crossing>& chain,
               std::vector<Note>& notes) {
    int edge = from;
    for (const Crossing& crossing : chain) {
        notes.push_back({place_of(counting.network.topology, crossing),
                         fmt::format("{}, {} has as many cells as {}",
                                     text_of(counting.network.topology, crossing),
                                     counting.edge_name(crossing.edge), counting.edge_name(edge))});
        edge = crossing.edge;
    }
}

/// The count that most edges of the group give, of equally frequent ones the first in the file.
int prevailing_count(const Counting& counting, const std::vector<int>& edges) {
    std::map<int, int> votes;
    for (const int edge : edges) ++votes[counting.given[static_cast<std::size_t>(edge)]->value];
    int best = 0;
    for (const int edge : edges) {
        const int value = counting.given[static_cast<std::size_t>(edge)]->value;
        if (best == 0 || votes[value] > votes[best]) best = value;
    }
    return best;
}

void report_conflict(const Counting& counting, int edge, const std::vector<bool>& prevailing) {
    const Located<int>& own = *counting.given[static_cast<std::size_t>(edge)];
    const auto chain = shortest_chain(counting.parallels, edge, prevailing);
    const int other = chain->back().edge;
    const Located<int>& wanted = *counting.given[static_cast<std::size_t>(other)];
    Diagnostic& error = counting.diagnostics.error(
        own.place,
        fmt::format("edge {} has {}, but edge {}, parallel to it, has {}", counting.edge_name(edge),
                    cells_text(own.value), counting.edge_name(other), cells_text(wanted.value)),
        "parallel edges have equally many cells: give 'cells' to one of them");
    add_chain(counting, edge, *chain, error.notes);
    error.notes.push_back({wanted.place, fmt::format("{} has {}", counting.edge_name(other),
                                                     cells_text(wanted.value))});
}

/// Gives each group the count that its edges give, and reports those that differ.
void count_groups(Counting& counting) {
    std::vector<std::vector<int>> givers(counting.groups.size());
    for (std::size_t edge = 0; edge < counting.given.size(); ++edge) {
        if (!counting.given[edge]) continue;
        givers[static_cast<std::size_t>(counting.group_of[edge])].push_back(static_cast<int>(edge));
    }
    for (std::size_t group = 0; group < givers.size(); ++group) {
        std::vector<int>& edges = givers[group];
        if (edges.empty()) continue;
        std::sort(edges.begin(), edges.end(), [&](int a, int b) {
            const Place& pa = counting.given[static_cast<std::size_t>(a)]->place;
            const Place& pb = counting.given[static_cast<std::size_t>(b)]->place;
            return std::pair(pa.line, pa.column) < std::pair(pb.line, pb.column);
        });
        const int count = prevailing_count(counting, edges);
        counting.groups[group].cells = count;
        std::vector<bool> prevailing(counting.given.size());
        for (const int edge : edges) {
            const auto e = static_cast<std::size_t>(edge);
            prevailing[e] = counting.given[e]->value == count;
        }
        for (const int edge : edges) {
            if (!prevailing[static_cast<std::size_t>(edge)]) {
                report_conflict(counting, edge, prevailing);
                counting.groups[group].faulty = true;
            }
        }
    }
}

std::vector<SumEquation> sum_equations(const Counting& counting) {
    std::vector<SumEquation> equations;
    const std::vector<Face>& faces = counting.network.topology.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto& low = faces[f].sides[2 * axis];
            const auto& high = faces[f].sides[2 * axis + 1];
            if (low.size() == 1 && high.size() == 1) continue;
            SumEquation equation{static_cast<int>(f), axis, {}};
            const auto group = [&](const EdgeUse& use) {
                return counting.group_of[static_cast<std::size_t>(use.edge)];
            };
            for (const EdgeUse& use : low) ++equation.coefficients[group(use)];
            for (const EdgeUse& use : high) --equation.coefficients[group(use)];
            std::erase_if(equation.coefficients, [](const auto& c) { return c.second == 0; });
            equations.push_back(std::move(equation));
        }
    }
    return equations;
}

/// How an edge came to its count.
void add_origin(Counting& counting, int edge, std::vector<Note>& notes) {
    std::vector<bool> givers(counting.given.size());
    const int group = counting.group_of[static_cast<std::size_t>(edge)];
    for (std::size_t e = 0; e < givers.size(); ++e) {
        givers[e] = counting.group_of[e] == group && counting.given[e].has_value();
    }
    const std::string text =
        fmt::format("{} has {}", counting.edge_name(edge), cells_text(counting.cells(edge)));
    if (const auto chain = shortest_chain(counting.parallels, edge, givers)) {
        const int source = chain->empty() ? edge : chain->back().edge;
        const std::string as =
            source == edge ? "" : fmt::format(", as edge {}", counting.edge_name(source));
        notes.push_back({counting.given[static_cast<std::size_t>(source)]->place, text + as});
    } else {
        const int face = counting.group(edge).from_face;
        notes.push_back({counting.network.face(face).place,
                         text + fmt::format(", by the sums over the sides of face {}",
                                            counting.face_name(face))});
    }
}

std::int64_t side_cells(Counting& counting, const std::vector<EdgeUse>& side) {
    std::int64_t sum = 0;
    for (const EdgeUse& use : side) sum += counting.cells(use.edge);
    return sum;
}

void add_origins(Counting& counting, const SumEquation& equation, std::vector<Note>& notes) {
    const Face& face = counting.network.face(equation.face);
    std::vector<int> told;
    for (const std::size_t s : {2 * equation.axis, 2 * equation.axis + 1}) {
        for (const EdgeUse& use : face.sides[s]) {
            if (std::find(told.begin(), told.end(), use.edge) != told.end()) continue;
            told.push_back(use.edge);
            if (counting.cells(use.edge) > 0) add_origin(counting, use.edge, notes);
        }
    }
}

void report_unequal(Counting& counting, const SumEquation& equation) {
    const Face& face = counting.network.face(equation.face);
    const std::size_t low = 2 * equation.axis;
    Diagnostic& error = counting.diagnostics.error(
        face.place,
        fmt::format("{} of face {} has {}, but {} has {}", side_name(all_sides[low]),
                    quoted(face.name), cells_text(side_cells(counting, face.sides[low])),
                    side_name(all_sides[low + 1]),
                    cells_text(side_cells(counting, face.sides[low + 1]))),
        "opposite sides have equally many cells in all");
    add_origins(counting, equation, error.notes);
}

void report_unsolvable(Counting& counting, const SumEquation& equation, int group) {
    const Face& face = counting.network.face(equation.face);
    std::string unknown;
    for (const std::size_t s : {2 * equation.axis, 2 * equation.axis + 1}) {
        for (const EdgeUse& use : face.sides[s]) {
            if (counting.group_of[static_cast<std::size_t>(use.edge)] == group) {
                unknown = counting.edge_name(use.edge);
            }
        }
    }
    Diagnostic& error = counting.diagnostics.error(
        face.place,
        fmt::format("no number of cells of edge {} makes {} and {} of face {} equal", unknown,
                    side_name(all_sides[2 * equation.axis]),
                    side_name(all_sides[2 * equation.axis + 1]), quoted(face.name)),
        "opposite sides have equally many cells in all");
    add_origins(counting, equation, error.notes);
}

/// Solves the equation when one group's count is all that it lacks; true when that gave a count.
bool solve_for_unknown(Counting& counting, const SumEquation& equation) {
    std::int64_t known = 0;
    int unknown = -1;
    for (const auto& [group, coefficient] : equation.coefficients) {
        const GroupCount& count = counting.groups[static_cast<std::size_t>(group)];
        if (count.cells > 0) {
            known += coefficient * count.cells;
        } else if (unknown >= 0 || count.faulty) {
            return false;
        } else {
            unknown = group;
        }
    }
    if (unknown < 0) return false;
    const std::int64_t coefficient = equation.coefficients.at(unknown);
    GroupCount& count = counting.groups[static_cast<std::size_t>(unknown)];
    if (known % coefficient != 0 || -known / coefficient < 1) {
        report_unsolvable(counting, equation, unknown);
        count.faulty = true;
        return false;
    }
    count.cells = -known / coefficient;
    count.from_face = equation.face;
    return true;
}

void check_equation(Counting& counting, const SumEquation& equation) {
    std::int64_t sum = 0;
    for (const auto& [group, coefficient] : equation.coefficients) {
        const GroupCount& count = counting.groups[static_cast<std::size_t>(group)];
        if (count.cells == 0 || count.faulty) return;
        sum += coefficient * count.cells;
    }
    if (sum != 0) report_unequal(counting, equation);
}

void solve_sums(Counting& counting, const std::vector<SumEquation>& equations) {
    bool found = true;
    while (found) {
        found = false;
        for (const SumEquation& equation : equations) {
            if (solve_for_unknown(counting, equation)) found = true;
        }
    }
    for (const SumEquation& equation : equations) check_equation(counting, equation);
}

/// Reports the groups without a count; those that one equation of sums holds together, as one.
void report_unknown(Counting& counting, const std::vector<SumEquation>& equations) {
    const auto unknown = [&](int group) {
        const GroupCount& count = counting.groups[static_cast<std::size_t>(group)];
        return count.cells == 0 && !count.faulty;
    };
    std::vector<int> cluster(counting.groups.size());
    for (std::size_t g = 0; g < cluster.size(); ++g) cluster[g] = static_cast<int>(g);
    for (const SumEquation& equation : equations) {
        int first = -1;
        for (const auto& [group, coefficient] : equation.coefficients) {
            if (!unknown(group)) continue;
            const int own = cluster[static_cast<std::size_t>(group)];
            if (first < 0) first = own;
            std::replace(cluster.begin(), cluster.end(), own, first);
        }
    }
    std::map<int, std::vector<int>> edges_of;
    std::map<int, std::vector<int>> groups_of;
    for (std::size_t e = 0; e < counting.group_of.size(); ++e) {
        const int group = counting.group_of[e];
        if (!unknown(group)) continue;
        const int c = cluster[static_cast<std::size_t>(group)];
        edges_of[c].push_back(static_cast<int>(e));
        std::vector<int>& groups = groups_of[c];
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
    }
    for (const auto& [c, edges] : edges_of) {
        std::vector<std::string> names;
        for (const int edge : edges) names.push_back(counting.network.edge(edge).name);
        const bool one = names.size() == 1;
        const std::string hint =
            one ? "give it 'cells', as in 'cells: 40'"
            : groups_of[c].size() == 1
                ? "they are parallel: give one of them 'cells', as in 'cells: 40'"
                : "sides of several edges join them: give 'cells' to more of "
                  "them, until the others follow";
        counting.diagnostics.error(
            counting.network.edge(edges.front()).place,
            fmt::format("nothing says how many cells {} {} {}", one ? "edge" : "edges",
                        listed(names), one ? "has" : "have"),
            hint);
    }
}

/// Writes the counts into the topology. Edges, and sums over sides, that no 'int' holds are faults.
void store(Counting& counting, Topology& topology) {
    constexpr std::int64_t most = std::numeric_limits<int>::max() - 1;
    const auto stored = [&](std::int64_t cells, const Place& place, const std::string& what) {
        if (cells <= most) return static_cast<int>(cells);
        counting.diagnostics.error(
            place,
            fmt::format("{} has {}: more than a CGNS zone can hold", what, cells_text(cells)),
            "give its edges fewer cells");
        return 0;
    };
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const GroupCount& count = counting.group(static_cast<int>(e));
        Edge& edge = topology.edges[e];
        edge.cells =
            count.faulty ? 0 : stored(count.cells, edge.place, "edge " + quoted(edge.name));
    }
    const auto along = [&](const std::vector<EdgeUse>& side, const Face& face) {
        std::int64_t sum = 0;
        for (const EdgeUse& use : side) {
            const int cells = topology.edges[static_cast<std::size_t>(use.edge)].cells;
            if (cells == 0) return 0;
            sum += cells;
        }
        return stored(sum, face.place, "face " + quoted(face.name));
    };
    for (Face& face : topology.faces) {
        face.cells_i = along(face.side(Side::jmin), face);
        face.cells_j = along(face.side(Side::imin), face);
    }
    for (Block& block : topology.blocks) {
        std::array<Extent, 6> extents;
        for (std::size_t s = 0; s < 6; ++s) {
            extents[s] = place_faces(topology.faces, block.sides[s]);
        }
        const Extent& base = extents[static_cast<std::size_t>(Side::kmin)];
        block.extent = {base.ni, base.nj, extents[static_cast<std::size_t>(Side::imin)].nj};
    }
}

}  // namespace

void resolve_counts(Network& network, const ParallelEdges& parallels, const CountRules& rules,
                    Diagnostics& diagnostics) {
    Counting counting{network, parallels, diagnostics, {}, parallel_groups(parallels), {}};
    for (const EdgeEntry* entry : network.edge_entries) {
        counting.given.push_back(given_count(entry, diagnostics));
    }
    int groups = 0;
    for (const int group : counting.group_of) groups = std::max(groups, group + 1);
    counting.groups.resize(static_cast<std::size_t>(groups));
    count_groups(counting);
    const std::vector<SumEquation> equations = sum_equations(counting);
    solve_sums(counting, equations);
    if (network.intact) report_unknown(counting, equations);
    if (!diagnostics.has_errors()) {
        network.topology.adjusted_counts = adjust_counts(counting, equations, rules);
    }
    store(counting, network.topology);
}

}  // namespace hexweave
