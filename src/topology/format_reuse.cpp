// SPDX-License-Identifier: Apache-2.0
// The table of the format: components and their instances.
#include <algorithm>
#include <array>

#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

MappingFormat format_of_component(const MappingFormat& the_case) {
    constexpr std::array<std::string_view, 8> shared{
        "curves", "surfaces", "vertices", "edges", "faces", "blocks", "boundaries", "instances"};
    MappingFormat component{
        "component",
        "A part of a topology, to be used several times: sections as in a case, with names and "
        "parameters of their own.",
        {{"parameters",
          {entries("parameter", {number(), words({"required"})})},
          "",
          "names for its expressions, with their defaults; `required`: every instance must set it",
          "parameters: {chord: 1, wall: 1e-5 * chord}"},
         {"ports",
          {entries("port", {any_entity(), list({any_entity()})})},
          "",
          "vertices, edges and faces that others may be joined to",
          "ports: {inlet: south}, vertices: {a: [0, 0], b: [1, 0]}, edges: {south: {from: a, to: "
          "b}}"}}};
    for (const KeyFormat& key : the_case.keys) {
        if (std::find(shared.begin(), shared.end(), key.key) != shared.end()) {
            component.keys.push_back(key);
        }
    }
    return component;
}

std::vector<MappingFormat> formats_of_reuse() {
    return {
        {"instance",
         "A component where it is used; its names begin with the instance's: `flap.wake`.",
         {{"of", {name("component")}, key_required, "which component", "of: strip"},
          {"set",
           {entries("parameter", {number()})},
           "the defaults",
           "parameters of the component, by expressions of where the instance stands",
           "of: strip, set: {length: 2}"},
          {"join",
           {entries("port", {any_entity(), list({any_entity()}), mapping("join")})},
           "",
           "what its ports are one with: entities, or ports of other instances",
           "of: strip, join: {}"},
          {"families",
           {words({"shared", "own"})},
           "shared",
           "whether its boundaries join those of the same name, or begin with its own name",
           "of: strip, families: own"}},
         {"transforms"}},
        {"join",
         "What a port is joined to, where a condition holds.",
         {{"to",
           {any_entity(), list({any_entity()})},
           key_required,
           "entities, or ports of other instances",
           "to: main.outlet"},
          {"when", {number()}, "always", "not joined where this is 0", "when: 1 > 2"}}},
    };
}

}  // namespace hexweave
