// SPDX-License-Identifier: Apache-2.0
#include "io/format_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "io/format_words.h"
#include "topology/format_table.h"

namespace hexweave {
namespace {

constexpr std::size_t line_width = 110;

constexpr std::string_view introduction = R"(# Format reference

Every key of a case, as the reader knows it: printed by `hexweave docs`, not written by hand. `hexweave docs KEY` prints a
part of it, `hexweave schema` the same for editors. The [guide](format.md) explains how things work together.

What stands where:

- A number, length, angle, fraction or whole number may be an [expression](format.md#expressions) in parameters: `20 * chord`.
- A point is `[x, y]` or `[x, y, z]`, a vector too. Lengths are in the `units` of the case; angles in radians unless said.
- A name is letters, digits and underscores, no digit first, and not what YAML reads as true or false: `y`, `n`, `yes`, `no`, `on`,
  `off`, `true`, `false`. An edge or face that nobody drew is named after its corners: `a-b`.
- Where several types are possible, each is told; "required" keys must be there; without a default the key does nothing when it
  is absent.
)";

using Forms = std::vector<ValueForm>;

/// The mappings that values of these forms may be, in order.
void collect_mappings(const Forms& forms, Keys& names) {
    for (const ValueForm& form : forms) {
        if (form.kind == ValueForm::Kind::mapping) names.push_back(form.of);
        collect_mappings(form.items, names);
    }
}

Keys mappings_in(const MappingFormat& format) {
    Keys names;
    for (const KeyFormat& key : format.keys) collect_mappings(key.values, names);
    return names;
}

/// A mapping and all that stands in it; the mappings whose keys it shares with others go to
/// `shared`.
void visit(std::string_view name, std::vector<const MappingFormat*>& order, Keys& shared) {
    const MappingFormat* format = find_format(name);
    if (format == nullptr || std::find(order.begin(), order.end(), format) != order.end()) return;
    order.push_back(format);
    for (const std::string_view inner : mappings_in(*format)) visit(inner, order, shared);
    shared.insert(shared.end(), format->with.begin(), format->with.end());
}

/// The case, then what stands under each of its keys: every mapping after the one that first holds
/// it, and at the end what several of them share.
std::vector<const MappingFormat*> reading_order() {
    const MappingFormat& whole = format_table().front();
    std::vector<const MappingFormat*> order{&whole};
    for (const KeyFormat& key : whole.keys) {
        Keys names;
        collect_mappings(key.values, names);
        while (!names.empty()) {
            Keys shared;
            for (const std::string_view name : names) visit(name, order, shared);
            names = shared;
        }
    }
    return order;
}

std::string link_to(std::string_view name) {
    std::string anchor(name);
    std::replace(anchor.begin(), anchor.end(), '_', '-');
    return fmt::format("[{}](#{})", format_title(name), anchor);
}

/// Text in lines of at most `line_width` where words allow; lines after the first are indented.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::string lines;
    std::size_t column = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (column > indent && column + 1 + end - begin > line_width) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (begin > 0) {
            lines += ' ';
            ++column;
        }
        lines.append(text, begin, end - begin);
        column += end - begin;
        begin = end + 1;
    }
    return lines + '\n';
}

std::string default_text(const KeyFormat& key) {
    if (key.absent == key_required) return "required";
    if (key.absent.empty()) return "optional";
    if (has_literal_default(key)) return fmt::format("default `{}`", key.absent);
    return fmt::format("default: {}", key.absent);
}

/// A key as an item of a list, its example beneath.
std::string key_text(const KeyFormat& key, const MappingText& mapping) {
    const std::string told = fmt::format("- **`{}`**: {}. *{}; {}.*", key.key, key.meaning,
                                         type_of(key.values, mapping), default_text(key));
    return wrapped(told, 2) + fmt::format("  Example: `{}`\n", key.example);
}

/// "Exactly one of `at` and `near` must be there."
std::string choice_text(const Keys& choice) {
    std::vector<std::string> keys;
    for (const std::string_view key : choice) keys.push_back(fmt::format("`{}`", key));
    return fmt::format("\nExactly one of {} must be there.\n", fmt::join(keys, ", "));
}

std::string mapping_text(const MappingFormat& format, const MappingText& mapping) {
    std::string text = fmt::format("\n## {}\n\n{}\n\n", format_title(format.name), format.what);
    for (const KeyFormat& key : format.keys) text += key_text(key, mapping);
    for (const Keys& choice : format.one_of) text += choice_text(choice);
    if (format.with.empty()) return text;
    std::vector<std::string> others;
    for (const std::string_view other : format.with) others.push_back(mapping(other));
    return text + fmt::format("\nAnd the keys of: {}.\n", fmt::join(others, ", "));
}

/// The sections of these mappings that are not yet told.
std::string sections(const Keys& mappings, std::set<std::string_view>& told) {
    std::string text;
    for (const std::string_view mapping : mappings) {
        const MappingFormat* format = find_format(mapping);
        if (format == nullptr || !told.insert(format->name).second) continue;
        text += mapping_text(*format, format_title);
    }
    return text;
}

}  // namespace

std::string format_reference() {
    std::string text(introduction);
    for (const MappingFormat* format : reading_order()) text += mapping_text(*format, link_to);
    return text;
}

std::string format_reference_of(const std::string& topic) {
    std::string name = topic;
    std::replace(name.begin(), name.end(), ' ', '_');
    Keys named;
    if (const MappingFormat* format = find_format(name)) {
        named.push_back(format->name);
        named.insert(named.end(), format->with.begin(), format->with.end());
    }
    Keys held;
    std::string uses;
    for (const MappingFormat* format : reading_order()) {
        for (const KeyFormat& key : format->keys) {
            if (key.key != name) continue;
            uses += fmt::format("\nIn {}:\n\n{}", format_title(format->name),
                                key_text(key, format_title));
            collect_mappings(key.values, held);
        }
    }
    std::set<std::string_view> told;
    std::string text = sections(named, told) + uses;
    text += sections(held, told);
    return text.substr(std::min<std::size_t>(text.size(), 1));  // without the empty line above
}

std::vector<std::string> reference_topics() {
    std::set<std::string> topics;
    for (const MappingFormat& format : format_table()) {
        topics.insert(format_title(format.name));
        for (const KeyFormat& key : format.keys) topics.insert(std::string(key.key));
    }
    return {topics.begin(), topics.end()};
}

}  // namespace hexweave
