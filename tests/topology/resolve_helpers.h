// SPDX-License-Identifier: Apache-2.0
// For tests of resolving: a case as text, its topology or all that is wrong with it.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "topology/read_case.h"
#include "topology/resolve.h"

namespace hexweave {

/// Reads and resolves a case; throws InputError when it has faults.
inline Topology resolved(const std::string& text) {
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    const Case c = read_case(source, {}, diagnostics);
    return resolve(c, diagnostics);
}

/// "12: error: message" (the line in the text given), then the notes as "  12: message" and the
/// hint as "  hint: ...".
inline std::string shown(const Diagnostic& d) {
    const auto line = [](const Place& place) {
        return place.line == 0 ? std::string("file: ") : std::to_string(place.line - 1) + ": ";
    };
    std::string text = line(d.place);
    text += d.severity == Severity::error ? "error: " : "warning: ";
    text += d.message + "\n";
    for (const Note& note : all_notes(d)) {
        text += "  " + line(note.place) + note.message + "\n";
    }
    if (!d.hint.empty()) text += "  hint: " + d.hint + "\n";
    return text;
}

/// All diagnostics of a case, empty when there are none.
inline std::string faults(const std::string& text) {
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    try {
        const Case c = read_case(source, {}, diagnostics);
        resolve(c, diagnostics);
    } catch (const InputError& error) {
        if (!error.diagnostics.has_errors()) return "InputError without an error";
    }
    std::string all;
    for (const Diagnostic& d : diagnostics.all()) all += shown(d);
    return all;
}

/// The first error at a line of a case.
inline std::string first_error(const std::string& text) {
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    try {
        const Case c = read_case(source, {}, diagnostics);
        resolve(c, diagnostics);
    } catch (const InputError&) {
        for (const Diagnostic& d : diagnostics.all()) {
            if (d.severity == Severity::error && d.place.line > 0) return shown(d);
        }
    }
    return "";
}

template <class Entities>
auto& named(const Entities& entities, const std::string& name) {
    for (const auto& entity : entities) {
        if (entity.name == name) return entity;
    }
    throw std::runtime_error("no entity is named " + name);
}

/// The uses of a side as names, reversed ones with a minus: "a -b".
inline std::string side_text(const Topology& t, const std::vector<EdgeUse>& side) {
    std::string text;
    for (const EdgeUse& use : side) {
        if (!text.empty()) text += ' ';
        if (use.reversed) text += '-';
        text += t.edges[static_cast<std::size_t>(use.edge)].name;
    }
    return text;
}

inline std::string edge_name(const Topology& t, int edge) {
    return t.edges[static_cast<std::size_t>(edge)].name;
}

inline std::string vertex_name(const Topology& t, int vertex) {
    return t.vertices[static_cast<std::size_t>(vertex)].name;
}

template <class Corners>
std::string corner_text(const Topology& t, const Corners& corners) {
    std::string text;
    for (const int corner : corners) {
        if (!text.empty()) text += ' ';
        text += vertex_name(t, corner);
    }
    return text;
}

/// "same as NAME", with a minus where reversed; "own" for a law of its own.
inline std::string law_text(const Topology& t, const Edge& edge) {
    if (const auto* same = std::get_if<SameAs>(&edge.law)) {
        std::string text = same->reversed ? "same as -" : "same as ";
        text += edge_name(t, same->edge);
        return text;
    }
    return "own";
}

/// What a valid topology promises, checked from the vertices: empty, or the first promise broken.
std::string broken_promise(const Topology& t);

}  // namespace hexweave
