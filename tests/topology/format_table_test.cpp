// SPDX-License-Identifier: Apache-2.0
// The table of the format against the readers: what is in it is read, what is not is refused.
#include "topology/format_table.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "geometry/cad.h"
#include "topology/read_case.h"
#include "topology/yaml_tree.h"

using namespace hexweave;

namespace {

using Kind = ValueForm::Kind;

/// Where a mapping stands: under a key of another one, within lists and names.
struct Holder {
    const MappingFormat* format = nullptr;
    const KeyFormat* key = nullptr;
    std::string before;  ///< of its text, after "key: "
    std::string after;
};

/// How a value of one of `forms` may hold the mapping `name`: what stands before and behind it.
std::optional<std::pair<std::string, std::string>> way_to(const std::vector<ValueForm>& forms,
                                                          std::string_view name) {
    for (const ValueForm& form : forms) {
        if (form.kind == Kind::mapping && form.of == name) return {{"", ""}};
        const auto inner = way_to(form.items, name);
        if (!inner) continue;
        const bool list = form.kind == Kind::list;
        return {{(list ? "[" : "{entry: ") + inner->first, inner->second + (list ? "]" : "}")}};
    }
    return std::nullopt;
}

std::optional<Holder> holder_of(std::string_view name) {
    for (const MappingFormat& format : format_table()) {
        for (const KeyFormat& key : format.keys) {
            if (const auto way = way_to(key.values, name)) {
                return Holder{&format, &key, way->first, way->second};
            }
        }
        if (std::find(format.with.begin(), format.with.end(), name) != format.with.end()) {
            return Holder{&format, nullptr, "", ""};
        }
    }
    return std::nullopt;
}

std::set<std::string> keys_in(const std::string& flow) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<const SourceFile>(SourceFile{"example", "{" + flow + "}"});
    const auto root = read_yaml(source, diagnostics);
    INFO(flow << "\n" << render(diagnostics));
    REQUIRE(root);
    REQUIRE(root->is_mapping());
    std::set<std::string> keys;
    for (const YamlNode& child : root->children) keys.insert(child.key);
    return keys;
}

/// The inside of a mapping: `flow`, and what else must be there.
std::string completed(const MappingFormat& format, std::string flow) {
    std::set<std::string> there = keys_in(flow);
    const auto add = [&](const KeyFormat& key) {
        if (!there.insert(std::string(key.key)).second) return;
        flow += (flow.empty() ? "" : ", ") + std::string(key.example);
    };
    for (const KeyFormat& key : format.keys) {
        if (key.absent == key_required) add(key);
    }
    for (const Keys& choice : format.one_of) {
        const bool chosen = std::any_of(choice.begin(), choice.end(), [&](std::string_view key) {
            return there.contains(std::string(key));
        });
        if (chosen) continue;
        for (const KeyFormat& key : format.keys) {
            if (key.key == choice.front()) add(key);
        }
    }
    return flow;
}

/// The whole of a case in which a mapping has this inside, as a line of YAML.
std::string case_with(const MappingFormat& format, const std::string& inside) {
    const std::string whole = completed(format, inside);
    if (format.name == "case") return whole;
    const auto holder = holder_of(format.name);
    INFO(format.name);
    REQUIRE(holder);
    if (holder->key == nullptr) return case_with(*holder->format, whole);
    return case_with(*holder->format, std::string(holder->key->key) + ": " + holder->before + "{" +
                                          whole + "}" + holder->after);
}

/// What examples speak of.
const std::map<std::string, std::string> known{
    {"components",
     "strip: {parameters: {length: 1}, ports: {entry: a, outlet: a}, vertices: {a: [0, 0], b: "
     "[length, 0]}}"},
    {"curves", "root: {line: [[0, 1, 0], [1, 1, 0]]}, tip: {line: [[0, 0.2, 1], [1, 0.2, 1]]}"},
    {"surfaces", "wing: {plane: {point: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0]}}"},
    {"instances", "main: {of: strip}"}};

