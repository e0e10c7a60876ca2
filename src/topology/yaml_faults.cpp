// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_faults.h"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "topology/text_limit.h"
#include "topology/yaml_layout.h"

namespace hexweave {

namespace {

/// What yaml-cpp says, and what to say instead.
struct Rewording {
    std::string_view yaml_cpp;
    std::string_view message;
    std::string_view hint;
};

constexpr std::array<Rewording, 8> rewordings{{
    {"illegal map value", "a ':' where no key can stand", "quote a text that holds ': '"},
    {"illegal flow end", "this bracket closes nothing", "remove it, or open one before it"},
    {"illegal block entry", "a list item cannot begin here", "write a list as [a, b]"},
    {"end of map not found", "this does not fit what stands before it",
     "check the indentation and the quotes"},
    {"end of sequence not found", "this does not fit what stands before it",
     "check the indentation and the quotes"},
    {"illegal EOF in scalar", "the file ends inside of a quoted text", "close the quote"},
    {"end of map flow not found", "a ',' or '}' is missing before this",
     "close the bracket, or put a comma between entries"},
    {"end of sequence flow not found", "a ',' or ']' is missing before this",
     "close the bracket, or put a comma between items"},
}};

/// Faults of block YAML, which its layout explains.
bool is_of_layout(std::string_view fault) {
    return fault == "illegal map value" || fault == "end of map not found" ||
           fault == "end of sequence not found" || fault == "illegal block entry";
}

/// The hint for a bracket that is not closed where `offset` is: what of the text is not read as it
/// was meant. Empty where nothing such shows.
std::string hint_in_brackets(const SourcePlaces& places, std::size_t offset, const Place& open) {
    const std::string_view text = places.text();
    if (offset < text.size() && text[offset] == '?') {
        return "quote an expression that holds '?' or ': '";
    }
    std::size_t begin = 0;
    for (int line = 1; line < open.line; ++line) begin = text.find('\n', begin) + 1;
    const std::string_view inside = text.substr(begin, offset - std::min(begin, offset));
    if (inside.find(" #") == std::string_view::npos) return {};
    return "' #' begins a comment, which is not read: close the bracket before it";
}

/// Faults that a user of expressions meets: `*x`, `&x`, `@x` or `%x` without quotes.
bool tell_unquoted(std::string_view fault, std::size_t offset, const SourcePlaces& places,
                   Diagnostics& diagnostics) {
    const std::string_view text = places.text();
    if (fault == "alias not found after *" || fault == "anchor not found after &") --offset;
    const std::string_view whole =
        text.substr(offset, text.substr(offset).find_first_of(" \t\r\n,]}"));
    const std::string word = shown(std::string(whole));
    if (word.empty() || std::string_view("*&@%`").find(word.front()) == std::string_view::npos) {
        return false;
    }
    const bool alias = word.front() == '*' && word.size() > 1;
    diagnostics.error(
        places.at(offset, count_characters(whole)),
        alias ? fmt::format("'{}' is a YAML alias, but no anchor '&{}' stands before it", word,
                            word.substr(1))
              : fmt::format("'{}' begins no text in YAML", word.front()),
        fmt::format("a text that begins with '{}' must be quoted", word.front()));
    return true;
}

}  // namespace

void tell_syntax_error(const YAML::Exception& fault, const SourcePlaces& places,
                       const std::optional<Note>& inside, Diagnostics& diagnostics) {
    const std::size_t size = places.text().size();
    const std::size_t offset =
        fault.mark.pos < 0 ? size : std::min(static_cast<std::size_t>(fault.mark.pos), size);
    if (tell_unquoted(fault.msg, offset, places, diagnostics)) return;
    const bool colon = fault.msg == "illegal map value";
    if (colon && tell_long_key(offset, places, diagnostics)) return;

    if (is_of_layout(fault.msg) && !inside) {
        if (const auto layout = layout_fault(places, offset)) {
            diagnostics.error(layout->place, layout->message, layout->hint).notes = layout->notes;
            return;
        }
    }
    const auto* known = std::find_if(rewordings.begin(), rewordings.end(),
                                     [&](const Rewording& r) { return r.yaml_cpp == fault.msg; });
    const bool found = known != rewordings.end();
    std::string hint = inside ? hint_in_brackets(places, offset, inside->place) : "";
    if (hint.empty() && found) hint = known->hint;
    Diagnostic& d = diagnostics.error(
        places.at(offset), "not valid YAML: " + (found ? std::string(known->message) : fault.msg),
        hint);
    if (inside) d.notes.push_back(*inside);
}

bool tell_long_key(std::size_t offset, const SourcePlaces& places, Diagnostics& diagnostics) {
    constexpr int longest_key = 1024;  // YAML 1.2, 7.4.2
    const std::string_view text = places.text();
    const std::size_t before = text.find_last_of("\n,{[", offset);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t begin = text.find_first_not_of(" -?", first);
    const std::size_t end = text.find_first_of(":\n", offset);
    if (end == std::string_view::npos || begin >= end) return false;
    const int length = count_characters(text.substr(begin, end - begin));
    if (length <= longest_key) return false;
    diagnostics.error(
        places.at(begin, length),
        fmt::format("this key has {} characters; YAML allows {}", length, longest_key),
        fmt::format("the names of a case have at most {}", longest_name_given));
    return true;
}

}  // namespace hexweave
