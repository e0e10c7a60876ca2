// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_slips.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "topology/source_text.h"

namespace hexweave {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Columns between the end of a value and what follows on the same line; -1 on another line.
int columns_between(const YamlNode& before, const Place& next) {
    if (before.place.line != next.line) return -1;
    return next.column - before.place.column - before.place.length;
}

/// `start: 0,5`: a whole number, a comma without a space, and digits.
bool mend_decimal_comma(YamlNode& before, const YamlNode& entry, Diagnostics& diagnostics) {
    const bool whole = !before.text.empty() && is_digit(before.text.back()) &&
                       before.text.find_first_not_of("+-0123456789") == std::string::npos;
    if (!whole || !is_digit(entry.key.front()) || columns_between(before, entry.key_place) != 1)
        return false;
    Place place = before.place;
    place.length += 1 + entry.key_place.length;
    diagnostics.error(place,
                      fmt::format("'{},{}' are two values: a comma separates them",
                                  shown(before.text), shown(entry.key)),
                      fmt::format("the decimal separator is the point: write {}.{}",
                                  shown(before.text), shown(entry.key)));
    before.text += "." + entry.key;
    before.place = place;
    return true;
}

/// `max(4, n)` within brackets: a comma inside of parentheses, and what follows it.
bool mend_open_parenthesis(YamlNode& before, const std::string& next, const Place& place,
                           Diagnostics& diagnostics) {
    const auto open = std::count(before.text.begin(), before.text.end(), '(') -
                      std::count(before.text.begin(), before.text.end(), ')');
    const int columns = columns_between(before, place);
    if (open <= 0 || columns < 1) return false;
    before.text += "," + std::string(static_cast<std::size_t>(columns - 1), ' ') + next;
    before.place.length += columns + place.length;
    const auto closed =
        std::count(next.begin(), next.end(), ')') - std::count(next.begin(), next.end(), '(');
    if (closed < open) return true;
    diagnostics.error(before.place,
                      "an expression with a comma must be quoted within {...} and [...]",
                      fmt::format("write \"{}\"", shown(before.text)));
    return true;
}

/// `cells:4`: YAML wants a space behind the colon.
void mend_missing_space(YamlNode& entry, Diagnostics& diagnostics) {
    const std::size_t colon = entry.key.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == entry.key.size()) return;
    const std::string key = entry.key.substr(0, colon);
    diagnostics.error(
        entry.key_place, fmt::format("a space is missing behind the ':' of '{}'", shown(entry.key)),
        fmt::format("write '{}: {}'", shown(key), shown(entry.key.substr(colon + 1))));
    const int length = count_characters(key);
    entry.kind = YamlNode::Kind::scalar;
    entry.text = entry.key.substr(colon + 1);
    entry.place = entry.key_place;
    entry.place.column += length + 1;
    entry.place.length -= length + 1;
    entry.text_column = entry.place.column;
    entry.key_place.length = length;
    entry.key = key;
}

}  // namespace

bool mend_slip(YamlNode* before, YamlNode& entry, Diagnostics& diagnostics) {
    if (!entry.is_null() || entry.key.empty()) return false;
    // A quoted key is meant as it is.
    if (entry.key_place.length != count_characters(entry.key)) return false;
    if (before != nullptr && before->is_scalar() && !before->quoted) {
        if (mend_decimal_comma(*before, entry, diagnostics)) return true;
        if (mend_open_parenthesis(*before, entry.key, entry.key_place, diagnostics)) return true;
    }
    mend_missing_space(entry, diagnostics);
    return false;
}

bool mend_slip_in_list(YamlNode& before, const YamlNode& item, Diagnostics& diagnostics) {
    if (!before.is_scalar() || before.quoted || !item.is_scalar() || item.quoted) return false;
    return mend_open_parenthesis(before, item.text, item.place, diagnostics);
}

}  // namespace hexweave
