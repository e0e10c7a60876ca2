// SPDX-License-Identifier: Apache-2.0
#include "io/format_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hexweave {
namespace {

using Kind = ValueForm::Kind;

std::string limits_text(const Limits& limits) {
    std::vector<std::string> parts;
    if (std::isfinite(limits.above)) parts.push_back(fmt::format("> {}", limits.above));
    if (std::isfinite(limits.at_least)) parts.push_back(fmt::format(">= {}", limits.at_least));
    if (std::isfinite(limits.at_most)) parts.push_back(fmt::format("<= {}", limits.at_most));
    if (std::isfinite(limits.below)) parts.push_back(fmt::format("< {}", limits.below));
    return fmt::format("{}", fmt::join(parts, " and "));
}

std::string number_text(const ValueForm& form) {
    const std::string limits = limits_text(form.limits);
    const auto of = [&](std::string_view what, std::string_view unit) {
        return fmt::format("{}{}{}{}", what, limits.empty() ? "" : " ", limits, unit);
    };
    switch (form.quantity) {
        case Quantity::length:
            return of("length", " (`units`)");
        case Quantity::angle:
            return of("angle", " (radians)");
        case Quantity::degrees:
            return of("angle", " (degrees)");
        case Quantity::fraction:
            return of("fraction", "");
        case Quantity::none:
            break;
    }
    return of("number", "");
}

/// "a, b or c"; with longer parts, "list of: a; or b".
std::string alternatives(const std::vector<std::string>& parts) {
    if (parts.size() < 2) return parts.empty() ? "" : parts.front();
    const bool lists = std::any_of(parts.begin(), parts.end(), [](const std::string& part) {
        return part.find(": ") != std::string::npos;
    });
    return fmt::format("{}{}{}", fmt::join(parts.begin(), parts.end() - 1, lists ? "; " : ", "),
                       lists ? "; or " : " or ", parts.back());
}

std::string words_text(const Keys& words) {
    std::vector<std::string> parts;
    for (const std::string_view word : words) parts.push_back(fmt::format("`{}`", word));
    return alternatives(parts);
}

std::string list_text(const ValueForm& form, const MappingText& mapping) {
    const std::string items = type_of(form.items, mapping);
    if (form.most == 0 && form.least <= 1) return fmt::format("list of: {}", items);
    if (form.most == 0) return fmt::format("list of {} or more: {}", form.least, items);
    if (form.most == form.least) return fmt::format("list of {}: {}", form.most, items);
    return fmt::format("list of {} to {}: {}", form.least, form.most, items);
}

std::string form_text(const ValueForm& form, const MappingText& mapping) {
    switch (form.kind) {
        case Kind::number:
            return number_text(form);
        case Kind::count:
            return "whole number >= 1";
        case Kind::point:
            return form.quantity == Quantity::length ? "point (`units`)" : "vector";
        case Kind::formula:
            return fmt::format("formula of {}", form.of);
        case Kind::text:
            return "text";
        case Kind::file:
            return "file name";
        case Kind::truth:
            return "`true` or `false`";
        case Kind::words:
            return words_text(form.words);
        case Kind::name:
            return fmt::format("{} (name)", form.of);
        case Kind::signed_name:
            return fmt::format("{0} (name, or -name: backwards)", form.of);
        case Kind::axis_plane:
            return "plane, `\"z = 0\"` (or x, y for z)";
        case Kind::list:
            return list_text(form, mapping);
        case Kind::mapping:
            return mapping(form.of);
        case Kind::entries:
            break;
    }
    if (form.items.empty()) return "mapping";
    return fmt::format("mapping of {} names to: {}", form.of, type_of(form.items, mapping));
}

/// With a capital letter and a full stop.
std::string sentence(std::string text) {
    if (text.empty()) return text;
    if (text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text + ".";
}

}  // namespace

bool has_literal_default(const KeyFormat& key) {
    const std::string absent(key.absent);
    if (nlohmann::json::accept(absent)) return true;
    return std::any_of(key.values.begin(), key.values.end(), [&](const ValueForm& form) {
        return form.kind == Kind::words &&
               std::find(form.words.begin(), form.words.end(), absent) != form.words.end();
    });
}

std::string format_title(std::string_view name) {
    std::string title(name);
    std::replace(title.begin(), title.end(), '_', ' ');
    return title;
}

std::string type_of(const std::vector<ValueForm>& forms, const MappingText& mapping) {
    std::vector<std::string> parts;
    for (const ValueForm& form : forms) parts.push_back(form_text(form, mapping));
    return alternatives(parts);
}

std::string description_of(const KeyFormat& key) {
    std::string text =
        sentence(std::string(key.meaning)) + " " + sentence(type_of(key.values, format_title));
    if (!key.absent.empty() && key.absent != key_required) {
        text += fmt::format(" Without it: {}.", key.absent);
    }
    return text;
}

}  // namespace hexweave
