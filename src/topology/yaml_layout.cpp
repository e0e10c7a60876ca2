// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace hexweave {

namespace {

/// A line without its break; `begin` is its offset in the text.
struct Line {
    std::size_t begin = 0;
    std::string_view text;

    std::size_t indent() const { return std::min(text.find_first_not_of(' '), text.size()); }
    bool is_blank() const { return indent() == text.size() || text[indent()] == '#'; }
};

Line line_at(std::string_view text, std::size_t offset) {
    const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return {begin, line};
}

/// The last line before another that says something.
std::optional<Line> line_before(std::string_view text, const Line& line) {
    std::size_t begin = line.begin;
    while (begin > 0) {
        const Line previous = line_at(text, begin - 1);
        if (!previous.is_blank()) return previous;
        begin = previous.begin;
    }
    return std::nullopt;
}

/// Where a key's colon stands without a space behind it; npos where the line begins with none.
std::size_t glued_colon(const Line& line) {
    const std::size_t colon = line.text.find_first_not_of(
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789{}", line.indent());
    const bool glued = colon != std::string_view::npos && colon > line.indent() &&
                       line.text[colon] == ':' && colon + 1 < line.text.size() &&
                       std::string_view(" \t").find(line.text[colon + 1]) == std::string_view::npos;
    return glued ? colon : std::string_view::npos;
}

Diagnostic tell_glued(const SourcePlaces& places, const Line& line, std::size_t colon) {
    const std::string key(line.text.substr(line.indent(), colon + 1 - line.indent()));
    Diagnostic fault;
    fault.place = places.at(line.begin + line.indent(), count_characters(key) + 1);
    fault.message = fmt::format("not valid YAML: a space is missing behind '{}'", shown(key));
    fault.hint =
        fmt::format("write '{} {}'", shown(key), shown(std::string(line.text.substr(colon + 1))));
    return fault;
}

}  // namespace

std::optional<Diagnostic> layout_fault(const SourcePlaces& places, std::size_t offset) {
    const std::string_view text = places.text();
    const Line line = line_at(text, offset);
    const std::optional<Line> before = line_before(text, line);
    if (before) {
        const std::size_t colon = glued_colon(*before);
        if (colon != std::string_view::npos) return tell_glued(places, *before, colon);
    }
    const std::size_t colon = glued_colon(line);
    if (colon != std::string_view::npos) return tell_glued(places, line, colon);
    if (!before || before->indent() == line.indent()) return std::nullopt;
    Diagnostic fault;
    fault.place = places.at(line.begin + line.indent());
    fault.message =
        fmt::format("not valid YAML: this line is indented by {} space{}, the one before it by {}",
                    line.indent(), line.indent() == 1 ? "" : "s", before->indent());
    fault.hint = "entries of one section begin in the same column";
    fault.notes.push_back({places.at(before->begin + before->indent()), "the line before it"});
    return fault;
}

}  // namespace hexweave
