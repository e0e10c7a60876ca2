// SPDX-License-Identifier: Apache-2.0
// What the table of the format is written with, and its sections.
#pragma once

#include <utility>

#include "topology/format_table.h"

namespace hexweave {

std::vector<MappingFormat> formats_of_case();
std::vector<MappingFormat> formats_of_curves();
std::vector<MappingFormat> formats_of_surfaces();
std::vector<MappingFormat> formats_of_shapes();
std::vector<MappingFormat> formats_of_points();
std::vector<MappingFormat> formats_of_faces();
std::vector<MappingFormat> formats_of_files();
std::vector<MappingFormat> formats_of_reuse();
/// Made of sections of the case.
MappingFormat format_of_component(const MappingFormat& the_case);
std::vector<MappingFormat> formats_of_images();

namespace forms {

inline constexpr Limits positive{.above = 0};

inline ValueForm number(Quantity quantity = Quantity::none, Limits limits = {}) {
    return {.kind = ValueForm::Kind::number, .quantity = quantity, .limits = limits};
}
inline ValueForm length() {
    return number(Quantity::length, positive);
}
inline ValueForm count() {
    return {.kind = ValueForm::Kind::count};
}
inline ValueForm point(Quantity quantity = Quantity::length) {
    return {.kind = ValueForm::Kind::point, .quantity = quantity};
}
inline ValueForm formula(std::string_view variables) {
    return {.kind = ValueForm::Kind::formula, .of = variables};
}
inline ValueForm text() {
    return {.kind = ValueForm::Kind::text};
}
inline ValueForm file() {
    return {.kind = ValueForm::Kind::file};
}
inline ValueForm truth() {
    return {.kind = ValueForm::Kind::truth};
}
inline ValueForm words(Keys list) {
    return {.kind = ValueForm::Kind::words, .words = std::move(list)};
}
inline ValueForm name(std::string_view kind) {
    return {.kind = ValueForm::Kind::name, .of = kind};
}
inline ValueForm signed_name(std::string_view kind) {
    return {.kind = ValueForm::Kind::signed_name, .of = kind};
}
inline ValueForm any_entity() {
    return name("vertex, edge or face");
}
inline ValueForm axis_plane() {
    return {.kind = ValueForm::Kind::axis_plane};
}
inline ValueForm list(std::vector<ValueForm> items, std::size_t least = 1, std::size_t most = 0) {
    return {.kind = ValueForm::Kind::list, .items = std::move(items), .least = least, .most = most};
}
inline ValueForm pair(ValueForm item) {
    return list({std::move(item)}, 2, 2);
}
inline ValueForm mapping(std::string_view format) {
    return {.kind = ValueForm::Kind::mapping, .of = format};
}
inline ValueForm entries(std::string_view kind, std::vector<ValueForm> items,
                         std::size_t longest_name = 200) {
    return {.kind = ValueForm::Kind::entries,
            .of = kind,
            .items = std::move(items),
            .most = longest_name};
}

}  // namespace forms

}  // namespace hexweave
