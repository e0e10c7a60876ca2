// SPDX-License-Identifier: Apache-2.0
#include "topology/read_cad.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/cad.h"
#include "geometry/length_units.h"
#include "topology/read_data_file.h"

namespace hexweave {

namespace {

/// An entry that names a part of a CAD file.
struct CadUse {
    Reading& reading;
    const YamlNode& entry;
    const YamlNode& path;
    std::shared_ptr<const CadFile> file;

    std::string of_file() const { return fmt::format("'{}'", shown(path.text)); }
    std::string see_list() const {
        return fmt::format("`hexweave geometry {}` lists what it holds", shown(path.text));
    }
};

/// "entity 31 of 'wing.igs' (trimmed surface)".
std::string words_for(const CadUse& use, const CadEntity& entity) {
    return fmt::format("entity {} of {} ({})", entity.number, use.of_file(), entity.type);
}

std::shared_ptr<const CadFile> read_file(Reading& reading, const YamlNode& path) {
    const std::string where = path_of_file(path).string();
    const auto known = reading.cad_files.find(where);
    if (path.is_scalar() && known != reading.cad_files.end()) return known->second;
    std::shared_ptr<const CadFile> read;
    if (const std::shared_ptr<const SourceFile> file = read_data_file(reading, path, "'cad'")) {
        CadResult result = read_cad(file->text);
        if (result.file) {
            read = std::make_shared<const CadFile>(std::move(*result.file));
        } else {
            tell_file_fault(reading, path, file, result.error, 0,
                            "save it as IGES (.igs) or STEP (.stp) where it was drawn");
        }
    }
    if (path.is_scalar()) reading.cad_files.emplace(where, read);
    return read;
}

/// Nothing where the file cannot be read; that has been told.
std::optional<CadUse> use_file(Reading& reading, const YamlNode& entry) {
    const YamlNode& path = *find(reading, entry, "cad");
    if (!can_read_cad()) {
        reading.diagnostics.error(
            entry.key_place,
            fmt::format("'{}' is of a CAD file; this hexweave was built without Open CASCADE, "
                        "which reads them",
                        shown(entry.key)),
            "build it with -DHEXWEAVE_CAD=ON; shapes by control points, nurbs or formulas need no "
            "Open CASCADE");
        return std::nullopt;
    }
    CadUse use{reading, entry, path, read_file(reading, path)};
    return use.file ? std::optional(use) : std::nullopt;
}

/// "1, 3, 5", or the first of them where they are many.
std::string numbers_of(const std::vector<const CadEntity*>& entities) {
    constexpr std::size_t most = 12;
    std::string list;
    for (std::size_t n = 0; n < std::min(entities.size(), most); ++n) {
        list += fmt::format("{}{}", n == 0 ? "" : ", ", entities[n]->number);
    }
    return entities.size() > most ? list + ", ..." : list;
}

std::vector<const CadEntity*> entities_where(const CadFile& file, const auto& holds) {
    std::vector<const CadEntity*> found;
    for (const CadEntity& entity : file.entities) {
        if (holds(entity)) found.push_back(&entity);
    }
    return found;
}

const CadEntity* entity_by_number(const CadUse& use, const YamlNode& node) {
    const auto number = read_count(use.reading, node, "'entity'");
    if (!number) return nullptr;
    const auto found =
        entities_where(*use.file, [&](const CadEntity& e) { return e.number == *number; });
    if (!found.empty()) return found.front();
    const auto all = entities_where(*use.file, [](const CadEntity&) { return true; });
    use.reading.diagnostics.error(
        node.place, fmt::format("{} has no surface or curve {}", use.of_file(), *number),
        fmt::format("it has {}; {}", numbers_of(all), use.see_list()));
    return nullptr;
}

const CadEntity* entity_by_text(const CadUse& use, const YamlNode& node, std::string_view key,
                                std::string CadEntity::*text) {
    const auto wanted = read_text(use.reading, node, fmt::format("'{}'", key));
    if (!wanted) return nullptr;
    const auto found =
        entities_where(*use.file, [&](const CadEntity& e) { return e.*text == *wanted; });
    if (found.size() == 1) return found.front();
    if (found.empty()) {
        std::vector<std::string> known;
        for (const CadEntity& e : use.file->entities) known.push_back(e.*text);
        const std::string near = nearest_name(*wanted, known);
        use.reading.diagnostics.error(
            node.place,
            fmt::format("{} has no surface or curve of the {} '{}'", use.of_file(), key,
                        shown(*wanted)),
            near.empty() ? use.see_list() : fmt::format("did you mean '{}'?", near));
    } else {
        use.reading.diagnostics.error(node.place,
                                      fmt::format("{} has {} entities of the {} '{}'",
                                                  use.of_file(), found.size(), key, shown(*wanted)),
                                      fmt::format("say which by entity: {}", numbers_of(found)));
    }
    return nullptr;
}

const CadEntity* choose_entity(const CadUse& use) {
    const YamlNode* chosen = nullptr;
    for (const std::string_view key : {"entity", "label", "name"}) {
        const YamlNode* node = find(use.reading, use.entry, key);
        if (node == nullptr) continue;
        if (chosen != nullptr) {
            use.reading.diagnostics.error(
                node->key_place, fmt::format("the entity is already given by '{}'", chosen->key),
                "one of entity, label and name is enough");
            return nullptr;
        }
        chosen = node;
    }
    if (chosen == nullptr && use.file->entities.size() == 1) return &use.file->entities.front();
    if (chosen == nullptr) {
        use.reading.diagnostics.error(
            use.path.place,
            fmt::format("'{}' does not say which of the {} entities of {} it is",
                        shown(use.entry.key), use.file->entities.size(), use.of_file()),
            "give one of entity, label and name; " + use.see_list());
        return nullptr;
    }
    if (chosen->key == "entity") return entity_by_number(use, *chosen);
    return chosen->key == "label" ? entity_by_text(use, *chosen, "label", &CadEntity::label)
                                  : entity_by_text(use, *chosen, "name", &CadEntity::name);
}

/// The one of `parts` that the number under `key` picks; it may be left out where there is one.
template <class Part>
const Part* pick(const CadUse& use, const std::vector<Part>& parts, std::string_view key,
                 const std::string& whole) {
    const YamlNode* node = find(use.reading, use.entry, key);
    if (node == nullptr && parts.size() == 1) return &parts.front();
    if (parts.empty()) {
        use.reading.diagnostics.error(use.path.place, fmt::format("{} has no {}", whole, key),
                                      "name another entity; " + use.see_list());
        return nullptr;
    }
    const std::string count =
        fmt::format("{} has {} {}{}", whole, parts.size(), key, parts.size() == 1 ? "" : "s");
    const std::string hint = fmt::format("say which by {}: 1 to {}", key, parts.size());
    if (node == nullptr) {
        use.reading.diagnostics.error(use.path.place, count, hint);
        return nullptr;
    }
    const auto number = read_count(use.reading, *node, fmt::format("'{}'", key));
    if (!number) return nullptr;
    const auto index = static_cast<std::size_t>(*number) - 1;
    if (index < parts.size()) return &parts[index];
    use.reading.diagnostics.error(node->place, count, hint);
    return nullptr;
}

/// Whether a face, edge or curve has a shape; tells why not.
template <class Part>
bool is_usable(const CadUse& use, const Part* part, const std::string& words) {
    if (part == nullptr) return false;
    if (part->fault.empty()) return true;
    use.reading.diagnostics.error(use.path.place,
                                  fmt::format("{} cannot be used: {}", words, part->fault),
                                  "name another entity; " + use.see_list());
    return false;
}

/// What lengths of the file are multiplied with to be in the units of the case.
std::optional<double> read_scale(const CadUse& use) {
    const YamlNode* node = find(use.reading, use.entry, "units");
    const LengthUnit* own = find_length_unit(use.reading.units);
    if (node == nullptr && use.file->unit_in_metres > 0) {
        return use.file->unit_in_metres / own->metres;
    }
    if (node == nullptr) {
        use.reading.diagnostics.error(
            use.path.place, fmt::format("{} does not say its unit of length", use.of_file()),
            "say it beside 'cad', as in units: mm");
        return std::nullopt;
    }
    if (use.file->several_units) {
        use.reading.diagnostics.error(
            node->place, fmt::format("parts of {} are in different units", use.of_file()),
            "leave 'units' out: each part is converted from its own");
        return std::nullopt;
    }
    const Keys& names = words_of("surface_cad", "units");
    const auto choice = read_choice(use.reading, *node, "'units'", names);
    if (!choice) return std::nullopt;
    return find_length_unit(names[*choice])->metres / own->metres;
}

const CadFace* choose_face(const CadUse& use, const CadEntity& entity) {
    const std::string words = words_for(use, entity);
    const CadFace* face = pick(use, entity.faces, "face", words);
    return is_usable(use, face, words) ? face : nullptr;
}

const CadCurve* choose_curve(const CadUse& use, const CadEntity& entity) {
    const std::string words = words_for(use, entity);
    if (entity.faces.empty()) {
        const CadCurve* curve = pick(use, entity.curves, "edge", words);
        return is_usable(use, curve, words) ? curve : nullptr;
    }
    const CadFace* face = pick(use, entity.faces, "face", words);
    if (face == nullptr) return nullptr;
    const CadCurve* edge = pick(use, face->edges, "edge", words);
    return is_usable(use, edge, "an edge of " + words) ? edge : nullptr;
}

}  // namespace

std::optional<Surface> read_cad_surface(Reading& reading, const YamlNode& entry) {
    const std::optional<CadUse> use = use_file(reading, entry);
    if (!use) return std::nullopt;
    const CadEntity* entity = choose_entity(*use);
    const std::optional<double> scale = read_scale(*use);
    const CadFace* face = entity == nullptr ? nullptr : choose_face(*use, *entity);
    if (face == nullptr || !scale) return std::nullopt;
    return cad_surface(*face, *scale);
}

std::optional<Curve> read_cad_curve(Reading& reading, const YamlNode& entry) {
    const std::optional<CadUse> use = use_file(reading, entry);
    if (!use) return std::nullopt;
    const CadEntity* entity = choose_entity(*use);
    const std::optional<double> scale = read_scale(*use);
    const CadCurve* curve = entity == nullptr ? nullptr : choose_curve(*use, *entity);
    if (curve == nullptr || !scale) return std::nullopt;
    return cad_curve(*curve, *scale);
}

}  // namespace hexweave
