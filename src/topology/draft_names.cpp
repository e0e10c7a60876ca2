// SPDX-License-Identifier: Apache-2.0
// What names mean elsewhere in the case: other kinds of entities, and entries that are left out.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "topology/draft.h"

namespace hexweave {

namespace {

/// A kind of entity, its section, and the table of its names.
struct NamedKind {
    std::string_view section;
    std::string_view words;
    NameTable& table;
};

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries) {
    std::vector<std::string> names;
    names.reserve(entries.size());
    for (const Entry& entry : entries) names.push_back(entry.name.value);
    return names;
}

std::array<NamedKind, 5> kinds_of(Draft& draft) {
    return {{{"curves", "a curve", draft.curve_names},
             {"surfaces", "a surface", draft.surface_names},
             {"vertices", a_vertex, draft.vertex_names},
             {"edges", "an edge", draft.edge_names},
             {"faces", "a face", draft.face_names}}};
}

}  // namespace

void note_other_names(Draft& draft) {
    const Case& c = draft.c;
    const std::array<std::vector<std::string>, 5> names{names_of(c.curves), names_of(c.surfaces),
                                                        names_of(c.vertices), names_of(c.edges),
                                                        names_of(c.faces)};
    const std::array<NamedKind, 5> kinds = kinds_of(draft);
    const std::vector<std::string> blocks = names_of(c.blocks);
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        for (const LeftOutEntry& entry : c.left_out) {
            if (entry.section == kinds[n].section) kinds[n].table.note_left_out(entry);
        }
        if (std::find(c.lost_sections.begin(), c.lost_sections.end(), kinds[n].section) !=
            c.lost_sections.end()) {
            kinds[n].table.set_incomplete();
        }
        for (const std::string& scope : c.lost_scopes) kinds[n].table.set_lost(scope);
        for (const std::string& name : blocks) kinds[n].table.note_other(name, "a block");
        for (std::size_t other = 0; other < kinds.size(); ++other) {
            if (other == n) continue;
            for (const std::string& name : names[other]) {
                kinds[n].table.note_other(name, std::string(kinds[other].words));
            }
        }
    }
}

}  // namespace hexweave
