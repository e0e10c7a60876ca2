// SPDX-License-Identifier: Apache-2.0
#include "core/diagnostics.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/utf8.h"

namespace hexweave {

namespace {

/// One character of a source line as it is shown: a tab stays a tab, a control character or a
/// broken UTF-8 sequence becomes '?'.
struct ShownCharacter {
    std::string text;
    int width = 1;  ///< terminal columns; a tab has -1
};

/// Columns that a terminal gives to a character: none to combining marks, two to East Asian wide
/// characters and emoji.
int width_of(std::uint32_t c) {
    using Range = std::pair<std::uint32_t, std::uint32_t>;
    static constexpr std::array<Range, 5> none{
        {{0x300, 0x36F}, {0x200B, 0x200F}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}}};
    static constexpr std::array<Range, 9> wide{{{0x1100, 0x115F},
                                                {0x2E80, 0xA4CF},
                                                {0xAC00, 0xD7A3},
                                                {0xF900, 0xFAFF},
                                                {0xFE30, 0xFE6F},
                                                {0xFF00, 0xFF60},
                                                {0xFFE0, 0xFFE6},
                                                {0x1F300, 0x1FAFF},
                                                {0x20000, 0x3FFFD}}};
    const auto holds = [c](const Range& r) { return c >= r.first && c <= r.second; };
    if (std::any_of(none.begin(), none.end(), holds)) return 0;
    return std::any_of(wide.begin(), wide.end(), holds) ? 2 : 1;
}

ShownCharacter shown(std::string_view bytes, const Utf8Character& c) {
    if (c.code == '\t' && c.valid) return {"\t", -1};
    const bool control = c.code < 0x20 || (c.code >= 0x7F && c.code < 0xA0);
    if (!c.valid || control) return {"?", 1};
    return {std::string(bytes.substr(0, c.bytes)), width_of(c.code)};
}

/// The offset of character `number` of a line, from 0; its end where it is shorter.
std::size_t offset_of(std::string_view line, int number) {
    std::size_t at = 0;
    for (int n = 0; at < line.size(); ++at) {
        if (!is_utf8_continuation(line[at]) && n++ == number) break;
    }
    return at;
}

/// The first characters of a text, at most `most`.
std::vector<ShownCharacter> characters(std::string_view text, int most) {
    std::vector<ShownCharacter> result;
    for (int n = 0; n < most && !text.empty(); ++n) {
        const Utf8Character c = decode_utf8(text);
        result.push_back(shown(text, c));
        text.remove_prefix(c.bytes);
    }
    return result;
}

/// Line `number` of a text, counted from 1, without its line break or byte order mark.
std::string_view line_of(std::string_view text, int number) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    for (int i = 1; i < number; ++i) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
}

/// The characters of a line that are shown: of a long one only a window round the caret, so that a
/// message stays a few lines. `column` is moved with them.
std::vector<ShownCharacter> shown_part(std::string_view line, int& column) {
    constexpr int window = 120;
    constexpr int before = 60;
    const ShownCharacter dots{"...", 3};
    if (offset_of(line, window + before) == line.size()) return characters(line, window + before);
    const int begin = std::max(0, column - before);
    line.remove_prefix(offset_of(line, begin));
    std::vector<ShownCharacter> part = characters(line, window);
    if (offset_of(line, window) < line.size()) part.push_back(dots);
    if (begin > 0) {
        part.insert(part.begin(), dots);
        column -= begin - 1;
    }
    return part;
}

/// The source line and, where the column is known, the caret line under it.
std::string excerpt(const Place& place) {
    if (!place.file || place.line < 1) return {};
    int column = place.column;
    const std::vector<ShownCharacter> line =
        shown_part(line_of(place.file->text, place.line), column);

    std::string text;
    for (const ShownCharacter& c : line) text += c.text;
    text += '\n';
    if (column < 1) return text;

    std::string under;
    const auto caret = static_cast<std::size_t>(column - 1);
    for (std::size_t i = 0; i < std::min(caret, line.size()); ++i) {
        under +=
            line[i].width < 0 ? "\t" : std::string(static_cast<std::size_t>(line[i].width), ' ');
    }
    if (caret >= line.size()) return text + under + "^\n";
    int columns = 0;
    const auto length = static_cast<std::size_t>(std::max(1, place.length));
    for (std::size_t i = caret; i < std::min(caret + length, line.size()); ++i) {
        columns += std::abs(line[i].width);
    }
    return text + under + '^' +
           std::string(static_cast<std::size_t>(std::max(1, columns) - 1), '~') + '\n';
}

/// `wing.yaml:42:9: ` as far as it is known.
std::string prefix(const Place& place) {
    if (!place.file) return {};
    std::string text = place.file->name;
    if (place.line > 0) text += ':' + std::to_string(place.line);
    if (place.line > 0 && place.column > 0) text += ':' + std::to_string(place.column);
    return text + ": ";
}

void add_users(std::vector<Note>& notes, const Place& place) {
    for (const Note* user = place.used_by.get(); user != nullptr;
         user = user->place.used_by.get()) {
        notes.push_back(*user);
    }
}

/// A text with the names of a scope as they are written within it.
std::string within_scope(std::string text, const std::string& scope) {
    if (scope.empty()) return text;
    const auto in_name = [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '.';
    };
    std::size_t at = text.find(scope);
    while (at != std::string::npos) {
        if (at == 0 || !in_name(static_cast<unsigned char>(text[at - 1]))) {
            text.erase(at, scope.size());
        } else {
            at += scope.size();
        }
        at = text.find(scope, at);
    }
    return text;
}

