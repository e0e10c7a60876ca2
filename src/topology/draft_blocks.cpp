// SPDX-License-Identifier: Apache-2.0
// Blocks given by their faces: how these lie on each side, or why there is no way.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "topology/block_faults.h"
#include "topology/block_orientation.h"
#include "topology/draft.h"
#include "topology/handedness.h"

namespace hexweave {

namespace {

/// The faces of the six sides; false where one is unknown or faulty.
bool find_faces(Draft& draft, DraftBlock& block, const BlockSideEntries& named) {
    bool found = true;
    for (std::size_t s = 0; s < 6; ++s) {
        BlockSide& side = block.block.sides[s];
        side.columns = named[s].columns;
        side.faces.assign(named[s].faces.size(), {});
        for (std::size_t n = 0; n < side.faces.size(); ++n) {
            const Name& name = named[s].faces[n].face;
            const std::optional<int> face = find_face(draft.face_names, name.value);
            if (!face) {
                if (!name.value.empty()) draft.face_names.report_unknown(name, draft.diagnostics);
                found = false;
                continue;
            }
            draft.face(*face).used = true;
            found = found && draft.face(*face).sound;
            side.faces[n].face = *face;
        }
    }
    return found;
}

/// A face may be named twice on opposite sides (a cut) or on one side (a fold).
bool cuts_are_sound(Draft& draft, const DraftBlock& block, const BlockSideEntries& named) {
    bool sound = true;
    const auto check = [&](std::size_t a, int face, std::size_t b, const Name& name) {
        if (a / 2 == b / 2) return;
        draft.diagnostics.error(
            name.place,
            fmt::format("face {} is on the adjacent sides {} and {} of block {}",
                        quoted(draft.face_name(face)), side_name(all_sides[a]),
                        side_name(all_sides[b]), quoted(block.block.name)),
            "a cut is on opposite sides");
        sound = false;
    };
    for (std::size_t b = 0; b < 6; ++b) {
        for (std::size_t n = 0; n < named[b].faces.size(); ++n) {
            const int face = block.block.sides[b].faces[n].face;
            for (std::size_t a = 0; a < b; ++a) {
                for (const FaceUse& use : block.block.sides[a].faces) {
                    if (use.face == face) check(a, face, b, named[b].faces[n].face);
                }
            }
        }
    }
    return sound;
}

FacesOfBlock faces_of(Draft& draft, const DraftBlock& block, const BlockSideEntries& named) {
    FacesOfBlock faces;
    for (std::size_t s = 0; s < 6; ++s) {
        faces[s].columns = named[s].columns;
        faces[s].strip = named[s].strip;
        for (const FaceUse& use : block.block.sides[s].faces) {
            faces[s].faces.push_back(draft.face(use.face).face.sides);
            faces[s].collapsed.push_back(draft.face(use.face).face.is_collapsed());
        }
        for (const FaceUseEntry& entry : named[s].faces) {
            faces[s].required.push_back(
                entry.axes ? std::optional(Orientation{{(*entry.axes)[0], (*entry.axes)[1], 3}})
                           : std::nullopt);
        }
    }
    return faces;
}

void enter(Draft& draft, Block& block, const BlockArrangement& arrangement) {
    for (std::size_t s = 0; s < 6; ++s) {
        BlockSide& side = block.sides[s];
        side.columns = arrangement[s].columns;
        for (std::size_t n = 0; n < side.faces.size(); ++n) {
            side.faces[n].orientation = arrangement[s].orientations[n];
        }
    }
    const auto corners_of = [&](const BlockSide& side, int column, int row) {
        const FaceUse& use = side.at(column, row);
        return corners_in_frame(draft.face(use.face).face.corners, use.orientation);
    };
    for (const Side side : {Side::kmin, Side::kmax}) {
        const BlockSide& faces = block.side(side);
        const int right = faces.columns - 1;
        const int top = faces.rows() - 1;
        const std::array<int, 4> corners{corners_of(faces, 0, 0)[0], corners_of(faces, right, 0)[1],
                                         corners_of(faces, right, top)[2],
                                         corners_of(faces, 0, top)[3]};
        const std::array<std::size_t, 4> positions = corners_of_side(side);
        for (std::size_t n = 0; n < 4; ++n) block.corners[positions[n]] = corners[n];
    }
}

/// The vertices, edges and faces drawn so far.
Topology drawn_part(const Draft& draft) {
    Topology topology;
    for (const DraftVertex& v : draft.vertices) topology.vertices.push_back(v.vertex);
    for (const DraftEdge& e : draft.edges) topology.edges.push_back(e.edge);
    for (const DraftFace& f : draft.faces) topology.faces.push_back(f.face);
    return topology;
}

/// Which of several arrangements make a right-handed block.
std::vector<bool> right_handed(Draft& draft, const DraftBlock& block,
                               const std::vector<BlockArrangement>& arrangements) {
    const Topology topology = drawn_part(draft);
    std::vector<bool> right;
    for (const BlockArrangement& arrangement : arrangements) {
        Block arranged = block.block;
        enter(draft, arranged, arrangement);
        right.push_back(signed_volume(topology, arranged) > 0);
    }
    return right;
}

void join_block(Draft& draft, DraftBlock& block, const BlockSideEntries& named) {
    if (!find_faces(draft, block, named)) return;
    if (!cuts_are_sound(draft, block, named)) return;
    const FacesOfBlock faces = faces_of(draft, block, named);
    if (report_misfits(draft, block, named, faces)) return;
    const std::vector<BlockArrangement> solutions = block_arrangements(faces);
    if (solutions.empty()) {
        report_unclosed(draft, block, named, faces);
        return;
    }
    if (solutions.size() > 1) {
        report_ambiguous(draft, block, named, solutions, right_handed(draft, block, solutions));
        return;
    }
    enter(draft, block.block, solutions.front());
    block.sound = true;
}

}  // namespace

void join_blocks(Draft& draft) {
    for (DraftBlock& block : draft.blocks) {
        if (const auto* named = std::get_if<BlockSideEntries>(&block.entry->shape)) {
            join_block(draft, block, *named);
        }
    }
}

}  // namespace hexweave
