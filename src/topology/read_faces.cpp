// SPDX-License-Identifier: Apache-2.0
// Faces and blocks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "topology/read_entries.h"
#include "topology/read_gates.h"
#include "topology/read_heights.h"

namespace hexweave {

namespace {

MethodEntry read_method(Reading& reading, const YamlNode& node, const FormatNames& heights) {
    MethodEntry how;
    if (const YamlNode* method = find(reading, node, "method")) {
        const auto choice =
            read_choice(reading, *method, "'method'", words_of("any_face", "method"));
        if (choice && *choice == 1) how.method = Method::algebraic;
    }
    if (const YamlNode* tolerance = find(reading, node, "tolerance")) {
        how.tolerance = read_positive(reading, *tolerance, "'tolerance'");
    }
    how.flat_edge_exponent = read_flat_edge_exponent(reading, node);
    how.heights = read_heights(reading, node, heights);
    how.gates = read_gates(reading, node);
    return how;
}

/// A face or block is given by its sides or by its corners: whether by its corners; nothing after
/// an error.
std::optional<bool> by_corners(Reading& reading, const YamlNode& node, const Keys& sides,
                               const std::string& what) {
    const bool corners = find(reading, node, "corners") != nullptr;
    const YamlNode* first = nullptr;
    for (const std::string_view side : sides) {
        const YamlNode* given = find(reading, node, side);
        if (given != nullptr && first == nullptr) first = given;
    }
    if (corners && first != nullptr) {
        reading.diagnostics.error(first->key_place,
                                  fmt::format("{} is already given by its corners", what),
                                  "give either the corners or the sides");
        return std::nullopt;
    }
    if (!corners && first == nullptr) {
        reading.diagnostics.error(node.key_place, fmt::format("{} has no sides", what),
                                  fmt::format("give {}, or corners", fmt::join(sides, ", ")));
        return std::nullopt;
    }
    return corners;
}

/// Tells a face of three corners how one of its sides becomes a pole.
void tell_triangle(Reading& reading, const YamlNode& corners) {
    std::array<std::string, 3> names;
    for (std::size_t n = 0; n < names.size(); ++n) names.at(n) = shown(corners.children[n].text);
    reading.diagnostics.error(
        corners.place, "a face has four corners, not three",
        fmt::format("for a triangle draw its tip as an edge, 'tip: {{at: {}}}', and give the four "
                    "sides: 'imin: tip', 'imax' from {} to {}, 'jmin' from {} to {}, 'jmax' from "
                    "{} to {}",
                    names[0], names[1], names[2], names[0], names[1], names[0], names[2]));
}

template <std::size_t count>
std::array<Name, count> read_corners(Reading& reading, const YamlNode& node) {
    std::array<Name, count> corners;
    corners.fill({{}, node.place});
    const bool three = node.children.size() == 3 &&
                       std::all_of(node.children.begin(), node.children.end(),
                                   [](const YamlNode& name) { return name.is_scalar(); });
    if (count == 4 && three) {
        tell_triangle(reading, node);
        return corners;
    }
    if (!expect_list(reading, node, "'corners'", count)) return corners;
    for (std::size_t n = 0; n < count; ++n)
        corners[n] = read_name(reading, node.children[n], "a corner");
    return corners;
}

/// One edge or several; never empty: what cannot be read is an empty name.
std::vector<SignedName> read_face_side(Reading& reading, const YamlNode& node,
                                       const std::string& what) {
    if (!node.is_sequence()) return {read_signed_name(reading, node, what)};
    std::vector<SignedName> edges;
    for (const YamlNode& item : node.children) {
        edges.push_back(read_signed_name(reading, item, fmt::format("an edge of {}", what)));
    }
    if (!edges.empty()) return edges;
    reading.diagnostics.error(node.place, fmt::format("{} names no edge", what),
                              usage_of(reading, node));
    return {SignedName{{}, false, false, node.place}};
}

/// The surfaces that a face names; none where it is a minimal surface.
std::vector<Name> read_surfaces(Reading& reading, const YamlNode& face) {
    const YamlNode* node = find(reading, face, "surface");
    if (node == nullptr || (node->is_scalar() && node->text == "minimal")) return {};
    return read_names(reading, *node, "'surface'");
}

/// Marks the side that one name of 'orthogonal' means, or tells why it means none.
void mark_orthogonal(Reading& reading, const YamlNode& name, const Keys& sides,
                     std::array<bool, 4>& marked) {
    const auto choice = read_choice(reading, name, "a side of 'orthogonal'", sides);
    if (!choice) return;
    if (marked.at(*choice)) {
        reading.diagnostics.error(
            name.place, fmt::format("'orthogonal' names {} twice", sides[*choice]), "name it once");
    }
    marked.at(*choice) = true;
}

/// `[jmin, imax]`, one side, or `all`: the sides that grid lines are to meet at right angles.
std::array<bool, 4> read_orthogonal(Reading& reading, const YamlNode& face, Method method) {
    std::array<bool, 4> marked{};
    const YamlNode* node = find(reading, face, "orthogonal");
    if (node == nullptr) return marked;
    if (method == Method::algebraic) {
        reading.diagnostics.error(node->key_place,
                                  "'orthogonal' is for elliptic faces, and this one is algebraic",
                                  "remove 'orthogonal' or 'method: algebraic'");
    }
    const Keys sides = required_keys("face");
    if (node->is_sequence()) {
        if (node->children.empty()) {
            reading.diagnostics.error(node->place, "'orthogonal' names no side",
                                      "name sides of the face, or remove the key");
        }
        for (const YamlNode& name : node->children) mark_orthogonal(reading, name, sides, marked);
        return marked;
    }
    const auto choice =
        read_choice(reading, *node, "'orthogonal'", words_of("any_face", "orthogonal"));
    if (!choice) return marked;
    if (*choice == sides.size()) {
        marked.fill(true);
    } else {
        marked.at(*choice) = true;
    }
    return marked;
}

FaceEntry read_face(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("face '{}'", shown(node.key));
    const Keys sides = required_keys("face");
    std::array<std::vector<SignedName>, 4> edges;
    edges.fill({SignedName{{}, false, false, node.key_place}});
    FaceEntry face{{node.key, node.key_place}, edges, {}, {}};

    if (!expect_mapping(reading, node, what, {"face", "face_by_corners"})) return face;
    face.how = read_method(reading, node, "face_heights");
    face.orthogonal = read_orthogonal(reading, node, face.how.method);
    face.surfaces = read_surfaces(reading, node);
    face.gap = read_gap(reading, node, "faces");
    const std::optional<bool> corners = by_corners(reading, node, sides, what);
    if (!corners) return face;
    if (*corners) {
        face.shape = read_corners<4>(reading, *find(reading, node, "corners"));
        return face;
    }
    tell_lacking(reading, node, sides, what);
    for (std::size_t n = 0; n < 4; ++n) {
        const YamlNode* side = find(reading, node, sides[n]);
        if (side != nullptr)
            edges.at(n) = read_face_side(reading, *side, fmt::format("'{}'", sides[n]));
    }
    face.shape = std::move(edges);
    return face;
}

/// `[-j, i]`: the two axes of a block's side in the face's own.
std::optional<std::array<int, 2>> read_axes(Reading& reading, const YamlNode& node) {
    if (!expect_list(reading, node, "'axes'", 2)) return std::nullopt;
    const Keys& names = words_of("face_use", "axes");
    static constexpr std::array<int, 4> values{1, 2, -1, -2};
    std::array<int, 2> axes{};
    for (std::size_t n = 0; n < 2; ++n) {
        const auto choice = read_choice(reading, node.children[n], "an axis", names);
        if (!choice) return std::nullopt;
        axes.at(n) = values.at(*choice);
    }
    if (std::abs(axes[0]) != std::abs(axes[1])) return axes;
    reading.diagnostics.error(node.place, "'axes' must name both i and j", usage_of(reading, node));
    return std::nullopt;
}

FaceUseEntry read_face_use(Reading& reading, const YamlNode& node, const std::string& what) {
    FaceUseEntry use{{{}, node.place}, {}};
    if (!node.is_mapping()) {
        use.face = read_name(reading, node, what);
        return use;
    }
    expect_mapping(reading, node, what, "face_use");
    const YamlNode* face = require(reading, node, "face", what);
    if (face != nullptr) use.face = read_name(reading, *face, "'face'");
    if (const YamlNode* axes = find(reading, node, "axes")) {
        use.axes = read_axes(reading, *axes);
        if (!use.axes) use.face.value.clear();
    }
    return use;
}

/// Rows of a block's side, all of one length.
BlockSideEntry read_rows(Reading& reading, const YamlNode& node, const std::string& what) {
    BlockSideEntry side{
        {}, static_cast<int>(node.children.front().children.size()), false, node.place};
    for (const YamlNode& row : node.children) {
        if (!row.is_sequence() || row.children.empty()) {
            reading.diagnostics.error(
                row.place,
                fmt::format("a row of {} must be a list of faces, not {}", what, describe(row)),
                "write a strip as [a, b], rows as [[a, b], [c, d]]");
            return {{{{{}, node.place}, {}}}, 1, false, node.place};
        }
        if (row.children.size() != node.children.front().children.size()) {
            reading.diagnostics.error(
                row.place,
                fmt::format("this row of {} has {} {}, but the first has {}", what,
                            row.children.size(), row.children.size() == 1 ? "face" : "faces",
                            node.children.front().children.size()),
                "the faces of a side are a rectangle: as many in every row");
            return {{{{{}, node.place}, {}}}, 1, false, node.place};
        }
        for (const YamlNode& face : row.children) {
            side.faces.push_back(read_face_use(reading, face, fmt::format("a face of {}", what)));
        }
    }
    return side;
}

/// A face, a strip of faces, or rows of them; never empty: what cannot be read is an empty name.
BlockSideEntry read_block_side(Reading& reading, const YamlNode& node, const std::string& what) {
    if (!node.is_sequence()) {
        FaceUseEntry use = read_face_use(reading, node, what);
        const Place place = use.face.place;
        return {{std::move(use)}, 1, false, place};
    }
    if (node.children.empty()) {
        reading.diagnostics.error(node.place, fmt::format("{} names no face", what),
                                  usage_of(reading, node));
        return {{{{{}, node.place}, {}}}, 1, false, node.place};
    }
    if (node.children.front().is_sequence()) return read_rows(reading, node, what);
    BlockSideEntry side{{}, static_cast<int>(node.children.size()), true, node.place};
    for (const YamlNode& face : node.children) {
        side.faces.push_back(read_face_use(reading, face, fmt::format("a face of {}", what)));
    }
    return side;
}

BlockEntry read_block(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("block '{}'", shown(node.key));
    const Keys sides = required_keys("block");
    std::array<BlockSideEntry, 6> faces;
    faces.fill({{{{{}, node.key_place}, {}}}, 1, false, node.key_place});
    BlockEntry block{{node.key, node.key_place}, faces, {}};

    if (!expect_mapping(reading, node, what, {"block", "block_by_corners"})) return block;
    block.how = read_method(reading, node, "block_heights");
    const std::optional<bool> corners = by_corners(reading, node, sides, what);
    if (!corners) return block;
    if (*corners) {
        block.shape = read_corners<8>(reading, *find(reading, node, "corners"));
        return block;
    }
    tell_lacking(reading, node, sides, what);
    for (std::size_t n = 0; n < 6; ++n) {
        const YamlNode* side = find(reading, node, sides[n]);
        if (side != nullptr)
            faces.at(n) = read_block_side(reading, *side, fmt::format("'{}'", sides[n]));
    }
    block.shape = std::move(faces);
    return block;
}

template <class Entry, class Reader>
std::vector<Entry> read_section(Reading& reading, const YamlNode& section, const std::string& kind,
                                Reader read) {
    std::vector<Entry> entries;
    for (const YamlNode& node : section.children) {
        check_new_name(reading, node, kind, longest_zone_name);
        entries.push_back(read(reading, node));
    }
    return entries;
}

}  // namespace

std::optional<double> read_flat_edge_exponent(Reading& reading, const YamlNode& mapping) {
    const YamlNode* node = find(reading, mapping, "flat_edge_exponent");
    if (node == nullptr) return std::nullopt;
    const std::optional<double> value = read_positive(reading, *node, "'flat_edge_exponent'");
    if (!value || *value <= 1) return value;
    reading.diagnostics.error(node->place,
                              fmt::format("'flat_edge_exponent' must be at most 1, not {}", *value),
                              "1 is the arc length; 0.7 is the default of grids of blocks");
    return std::nullopt;
}

std::optional<double> read_gap(Reading& reading, const YamlNode& entry, const std::string& kind) {
    const YamlNode* node = find(reading, entry, "gap");
    if (node == nullptr) return std::nullopt;
    const YamlNode* surface = find(reading, entry, "surface");
    const bool on_surface =
        surface != nullptr && !(surface->is_scalar() && surface->text == "minimal");
    if (!on_surface && find(reading, entry, "plane") == nullptr) {
        reading.diagnostics.error(node->key_place, fmt::format("'gap' is for {} on surfaces", kind),
                                  "name the 'surface', or remove 'gap'");
    }
    return read_positive(reading, *node, "'gap'");
}

std::vector<FaceEntry> read_faces(Reading& reading, const YamlNode& section) {
    return read_section<FaceEntry>(reading, section, "face", read_face);
}

std::vector<BlockEntry> read_blocks(Reading& reading, const YamlNode& section) {
    return read_section<BlockEntry>(reading, section, "block", read_block);
}

}  // namespace hexweave
