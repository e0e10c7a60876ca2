// SPDX-License-Identifier: Apache-2.0
#include "core/orientation.h"

#include <cstdlib>

#include "core/assert.h"

namespace hexweave {

namespace {

/// The other space's axis (0, 1, 2) that own axis `own` runs along.
std::size_t target(const Orientation& o, std::size_t own) {
    HEXWEAVE_ASSERT(std::abs(o.axes[own]) >= 1 && std::abs(o.axes[own]) <= 3);
    return static_cast<std::size_t>(std::abs(o.axes[own]) - 1);
}

bool reverses(const Orientation& o, std::size_t own) {
    return o.axes[own] < 0;
}

}  // namespace

std::string_view side_name(Side side) {
    constexpr std::array<std::string_view, 6> names{"imin", "imax", "jmin", "jmax", "kmin", "kmax"};
    return names[static_cast<std::size_t>(side)];
}

Orientation inverse(const Orientation& o) {
    Orientation result;
    for (std::size_t own = 0; own < 3; ++own) {
        const int axis = static_cast<int>(own) + 1;
        result.axes[target(o, own)] = reverses(o, own) ? -axis : axis;
    }
    return result;
}

Orientation compose(const Orientation& first, const Orientation& second) {
    Orientation result;
    for (std::size_t own = 0; own < 3; ++own) {
        const int axis = second.axes[target(first, own)];
        result.axes[own] = reverses(first, own) ? -axis : axis;
    }
    return result;
}

int determinant(const Orientation& o) {
    int sign = 1;
    for (std::size_t a = 0; a < 3; ++a) {
        if (reverses(o, a)) sign = -sign;
        for (std::size_t b = a + 1; b < 3; ++b) {
            if (target(o, a) > target(o, b)) sign = -sign;
        }
    }
    return sign;
}

Node map_node(const Orientation& o, const Node& n, const Extent& other) {
    Node result{};
    for (std::size_t own = 0; own < 3; ++own) {
        const std::size_t axis = target(o, own);
        const int last = other[static_cast<int>(axis)] - 1;
        result[axis] = reverses(o, own) ? last - n[own] : n[own];
    }
    return result;
}

Node map_node(const Orientation& o, const Node& n, const Node& begin, const Node& other_begin) {
    Node result = other_begin;
    for (std::size_t own = 0; own < 3; ++own) {
        const int steps = n[own] - begin[own];
        result[target(o, own)] += reverses(o, own) ? -steps : steps;
    }
    return result;
}

Extent own_extent(const Orientation& o, const Extent& other) {
    return {other[std::abs(o.axes[0]) - 1], other[std::abs(o.axes[1]) - 1],
            other[std::abs(o.axes[2]) - 1]};
}

const std::array<Orientation, 8>& face_orientations() {
    static constexpr std::array<Orientation, 8> orientations{
        Orientation{{1, 2, 3}},   Orientation{{-1, 2, 3}}, Orientation{{1, -2, 3}},
        Orientation{{-1, -2, 3}}, Orientation{{2, 1, 3}},  Orientation{{-2, 1, 3}},
        Orientation{{2, -1, 3}},  Orientation{{-2, -1, 3}}};
    return orientations;
}

std::string to_string(const Orientation& o, int axes) {
    constexpr std::string_view letters = "ijk";
    std::string text = "[";
    for (std::size_t own = 0; own < static_cast<std::size_t>(axes); ++own) {
        if (own > 0) text += ", ";
        if (reverses(o, own)) text += '-';
        text += letters[target(o, own)];
    }
    return text + "]";
}

IndexBox side_box(Side side, const Extent& extent) {
    IndexBox box{{0, 0, 0}, {extent.ni - 1, extent.nj - 1, extent.nk - 1}};
    const auto axis = static_cast<std::size_t>(axis_of(side));
    if (is_max(side)) {
        box.begin[axis] = box.end[axis];
    } else {
        box.end[axis] = box.begin[axis];
    }
    return box;
}

}  // namespace hexweave