/// Tells of further users of the place of a diagnostic, for which it says the same.
void add_other_users(Diagnostic& diagnostic, const std::vector<const Note*>& others) {
    if (others.empty()) return;
    const Note& first = *others.front();
    const std::string more =
        others.size() == 1 ? "" : " and " + std::to_string(others.size() - 1) + " more";
    const std::string name = first.scope.substr(0, first.scope.size() - 1);
    diagnostic.notes.push_back({first.place, "and in '" + name + "'" + more});
}

/// A text of bounded length: what is too long is shown with its beginning and its end.
std::string without_middle(std::string text) {
    constexpr std::size_t longest = 1000;
    constexpr std::size_t end_shown = 400;
    if (text.size() <= longest) return text;
    std::size_t cut = longest - end_shown;
    while (cut > 0 && is_utf8_continuation(text[cut])) --cut;
    std::size_t end = text.size() - end_shown;
    while (end < text.size() && is_utf8_continuation(text[end])) ++end;
    return text.replace(cut, end - cut, " ... ");
}

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Insertions, deletions, substitutions and swaps of neighbours that lead from a to b; `most` or
/// more where they are so many.
std::size_t edit_distance(const std::string& a, const std::string& b, std::size_t most) {
    if (a.size() >= b.size() + most || b.size() >= a.size() + most) return most;
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> before(width);
    std::vector<std::size_t> above(width);
    std::vector<std::size_t> row(width);
    for (std::size_t j = 0; j < width; ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before, above);
        std::swap(above, row);
        row[0] = i;
        for (std::size_t j = 1; j < width; ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        // A later row follows from this one or, by a swap, from the one above it.
        const auto least = [](const auto& r) { return *std::min_element(r.begin(), r.end()); };
        if (least(row) >= most && least(above) >= most) return most;
    }
    return row.back();
}

}  // namespace

Diagnostic& Diagnostics::add(Diagnostic diagnostic) {
    Count& kind = count(diagnostic.severity);
    ++kind.found;
    diagnostic.message = without_middle(std::move(diagnostic.message));
    diagnostic.hint =
        without_middle(within_scope(std::move(diagnostic.hint), scope_at(diagnostic.place)));
    if (kind.kept == most_kept) return not_kept_ = std::move(diagnostic);
    ++kind.kept;
    return all_.emplace_back(std::move(diagnostic));
}

Diagnostic& Diagnostics::error(Place place, std::string message, std::string hint) {
    if (errors_.kept == most_kept) {
        ++errors_.found;
        sort();
        throw InputError(*this);
    }
    return add({Severity::error, std::move(place), std::move(message), std::move(hint), {}});
}

Diagnostic& Diagnostics::warning(Place place, std::string message, std::string hint) {
    return add({Severity::warning, std::move(place), std::move(message), std::move(hint), {}});
}

void Diagnostics::sort() {
    using Key = std::tuple<std::size_t, int, int>;  // file in order of appearance, line, column
    std::map<std::string, std::size_t> files;
    std::vector<std::pair<Key, Diagnostic>> keyed;
    for (Diagnostic& d : all_) {
        const std::string name = d.place.file ? d.place.file->name : std::string();
        const std::size_t file = files.emplace(name, files.size()).first->second;
        keyed.emplace_back(Key(file, d.place.line, d.place.column), std::move(d));
    }
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });

    all_.clear();
    std::map<std::tuple<Key, Severity, std::string>, std::size_t> told;
    std::vector<std::vector<const Note*>> others;
    for (auto& [key, d] : keyed) {
        const std::string& scope = scope_at(d.place);
        const auto [first, is_new] =
            told.emplace(std::tuple(key, d.severity, within_scope(d.message, scope)), all_.size());
        if (is_new) {
            all_.push_back(std::move(d));
            others.emplace_back();
            continue;
        }
        --count(d.severity).found;
        --count(d.severity).kept;
        if (!scope.empty() && scope != scope_at(all_[first->second].place)) {
            others[first->second].push_back(d.place.used_by.get());
        }
    }
    for (std::size_t i = 0; i < all_.size(); ++i) add_other_users(all_[i], others[i]);
}

const std::string& scope_at(const Place& place) {
    static const std::string none;
    return place.used_by ? place.used_by->scope : none;
}

std::vector<Note> all_notes(const Diagnostic& diagnostic) {
    std::vector<Note> notes;
    add_users(notes, diagnostic.place);
    for (const Note& note : diagnostic.notes) {
        notes.push_back(note);
        if (note.place.used_by != diagnostic.place.used_by) add_users(notes, note.place);
    }
    return notes;
}

std::string render(const Diagnostic& diagnostic) {
    const char* severity = diagnostic.severity == Severity::error ? "error: " : "warning: ";
    std::string text = prefix(diagnostic.place) + severity + diagnostic.message + '\n';
    text += excerpt(diagnostic.place);
    for (const Note& note : all_notes(diagnostic)) {
        text += prefix(note.place) + "note: " + note.message + '\n' + excerpt(note.place);
    }
    if (!diagnostic.hint.empty()) text += "  hint: " + diagnostic.hint + '\n';
    return text;
}

std::string render(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics.all()) text += render(d);
    const auto warnings =
        std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                      [](const Diagnostic& d) { return d.severity == Severity::warning; });
    if (diagnostics.warnings() > warnings) {
        text += "and " + std::to_string(diagnostics.warnings() - warnings) + " more warnings\n";
    }
    return text;
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    // Of very many names some are near by chance, and to look through them takes long.
    constexpr std::size_t most_known = 20'000;
    if (known.size() > most_known) return {};
    std::string nearest;
    std::size_t least = std::min<std::size_t>(name.size() / 3, 3) + 1;
    const std::string written = lower_case(name);
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(written, lower_case(candidate), least);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace hexweave
