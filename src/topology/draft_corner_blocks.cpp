// SPDX-License-Identifier: Apache-2.0
// Blocks given by their corners: the drawn face on each side, or a made one.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "topology/block_orientation.h"
#include "topology/corners.h"
#include "topology/draft.h"

namespace hexweave {

namespace {

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
            fmt::format("{} of block {} has several faces between its corners: {}", side_name(side),
                        quoted(block.block.name), listed(names)),
            remedy);
        return -1;
    }
    if (others.empty()) return make_face(draft, corners, block.block.place);
    std::sort(others.begin(), others.end());
    draft.diagnostics.error(
        block.block.place,
        fmt::format("{} of block {} has the corners of face {}, but other edges", side_name(side),
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
        block.block.sides[static_cast<std::size_t>(side)].faces = {
            {face, matching_orientations(draft.face(face).face.sides, asked).front()}};
    }
    block.sound = sound;
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

}  // namespace hexweave
