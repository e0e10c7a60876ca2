// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_faults.h"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace hexweave {

namespace {

/// What yaml-cpp says, and what to say instead.
struct Rewording {
    std::string_view yaml_cpp;
    std::string_view message;
    std::string_view hint;
};

constexpr std::array<Rewording, 8> rewordings{{
    {"illegal map value", "a ':' where no key can stand",
     "check the indentation, and quote a text that holds ': '"},
    {"illegal flow end", "this bracket closes nothing", ""},
    {"illegal block entry", "a list item cannot begin here", "write a list as [a, b]"},
    {"end of map not found", "this does not fit what stands before it",
     "check the indentation and the quotes"},
    {"end of sequence not found", "this does not fit what stands before it",
     "check the indentation and the quotes"},
    {"illegal EOF in scalar", "the file ends inside of a quoted text", "close the quote"},
    {"end of map flow not found", "a ',' or '}' is missing before this", ""},
    {"end of sequence flow not found", "a ',' or ']' is missing before this", ""},
}};

/// Faults that a user of expressions meets: `*x`, `&x`, `@x` or `%x` without quotes.
bool tell_unquoted(std::string_view fault, std::size_t offset, const SourcePlaces& places,
                   Diagnostics& diagnostics) {
    const std::string_view text = places.text();
    if (fault == "alias not found after *" || fault == "anchor not found after &") --offset;
    const std::string_view word =
        text.substr(offset, text.substr(offset).find_first_of(" \t\r\n,]}"));
    if (word.empty() || std::string_view("*&@%`").find(word.front()) == std::string_view::npos) {
        return false;
    }
    const bool alias = word.front() == '*' && word.size() > 1;
    diagnostics.error(
        places.at(offset, count_characters(word)),
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

    const auto* known = std::find_if(rewordings.begin(), rewordings.end(),
                                     [&](const Rewording& r) { return r.yaml_cpp == fault.msg; });
    const bool found = known != rewordings.end();
    Diagnostic& d = diagnostics.error(
        places.at(offset), "not valid YAML: " + (found ? std::string(known->message) : fault.msg),
        found ? std::string(known->hint) : std::string());
    if (inside) d.notes.push_back(*inside);
}

}  // namespace hexweave
