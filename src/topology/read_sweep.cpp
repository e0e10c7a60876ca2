// SPDX-License-Identifier: Apache-2.0
#include "topology/read_sweep.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "topology/read_periodic.h"
#include "topology/read_spacing.h"

namespace hexweave {

namespace {

/// The boundaries of the two ends, or that they are joined.
void read_ends(Reading& reading, const YamlNode& node, SweepEntry& sweep) {
    if (const YamlNode* start = find(reading, node, "start")) {
        sweep.ends[0] = read_name(reading, *start, "'start'");
    }
    if (const YamlNode* end = find(reading, node, "end")) {
        sweep.ends[1] = read_name(reading, *end, "'end'");
    }
    sweep.periodic = read_switch(reading, node, "periodic").value_or(false);
    if (sweep.periodic && (sweep.ends[0] || sweep.ends[1])) {
        const Name& named = sweep.ends[0] ? *sweep.ends[0] : *sweep.ends[1];
        reading.diagnostics.error(named.place, "ends that are periodic are no boundary",
                                  "leave 'periodic' out, or 'start' and 'end'");
    }
}

std::optional<Located<int>> read_cells(Reading& reading, const YamlNode& node) {
    const YamlNode* cells = find(reading, node, "cells");
    if (cells == nullptr) return Located<int>{1, node.place};
    const std::optional<int> count = read_count(reading, *cells, "'cells'");
    if (!count) return std::nullopt;
    return Located<int>{*count, cells->place};
}

/// What only 'extrude' has: the vector, and the law of the layers. False where there is no vector.
bool read_way(Reading& reading, const YamlNode& node, SweepEntry& sweep) {
    const YamlNode* along = require(reading, node, "along", "'extrude'");
    const auto way = along == nullptr ? std::nullopt : read_point(reading, *along, "'along'");
    if (const YamlNode* spacing = find(reading, node, "spacing")) {
        if (auto law = read_spacing(reading, *spacing)) {
            sweep.spacing = Located<SpacingEntry>{*law, spacing->place};
        }
    }
    if (!way) return false;
    if (way->z == 0) {
        reading.diagnostics.error(along->place, "'along' must lead out of the plane z = 0",
                                  "write [0, 0, 1]");
    }
    sweep.map = *way;
    return way->z != 0;
}

/// What only 'revolve' has: the turn. False where there is none in the plane z = 0.
bool read_axis(Reading& reading, const YamlNode& node, SweepEntry& sweep) {
    require(reading, node, "axis", "'revolve'");
    const auto turn = read_turn(reading, node, "'revolve'");
    if (!turn) return false;
    const bool leans = turn->axis.z != 0;
    if (leans || turn->center.z != 0) {
        reading.diagnostics.error(
            find(reading, node, leans ? "axis" : "center")->place,
            "the axis of 'revolve' must lie in the plane z = 0",
            leans ? "write [1, 0, 0] or [0, 1, 0]" : "write a center of two numbers");
        return false;
    }
    sweep.map = *turn;
    return true;
}

std::optional<SweepEntry> read_sweep(Reading& reading, const YamlNode& node, const char* key,
                                     bool (*read_map)(Reading&, const YamlNode&, SweepEntry&)) {
    if (!expect_mapping(reading, node, fmt::format("'{}'", key), key)) return std::nullopt;
    SweepEntry sweep;
    sweep.place = node.key_place;
    read_ends(reading, node, sweep);
    const bool mapped = read_map(reading, node, sweep);
    const auto cells = read_cells(reading, node);
    if (!mapped || !cells) return std::nullopt;
    sweep.cells = *cells;
    return sweep;
}

std::optional<MirrorEntry> read_mirror(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'mirror'", "mirror_copy")) return std::nullopt;
    MirrorEntry mirror;
    mirror.place = node.key_place;
    if (const YamlNode* at = require(reading, node, "at", "'mirror'")) {
        mirror.at = read_name(reading, *at, "'at'");
    }
    if (const YamlNode* families = find(reading, node, "families")) {
        const auto choice =
            read_choice(reading, *families, "'families'", words_of("mirror_copy", "families"));
        mirror.families_apart = choice && *choice == 1;
    }
    return mirror;
}

}  // namespace

void read_sweep_and_mirror(Reading& reading, const YamlNode& root, Case& c) {
    const YamlNode* extrude = find(reading, root, "extrude");
    const YamlNode* revolve = find(reading, root, "revolve");
    if (extrude != nullptr) c.sweep = read_sweep(reading, *extrude, "extrude", read_way);
    if (revolve != nullptr) c.sweep = read_sweep(reading, *revolve, "revolve", read_axis);
    if (extrude != nullptr && revolve != nullptr) {
        reading.diagnostics.error(revolve->key_place,
                                  "a case has either 'extrude' or 'revolve', not both",
                                  "leave one out");
    }
    if (const YamlNode* mirror = find(reading, root, "mirror")) {
        c.mirror = read_mirror(reading, *mirror);
    }
}

}  // namespace hexweave
