// SPDX-License-Identifier: Apache-2.0
// Prints libFuzzer's dictionary: the keys, words and examples of the format's table.
#include <fmt/core.h>

#include <set>
#include <string>

#include "topology/format_table.h"

using namespace hexweave;

namespace {

void add_words(const std::vector<ValueForm>& forms, std::set<std::string>& entries) {
    for (const ValueForm& form : forms) {
        for (const std::string_view word : form.words) entries.emplace(word);
        add_words(form.items, entries);
    }
}

std::string quoted_for_libfuzzer(const std::string& entry) {
    std::string text = "\"";
    for (const char c : entry) {
        const bool plain = c >= ' ' && c <= '~' && c != '"' && c != '\\';
        text += plain ? std::string(1, c) : fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    }
    return text + "\"";
}

}  // namespace

int main() {
    // What is wrong in any place, and the syntax of YAML.
    std::set<std::string> entries{".nan",   "1e999", "-0",  "1e12",   "NaN", "*x", "&x ", "<<: ",
                                  "\n    ", "\n  ",  ": {", "}, a: ", "[[",  "]]", "$",   "{i}"};
    for (const MappingFormat& format : format_table()) {
        for (const KeyFormat& key : format.keys) {
            entries.insert(std::string(key.key) + ": ");
            entries.emplace(key.example);
            add_words(key.values, entries);
        }
    }
    for (const std::string& entry : entries) {
        if (!entry.empty()) fmt::print("{}\n", quoted_for_libfuzzer(entry));
    }
    return 0;
}
