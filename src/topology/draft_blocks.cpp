// SPDX-License-Identifier: Apache-2.0
// Blocks: which face covers each side, and how it lies there.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "topology/block_orientation.h"
#include "topology/corners.h"
#include "topology/draft.h"

namespace hexweave {

namespace {

using NamedFaces = std::array<FaceUseEntry, 6>;

std::string name_of(Side side) {
    return std::string(side_name(side));
}

std::array<int, 4> pick(const std::array<int, 8>& corners, Side side) {
    std::array<int, 4> result{};
    const std::array<std::size_t, 4> positions = corners_of_side(side);
    for (std::size_t n = 0; n < 4; ++n) result[n] = corners[positions[n]];
    return result;
}

/// A made face in its canonical orientation, so that all who need it get the same one.
int make_face(Draft& draft, const std::array<int, 4>& corners, const Place& place) {
    std::array<std::string, 4> names;
    for (std::size_t n = 0; n < 4; ++n) names[n] = draft.vertex_name(corners[n]);
    DraftFace face;
    face.face.name = made_face_name(names);
    if (const auto known = draft.face_names.find(face.face.name)) return *known;
    const std::array<std::size_t, 4> cycle = canonical_cycle(names);
    for (std::size_t n = 0; n < 4; ++n) face.face.corners[n] = corners[cycle[n]];
    face.face.sides = *sides_between(draft, face.face.corners);
    face.face.place = place;
    face.face.solve = solve_request(draft.c, {});
    face.face.made = true;
    face.sound = std::all_of(
        face.face.sides.begin(), face.face.sides.end(),
        [&](const std::vector<EdgeUse>& side) { return draft.edge(side.front().edge).sound; });
    const int index = static_cast<int>(draft.faces.size());
    draft.face_names.add(face.face.name, index);
    draft.faces.push_back(std::move(face));
    return index;
}

/// The face between four corners of a block: the drawn one or else a made one; -1 after an error.
int face_between(Draft& draft, const DraftBlock& block, Side side,
                 const std::array<int, 4>& corners, const FrameSides& asked) {
    std::array<int, 4> wanted = corners;
    std::sort(wanted.begin(), wanted.end());
    std::vector<int> matching;
    std::vector<std::string> others;
    for (std::size_t n = 0; n < draft.faces.size(); ++n) {
        DraftFace& face = draft.faces[n];
        if (face.entry == nullptr || !face.sound) continue;
        std::array<int, 4> own = face.face.corners;
        std::sort(own.begin(), own.end());
        if (own != wanted) continue;
        face.used = true;
        if (matching_orientations(face.face.sides, asked).empty()) {
            others.push_back(face.face.name);
        } else {
            matching.push_back(static_cast<int>(n));
        }
    }
    if (matching.size() == 1) return matching.front();
    const std::string remedy = "give the block by its six faces";
    if (matching.size() > 1) {
        std::vector<std::string> names;
        names.reserve(matching.size());
        for (const int face : matching) names.push_back(draft.face_name(face));
        std::sort(names.begin(), names.end());
        draft.diagnostics.error(
            block.block.place,
            fmt::format("{} of block {} has several faces between its corners: {}", name_of(side),
                        quoted(block.block.name), listed(names)),
            remedy);
        return -1;
    }
    if (others.empty()) return make_face(draft, corners, block.block.place);
    std::sort(others.begin(), others.end());
    draft.diagnostics.error(
        block.block.place,
        fmt::format("{} of block {} has the corners of face {}, but other edges", name_of(side),
                    quoted(block.block.name), listed(others)),
        remedy);
    return -1;
}

void join_corner_block(Draft& draft, DraftBlock& block) {
    bool sound = true;
    for (const Side side : all_sides) {
        const std::array<int, 4> corners = pick(block.block.corners, side);
        const FrameSides asked = *sides_between(draft, corners);
        const int face = face_between(draft, block, side, corners, asked);
        if (face < 0) {
            sound = false;
            continue;
        }
        draft.face(face).used = true;
        sound = sound && draft.face(face).sound;
        block.block.sides[static_cast<std::size_t>(side)] = {
            face, matching_orientations(draft.face(face).face.sides, asked).front()};
    }
    block.sound = sound;
}

/// The faces of the six sides; false where one is unknown or faulty.
bool find_faces(Draft& draft, DraftBlock& block, const NamedFaces& named) {
    bool found = true;
    for (std::size_t s = 0; s < 6; ++s) {
        const Name& name = named[s].face;
        const std::optional<int> face = find_face(draft.face_names, name.value);
        if (!face) {
            if (!name.value.empty()) draft.face_names.report_unknown(name, draft.diagnostics);
            found = false;
            continue;
        }
        draft.face(*face).used = true;
        found = found && draft.face(*face).sound;
        block.block.sides[s].face = *face;
    }
    return found;
}

/// A face may be named twice, on opposite sides: a cut.
bool cuts_are_sound(Draft& draft, const DraftBlock& block, const NamedFaces& named) {
    bool sound = true;
    for (std::size_t b = 0; b < 6; ++b) {
        for (std::size_t a = 0; a < b; ++a) {
            if (block.block.sides[a].face != block.block.sides[b].face || a / 2 == b / 2) continue;
            draft.diagnostics.error(
                named[b].face.place,
                fmt::format("face {} is on the adjacent sides {} and {} of block {}",
                            quoted(draft.face_name(block.block.sides[a].face)),
                            name_of(all_sides[a]), name_of(all_sides[b]), quoted(block.block.name)),
                "a cut is on opposite sides");
            sound = false;
        }
    }
    return sound;
}

FacesOfBlock faces_of(Draft& draft, const DraftBlock& block, const NamedFaces& named) {
    FacesOfBlock faces;
    for (std::size_t s = 0; s < 6; ++s) {
        faces.sides[s] = draft.face(block.block.sides[s].face).face.sides;
        if (named[s].axes) {
            faces.required[s] = Orientation{{(*named[s].axes)[0], (*named[s].axes)[1], 3}};
        }
    }
    return faces;
}

/// Reports why no orientations fit: faces without a common edge, 'axes' that contradict the edges,
/// or faces that share edges pair by pair but do not close.
void report_unclosed(Draft& draft, const DraftBlock& block, const NamedFaces& named,
                     FacesOfBlock faces) {
    const auto text = [&](Side side) {
        const auto s = static_cast<std::size_t>(side);
        return fmt::format("{} ({})", quoted(draft.face_name(block.block.sides[s].face)),
                           name_of(side));
    };
    const auto pairs = strangers(faces);
    if (!pairs.empty()) {
        Diagnostic& error = draft.diagnostics.error(
            named[static_cast<std::size_t>(pairs.front().second)].face.place,
            fmt::format("block {} does not close: {} and {} share no edge",
                        quoted(block.block.name), text(pairs.front().first),
                        text(pairs.front().second)),
            "faces on adjacent sides of a block have one side, edge for edge, in common");
        for (std::size_t n = 1; n < pairs.size(); ++n) {
            error.notes.push_back(
                {named[static_cast<std::size_t>(pairs[n].second)].face.place,
                 fmt::format("nor do {} and {}", text(pairs[n].first), text(pairs[n].second))});
        }
        return;
    }
    const auto required = faces.required;
    faces.required = {};
    const std::vector<BlockOrientations> free = block_orientations(faces);
    for (std::size_t s = 0; s < 6 && !free.empty(); ++s) {
        if (!required[s]) continue;
        const bool possible = std::any_of(free.begin(), free.end(), [&](const auto& solution) {
            return solution[s] == *required[s];
        });
        if (possible) continue;
        draft.diagnostics.error(
            named[s].face.place,
            fmt::format("'axes: {}' of {} contradict the edges of block {}",
                        to_string(*required[s], 2), text(all_sides[s]), quoted(block.block.name)),
            fmt::format("the edges ask for 'axes: {}'", to_string(free.front()[s], 2)));
        return;
    }
    draft.diagnostics.error(
        block.block.place,
        fmt::format("block {} does not close: each two adjacent faces share an edge, but all six "
                    "do not fit together",
                    quoted(block.block.name)),
        free.empty() ? "check which face is on which side" : "check the 'axes' of its faces");
}

/// Reports that several orientations fit, with the 'axes' that decide.
void report_ambiguous(Draft& draft, const DraftBlock& block, const NamedFaces& named,
                      const std::vector<BlockOrientations>& solutions) {
    std::size_t decisive = 0;  // the side that tells most solutions apart
    std::size_t most = 0;
    for (std::size_t s = 0; s < 6; ++s) {
        std::vector<std::array<int, 3>> different;
        for (const BlockOrientations& solution : solutions) {
            if (std::find(different.begin(), different.end(), solution[s].axes) ==
                different.end()) {
                different.push_back(solution[s].axes);
            }
        }
        if (different.size() > most) {
            most = different.size();
            decisive = s;
        }
    }
    std::vector<std::string> ways;
    for (const BlockOrientations& solution : solutions) {
        std::string way = fmt::format("'{}: {{face: {}, axes: {}}}'", name_of(all_sides[decisive]),
                                      named[decisive].face.value, to_string(solution[decisive], 2));
        if (std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(std::move(way));
    }
    draft.diagnostics.error(
        named[decisive].face.place,
        fmt::format("the orientation of the faces of block {} is ambiguous",
                    quoted(block.block.name)),
        fmt::format("say it by the axes of a face: {}", fmt::join(ways, " or ")));
}

void join_block(Draft& draft, DraftBlock& block, const NamedFaces& named) {
    if (!find_faces(draft, block, named)) return;
    if (!cuts_are_sound(draft, block, named)) return;
    const FacesOfBlock faces = faces_of(draft, block, named);
    const std::vector<BlockOrientations> solutions = block_orientations(faces);
    if (solutions.empty()) {
        report_unclosed(draft, block, named, faces);
        return;
    }
    if (solutions.size() > 1) {
        report_ambiguous(draft, block, named, solutions);
        return;
    }
    for (std::size_t s = 0; s < 6; ++s) {
        block.block.sides[s].orientation = solutions.front()[s];
    }
    for (const Side side : {Side::kmin, Side::kmax}) {
        const FaceUse& use = block.block.side(side);
        const std::array<int, 4> corners =
            corners_in_frame(draft.face(use.face).face.corners, use.orientation);
        const std::array<std::size_t, 4> positions = corners_of_side(side);
        for (std::size_t n = 0; n < 4; ++n) block.block.corners[positions[n]] = corners[n];
    }
    block.sound = true;
}

}  // namespace

void join_corner_blocks(Draft& draft) {
    for (const DraftFace& face : draft.faces) {
        if (!face.sound) continue;
        std::array<std::string, 4> corners;
        for (std::size_t n = 0; n < 4; ++n) corners[n] = draft.vertex_name(face.face.corners[n]);
        draft.face_names.note_drawn(made_face_name(corners), face.face.name);
    }
    for (DraftBlock& block : draft.blocks) {
        if (block.corners_known) join_corner_block(draft, block);
    }
}

void join_blocks(Draft& draft) {
    for (DraftBlock& block : draft.blocks) {
        if (const auto* named = std::get_if<NamedFaces>(&block.entry->shape)) {
            join_block(draft, block, *named);
        }
    }
}

}  // namespace hexweave
