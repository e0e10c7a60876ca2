// SPDX-License-Identifier: Apache-2.0
#include "topology/includes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "topology/expand_entries.h"
#include "topology/read_data_file.h"
#include "topology/read_parameters.h"

namespace hexweave {

namespace {

/// Files that are being merged, by their one true path, with where each was first named.
struct Merge {
    Reading& reading;
    std::map<std::filesystem::path, Place> files;
};

YamlNode merged(Merge& merge, YamlNode root);

std::filesystem::path true_path(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
    return error ? path : canonical;
}

/// Whether a place is in a file, or in one that the file includes.
bool is_within(const Place& place, const std::filesystem::path& file) {
    if (place.file && true_path(place.file->name) == file) return true;
    return place.used_by && is_within(place.used_by->place, file);
}

/// How many files lie between a place and the case.
int depth_of(const Place& place) {
    int depth = 0;
    for (const Note* user = place.used_by.get(); user != nullptr;
         user = user->place.used_by.get()) {
        ++depth;
    }
    return depth;
}

/// False, after an error, for a file that is part of the case already, or too deep in it.
bool enter_file(Merge& merge, const YamlNode& name) {
    constexpr int most_nested = 20;
    if (depth_of(name.place) >= most_nested) {
        merge.reading.diagnostics.error(
            name.place, fmt::format("files include one another more than {} deep", most_nested),
            "include the innermost files from a file further out");
        return false;
    }
    const std::filesystem::path path = true_path(path_of_file(name));
    if (is_within(name.place, path)) {
        merge.reading.diagnostics.error(name.place,
                                        fmt::format("'{}' includes itself", shown(name.text)),
                                        "take this include out");
        return false;
    }
    const auto [first, is_new] = merge.files.emplace(path, name.place);
    if (is_new) return true;
    Diagnostic& d = merge.reading.diagnostics.error(
        name.place, fmt::format("the file '{}' is included twice", shown(name.text)),
        "include it once; a part that is needed several times is a component");
    d.notes.push_back({first->second, "first included here"});
    return false;
}

/// The tree of an included file; nothing after an error. What is wrong with its YAML is told as of
/// the file that includes it, too.
std::optional<YamlNode> read_tree(Merge& merge, const YamlNode& name) {
    const auto contents = read_data_file(merge.reading, name, "an included file");
    if (!contents || !enter_file(merge, name)) return std::nullopt;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{path_of_file(name).string(), contents->text});
    merge.reading.included.push_back(source);
    const auto user = std::make_shared<const Note>(Note{name.place, "included here"});

