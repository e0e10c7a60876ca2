// SPDX-License-Identifier: Apache-2.0
#include "topology/block_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace hexweave {

namespace {

constexpr const char* edge_for_edge =
    "faces beside each other on a side of a block have one side, edge for edge, in common";

/// What the messages about one block are made of.
struct Telling {
    Draft& draft;
    const DraftBlock& block;
    const BlockSideEntries& named;

    const std::string& face(std::size_t side, std::size_t n) const {
        return draft.face_name(block.block.sides[side].faces[n].face);
    }
    /// 'a' and 'b' (imin)
    std::string side(Side s) const {
        std::vector<std::string> names;
        const auto index = static_cast<std::size_t>(s);
        for (std::size_t n = 0; n < named[index].faces.size(); ++n) {
            names.push_back(face(index, n));
        }
        return fmt::format("{} ({})", listed(names), side_name(s));
    }
    std::string edges(const std::vector<EdgeUse>& chain) const {
        std::vector<std::string> names;
        names.reserve(chain.size());
        for (const EdgeUse& use : chain) names.push_back(draft.edge_name(use.edge));
        return listed(names);
    }
};

FacesOfBlock without_required(FacesOfBlock faces) {
    for (SideFaces& side : faces) {
        std::fill(side.required.begin(), side.required.end(), std::nullopt);
    }
    return faces;
}

/// The neighbours of a face in the arrangement that come before it in the list.
std::vector<std::size_t> earlier_neighbours(const SideFaces& side, std::size_t face) {
    if (side.strip) return {face - 1};
    const auto columns = static_cast<std::size_t>(side.columns);
    std::vector<std::size_t> neighbours;
    if (face % columns > 0) neighbours.push_back(face - 1);
    if (face >= columns) neighbours.push_back(face - columns);
    return neighbours;
}

/// Notes that two faces share some edges, where the one goes on and the other does not.
void note_partly_shared(const Telling& tell, Diagnostic& error, const SideFaces& side,
                        std::array<std::size_t, 2> pair, std::size_t s) {
    for (const auto& own : side.faces[pair[0]]) {
        for (const auto& other : side.faces[pair[1]]) {
            const bool common = std::any_of(own.begin(), own.end(), [&](const EdgeUse& a) {
                return std::any_of(other.begin(), other.end(),
                                   [&](const EdgeUse& b) { return a.edge == b.edge; });
            });
            if (!common) continue;
            error.notes.push_back({tell.named[s].faces[pair[1]].face.place,
                                   fmt::format("the side of {} is made of {}, that of {} of {}",
                                               quoted(tell.face(s, pair[0])), tell.edges(own),
                                               quoted(tell.face(s, pair[1])), tell.edges(other))});
            return;
        }
    }
}

/// Another order of a side's faces, and how a user would write it.
struct OtherOrder {
    SideFaces side;
    std::string text;
};

/// Rows and columns changed.
OtherOrder turned_round(const Telling& tell, const SideFaces& side, std::size_t s) {
    const auto columns = static_cast<std::size_t>(side.columns);
    const std::size_t rows = side.faces.size() / columns;
    OtherOrder turned{side, {}};
    turned.side.columns = static_cast<int>(rows);
    std::size_t place = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        std::string row_text;
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t face = column + row * columns;
            turned.side.collapsed[place] = side.collapsed[face];
            turned.side.faces[place++] = side.faces[face];
            row_text += fmt::format("{}{}", row_text.empty() ? "" : ", ", tell.face(s, face));
        }
        turned.text += fmt::format("{}[{}]", turned.text.empty() ? "" : ", ", row_text);
    }
    turned.text = "[" + turned.text + "]";
    return turned;
}

/// A strip run through from its other end.
OtherOrder reversed(const Telling& tell, const SideFaces& side, std::size_t s) {
    OtherOrder reversed{side, {}};
    std::reverse(reversed.side.faces.begin(), reversed.side.faces.end());
    std::reverse(reversed.side.collapsed.begin(), reversed.side.collapsed.end());
    for (std::size_t n = side.faces.size(); n-- > 0;) {
        reversed.text += fmt::format("{}{}", reversed.text.empty() ? "[" : ", ", tell.face(s, n));
    }
    reversed.text += "]";
    return reversed;
}

std::string axis_letter(Side side, std::size_t which) {
    return std::string(1, "ijk"[tangential_axes(side)[which]]);
}

