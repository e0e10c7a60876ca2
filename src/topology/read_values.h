// SPDX-License-Identifier: Apache-2.0
// Values of the tree as numbers, points, names and choices. Each reader tells what was expected,
// what was found and where, and then returns nothing, so that reading goes on with the next value.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnostics.h"
#include "core/vec3.h"
#include "topology/case.h"
#include "topology/expressions.h"
#include "topology/format_table.h"
#include "topology/source_text.h"
#include "topology/suggestions.h"
#include "topology/text_limit.h"
#include "topology/yaml_tree.h"

namespace hexweave {

struct CadFile;

/// A key that was told as unknown though it is near to a legal one, which is not there: its value
/// is then read as that of the key that was meant, so that one slip is one fault.
struct MisspelledKey {
    const YamlNode* mapping = nullptr;
    const YamlNode* value = nullptr;
    std::string meant;
};

/// What expect_mapping knew of the mappings that it saw: for the hints about their values.
struct SeenMappings {
    std::map<const YamlNode*, FormatNames> formats{};      ///< by mapping
    std::map<const YamlNode*, const KeyFormat*> key_of{};  ///< by value of a key that was known
};

/// What all parts of reading share.
struct Reading {
    Diagnostics& diagnostics;
    std::shared_ptr<const SourceFile> source;
    ParameterScope parameters{};
    std::vector<MisspelledKey> misspelled{};
    SeenMappings seen{};
    std::string units = "m";  ///< of the case's lengths
    /// CAD files by their path; null where a fault has been told.
    std::map<std::string, std::shared_ptr<const CadFile>> cad_files{};
    std::vector<std::shared_ptr<const SourceFile>> included{};  ///< files, in order
    std::vector<std::shared_ptr<InstanceScope>> scopes{};       ///< each behind that it stands in
    std::vector<LeftOutEntry> left_out{};
    std::vector<Name> files{};                    ///< data files and included ones: their paths
    std::vector<std::string> lost_sections{};     ///< keys of those that could not be read
    std::vector<std::string> lost_scopes{};       ///< "root." of instances that could not be made
    int repeated = 0;                             ///< entries that repetition has made
    std::map<std::string, YamlNode> replaced{};   ///< parameters that an include gives a value
    std::map<std::string, YamlNode> overrides{};  ///< that the command line gives one
};

/// A key that is refused with its own words rather than as unknown.
struct RefusedKey {
    std::string_view key;
    std::string_view message;
    std::string_view hint;
};

/// The parameters that the expressions of a node may use.
ParameterScope& parameters_at(Reading& reading, const YamlNode& node);

/// In `what`, below: the words for the value or entry, as in "edge 'wake'" or "'chord'".

/// A list, a mapping, nothing, '...'.
std::string describe(const YamlNode& node);
/// The place of a fault inside of a scalar's expression.
Place place_in(const YamlNode& node, std::size_t offset, std::size_t length);

/// Whether the node is a mapping of keys that the format's table has for one of `formats`; tells
/// what is not. Unknown keys alone do not make it false: the known ones are still to be read.
bool expect_mapping(Reading& reading, const YamlNode& node, const std::string& what,
                    const FormatNames& formats, const std::vector<RefusedKey>& refused = {});
/// The value of a key, after expect_mapping; null where it is not there.
const YamlNode* find(const Reading& reading, const YamlNode& mapping, std::string_view key);
/// How the key of a value is written, for a hint, after expect_mapping; empty where the value is of
/// none.
std::string usage_of(const Reading& reading, const YamlNode& value);
/// Forgets the mappings that are seen, but for `kept`: nodes that are no more.
void forget_mappings(Reading& reading, const YamlNode& kept);
/// Whether expect_mapping found misspelled keys there.
bool has_misspelled(const Reading& reading, const YamlNode& mapping);
/// The value of a key that must be there; after expect_mapping.
const YamlNode* require(Reading& reading, const YamlNode& mapping, std::string_view key,
                        const std::string& what);
/// Tells together which of some keys are lacking.
void tell_lacking(Reading& reading, const YamlNode& mapping, const Keys& keys,
                  const std::string& what);
/// Whether the node is a list; with `count` > 0, of that many items.
bool expect_list(Reading& reading, const YamlNode& node, const std::string& what,
                 std::size_t count = 0);

/// A finite number.
std::optional<double> read_number(Reading& reading, const YamlNode& node, const std::string& what);
std::optional<double> read_positive(Reading& reading, const YamlNode& node,
                                    const std::string& what);
/// A whole number between 1 and ten million; `too_many` makes the hint for more.
std::optional<int> read_count(Reading& reading, const YamlNode& node, const std::string& what,
                              std::string (*too_many)(double) = nullptr);
/// The number under the key 'multiple_of', if it is there.
std::optional<Located<int>> read_multiple_of(Reading& reading, const YamlNode& mapping);
/// Two or three numbers.
std::optional<Vec3> read_point(Reading& reading, const YamlNode& node, const std::string& what);
/// A formula of t.
std::optional<std::function<double(double)>> read_formula(Reading& reading, const YamlNode& node,
                                                          const std::string& what);
/// The `true` or `false` under a key; false where the key is not there.
std::optional<bool> read_switch(Reading& reading, const YamlNode& mapping, std::string_view key);
/// A formula of u and v.
std::optional<std::function<double(double, double)>> read_formula_of_uv(Reading& reading,
                                                                        const YamlNode& node,
                                                                        const std::string& what);
/// Any text, not empty.
std::optional<std::string> read_text(Reading& reading, const YamlNode& node,
                                     const std::string& what);
/// The position of the node's text among `choices`.
std::optional<std::size_t> read_choice(Reading& reading, const YamlNode& node,
                                       const std::string& what, const Keys& choices);

/// The name that a key defines: letters, digits and underscores, not what YAML takes for a switch,
/// at most `longest` bytes.
bool check_new_name(Reading& reading, const YamlNode& node, const std::string& kind,
                    std::size_t longest = longest_name_given);
/// The use of a name; an empty name, after an error, where there is none. Hyphens may stand in it:
/// edges and faces that are made rather than drawn are called a-b.
Name read_name(Reading& reading, const YamlNode& node, const std::string& what);
/// The same with an optional sign in front.
SignedName read_signed_name(Reading& reading, const YamlNode& node, const std::string& what);
/// One name or a list of different ones; an empty name among them after an error. Not empty.
std::vector<Name> read_names(Reading& reading, const YamlNode& node, const std::string& what);

}  // namespace hexweave
