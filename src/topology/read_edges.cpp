// SPDX-License-Identifier: Apache-2.0
// Vertices and edges.
#include <fmt/format.h>

#include <utility>

#include "topology/limits.h"
#include "topology/read_entries.h"
#include "topology/read_spacing.h"

namespace hexweave {

namespace {

using VertexPlace = std::variant<Vec3, OnCurve, OnSurface>;

/// `{surface: S, at: [u, v]}` or `{surface: [S, ...], near: POINT}`.
VertexPlace read_place_on_surface(Reading& reading, const YamlNode& entry,
                                  const std::string& what) {
    const VertexPlace faulty = OnCurve{{{}, entry.place}, 0};
    expect_mapping(reading, entry, what, "vertex_on_surface");
    OnSurface place;
    place.surfaces = read_names(reading, *find(reading, entry, "surface"), "'surface'");
    const YamlNode* at = find(reading, entry, "at");
    const YamlNode* near = find(reading, entry, "near");
    if ((at == nullptr) == (near == nullptr)) {
        reading.diagnostics.error(
            entry.place, fmt::format("{} needs either 'at' or 'near'", what),
            "'at: [u, v]' are parameters of the surface, 'near: [x, y, z]' is a point whose "
            "nearest one on the surface is meant");
        return faulty;
    }
    place.place = at != nullptr ? at->place : near->place;
    if (near != nullptr) {
        const auto point = read_point(reading, *near, "'near'");
        if (!point) return faulty;
        place.where = *point;
        return place;
    }
    if (!expect_list(reading, *at, "'at'", 2)) return faulty;
    const auto u = read_number(reading, at->children[0], "u of 'at'");
    const auto v = read_number(reading, at->children[1], "v of 'at'");
    if (!u || !v) return faulty;
    place.where = SurfaceParameters{*u, *v};
    if (place.surfaces.size() == 1) return place;
    reading.diagnostics.error(at->place, "'at' are the parameters of one surface, not of several",
                              "name one surface, or give a point with 'near'");
    return faulty;
}

VertexPlace read_place(Reading& reading, const YamlNode& entry, const std::string& what) {
    const OnCurve faulty{{{}, entry.place}, 0};
    if (entry.is_sequence()) {
        const auto point = read_point(reading, entry, what);
        if (point) return *point;
        return faulty;
    }
    if (!entry.is_mapping()) {
        reading.diagnostics.error(entry.is_null() ? entry.key_place : entry.place,
                                  fmt::format("{} must be a point, not {}", what, describe(entry)),
                                  "write [x, y], [x, y, z], {curve: NAME, at: FRACTION} or "
                                  "{surface: NAME, at: [u, v]}");
        return faulty;
    }
    if (find(reading, entry, "surface") != nullptr) {
        return read_place_on_surface(reading, entry, what);
    }
    if (const YamlNode* point = find(reading, entry, "point")) {
        expect_mapping(reading, entry, what, "vertex_point");
        const auto position = read_point(reading, *point, what);
        if (position) return *position;
        return faulty;
    }
    expect_mapping(reading, entry, what, "vertex_on_curve");
    tell_lacking(reading, entry, required_keys("vertex_on_curve"), what);
    const YamlNode* curve = find(reading, entry, "curve");
    const YamlNode* at = find(reading, entry, "at");
    Name name;
    if (curve != nullptr) name = read_name(reading, *curve, "'curve'");
    const auto fraction = at == nullptr ? std::nullopt : read_number(reading, *at, "'at'");
    if (name.value.empty() || !fraction) return faulty;
    if (*fraction >= 0 && *fraction <= 1) return OnCurve{std::move(name), *fraction};
    reading.diagnostics.error(at->place,
                              fmt::format("'at' must lie between 0 and 1, not be {}", *fraction),
                              "it is a fraction of the curve's arc length");
    return faulty;
}

/// The name under a key; empty where it is faulty or not there.
Name read_name_at(Reading& reading, const YamlNode& entry, std::string_view key) {
    const YamlNode* node = find(reading, entry, key);
    return node == nullptr ? Name{{}, entry.key_place}
                           : read_name(reading, *node, fmt::format("'{}'", key));
}

/// What a grid of so many cells would need even if it were one cell wide.
std::string memory_of_strip(double cells) {
    return fmt::format("a grid of so many cells in a row needs about {} of memory",
                       memory_text(estimated_bytes(2 * (cells + 1))));
}

/// The number of cells, where it is given; a fault leaves the edge without a vertex.
void read_cells(Reading& reading, const YamlNode& node, EdgeEntry& edge) {
    const YamlNode* cells = find(reading, node, "cells");
    if (cells == nullptr) return;
    const auto count = read_count(reading, *cells, "'cells'", memory_of_strip);
    if (count) edge.cells = {*count, cells->place};
    if (!count) edge.from.value.clear();
}

/// `{at: VERTEX, cells: n}`: an edge that is one vertex.
void read_pole(Reading& reading, const YamlNode& node, const std::string& what, EdgeEntry& edge) {
    edge.pole = true;
    expect_mapping(reading, node, what, "pole",
                   {{"spacing", "a pole, an edge that is one vertex, has no spacing", ""},
                    {"along", "a pole, an edge that is one vertex, follows no curve", ""}});
    edge.from = edge.to = read_name_at(reading, node, "at");
    read_cells(reading, node, edge);
}

EdgeEntry read_edge(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("edge '{}'", shown(node.key));
    EdgeEntry edge;
    edge.name = edge.from = edge.to = {{}, node.key_place};
    edge.name.value = node.key;
    if (find(reading, node, "at") != nullptr && find(reading, node, "from") == nullptr) {
        read_pole(reading, node, what, edge);
        return edge;
    }
    if (!expect_mapping(
            reading, node, what, "edge",
            {{"at", "an edge is a pole 'at' a vertex, or goes 'from' one 'to' another",
              "leave out 'at', or 'from' and 'to'"},
             {"points", "an edge has 'cells', one less than its points", "write cells: NUMBER"},
             {"heights", "'heights' are held by faces and blocks, not by edges",
              "give a spacing with 'start', 'end' or 'positions'"}})) {
        return edge;
    }
    tell_lacking(reading, node, required_keys("edge"), what);
    edge.from = read_name_at(reading, node, "from");
    edge.to = read_name_at(reading, node, "to");
    if (const YamlNode* along = find(reading, node, "along")) {
        edge.along = read_name(reading, *along, "'along'");
    }
    if (const YamlNode* surface = find(reading, node, "surface")) {
        edge.surfaces = read_names(reading, *surface, "'surface'");
    }
    edge.gap = read_gap(reading, node, "edges");
    if (const YamlNode* plane = find(reading, node, "plane")) {
        const auto read = read_axis_plane(reading, *plane);
        if (read) edge.plane = {*read, plane->place};
    }
    if (const YamlNode* through = find(reading, node, "through")) {
        const auto point = read_point(reading, *through, "'through'");
        if (point) edge.through = {*point, through->place};
        if (!point) edge.from.value.clear();
    }
    read_cells(reading, node, edge);
    edge.multiple_of = read_multiple_of(reading, node);
    if (const YamlNode* spacing = find(reading, node, "spacing")) {
        auto law = read_spacing(reading, *spacing);
        if (law) edge.spacing = {std::move(*law), spacing->place};
    }
    return edge;
}

}  // namespace

std::vector<VertexEntry> read_vertices(Reading& reading, const YamlNode& section) {
    std::vector<VertexEntry> vertices;
    for (const YamlNode& entry : section.children) {
        check_new_name(reading, entry, "vertex");
        const std::string what = fmt::format("vertex '{}'", shown(entry.key));
        vertices.push_back({{entry.key, entry.key_place}, read_place(reading, entry, what)});
    }
    return vertices;
}

std::vector<EdgeEntry> read_edges(Reading& reading, const YamlNode& section) {
    std::vector<EdgeEntry> edges;
    for (const YamlNode& entry : section.children) {
        check_new_name(reading, entry, "edge");
        edges.push_back(read_edge(reading, entry));
    }
    return edges;
}

}  // namespace hexweave