/// A case's flow text as the text of a file in which the names of examples are known.
std::string with_known_names(const std::string& flow) {
    std::string text = "{" + flow + "}";
    for (const auto& [section, entries] : known) {
        const std::size_t at = text.find(section + ": {");
        const bool there = keys_in(flow).contains(section);
        if (there) {
            text.insert(at + section.size() + 3, entries + ", ");
        } else {
            text.insert(1, section + ": {" + entries + "}, ");
        }
    }
    return text;
}

/// The errors of reading a case; unused names are no matter here.
Diagnostics read(const std::string& text) {
    Diagnostics diagnostics;
    const std::string name = HEXWEAVE_SOURCE_DIR "/tests/cases/examples/example.yaml";
    read_case(std::make_shared<const SourceFile>(SourceFile{name, text}), {}, diagnostics);
    diagnostics.sort();
    return diagnostics;
}

bool needs_cad(const std::string& text) {
    return text.find("cad: ") != std::string::npos && !can_read_cad();
}

}  // namespace

TEST_CASE("the example of every key of the format's table is read without a fault") {
    int examples = 0;
    for (const MappingFormat& format : format_table()) {
        for (const KeyFormat& key : format.keys) {
            const std::string example(key.example);
            INFO(format.name << ": " << key.key);
            CHECK(keys_in(example).contains(std::string(key.key)));
            const std::string text = with_known_names(case_with(format, example));
            if (needs_cad(text)) continue;
            const Diagnostics faults = read(text);
            INFO(text << "\n" << render(faults));
            CHECK(!faults.has_errors());
            ++examples;
        }
    }
    CHECK(examples > 150);
}

TEST_CASE("a key that is not in the format's table is refused in every mapping") {
    for (const MappingFormat& format : format_table()) {
        const std::string text = with_known_names(case_with(format, "gremlin: 1"));
        if (needs_cad(text)) continue;
        const Diagnostics faults = read(text);
        INFO(text << "\n" << render(faults));
        const auto told =
            std::count_if(faults.all().begin(), faults.all().end(), [](const Diagnostic& fault) {
                return fault.message.find("unknown key 'gremlin'") != std::string::npos;
            });
        CHECK(told == 1);
    }
}

TEST_CASE("the table of the format names only what is in it") {
    std::set<std::string_view> names;
    for (const MappingFormat& format : format_table()) {
        INFO(format.name);
        CHECK(names.insert(format.name).second);
        CHECK(!format.what.empty());
        for (const std::string_view other : format.with) CHECK(find_format(other) != nullptr);
        std::set<std::string_view> keys;
        for (const KeyFormat& key : format.keys) {
            INFO(key.key);
            CHECK(keys.insert(key.key).second);
            CHECK(!key.meaning.empty());
            CHECK(!key.values.empty());
            std::deque<ValueForm> forms(key.values.begin(), key.values.end());
            for (; !forms.empty(); forms.pop_front()) {
                const ValueForm form = forms.front();
                if (form.kind == Kind::mapping) CHECK(find_format(form.of) != nullptr);
                if (form.kind == Kind::words) CHECK(!form.words.empty());
                forms.insert(forms.end(), form.items.begin(), form.items.end());
            }
        }
        for (const Keys& choice : format.one_of) {
            for (const std::string_view key : choice) CHECK(keys.contains(key));
        }
    }
}

TEST_CASE("the keys of several mappings are each mapping's own, then those in common") {
    const Keys keys = keys_of({"face", "face_by_corners"});
    REQUIRE(keys.size() > 6);
    CHECK(Keys(keys.begin(), keys.begin() + 6) ==
          Keys{"imin", "imax", "jmin", "jmax", "corners", "method"});
    CHECK(required_keys("face") == Keys{"imin", "imax", "jmin", "jmax"});
    CHECK(words_of("any_face", "orthogonal").back() == "all");
    CHECK(words_of("face_use", "axes") == Keys{"i", "j", "-i", "-j"});
}
