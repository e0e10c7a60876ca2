// SPDX-License-Identifier: Apache-2.0
// The table of the file format: every mapping that a case may hold, and every key of it. Readers
// take their keys and words from it, and `hexweave schema`, `hexweave docs` and docs/reference.md
// are printed from it: a key that is not here is refused, and one that is here must be read.
//
// To add a key: give it a line in its mapping in format_*.cpp, and read it. To add a mapping: give
// it an entry there, name it as a form of the key that holds it, and pass its name to
// expect_mapping. Nothing else is needed: the tests run every example through the reader, and tell
// when docs/reference.md is to be printed anew.
#pragma once

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace hexweave {

using Keys = std::vector<std::string_view>;

/// What a number measures.
enum class Quantity { none, length, angle, degrees, fraction };

/// Between which values a number must lie.
struct Limits {
    double above = -std::numeric_limits<double>::infinity();
    double at_least = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    double below = std::numeric_limits<double>::infinity();
};

/// A way in which a value may be written.
struct ValueForm {
    enum class Kind {
        number,       ///< or an expression
        count,        ///< a whole number from 1 on, or an expression
        point,        ///< a list of two or three numbers
        formula,      ///< an expression in variables, `of`
        text,         ///< any
        file,         ///< the path of one
        truth,        ///< true or false
        words,        ///< one of `words`
        name,         ///< of an entry of the kind `of`
        signed_name,  ///< the same, or -name
        axis_plane,   ///< "z = 0"
        list,         ///< of `items`, at least `least` and at most `most` of them
        mapping,      ///< one of the table, named `of`
        entries       ///< a mapping of names, of the kind `of`, to `items`
    };

    Kind kind = Kind::number;
    std::string_view of{};
    Quantity quantity = Quantity::none;
    Limits limits{};
    Keys words{};
    std::vector<ValueForm> items{};  ///< any of these forms
    std::size_t least = 0;
    std::size_t most = 0;  ///< 0: any number; of entries: of the bytes of a name
};

/// In place of a default.
inline constexpr std::string_view key_required = "required";

struct KeyFormat {
    std::string_view key;
    std::vector<ValueForm> values;  ///< any of these forms
    std::string_view absent;        ///< what holds without the key; `key_required`; empty: nothing
    std::string_view meaning;
    /// The key with a value, and the optional keys that must stand beside it: "law: geometric,
    /// ratio: 1.2".
    std::string_view example;
};

struct MappingFormat {
    std::string_view name;  ///< of a newcomer's words where it is a family: "curve_circle"
    std::string_view what;
    std::vector<KeyFormat> keys;
    Keys with{};                 ///< other mappings whose keys may stand here too
    std::vector<Keys> one_of{};  ///< of each of these, exactly one key must be there
};

/// All of it; the first is the case as a whole.
const std::vector<MappingFormat>& format_table();
/// The mapping of a name, or null.
const MappingFormat* find_format(std::string_view name);

/// Mappings of the table by name.
struct FormatNames {
    FormatNames(const char* name) : names{name} {}
    FormatNames(std::initializer_list<const char*> list) : names(list.begin(), list.end()) {}
    explicit FormatNames(std::string name) : names{std::move(name)} {}

    std::vector<std::string> names;
};

/// The keys of some mappings, of which an entry is one: their own in order, then those of the
/// mappings that they name as `with`, each once.
Keys keys_of(const FormatNames& formats);
/// The key of one of some mappings; null where none has it.
const KeyFormat* find_key(const FormatNames& formats, std::string_view key);
/// Those that must be there.
Keys required_keys(std::string_view format);
/// The words that may stand under a key, in the table's order.
const Keys& words_of(std::string_view format, std::string_view key);

}  // namespace hexweave
