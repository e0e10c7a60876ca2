// SPDX-License-Identifier: Apache-2.0
#include "topology/suggestions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/diagnostics.h"

namespace hexweave {

namespace {

struct Synonym {
    std::string_view said;
    std::string_view meant;
};

/// Words of other programs, of other fields and of other orthographies, in lower case and without
/// hyphens; of several of one word the first counts that is known where it was said.
constexpr std::array synonyms{
    // units
    Synonym{"meter", "m"}, Synonym{"metre", "m"}, Synonym{"millimeter", "mm"},
    Synonym{"millimetre", "mm"}, Synonym{"centimeter", "cm"}, Synonym{"centimetre", "cm"},
    Synonym{"kilometer", "km"}, Synonym{"kilometre", "km"}, Synonym{"micrometer", "um"},
    Synonym{"micron", "um"}, Synonym{"inch", "in"}, Synonym{"inche", "in"}, Synonym{"foot", "ft"},
    Synonym{"feet", "ft"}, Synonym{"mile", "mi"},
    // boundary conditions
    Synonym{"inlet", "BCInflow"}, Synonym{"outlet", "BCOutflow"},
    Synonym{"symmetric", "BCSymmetryPlane"}, Synonym{"viscous", "BCWallViscous"},
    Synonym{"noslip", "BCWallViscous"}, Synonym{"noslipwall", "BCWallViscous"},
    Synonym{"adiabatic", "BCWallViscousHeatFlux"}, Synonym{"isothermal", "BCWallViscousIsothermal"},
    Synonym{"slip", "BCWallInviscid"}, Synonym{"slipwall", "BCWallInviscid"},
    Synonym{"inviscid", "BCWallInviscid"}, Synonym{"euler", "BCWallInviscid"},
    Synonym{"freestream", "BCFarfield"}, Synonym{"wedge", "BCAxisymmetricWedge"},
    // sections of a case
    Synonym{"version", "hexweave"}, Synonym{"name", "title"}, Synonym{"description", "title"},
    Synonym{"variable", "parameters"}, Synonym{"constant", "parameters"},
    Synonym{"param", "parameters"}, Synonym{"point", "vertices"}, Synonym{"node", "vertices"},
    Synonym{"corner", "vertices"}, Synonym{"line", "edges"}, Synonym{"patch", "faces"},
    Synonym{"patche", "faces"}, Synonym{"zone", "blocks"}, Synonym{"boundary", "boundaries"},
    Synonym{"bc", "boundaries"}, Synonym{"boundarycondition", "boundaries"},
    Synonym{"geometry", "curves"}, Synonym{"shape", "curves"}, Synonym{"gate", "require"},
    // keys of entries
    Synonym{"start", "from"}, Synonym{"begin", "from"}, Synonym{"end", "to"},
    Synonym{"first", "start"}, Synonym{"firstcell", "start"}, Synonym{"begin", "start"},
    Synonym{"last", "end"}, Synonym{"lastcell", "end"}, Synonym{"growth", "ratio"},
    Synonym{"growthrate", "ratio"}, Synonym{"factor", "ratio"}, Synonym{"count", "cells"},
    Synonym{"number", "cells"}, Synonym{"n", "cells"}, Synonym{"interval", "cells"},
    Synonym{"distribution", "spacing"}, Synonym{"stretching", "spacing"},
    Synonym{"clustering", "spacing"}, Synonym{"curve", "along"}, Synonym{"bctype", "type"},
    Synonym{"kind", "type"}, Synonym{"edge", "sides"}, Synonym{"face", "sides"},
    Synonym{"vertice", "corners"}, Synonym{"vertex", "at"}, Synonym{"point", "corners"},
    Synonym{"middle", "center"}, Synonym{"origin", "center"}, Synonym{"r", "radius"},
    Synonym{"translation", "translate"}, Synonym{"shift", "translate"},
    Synonym{"move", "translate"}, Synonym{"rotation", "rotate"}, Synonym{"reflect", "mirror"},
    Synonym{"coordinate", "point"}, Synonym{"position", "point"}, Synonym{"xyz", "point"},
    Synonym{"component", "of"}, Synonym{"parameter", "set"}, Synonym{"maxcycle", "maximum_cycles"},
    Synonym{"iteration", "maximum_cycles"}, Synonym{"maxiteration", "maximum_cycles"},
    Synonym{"tfi", "algebraic"}, Synonym{"linear", "uniform"}};

/// Letters and digits in lower case, without the "BC" of CGNS and the s of a plural.
std::string bare(std::string_view word) {
    std::string letters;
    for (const char c : word) {
        if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
    }
    if (letters.size() > 2 && letters.ends_with('s')) letters.pop_back();
    if (letters.size() > 2 && letters.starts_with("bc")) letters.erase(0, 2);
    return letters;
}

std::string synonym_of(const std::string& letters, const Keys& known) {
    for (const Synonym& synonym : synonyms) {
        if (synonym.said != letters) continue;
        const auto found = std::find(known.begin(), known.end(), synonym.meant);
        if (found != known.end()) return std::string(*found);
    }
    return {};
}

/// The shortest that begins with these letters; too few tell nothing.
std::string shortest_beginning_with(const std::string& letters, const Keys& known) {
    constexpr std::size_t enough = 4;
    std::string_view shortest;
    if (letters.size() < enough) return {};
    for (const std::string_view word : known) {
        if (!bare(word).starts_with(letters)) continue;
        if (shortest.empty() || word.size() < shortest.size()) shortest = word;
    }
    return std::string(shortest);
}

}  // namespace

std::string meant_word(const std::string& word, const Keys& known) {
    std::string meant = nearest_name(word, {known.begin(), known.end()});
    if (meant.empty()) meant = synonym_of(bare(word), known);
    if (meant.empty()) meant = shortest_beginning_with(bare(word), known);
    return meant;
}

std::string suggestion(const std::string& word, const Keys& known, std::string_view label) {
    const std::string meant = meant_word(word, known);
    if (!meant.empty()) return fmt::format("did you mean '{}'?", meant);
    return fmt::format("{} {}", label, fmt::join(known, ", "));
}

std::string usage_of(const KeyFormat& key) {
    return fmt::format("as in '{}' ({})", key.example, key.meaning);
}

std::string usage_of(const std::vector<const KeyFormat*>& keys) {
    if (keys.size() == 1) return usage_of(*keys.front());
    std::vector<std::string_view> examples;
    examples.reserve(keys.size());
    for (const KeyFormat* key : keys) examples.push_back(key->example);
    return fmt::format("as in '{}'", fmt::join(examples, ", "));
}

}  // namespace hexweave
