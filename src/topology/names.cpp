// SPDX-License-Identifier: Apache-2.0
#include "topology/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "topology/source_text.h"
#include "topology/text_limit.h"

namespace hexweave {

namespace {

constexpr std::size_t longest_name = 32;

/// FNV-1a: the same on every machine.
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return hash;
}

/// Twelve hexadecimal digits tell about a million long names apart with near certainty.
std::string shortened(const std::string& name) {
    if (name.size() <= longest_name) return name;
    const std::string digits = fmt::format("{:012x}", hash_of(name) & 0xFFFFFFFFFFFFULL);
    return name.substr(0, longest_name - digits.size() - 1) + "-" + digits;
}

/// The parts of "a-b" or "a-b-c-d".
std::vector<std::string> split_at_hyphens(const std::string& name) {
    std::vector<std::string> parts(1);
    for (const char c : name) {
        if (c == '-') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

}  // namespace

std::optional<int> NameTable::find(const std::string& name) const {
    const auto found = index_.find(name);
    if (found == index_.end()) return std::nullopt;
    return found->second;
}

std::optional<int> NameTable::require(const Name& name, Diagnostics& diagnostics) {
    const std::optional<int> index = find(name.value);
    if (!index && !name.value.empty()) report_unknown(name, diagnostics);
    return index;
}

bool NameTable::is_lost(const std::string& name) const {
    const std::vector<std::string> parts = split_at_hyphens(name);
    return std::any_of(parts.begin(), parts.end(),
                       [&](const std::string& p) { return is_in_scope(p, lost_scopes_); });
}

bool NameTable::is_made_of_vertices(const std::string& name) const {
    const std::vector<std::string> parts = split_at_hyphens(name);
    return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [&](const std::string& p) {
               const auto other = others_.find(p);
               return other != others_.end() && other->second == a_vertex;
           });
}

std::string NameTable::hint_for(const Name& name) const {
    const std::string& unknown = name.value;
    const auto drawn = drawn_.find(canonical_name(unknown));
    if (drawn != drawn_.end()) {
        return fmt::format("the {} between these vertices is drawn as {}", kind_,
                           listed(drawn->second));
    }
    const auto other = others_.find(unknown);
    if (other != others_.end()) {
        return fmt::format("{} is {}; the name of {} {} is wanted here", quoted(unknown),
                           other->second, kind_ == "edge" ? "an" : "a", kind_);
    }
    std::string made_where = fmt::format(
        "a name of corners is made only where a face or block given by its 'corners' "
        "needs it; else draw it under '{}s'",
        kind_);
    if (is_made_of_vertices(unknown)) return made_where;
    std::vector<std::string> known;
    known.reserve(index_.size());
    const std::string& scope = scope_at(name.place);
    for (const auto& entry : index_) {
        if (entry.first.compare(0, scope.size(), scope) == 0) known.push_back(entry.first);
    }
    const std::string nearest = nearest_name(unknown, known);
    if (!nearest.empty()) return fmt::format("did you mean {}?", quoted(nearest));
    if (unknown.find('-') != std::string::npos) return made_where;
    constexpr std::size_t few = 8;
    if (known.empty() || known.size() > few) return {};
    return fmt::format("known: {}", listed(known, few));
}

void NameTable::report_unknown(const Name& name, Diagnostics& diagnostics) {
    unknown_asked_ = true;
    tell_unknown(name, diagnostics);
}

void NameTable::tell_unknown(const Name& name, Diagnostics& diagnostics) const {
    if (incomplete_ || is_lost(name.value)) return;
    const auto left_out = left_out_.find(name.value);
    if (left_out != left_out_.end()) {
        tell_left_out(kind_, name, left_out->second, diagnostics);
        return;
    }
    diagnostics.error(name.place, fmt::format("unknown {} {}", kind_, quoted(name.value)),
                      hint_for(name));
}

void NameTable::note_drawn(const std::string& made, const std::string& drawn) {
    drawn_[made].push_back(drawn);
}

void NameTable::renumber(const std::vector<int>& new_index) {
    for (auto& entry : index_) {
        if (entry.second >= 0) entry.second = new_index[static_cast<std::size_t>(entry.second)];
    }
}

std::optional<NamedEdge> find_edge(const NameTable& edges, const std::string& name) {
    if (const auto index = edges.find(name)) return NamedEdge{*index, false};
    const auto index = edges.find(canonical_name(name));
    if (!index) return std::nullopt;
    // A canonical name begins with the smaller vertex; this spelling is another one, or was cut.
    const std::vector<std::string> parts = split_at_hyphens(name);
    return NamedEdge{*index, parts[1] < parts[0]};
}

std::optional<int> find_face(const NameTable& faces, const std::string& name) {
    if (const auto index = faces.find(name)) return index;
    return faces.find(canonical_name(name));
}

bool is_in_scope(const std::string& name, const std::vector<std::string>& scopes) {
    return std::any_of(scopes.begin(), scopes.end(),
                       [&](const std::string& scope) { return name.starts_with(scope); });
}

void tell_left_out(const std::string& kind, const Name& name, const Place& when,
                   Diagnostics& diagnostics) {
    Diagnostic& error = diagnostics.error(
        name.place,
        fmt::format("{} {} is not there: its condition does not hold", kind, quoted(name.value)),
        "give what uses it the same 'when', or parameters with which this one holds");
    error.notes.push_back({when, "this is 0"});
}

std::string quoted(const std::string& name) {
    return "'" + (name.size() <= longest_name_given ? name : shown(name)) + "'";
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
    const std::size_t shown = std::min(most, names.size());
    const std::size_t hidden = names.size() - shown;
    std::string text;
    for (std::size_t n = 0; n < shown; ++n) {
        if (n > 0) text += n + 1 == shown && hidden == 0 ? " and " : ", ";
        text += quoted(names[n]);
    }
    return hidden == 0 ? text : fmt::format("{} and {} more", text, hidden);
}

std::string made_edge_name(const std::string& a, const std::string& b) {
    return shortened(a < b ? a + "-" + b : b + "-" + a);
}

std::array<std::size_t, 4> canonical_cycle(const std::array<std::string, 4>& corners) {
    const auto first = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) -
                                                corners.begin());
    const std::size_t next = (first + 1) % 4;
    const std::size_t previous = (first + 3) % 4;
    const std::size_t across = (first + 2) % 4;
    if (corners[next] < corners[previous]) return {first, next, across, previous};
    return {first, previous, across, next};
}

std::string made_face_name(const std::array<std::string, 4>& corners) {
    const std::array<std::size_t, 4> cycle = canonical_cycle(corners);
    return shortened(fmt::format("{}-{}-{}-{}", corners[cycle[0]], corners[cycle[1]],
                                 corners[cycle[2]], corners[cycle[3]]));
}

std::string canonical_name(const std::string& name) {
    const std::vector<std::string> parts = split_at_hyphens(name);
    if (parts.size() == 2) return made_edge_name(parts[0], parts[1]);
    if (parts.size() == 4) return made_face_name({parts[0], parts[1], parts[2], parts[3]});
    return name;
}

}  // namespace hexweave
