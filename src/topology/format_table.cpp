// SPDX-License-Identifier: Apache-2.0
#include "topology/format_table.h"

#include <algorithm>
#include <iterator>

#include "core/assert.h"
#include "topology/format_parts.h"

namespace hexweave {

namespace {

/// What may stand at any entry of a section may stand in every mapping that is one.
void add_keys_of_entries(std::vector<MappingFormat>& table) {
    std::vector<std::string_view> forms;
    for (const MappingFormat& format : table) {
        for (const KeyFormat& key : format.keys) {
            for (const ValueForm& value : key.values) {
                if (value.kind != ValueForm::Kind::entries) continue;
                for (const ValueForm& item : value.items) forms.push_back(item.of);
            }
        }
    }
    for (MappingFormat& format : table) {
        if (std::find(forms.begin(), forms.end(), format.name) == forms.end()) continue;
        format.with.push_back("any_entry");
    }
}

std::vector<MappingFormat> all_sections() {
    std::vector<MappingFormat> table;
    for (const auto section : {formats_of_case, formats_of_curves, formats_of_surfaces,
                               formats_of_shapes, formats_of_points, formats_of_faces,
                               formats_of_images, formats_of_files, formats_of_reuse}) {
        std::vector<MappingFormat> formats = section();
        std::move(formats.begin(), formats.end(), std::back_inserter(table));
    }
    add_keys_of_entries(table);
    return table;
}

void add_keys(Keys& keys, const MappingFormat& format) {
    for (const KeyFormat& key : format.keys) {
        if (std::find(keys.begin(), keys.end(), key.key) == keys.end()) keys.push_back(key.key);
    }
}

const MappingFormat& require_format(std::string_view name) {
    const MappingFormat* format = find_format(name);
    HEXWEAVE_ASSERT(format != nullptr);
    static const MappingFormat none{};
    return format == nullptr ? none : *format;
}

const KeyFormat* key_in(const MappingFormat& format, std::string_view key) {
    const auto found = std::find_if(format.keys.begin(), format.keys.end(),
                                    [&](const KeyFormat& known) { return known.key == key; });
    return found == format.keys.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<MappingFormat>& format_table() {
    static const std::vector<MappingFormat> table = all_sections();
    return table;
}

const MappingFormat* find_format(std::string_view name) {
    const std::vector<MappingFormat>& table = format_table();
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const MappingFormat& f) { return f.name == name; });
    return found == table.end() ? nullptr : &*found;
}

Keys keys_of(const FormatNames& formats) {
    Keys keys;
    for (const std::string& name : formats.names) add_keys(keys, require_format(name));
    for (const std::string& name : formats.names) {
        for (const std::string_view other : require_format(name).with) {
            add_keys(keys, require_format(other));
        }
    }
    return keys;
}

const KeyFormat* find_key(const FormatNames& formats, std::string_view key) {
    for (const std::string& name : formats.names) {
        const MappingFormat& format = require_format(name);
        if (const KeyFormat* found = key_in(format, key)) return found;
        for (const std::string_view other : format.with) {
            if (const KeyFormat* found = key_in(require_format(other), key)) return found;
        }
    }
    return nullptr;
}

Keys required_keys(std::string_view format) {
    Keys keys;
    for (const KeyFormat& key : require_format(format).keys) {
        if (key.absent == key_required) keys.push_back(key.key);
    }
    return keys;
}

const Keys& words_of(std::string_view format, std::string_view key) {
    static const Keys none;
    for (const KeyFormat& k : require_format(format).keys) {
        if (k.key != key) continue;
        for (const ValueForm& form : k.values) {
            const ValueForm& holder =
                form.kind == ValueForm::Kind::list && !form.items.empty() ? form.items[0] : form;
            if (holder.kind == ValueForm::Kind::words) return holder.words;
        }
    }
    HEXWEAVE_ASSERT(false);
    return none;
}

}  // namespace hexweave
