// SPDX-License-Identifier: Apache-2.0
#include "topology/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/transform.h"
#include "topology/instance_scope.h"
#include "topology/names.h"
#include "topology/read_curves.h"
#include "topology/read_surfaces.h"

namespace hexweave {

namespace {

/// How many shapes may be made of one another in a row.
constexpr int longest_descent = 100;

std::shared_ptr<const Curve> read_shape(Shapes& shapes, const ShapeOfFile<Curve>& curve) {
    return read_curve(shapes, *curve.node);
}

std::shared_ptr<const Surface> read_shape(Shapes& shapes, const ShapeOfFile<Surface>& surface) {
    return read_surface(shapes, *surface.node);
}

template <class Shape>
void read_now(Shapes& shapes, ShapeOfFile<Shape>& entry, const std::string& kind) {
    if (entry.state == ShapeOfFile<Shape>::State::read) return;
    shapes.open.push_back({fmt::format("{} '{}'", kind, shown(entry.node->key)), 0});
    entry.state = ShapeOfFile<Shape>::State::being_read;
    entry.shape = read_shape(shapes, entry);
    entry.state = ShapeOfFile<Shape>::State::read;
    entry.descent = shapes.open.back().descent;
    shapes.open.pop_back();
}

/// "it is made of surface 'wing', which is made of curve 'tip'"
std::string circle_text(const Shapes& shapes, const std::string& what) {
    const auto first = std::find_if(shapes.open.begin(), shapes.open.end(),
                                    [&](const Shapes::Open& o) { return o.what == what; });
    std::string text = "it";
    for (auto at = first + 1; at != shapes.open.end(); ++at) {
        text += fmt::format(" is made of {}, which", at->what);
    }
    return text + " is made of it";
}

void tell_circle(Shapes& shapes, const YamlNode& node, const std::string& what) {
    const bool alone = shapes.open.back().what == what;
    shapes.reading.diagnostics.error(node.place, fmt::format("{} is made of itself", what),
                                     alone ? "" : circle_text(shapes, what));
}

/// A shape of one scope as another sees it, or the case (null).
template <class Shape>
std::shared_ptr<const Shape> seen_from(const ShapeOfFile<Shape>& entry, const ScopePointer& scope) {
    if (!entry.shape || !entry.node->scope || entry.node->scope == scope) return entry.shape;
    const Affine map = map_between(entry.node->scope, scope);
    if (is_identity(map)) return entry.shape;
    return std::make_shared<const Shape>(transformed(*entry.shape, map));
}

template <class Shape>
void tell_unknown(Shapes& shapes, const std::vector<ShapeOfFile<Shape>>& entries,
                  const YamlNode& node, const std::string& name, const std::string& kind) {
    if (is_in_scope(name, shapes.reading.lost_scopes)) return;
    for (const LeftOutEntry& entry : shapes.reading.left_out) {
        if (entry.section != kind + "s" || entry.name != name) continue;
        tell_left_out(kind, {name, node.place}, entry.when, shapes.reading.diagnostics);
        return;
    }
    Keys known;
    for (const ShapeOfFile<Shape>& entry : entries) known.emplace_back(entry.node->key);
    shapes.reading.diagnostics.error(node.place, fmt::format("unknown {} {}", kind, quoted(name)),
                                     known.empty()
                                         ? fmt::format("draw it under '{}s'", kind)
                                         : suggestion(name, known, fmt::format("{}s are", kind)));
}

template <class Shape>
std::shared_ptr<const Shape> use(Shapes& shapes, std::vector<ShapeOfFile<Shape>>& entries,
                                 const YamlNode& node, const std::string& what,
                                 const std::string& kind) {
    const Name name = read_name(shapes.reading, node, what);
    if (name.value.empty()) return nullptr;
    const auto entry =
        std::find_if(entries.begin(), entries.end(),
                     [&](const ShapeOfFile<Shape>& e) { return e.node->key == name.value; });
    if (entry == entries.end()) {
        tell_unknown(shapes, entries, node, name.value, kind);
        return nullptr;
    }
    entry->used = true;
    if (entry->state == ShapeOfFile<Shape>::State::being_read) {
        tell_circle(shapes, node, fmt::format("{} '{}'", kind, shown(name.value)));
        return nullptr;
    }
    const bool too_deep = shapes.open.size() > static_cast<std::size_t>(longest_descent);
    if (!too_deep) read_now(shapes, *entry, kind);
    int& descent = shapes.open.back().descent;
    descent = std::max(descent, entry->descent + 1);
    if (!too_deep && descent <= longest_descent) return seen_from(*entry, node.scope);
    shapes.reading.diagnostics.error(
        node.place, fmt::format("more than {} shapes are made of one another", longest_descent),
        "transform the first of them at once");
    return nullptr;
}

template <class Shape>
std::vector<ShapeOfFile<Shape>> entries_of(Reading& reading, const YamlNode* section,
                                           const std::string& kind) {
    std::vector<ShapeOfFile<Shape>> entries;
    if (section == nullptr) return entries;
    for (const YamlNode& node : section->children) {
        check_new_name(reading, node, kind);
        entries.push_back({&node});
    }
    return entries;
}

}  // namespace

std::shared_ptr<const Curve> use_curve(Shapes& shapes, const YamlNode& node,
                                       const std::string& what) {
    return use(shapes, shapes.curves, node, what, "curve");
}

std::shared_ptr<const Surface> use_surface(Shapes& shapes, const YamlNode& node,
                                           const std::string& what) {
    return use(shapes, shapes.surfaces, node, what, "surface");
}

void read_shapes(Reading& reading, const YamlNode* curves, const YamlNode* surfaces, Case& c) {
    Shapes shapes{reading};
    shapes.curves = entries_of<Curve>(reading, curves, "curve");
    shapes.surfaces = entries_of<Surface>(reading, surfaces, "surface");
    for (ShapeOfFile<Curve>& entry : shapes.curves) read_now(shapes, entry, "curve");
    for (ShapeOfFile<Surface>& entry : shapes.surfaces) {
        if (entry.node->key == "minimal") {
            reading.diagnostics.error(entry.node->key_place, "no surface can be named 'minimal'",
                                      "that is what the surface of a face is by default");
        }
        read_now(shapes, entry, "surface");
    }
    for (const ShapeOfFile<Curve>& entry : shapes.curves) {
        c.curves.push_back(
            {{entry.node->key, entry.node->key_place}, seen_from(entry, nullptr), entry.used});
    }
    for (const ShapeOfFile<Surface>& entry : shapes.surfaces) {
        c.surfaces.push_back(
            {{entry.node->key, entry.node->key_place}, seen_from(entry, nullptr), entry.used});
    }
}

}  // namespace hexweave
