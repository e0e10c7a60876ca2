// SPDX-License-Identifier: Apache-2.0
#include "topology/place_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/transform.h"
#include "topology/instance_scope.h"

namespace hexweave {

namespace {

/// What an instance does to its entries.
struct Placement {
    Affine map;
    double scale = 1;
    bool mirrored = false;
    bool faces_are_the_grid = false;
};

void scale(std::optional<double>& length, double factor) {
    if (length) *length *= factor;
}

void place(VertexEntry& vertex, const Placement& how) {
    if (auto* point = std::get_if<Vec3>(&vertex.where)) *point = apply(how.map, *point);
    if (auto* on_surface = std::get_if<OnSurface>(&vertex.where)) {
        auto* near = std::get_if<Vec3>(&on_surface->where);
        if (near != nullptr) *near = apply(how.map, *near);
    }
}

void scale_law(SpacingEntry& law, double factor) {
    if (auto* tanh = std::get_if<TanhLaw>(&law)) {
        scale(tanh->start, factor);
        scale(tanh->end, factor);
        if (tanh->natural) tanh->natural->size *= factor;
        if (tanh->natural) tanh->natural->within *= factor;
    } else if (auto* geometric = std::get_if<GeometricLaw>(&law)) {
        scale(geometric->start, factor);
        scale(geometric->end, factor);
    }
}

/// The image of a plane across an axis; told where it is not one.
void place(Reading& reading, Located<AxisPlane>& plane, const Placement& how) {
    constexpr double turn_tolerance = 1e-12;
    const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    const Vec3 normal = axes.at(static_cast<std::size_t>(plane.value.axis));
    const Vec3 turned = apply_to_direction(how.map, normal) / how.scale;
    const Vec3 point = apply(how.map, plane.value.value * normal);
    for (std::size_t n = 0; n < 3; ++n) {
        if (std::abs(std::abs(dot(turned, axes.at(n))) - 1) > turn_tolerance) continue;
        plane.value = {static_cast<int>(n), dot(point, axes.at(n))};
        return;
    }
    reading.diagnostics.error(plane.place, "this plane is turned by its instance, off the axes",
                              "a plane is x, y or z = a number: turn by right angles, or leave the "
                              "plane out");
}

void place(Reading& reading, EdgeEntry& edge, const Placement& how) {
    if (edge.through) edge.through->value = apply(how.map, edge.through->value);
    if (edge.plane) place(reading, *edge.plane, how);
    if (edge.spacing) scale_law(edge.spacing->value, how.scale);
    scale(edge.gap, how.scale);
}

void place(MethodEntry& method, const Placement& how) {
    for (auto& held : method.heights) {
        if (held) scale(held->height, how.scale);
    }
    if (how.mirrored) std::swap(method.heights[0], method.heights[1]);
}

/// The same face run through backwards along i.
void reverse_i(FaceEntry& face) {
    if (auto* corners = std::get_if<std::array<Name, 4>>(&face.shape)) {
        std::swap((*corners)[0], (*corners)[1]);
        std::swap((*corners)[2], (*corners)[3]);
    } else {
        auto& sides = std::get<std::array<std::vector<SignedName>, 4>>(face.shape);
        std::swap(sides[0], sides[1]);
        for (auto* side : {&sides[2], &sides[3]}) {
            std::reverse(side->begin(), side->end());
            for (SignedName& edge : *side) edge.reversed = edge.sign_given != edge.reversed;
        }
    }
    std::swap(face.orthogonal[0], face.orthogonal[1]);
}

void place(FaceEntry& face, const Placement& how) {
    Placement own = how;
    own.mirrored = how.mirrored && how.faces_are_the_grid;
    place(face.how, own);
    scale(face.gap, how.scale);
    if (own.mirrored) reverse_i(face);
}

/// Rows of faces on a side whose first axis is i, run through backwards.
void reverse_rows(BlockSideEntry& side) {
    for (auto row = side.faces.begin(); row != side.faces.end(); row += side.columns) {
        std::reverse(row, row + side.columns);
    }
    for (FaceUseEntry& use : side.faces) {
        if (use.axes) (*use.axes)[0] = -(*use.axes)[0];
    }
}

/// The same block run through backwards along i.
void reverse_i(Reading& reading, BlockEntry& block) {
    if (auto* corners = std::get_if<std::array<Name, 8>>(&block.shape)) {
        for (const std::size_t n : {0U, 2U, 4U, 6U}) std::swap((*corners)[n], (*corners)[n + 1]);
        return;
    }
    auto& sides = std::get<std::array<BlockSideEntry, 6>>(block.shape);
    std::swap(sides[0], sides[1]);
    for (std::size_t s = 2; s < 6; ++s) {
        if (sides.at(s).strip && sides.at(s).faces.size() > 1) {
            reading.diagnostics.error(
                sides.at(s).place, "this strip is in a mirrored instance, and may run along i",
                "write it as rows: [[a, b]] along the side's first axis, [[a], [b]] along its "
                "second");
        }
        reverse_rows(sides.at(s));
    }
}

void place(Reading& reading, BlockEntry& block, const Placement& how) {
    place(block.how, how);
    if (how.mirrored) reverse_i(reading, block);
}

/// Hands every entry of a section that belongs to an instance to `move`.
template <class Entry, class Move>
void for_instances(const YamlNode& root, std::string_view key, std::vector<Entry>& entries,
                   bool faces_are_the_grid, Move move) {
    const YamlNode* section = root.find(key);
    if (section == nullptr || section->children.size() != entries.size()) return;
    for (std::size_t n = 0; n < entries.size(); ++n) {
        const ScopePointer& scope = section->children[n].scope;
        if (!scope) continue;
        move(entries[n], Placement{map_between(scope, nullptr), total_scale(scope),
                                   is_mirrored(scope), faces_are_the_grid});
    }
}

}  // namespace

void place_instances(Reading& reading, const YamlNode& root, Case& c) {
    if (reading.scopes.empty()) return;
    const bool flat = c.blocks.empty();
    for_instances(root, "vertices", c.vertices, flat,
                  [](VertexEntry& v, const Placement& how) { place(v, how); });
    for_instances(root, "edges", c.edges, flat,
                  [&](EdgeEntry& e, const Placement& how) { place(reading, e, how); });
    for_instances(root, "faces", c.faces, flat,
                  [](FaceEntry& f, const Placement& how) { place(f, how); });
    for_instances(root, "blocks", c.blocks, flat,
                  [&](BlockEntry& b, const Placement& how) { place(reading, b, how); });
    for_instances(root, "boundaries", c.boundaries, flat,
                  [&](BoundaryEntry& b, const Placement& how) {
                      if (b.plane) place(reading, *b.plane, how);
                  });
}

}  // namespace hexweave
