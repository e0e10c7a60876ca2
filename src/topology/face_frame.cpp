// SPDX-License-Identifier: Apache-2.0
#include "topology/face_frame.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace hexweave {

namespace {

constexpr std::array<std::array<int, 2>, 4> corner_positions{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

}  // namespace

std::vector<EdgeUse> backwards(const std::vector<EdgeUse>& side) {
    std::vector<EdgeUse> result;
    result.reserve(side.size());
    std::transform(side.rbegin(), side.rend(), std::back_inserter(result), [](const EdgeUse& use) {
        return EdgeUse{use.edge, !use.reversed && !use.pole, use.pole};
    });
    return result;
}

FrameSides sides_in_frame(const FrameSides& face_sides, const Orientation& orientation) {
    FrameSides result;
    for (std::size_t own = 0; own < 2; ++own) {
        const auto axis = static_cast<std::size_t>(std::abs(orientation.axes[own]) - 1);
        const bool swapped = orientation.axes[own] < 0;
        const bool against = orientation.axes[1 - own] < 0;
        for (std::size_t max = 0; max < 2; ++max) {
            const std::vector<EdgeUse>& side = face_sides[2 * axis + (swapped ? 1 - max : max)];
            result[2 * own + max] = against ? backwards(side) : side;
        }
    }
    return result;
}

std::array<int, 4> corners_in_frame(const std::array<int, 4>& corners,
                                    const Orientation& orientation) {
    std::array<int, 4> result{};
    for (std::size_t n = 0; n < 4; ++n) {
        std::array<int, 2> in_face{};
        for (std::size_t own = 0; own < 2; ++own) {
            const int position = corner_positions[n][own];
            const auto axis = static_cast<std::size_t>(std::abs(orientation.axes[own]) - 1);
            in_face[axis] = orientation.axes[own] < 0 ? 1 - position : position;
        }
        result[n] = corners[hexahedron_corner(in_face[0], in_face[1], 0)];
    }
    return result;
}

FrameSides joined_frame(const std::vector<FrameSides>& faces, int columns) {
    const int rows = static_cast<int>(faces.size()) / columns;
    FrameSides joined;
    const auto append = [&](std::size_t side, int column, int row) {
        const auto& part = faces[static_cast<std::size_t>(column + row * columns)][side];
        joined[side].insert(joined[side].end(), part.begin(), part.end());
    };
    for (int row = 0; row < rows; ++row) {
        append(0, 0, row);
        append(1, columns - 1, row);
    }
    for (int column = 0; column < columns; ++column) {
        append(2, column, 0);
        append(3, column, rows - 1);
    }
    return joined;
}

FrameSides sides_in_frame(const std::vector<Face>& faces, const BlockSide& side) {
    std::vector<FrameSides> frames;
    frames.reserve(side.faces.size());
    for (const FaceUse& use : side.faces) {
        frames.push_back(
            sides_in_frame(faces[static_cast<std::size_t>(use.face)].sides, use.orientation));
    }
    return joined_frame(frames, side.columns);
}

Extent place_faces(const std::vector<Face>& faces, BlockSide& side) {
    const auto extent_of = [&](int column, int row) {
        const FaceUse& use = side.at(column, row);
        return own_extent(use.orientation, faces[static_cast<std::size_t>(use.face)].extent());
    };
    std::vector<int> columns{0};
    std::vector<int> rows{0};
    for (int c = 0; c < side.columns; ++c)
        columns.push_back(columns.back() + extent_of(c, 0).ni - 1);
    for (int r = 0; r < side.rows(); ++r) rows.push_back(rows.back() + extent_of(0, r).nj - 1);
    const auto width = static_cast<std::size_t>(side.columns);
    for (std::size_t n = 0; n < side.faces.size(); ++n) {
        side.faces[n].begin = {columns[n % width], rows[n / width]};
    }
    return {columns.back() + 1, rows.back() + 1, 1};
}

std::array<std::size_t, 4> corners_of_side(Side side) {
    const std::array<int, 2> axes = tangential_axes(side);
    std::array<std::size_t, 4> result{};
    for (std::size_t n = 0; n < 4; ++n) {
        std::array<int, 3> node{};
        node[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? 1 : 0;
        for (std::size_t own = 0; own < 2; ++own) {
            node[static_cast<std::size_t>(axes[own])] = corner_positions[n][own];
        }
        result[n] = hexahedron_corner(node[0], node[1], node[2]);
    }
    return result;
}

}  // namespace hexweave