    Diagnostics faults;
    std::optional<YamlNode> root = read_yaml(source, faults);
    for (const Diagnostic& fault : faults.all()) {
        Place place = fault.place;
        place.used_by = user;
        merge.reading.diagnostics.error(place, fault.message, fault.hint).notes = fault.notes;
    }
    if (!root) return std::nullopt;
    mark_used_by(*root, user);
    if (!root->is_mapping()) {
        merge.reading.diagnostics.error(
            root->place, fmt::format("an included file must be a mapping, not {}", describe(*root)),
            "it begins with 'hexweave: 1'");
        return std::nullopt;
    }
    return check_version(merge.reading, *root) ? root : std::nullopt;
}

/// Notes the values that an include gives to parameters of the file; tells what it has not.
void set_parameters(Merge& merge, const YamlNode& set, const YamlNode& root) {
    Reading& reading = merge.reading;
    if (!set.is_mapping()) {
        reading.diagnostics.error(
            set.place, fmt::format("'set' must be a mapping of parameters, not {}", describe(set)),
            usage_of(reading, set));
        return;
    }
    const YamlNode* section = root.find("parameters");
    Keys known;
    if (section != nullptr) {
        for (const YamlNode& parameter : section->children) known.emplace_back(parameter.key);
    }
    for (const YamlNode& value : set.children) {
        if (std::find(known.begin(), known.end(), value.key) == known.end()) {
            reading.diagnostics.error(
                value.key_place,
                fmt::format("unknown parameter '{}' of the included file", shown(value.key)),
                known.empty() ? "it has no parameters"
                              : suggestion(value.key, known, "its parameters are"));
        } else {
            reading.replaced.insert_or_assign(value.key, value);
        }
    }
}

/// Whether the condition of an include holds, by the parameters of the file that it stands in.
bool is_wanted(Merge& merge, const YamlNode& when, const YamlNode& root) {
    Reading& reading = merge.reading;
    Diagnostics told_later;
    Reading own{told_later, reading.source};
    own.replaced = reading.replaced;
    own.overrides = reading.overrides;
    read_parameters(own, root.find("parameters"));
    Diagnostics faults;
    Reading condition{faults, reading.source};
    condition.parameters = own.parameters;
    const std::optional<double> value = read_number(condition, when, "'when'");
    reading.parameters.used.merge(condition.parameters.used);
    for (const Diagnostic& fault : faults.all()) {
        const bool unknown = fault.hint.find("known parameters are") == 0;
        reading.diagnostics.error(fault.place, fault.message,
                                  unknown ? "the condition of an include may use the parameters of "
                                            "the file that it stands in"
                                          : fault.hint);
    }
    if (!value && faults.all().empty()) {
        reading.diagnostics.error(
            when.place, "a parameter in this condition cannot be computed before the include",
            "use parameters that depend on those of this file alone");
    }
    return value && *value != 0;
}

/// One item of `include:`: a file, or a mapping with one; empty where it is not wanted or faulty.
std::optional<YamlNode> included(Merge& merge, const YamlNode& item, const YamlNode& root) {
    Reading& reading = merge.reading;
    const YamlNode* name = &item;
    const YamlNode* set = nullptr;
    if (item.is_mapping()) {
        expect_mapping(reading, item, "an include", "include");
        const YamlNode* when = find(reading, item, "when");
        if (when != nullptr && !is_wanted(merge, *when, root)) return std::nullopt;
        name = require(reading, item, "file", "an include");
        set = find(reading, item, "set");
    }
    std::optional<YamlNode> tree;
    if (name != nullptr) tree = read_tree(merge, *name);
    if (!tree) return std::nullopt;
    tree = merged(merge, std::move(*tree));
    if (set != nullptr) set_parameters(merge, *set, *tree);
    return tree;
}

/// The entries of a section behind those that are there; tells names that are there already.
void append_entries(Merge& merge, YamlNode& section, const YamlNode& more) {
    std::map<std::string_view, const Place*> known;
    for (const YamlNode& entry : section.children) known.emplace(entry.key, &entry.key_place);
    std::vector<YamlNode> added;
    for (const YamlNode& entry : more.children) {
        const auto first = known.find(entry.key);
        if (first == known.end()) {
            added.push_back(entry);
            continue;
        }
        const bool parameter = section.key == "parameters";
        Diagnostic& d = merge.reading.diagnostics.error(
            entry.key_place,
            fmt::format("'{}' is given twice under '{}'", shown(entry.key), section.key),
            parameter ? "to give a parameter of an included file another value, write "
                        "include: {file: ..., set: {NAME: EXPRESSION}}"
                      : "files that include one another share their names");
        d.notes.push_back({*first->second, "first given here"});
    }
    std::move(added.begin(), added.end(), std::back_inserter(section.children));
}

/// A key that can stand in one of the files only; `title` is that of the file that includes.
void replace_single(Merge& merge, YamlNode& there, const YamlNode& other) {
    const bool same_text = there.is_scalar() && other.is_scalar() && there.text == other.text;
    if (other.key != "title" && !same_text) {
        Diagnostic& d = merge.reading.diagnostics.error(
            other.key_place, fmt::format("'{}' is given in two files", other.key),
            other.key == "units" ? "files that include one another must have the same units"
                                 : "give it in one of them");
        d.notes.push_back({there.key_place, "first given here"});
    }
    there = other;
}

void append_file(Merge& merge, YamlNode& whole, const YamlNode& file) {
    for (const YamlNode& section : file.children) {
        if (section.key == "include") continue;
        const auto there =
            std::find_if(whole.children.begin(), whole.children.end(),
                         [&](const YamlNode& other) { return other.key == section.key; });
        if (there == whole.children.end()) {
            whole.children.push_back(section);
        } else if (there->is_mapping() && section.is_mapping() && holds_entries(section.key)) {
            append_entries(merge, *there, section);
        } else if (there->is_null() || !section.is_null()) {
            replace_single(merge, *there, section);
        }
    }
}

YamlNode merged(Merge& merge, YamlNode root) {
    const YamlNode* include = root.find("include");
    if (include == nullptr) return root;
    YamlNode whole = root;
    whole.children.clear();
    const auto add = [&](const YamlNode& item) {
        if (const auto file = included(merge, item, root)) append_file(merge, whole, *file);
    };
    if (include->is_sequence()) {
        for (const YamlNode& item : include->children) add(item);
    } else if (!include->is_null()) {
        add(*include);
    }
    append_file(merge, whole, root);
    return whole;
}

}  // namespace

YamlNode merge_includes(Reading& reading, YamlNode root) {
    Merge merge{reading, {}};
    return merged(merge, std::move(root));
}

bool check_version(Reading& reading, const YamlNode& root) {
    const YamlNode* version = find(reading, root, "hexweave");
    if (version == nullptr) {
        Place whole = root.place;
        whole.line = whole.column = 0;
        whole.length = 1;
        reading.diagnostics.error(whole, "the key 'hexweave' is missing",
                                  "a case begins with the version of its format, 'hexweave: 1'");
        return true;
    }
    if (version->is_scalar() && version->text == "1") return true;
    reading.diagnostics.error(
        version->place,
        fmt::format("the version of the format must be 1, not {}", describe(*version)),
        "write 'hexweave: 1'");
    return !version->is_scalar();
}

void mark_used_by(YamlNode& node, const std::shared_ptr<const Note>& user) {
    node.place.used_by = user;
    node.key_place.used_by = user;
    for (YamlNode& child : node.children) mark_used_by(child, user);
}

}  // namespace hexweave