/// Reports the first face of a side that does not fit beside those before it.
void report_misfit(const Telling& tell, const SideFaces& side, std::size_t s) {
    const std::size_t face = fitting_faces(side);
    const Side where = all_sides[s];
    const std::string text = fmt::format("{} of block {} does not fit together: ", side_name(where),
                                         quoted(tell.block.block.name));
    const Place& place = tell.named[s].faces[face].face.place;
    std::string order;
    if (!side.strip) {
        const OtherOrder turned = turned_round(tell, side, s);
        if (fitting_faces(turned.side) == side.faces.size()) {
            order = fmt::format("rows run along {} and follow each other along {}: write {}",
                                axis_letter(where, 0), axis_letter(where, 1), turned.text);
        }
    }
    for (const std::size_t neighbour : earlier_neighbours(side, face)) {
        if (share_a_side(side.faces[neighbour], side.faces[face])) continue;
        Diagnostic& error = tell.draft.diagnostics.error(
            place,
            text + fmt::format("{} and {} have no side in common", quoted(tell.face(s, neighbour)),
                               quoted(tell.face(s, face))),
            order.empty() ? edge_for_edge : order);
        note_partly_shared(tell, error, side, {neighbour, face}, s);
        return;
    }
    tell.draft.diagnostics.error(
        place,
        text + fmt::format("{} shares a side with each neighbour before it, but they do not lie in "
                           "a rectangle",
                           quoted(tell.face(s, face))),
        !order.empty() ? order
        : side.strip   ? "in a strip, a face meets the next one on the side opposite to the one "
                         "before"
                       : fmt::format("rows run along {} and follow each other along {}",
                                     axis_letter(where, 0), axis_letter(where, 1)));
}

/// Reports 'axes' that none of the arrangements has; false where there are none.
bool report_wrong_axes(const Telling& tell, const FacesOfBlock& faces, std::size_t s,
                       const std::vector<SideArrangement>& possible) {
    for (std::size_t n = 0; n < faces[s].faces.size(); ++n) {
        const auto& required = faces[s].required[n];
        if (!required) continue;
        const bool fits = std::any_of(possible.begin(), possible.end(), [&](const auto& way) {
            return way.orientations[n] == *required;
        });
        if (fits) continue;
        tell.draft.diagnostics.error(
            tell.named[s].faces[n].face.place,
            fmt::format("'axes: {}' of {} ({}) contradict the edges of block {}",
                        to_string(*required, 2), quoted(tell.face(s, n)), side_name(all_sides[s]),
                        quoted(tell.block.block.name)),
            fmt::format("the edges ask for 'axes: {}'",
                        to_string(possible.front().orientations[n], 2)));
        return true;
    }
    return false;
}

/// What adjacent sides have where they should have one and the same chain of edges: the pair of
/// chains that is nearest to it; empty where no two have as much as an edge or both ends in common.
std::string chains_text(const Telling& tell, const FacesOfBlock& faces, Side a, Side b) {
    const auto ends = [&](const std::vector<EdgeUse>& chain) {
        const EdgeUse& first = chain.front();
        const EdgeUse& last = chain.back();
        const Edge& start = tell.draft.edge(first.edge).edge;
        const Edge& end = tell.draft.edge(last.edge).edge;
        return std::array{first.reversed ? start.end : start.start,
                          last.reversed ? end.start : end.end};
    };
    const auto likeness = [&](const ChainPair& pair) {
        const auto common =
            std::count_if(pair.first.begin(), pair.first.end(), [&](const EdgeUse& use) {
                return std::find(pair.second.begin(), pair.second.end(), use) != pair.second.end();
            });
        return 2 * common + (ends(pair.first) == ends(pair.second) ? 1 : 0);
    };
    const std::vector<ChainPair> pairs = chains_between(faces, a, b);
    const auto nearest = std::max_element(
        pairs.begin(), pairs.end(),
        [&](const ChainPair& x, const ChainPair& y) { return likeness(x) < likeness(y); });
    if (nearest == pairs.end() || likeness(*nearest) == 0) return {};
    return fmt::format("{} has {} there, {} has {}", side_name(a), tell.edges(nearest->first),
                       side_name(b), tell.edges(nearest->second));
}

/// What to write for a side whose list runs the wrong way, if that closes the block.
std::string other_order(const Telling& tell, const FacesOfBlock& faces) {
    for (std::size_t s = 0; s < 6; ++s) {
        const SideFaces& side = faces[s];
        if (side.faces.size() == 1) continue;
        const OtherOrder other = side.strip ? reversed(tell, side, s) : turned_round(tell, side, s);
        FacesOfBlock changed = faces;
        changed[s] = other.side;
        if (block_arrangements(changed).empty()) continue;
        return fmt::format("with the faces in another order it does: '{}: {}'",
                           side_name(all_sides[s]), other.text);
    }
    return {};
}

