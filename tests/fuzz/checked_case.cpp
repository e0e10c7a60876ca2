// SPDX-License-Identifier: Apache-2.0
#include "fuzz/checked_case.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"
#include "core/parallel.h"
#include "topology/explain.h"
#include "topology/levels.h"
#include "topology/read_case.h"
#include "topology/resolve.h"
#include "topology/resolve_helpers.h"
#include "topology/source_text.h"

namespace hexweave::testing {

namespace {

constexpr std::size_t longest_line = 2'000;    ///< bytes of a message or a hint
constexpr std::size_t longest_text = 20'000;   ///< of a diagnostic with all that belongs to it
constexpr std::size_t most_diagnostics = 400;  ///< that are shown

/// Whether a text can be printed: valid UTF-8 without control characters.
bool is_printable(std::string text) {
    std::replace(text.begin(), text.end(), '\t', ' ');
    Diagnostics faults;
    return check_text(
        SourcePlaces(std::make_shared<const SourceFile>(SourceFile{"shown", std::move(text)})),
        faults);
}

bool is_one_line(const std::string& text) {
    return text.size() <= longest_line && text.find('\n') == std::string::npos &&
           is_printable(text);
}

/// Whether a place can be gone to: in a line of a file, not beyond its end.
bool is_in_file(const Place& place) {
    if (!place.file) return false;
    if (place.line == 0) return true;
    const std::string_view text = place.file->text;
    const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
    if (place.line < 0 || place.line > lines || place.column < 0 || place.length < 1) return false;
    std::size_t begin = 0;
    for (int line = 1; line < place.line; ++line) begin = text.find('\n', begin) + 1;
    const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
    return place.column <= count_characters(line) + 1;
}

std::string broken_diagnostic(const Diagnostic& d) {
    if (d.message.empty() || !is_one_line(d.message)) return "no message of one line: " + d.message;
    if (!is_one_line(d.hint)) return "no hint of one line: " + d.hint;
    if (!is_in_file(d.place)) return "a place outside of the file: " + d.message;
    for (const Note& note : all_notes(d)) {
        if (!is_one_line(note.message)) return "no note of one line: " + note.message;
        if (!is_in_file(note.place)) return "a note outside of the file: " + note.message;
    }
    const std::string text = render(d);
    if (text.size() > longest_text) return "too long: " + text.substr(0, longest_line);
    return is_printable(text) ? "" : "not printable: " + text;
}

std::string broken_diagnostics(const Diagnostics& diagnostics) {
    if (diagnostics.all().size() > most_diagnostics) return "too many diagnostics";
    for (const Diagnostic& d : diagnostics.all()) {
        if (std::string broken = broken_diagnostic(d); !broken.empty()) return broken;
    }
    return "";
}

std::string broken_explanation(const Case& written, const Topology& topology) {
    for (const std::string& name : explained_names(written, topology)) {
        const std::vector<Explanation> all = explain(written, topology, name);
        if (all.empty()) return "nothing explains " + name;
        for (const Explanation& explanation : all) {
            if (!is_printable(to_text(explanation))) return "the explanation of " + name;
        }
    }
    return "";
}

std::string broken_grid(const Case& written, Diagnostics& diagnostics) {
    const Topology topology = resolve(written, diagnostics);
    if (std::string broken = broken_promise(topology); !broken.empty()) return broken;
    if (topology.family && topology.family->nested()) {
        for (std::size_t level = 0; level < topology.family->names.size(); ++level) {
            const std::string broken = broken_promise(at_level(topology, level));
            if (!broken.empty()) return topology.family->names[level] + ": " + broken;
        }
    }
    return broken_explanation(written, topology);
}

}  // namespace

std::string broken_rule(const std::string& text) {
    set_threads(1);
    const auto source = std::make_shared<const SourceFile>(
        SourceFile{HEXWEAVE_SOURCE_DIR "/tests/cases/examples/input.yaml", text});
    Diagnostics diagnostics;
    try {
        Case written = read_case(source, {}, diagnostics);
        std::vector<std::string> levels{written.level.value};
        if (!diagnostics.has_errors() && !levels[0].empty()) levels = written.levels.names;
        for (const std::string& level : levels) {
            written.level.value = level;
            if (std::string broken = broken_grid(written, diagnostics); !broken.empty()) {
                return broken;
            }
        }
        if (diagnostics.has_errors()) return "resolved in spite of errors";
        return broken_diagnostics(diagnostics);
    } catch (const InputError& refused) {
        if (!refused.diagnostics.has_errors()) return "refused without an error";
        return broken_diagnostics(refused.diagnostics);
    }
}

}  // namespace hexweave::testing
