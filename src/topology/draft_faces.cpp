// SPDX-License-Identifier: Apache-2.0
// Faces given by their sides: the direction of every edge, or why there is none.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "topology/directions.h"
#include "topology/draft.h"
#include "topology/outline.h"

namespace hexweave {

namespace {

using NamedSides = std::array<std::vector<SignedName>, 4>;

constexpr std::array<Side, 4> face_sides{Side::imin, Side::imax, Side::jmin, Side::jmax};

std::string name_of(Side side) {
    return std::string(side_name(side));
}

/// The edges of the four sides; none where one is unknown or has unknown ends.
std::optional<std::array<std::vector<EdgeOfSide>, 4>> find_edges(Draft& draft,
                                                                 const NamedSides& named) {
    std::array<std::vector<EdgeOfSide>, 4> sides;
    bool found = true;
    for (std::size_t s = 0; s < 4; ++s) {
        if (named[s].empty()) found = false;
        for (const SignedName& name : named[s]) {
            const std::optional<NamedEdge> edge = find_edge(draft.edge_names, name.value);
            if (!edge) {
                if (!name.value.empty()) {
                    draft.edge_names.report_unknown({name.value, name.place}, draft.diagnostics);
                }
                found = false;
                continue;
            }
            DraftEdge& drawn = draft.edge(edge->edge);
            drawn.used = true;
            if (drawn.edge.start < 0 || drawn.edge.end < 0) {
                found = false;
                continue;
            }
            EdgeOfSide use{edge->edge, drawn.edge.start, drawn.edge.end, std::nullopt,
                           drawn.edge.pole};
            if (name.sign_given) use.reversed = name.reversed != edge->reversed;
            if (use.pole) use.reversed = false;
            sides[s].push_back(use);
        }
    }
    if (!found) return std::nullopt;
    return sides;
}

/// How an edge is drawn that is used in one direction.
Note runs(Draft& draft, int edge, bool reversed) {
    const Edge& e = draft.edge(edge).edge;
    return {e.place,
            fmt::format("{} runs from {} to {}{}", quoted(e.name),
                        quoted(draft.vertex_name(e.start)), quoted(draft.vertex_name(e.end)),
                        reversed ? "; here it is run through backwards" : "")};
}

/// Reports the first edge of a side that does not begin where the one before ends.
void report_broken_chain(Draft& draft, const DraftFace& face, Side side,
                         const std::vector<EdgeOfSide>& edges,
                         const std::vector<SignedName>& named) {
    std::vector<EdgeOfSide> prefix{edges.front()};
    SideChain chain = side_chains(prefix).front();
    while (prefix.size() < edges.size()) {
        prefix.push_back(edges[prefix.size()]);
        const std::vector<SideChain> chains = side_chains(prefix);
        if (chains.empty()) break;
        chain = chains.front();
    }
    const std::size_t next = prefix.size() - 1;
    const EdgeOfSide& before = edges[next - 1];
    const EdgeOfSide& after = edges[next];
    Diagnostic& error = draft.diagnostics.error(
        named[next].place,
        fmt::format("{} of face {} is broken: {} ends at {}, but {} starts at {}", name_of(side),
                    quoted(face.face.name), quoted(draft.edge_name(before.edge)),
                    quoted(draft.vertex_name(chain.end)), quoted(draft.edge_name(after.edge)),
                    quoted(draft.vertex_name(after.first(after.reversed.value_or(false))))),
        fmt::format("list the edges of a side in the order of increasing {}",
                    axis_of(side) == 0 ? "j" : "i"));
    error.notes.push_back(runs(draft, before.edge, chain.uses.back().reversed));
    error.notes.push_back(runs(draft, after.edge, after.reversed.value_or(false)));
}

/// The vertices at which the two sides of a corner end.
std::array<int, 2> corner_vertices(const FaceLoop& loop, const FaceCorner& corner) {
    const SideChain& along_j = loop[static_cast<std::size_t>(corner.along_j)];
    const SideChain& along_i = loop[static_cast<std::size_t>(corner.along_i)];
    return {corner.at_end_of_j_side ? along_j.end : along_j.start,
            corner.at_end_of_i_side ? along_i.end : along_i.start};
}

/// The first open corner that is open for two vertices in one place; null where there is none.
const FaceCorner* doubled_corner(Draft& draft, const FaceLoop& loop) {
    constexpr double same_place = 1e-9;
    double length = 0;
    for (const SideChain& side : loop) {
        for (const EdgeUse& use : side.uses) {
            length = std::max(length, draft.edge(use.edge).edge.length);
        }
    }
    for (const std::size_t n : open_corners(loop)) {
        const auto [a, b] = corner_vertices(loop, face_corners()[n]);
        if (!draft.vertex(a).sound || !draft.vertex(b).sound) continue;
        const double apart =
            distance(draft.vertex(a).vertex.position, draft.vertex(b).vertex.position);
        if (apart <= same_place * length) return &face_corners()[n];
    }
    return nullptr;
}

/// Reports two vertices in one place where a face needs one.
void report_doubled_vertex(Draft& draft, const DraftFace& face, const FaceLoop& loop,
                           const FaceCorner& corner, const Place& place) {
    const auto [a, b] = corner_vertices(loop, corner);
    const std::string& first = draft.vertex_name(a);
    const std::string& second = draft.vertex_name(b);
    Diagnostic& error = draft.diagnostics.error(
        place,
        fmt::format("face {} is open: {} and {} lie in the same place, but are two vertices",
                    quoted(face.face.name), quoted(first), quoted(second)),
        fmt::format("write {} for {} everywhere, and leave {} out", quoted(first), quoted(second),
                    quoted(second)));
    error.notes.push_back({draft.vertex(a).vertex.place, "one"});
    error.notes.push_back({draft.vertex(b).vertex.place, "the other"});
}

/// Reports the first corner in which the sides do not meet; the others are notes.
void report_open_loop(Draft& draft, const DraftFace& face, const FaceLoop& loop,
                      const NamedSides& named) {
    const auto describe = [&](std::size_t n) {
        const FaceCorner& corner = face_corners()[n];
        const auto end_text = [&](Side side, bool at_end) {
            const SideChain& chain = loop[static_cast<std::size_t>(side)];
            const EdgeUse& use = at_end ? chain.uses.back() : chain.uses.front();
            return fmt::format("{} ({}) {} at {}", quoted(draft.edge_name(use.edge)), name_of(side),
                               at_end ? "ends" : "starts",
                               quoted(draft.vertex_name(at_end ? chain.end : chain.start)));
        };
        return fmt::format("{}, but {}", end_text(corner.along_j, corner.at_end_of_j_side),
                           end_text(corner.along_i, corner.at_end_of_i_side));
    };
    const std::vector<std::size_t> open = open_corners(loop);
    const FaceCorner& first = face_corners()[open.front()];
    const auto i_side = static_cast<std::size_t>(first.along_i);
    const SignedName& at = first.at_end_of_i_side ? named[i_side].back() : named[i_side].front();
    if (const FaceCorner* doubled = doubled_corner(draft, loop)) {
        report_doubled_vertex(draft, face, loop, *doubled, at.place);
        return;
    }
    Diagnostic& error = draft.diagnostics.error(
        at.place,
        fmt::format("face {} is open: {}", quoted(face.face.name), describe(open.front())),
        "imin and imax lead from jmin to jmax; jmin and jmax lead from imin to imax");
    for (std::size_t n = 1; n < open.size(); ++n) {
        error.notes.push_back({at.place, fmt::format("also: {}", describe(open[n]))});
    }
    for (const Side side : {first.along_j, first.along_i}) {
        const SideChain& chain = loop[static_cast<std::size_t>(side)];
        const bool at_end = side == first.along_j ? first.at_end_of_j_side : first.at_end_of_i_side;
        const EdgeUse& use = at_end ? chain.uses.back() : chain.uses.front();
        error.notes.push_back(runs(draft, use.edge, use.reversed));
    }
}

/// Reports the edges whose direction nothing decides, with the directions that would close.
void report_ambiguous(Draft& draft, const DraftFace& face, const std::vector<FaceLoop>& loops,
                      const NamedSides& named) {
    constexpr std::size_t most_shown = 4;
    std::vector<std::string> open_names;
    std::vector<std::string> ways(std::min(loops.size(), most_shown));
    const SignedName* first = nullptr;
    for (std::size_t s = 0; s < 4; ++s) {
        for (std::size_t n = 0; n < named[s].size(); ++n) {
            const EdgeUse& use = loops.front()[s].uses[n];
            const bool decided = std::all_of(
                loops.begin(), loops.end(), [&](const FaceLoop& l) { return l[s].uses[n] == use; });
            if (decided) continue;
            if (first == nullptr) first = &named[s][n];
            const std::string& name = draft.edge_name(use.edge);
            if (std::find(open_names.begin(), open_names.end(), name) == open_names.end()) {
                open_names.push_back(name);
            }
            for (std::size_t w = 0; w < ways.size(); ++w) {
                ways[w] +=
                    fmt::format("{}{}: {}{}", ways[w].empty() ? "" : ", ", name_of(face_sides[s]),
                                loops[w][s].uses[n].reversed ? "-" : "+", name);
            }
        }
    }
    std::string all;
    for (const std::string& way : ways) {
        all += fmt::format("{}'{}'", all.empty() ? "" : " or ", way);
    }
    if (loops.size() > ways.size()) all += " or ...";
    draft.diagnostics.error(
        first->place,
        fmt::format("the {} of {} in face {} {} ambiguous",
                    open_names.size() == 1 ? "direction" : "directions", listed(open_names),
                    quoted(face.face.name), open_names.size() == 1 ? "is" : "are"),
        fmt::format("say it with a sign; these close: {}", all));
}

/// An edge may be on two opposite sides (a cut), or twice on one; no corner lies between a side and
/// itself.
bool cuts_are_sound(Draft& draft, const DraftFace& face, const NamedSides& named) {
    std::map<int, std::vector<std::pair<std::size_t, const SignedName*>>> uses;
    for (std::size_t s = 0; s < 4; ++s) {
        for (std::size_t n = 0; n < named[s].size(); ++n) {
            const EdgeUse& use = face.face.sides[s][n];
            if (!use.pole) uses[use.edge].emplace_back(s, &named[s][n]);
        }
    }
    bool sound = true;
    for (const auto& [edge, places] : uses) {
        if (places.size() > 2) {
            draft.diagnostics.error(
                places[2].second->place,
                fmt::format("face {} uses edge {} more than twice", quoted(face.face.name),
                            quoted(draft.edge_name(edge))),
                "an edge is once on a side, or twice as a cut");
            sound = false;
        } else if (places.size() == 2 && places[0].first / 2 != places[1].first / 2) {
            draft.diagnostics.error(
                places[1].second->place,
                fmt::format("edge {} is on the adjacent sides {} and {} of face {}",
                            quoted(draft.edge_name(edge)), name_of(face_sides[places[0].first]),
                            name_of(face_sides[places[1].first]), quoted(face.face.name)),
                "a cut is on opposite sides, or twice on one side");
            sound = false;
        }
    }
    return sound;
}

bool is_pole(const std::vector<EdgeUse>& side) {
    return std::all_of(side.begin(), side.end(), [](const EdgeUse& use) { return use.pole; });
}

/// A face without a surface is collapsed along an axis when its two sides along that axis are poles
/// and the other two are one and the same line; a face of four poles along both.
std::array<bool, 2> collapsed_axes(const Face& face) {
    if (face.is_on_surface()) return {};
    std::array<bool, 2> collapsed{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto& low = face.sides[2 * axis];
        const auto& high = face.sides[2 * axis + 1];
        const auto& low_along = face.sides[2 - 2 * axis];
        const auto& high_along = face.sides[3 - 2 * axis];
        const bool line = low == high || (is_pole(low) && is_pole(high));
        collapsed[axis] = line && is_pole(low_along) && is_pole(high_along);
    }
    return collapsed;
}

/// Nothing can be asked of grid lines at a side that is a pole.
bool poles_are_sound(Draft& draft, const DraftFace& face, const NamedSides& named) {
    bool sound = true;
    for (std::size_t s = 0; s < 4; ++s) {
        if (!is_pole(face.face.sides[s])) continue;
        const bool held = face.face.solve.heights[s].has_value();
        if (!held && !face.face.orthogonal[s]) continue;
        draft.diagnostics.error(named[s].front().place,
                                fmt::format("{} of face {} is a pole: {}", name_of(face_sides[s]),
                                            quoted(face.face.name),
                                            held ? "no heights can be held there"
                                                 : "no grid lines can meet it at right angles"),
                                fmt::format("take {} out of '{}'", name_of(face_sides[s]),
                                            held ? "heights" : "orthogonal"));
        sound = false;
    }
    return sound;
}

bool edges_are_sound(Draft& draft, const FaceLoop& loop) {
    for (const auto& side : loop) {
        for (const EdgeUse& use : side.uses) {
            if (!draft.edge(use.edge).sound) return false;
        }
    }
    return true;
}

/// The ways round a planar face that a grid can take, where there are some: those whose outline
/// turns once, else those that turn once clockwise, whose remedy is told later.
std::vector<FaceLoop> loops_that_turn_once(Draft& draft, std::vector<FaceLoop> loops) {
    if (draft.three_dimensional()) return loops;
    const auto edge = [&draft](int index) -> const Edge& { return draft.edge(index).edge; };
    std::vector<FaceLoop> right;
    std::vector<FaceLoop> left;
    for (const FaceLoop& loop : loops) {
        FrameSides sides;
        for (std::size_t s = 0; s < 4; ++s) sides[s] = loop[s].uses;
        const std::optional<int> turns = outline_turns(sides, edge);
        if (!turns) return loops;
        if (*turns == 1) right.push_back(loop);
        if (*turns == -1) left.push_back(loop);
    }
    if (!right.empty()) return right;
    return left.empty() ? loops : left;
}

void join_face(Draft& draft, DraftFace& face, const NamedSides& named) {
    const auto edges = find_edges(draft, named);
    if (!edges) return;
    std::array<std::vector<SideChain>, 4> chains;
    bool unbroken = true;
    for (std::size_t s = 0; s < 4; ++s) {
        chains[s] = side_chains((*edges)[s]);
        if (!chains[s].empty()) continue;
        report_broken_chain(draft, face, face_sides[s], (*edges)[s], named[s]);
        unbroken = false;
    }
    if (!unbroken) return;
    std::vector<FaceLoop> loops = face_loops(chains);
    if (loops.empty()) {
        report_open_loop(draft, face, most_closed_loop(chains), named);
        return;
    }
    // Which way it is meant, an edge without its curve cannot tell.
    if (loops.size() > 1 && !edges_are_sound(draft, loops.front())) return;
    if (loops.size() > 1) loops = loops_that_turn_once(draft, std::move(loops));
    if (loops.size() > 1) {
        report_ambiguous(draft, face, loops, named);
        return;
    }
    const FaceLoop& loop = loops.front();
    for (std::size_t s = 0; s < 4; ++s) face.face.sides[s] = loop[s].uses;
    face.face.corners = {loop[2].start, loop[2].end, loop[3].end, loop[3].start};
    face.face.collapsed = collapsed_axes(face.face);
    const bool poles = poles_are_sound(draft, face, named);
    face.sound = cuts_are_sound(draft, face, named) && poles && edges_are_sound(draft, loop);
}

}  // namespace

void join_faces(Draft& draft) {
    for (DraftFace& face : draft.faces) {
        if (face.entry == nullptr) continue;
        if (const auto* named = std::get_if<NamedSides>(&face.entry->shape)) {
            join_face(draft, face, *named);
        }
    }
}

}  // namespace hexweave