/// Reports adjacent sides that have no edge of the block in common; whether there are any.
bool report_strangers(const Telling& tell, const FacesOfBlock& faces) {
    const auto pairs = strangers(faces);
    if (pairs.empty()) return false;
    const auto place = [&](const std::pair<Side, Side>& pair) {
        return tell.named[static_cast<std::size_t>(pair.second)].place;
    };
    const auto& [first, second] = pairs.front();
    const std::string order = other_order(tell, faces);
    Diagnostic& error = tell.draft.diagnostics.error(
        place(pairs.front()),
        fmt::format("block {} does not close: {} and {} share no edge",
                    quoted(tell.block.block.name), tell.side(first), tell.side(second)),
        !order.empty()
            ? order
            : "faces on adjacent sides of a block have one side, edge for edge, in common");
    const std::string chains = chains_text(tell, faces, first, second);
    if (!chains.empty()) error.notes.push_back({place(pairs.front()), chains});
    for (std::size_t n = 1; n < pairs.size(); ++n) {
        const auto& [a, b] = pairs[n];
        const std::string more = chains_text(tell, faces, a, b);
        error.notes.push_back(
            {place(pairs[n]), fmt::format("nor do {} and {}{}{}", tell.side(a), tell.side(b),
                                          more.empty() ? "" : ": ", more)});
    }
    return true;
}

/// A side as the user would write it with the axes of one face, and the direction of a strip.
std::string with_axes(const Telling& tell, const SideArrangement& way, std::size_t s,
                      std::size_t face) {
    const auto& entries = tell.named[s].faces;
    const auto entry = [&](std::size_t n) {
        const std::string& name = entries[n].face.value;
        return n == face
                   ? fmt::format("{{face: {}, axes: {}}}", name, to_string(way.orientations[n], 2))
                   : name;
    };
    if (entries.size() == 1) return entry(0);
    std::string text;
    for (std::size_t n = 0; n < entries.size(); ++n) {
        const bool begins = n % static_cast<std::size_t>(way.columns) == 0;
        text += n == 0 ? "[[" : begins ? "], [" : ", ";
        text += entry(n);
    }
    return text + "]]";
}

}  // namespace

bool report_misfits(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                    const FacesOfBlock& faces) {
    const Telling tell{draft, block, named};
    bool any = false;
    const FacesOfBlock free = without_required(faces);
    for (std::size_t s = 0; s < 6; ++s) {
        if (!side_arrangements(faces[s]).empty()) continue;
        any = true;
        const std::vector<SideArrangement> possible = side_arrangements(free[s]);
        if (possible.empty()) {
            report_misfit(tell, faces[s], s);
        } else if (!report_wrong_axes(tell, faces, s, possible)) {
            draft.diagnostics.error(
                named[s].place,
                fmt::format("the 'axes' of {} contradict each other", tell.side(all_sides[s])),
                "give the axes of one of them");
        }
    }
    return any;
}

void report_unclosed(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                     const FacesOfBlock& faces) {
    const Telling tell{draft, block, named};
    const FacesOfBlock free_faces = without_required(faces);
    if (report_strangers(tell, free_faces)) return;
    const std::vector<BlockArrangement> free = block_arrangements(free_faces);
    for (std::size_t s = 0; s < 6 && !free.empty(); ++s) {
        std::vector<SideArrangement> possible;
        for (const BlockArrangement& way : free) possible.push_back(way[s]);
        if (report_wrong_axes(tell, faces, s, possible)) return;
    }
    draft.diagnostics.error(
        block.block.place,
        fmt::format("block {} does not close: each two adjacent faces share an edge, but all six "
                    "do not fit together",
                    quoted(block.block.name)),
        free.empty() ? "check which face is on which side" : "check the 'axes' of its faces");
}

void report_ambiguous(Draft& draft, const DraftBlock& block, const BlockSideEntries& named,
                      const std::vector<BlockArrangement>& solutions,
                      const std::vector<bool>& right_handed) {
    const Telling tell{draft, block, named};
    std::size_t decisive = 0;  // the side, and the face on it, that tell most solutions apart
    std::size_t decisive_face = 0;
    std::map<std::string, bool> ways;  // and whether one of them is right-handed
    for (std::size_t s = 0; s < 6; ++s) {
        for (std::size_t n = 0; n < named[s].faces.size(); ++n) {
            std::map<std::string, bool> different;
            for (std::size_t way = 0; way < solutions.size(); ++way) {
                different[fmt::format("'{}: {}'", side_name(all_sides[s]),
                                      with_axes(tell, solutions[way][s], s, n))] |=
                    right_handed[way];
            }
            if (different.size() <= ways.size()) continue;
            ways = std::move(different);
            decisive = s;
            decisive_face = n;
        }
    }
    std::string all;
    for (const bool right : {true, false}) {
        for (const auto& [text, is_right] : ways) {
            if (is_right != right) continue;
            all += (all.empty() ? "" : " or ") + text + (right ? "" : " (left-handed)");
        }
    }
    draft.diagnostics.error(named[decisive].faces[decisive_face].face.place,
                            fmt::format("the orientation of the faces of block {} is ambiguous",
                                        quoted(block.block.name)),
                            fmt::format("say it by the axes of a face: {}", all));
}

}  // namespace hexweave
