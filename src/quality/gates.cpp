// SPDX-License-Identifier: Apache-2.0
#include "quality/gates.h"

#include <algorithm>
#include <cmath>

#include "quality/measure.h"

namespace hexweave {

namespace {

/// First heights at a side of a face or block.
struct HeightRow {
    const SolveMeasure* solve = nullptr;
    const HeightMeasure* heights = nullptr;
};

/// What gates are judged by: the measures of a grid or of a part of it.
struct Subject {
    std::string name;  ///< empty for the whole grid
    std::vector<const ZoneMeasure*> zones;
    std::vector<const InterfaceMeasure*> interfaces;
    std::vector<WallMeasure> walls;
    std::vector<const SpacingMeasure*> spacings;
    std::vector<HeightRow> heights;
};

/// The worst found so far.
class Worst {
public:
    explicit Worst(const Gate& gate) : lower_(is_lower_limit(gate.measure)) {
        result.measure = gate.measure;
        result.limit = gate.limit;
        result.asked_at = gate.place;
    }

    void include(double value, const std::string& where, std::optional<Vec3> place = {}) {
        if (found_ && (lower_ ? value >= result.got : value <= result.got)) return;
        found_ = true;
        result.got = value;
        result.where = where;
        result.place = place;
    }

    GateResult finish() {
        result.judged = found_;
        result.met = found_ && (lower_ ? result.got >= result.limit : result.got <= result.limit);
        return result;
    }

    GateResult result;

private:
    bool lower_ = false;
    bool found_ = false;
};

std::string zone_text(const std::string& name) {
    return "zone '" + name + "'";
}

void include_growth(const Subject& subject, Worst& worst) {
    for (const ZoneMeasure* zone : subject.zones) {
        for (const GrowthMeasure& growth : zone->growth) {
            if (!growth.measured) continue;
            worst.include(growth.ratio, zone_text(zone->name), growth.place);
        }
    }
    for (const InterfaceMeasure* interface : subject.interfaces) {
        if (!interface->growth.measured) continue;
        worst.include(interface->growth.ratio, "interface '" + interface->name + "'",
                      interface->growth.place);
    }
}

void include_spacing_errors(const Subject& subject, Worst& worst) {
    for (const SpacingMeasure* s : subject.spacings) {
        const auto include = [&](const std::optional<double>& asked, double got, const Vec3& at) {
            if (asked) worst.include(std::abs(got / *asked - 1), "edge '" + s->edge + "'", at);
        };
        include(s->asked_start, s->got_start, s->start_place);
        include(s->asked_end, s->got_end, s->end_place);
    }
    for (const auto& [s, h] : subject.heights) {
        const std::string where = (s->is_block ? "block '" : "face '") + s->name + "', " +
                                  std::string(side_name(h->side));
        worst.include(std::abs(h->least - 1), where, h->least_place);
        worst.include(std::abs(h->greatest - 1), where, h->greatest_place);
    }
}

/// The angle of a zone that is worst for a gate.
void include_angle(const ZoneMeasure& zone, GateMeasure measure, Worst& worst) {
    const AngleMeasure& angles = zone.angles;
    if (angles.corners == 0) return;
    if (measure == GateMeasure::min_angle) {
        worst.include(angles.least, zone_text(zone.name), angles.least_place);
    } else if (measure == GateMeasure::max_angle) {
        worst.include(angles.greatest, zone_text(zone.name), angles.greatest_place);
    } else {
        worst.include(std::max(90 - angles.least, angles.greatest - 90) / 90, zone_text(zone.name),
                      angles.worst_place());
    }
}

GateResult judge(const Gate& gate, const Subject& subject) {
    Worst worst(gate);
    worst.result.subject = subject.name;
    switch (gate.measure) {
        case GateMeasure::min_scaled_jacobian:
            for (const ZoneMeasure* zone : subject.zones) {
                worst.include(zone->worst_scaled_jacobian, zone_text(zone->name),
                              zone->worst_place);
            }
            break;
        case GateMeasure::min_angle:
        case GateMeasure::max_angle:
        case GateMeasure::max_skewness:
            for (const ZoneMeasure* zone : subject.zones) {
                include_angle(*zone, gate.measure, worst);
            }
            break;
        case GateMeasure::max_growth:
            include_growth(subject, worst);
            break;
        case GateMeasure::max_wall_angle:
            for (const WallMeasure& wall : subject.walls) {
                if (wall.nodes == 0) continue;
                worst.include(wall.greatest_angle, "wall '" + wall.family + "'", wall.worst_place);
            }
            break;
        case GateMeasure::wall_spacing_error:
            include_spacing_errors(subject, worst);
            break;
    }
    return worst.finish();
}

void add_heights(const SolveMeasure& solve, Subject& subject) {
    for (const HeightMeasure& h : solve.heights) subject.heights.push_back({&solve, &h});
}

Subject whole_grid(const Report& report) {
    Subject subject;
    for (const ZoneMeasure& zone : report.zones) subject.zones.push_back(&zone);
    for (const InterfaceMeasure& i : report.interfaces) subject.interfaces.push_back(&i);
    subject.walls = report.walls;
    for (const SpacingMeasure& s : report.spacings) subject.spacings.push_back(&s);
    for (const SolveMeasure& s : report.solves) add_heights(s, subject);
    return subject;
}

/// One zone, with the walls that are its own.
Subject zone_of(const MultiblockGrid& grid, const Report& report, std::size_t zone) {
    Subject subject;
    subject.zones.push_back(&report.zones[zone]);
    subject.walls = measure_walls(
        grid, [zone](const BoundaryPatch& patch) { return patch.zone == static_cast<int>(zone); });
    return subject;
}

void add_heights(const Report& report, const std::string& name, bool is_block, Subject& subject) {
    for (const SolveMeasure& s : report.solves) {
        if (s.name == name && s.is_block == is_block) add_heights(s, subject);
    }
}

/// The first heights of blocks at the sides that a face is part of.
void add_heights_of_blocks(const Topology& topology, std::size_t face, const Report& report,
                           Subject& subject) {
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        const SolveMeasure& solve = report.solves[topology.faces.size() + b];
        for (const HeightMeasure& h : solve.heights) {
            const auto& faces = topology.blocks[b].sides[static_cast<std::size_t>(h.side)].faces;
            const bool has_it = std::any_of(faces.begin(), faces.end(), [&](const FaceUse& use) {
                return use.face == static_cast<int>(face);
            });
            if (has_it) subject.heights.push_back({&solve, &h});
        }
    }
}

/// The edges' spacings, by the place of the edge in the topology.
void add_spacings(const Face& face, const Report& report, Subject& subject) {
    for (const auto& side : face.sides) {
        for (const EdgeUse& use : side) {
            subject.spacings.push_back(&report.spacings[static_cast<std::size_t>(use.edge)]);
        }
    }
}

void append(const std::vector<Gate>& gates, const Subject& subject,
            std::vector<GateResult>& results) {
    for (const Gate& gate : gates) results.push_back(judge(gate, subject));
}

}  // namespace

std::vector<GateResult> judge_gates(const Topology& topology, const std::vector<FaceGrid>& faces,
                                    const MultiblockGrid& grid, const Report& report) {
    std::vector<GateResult> results;
    append(topology.gates, whole_grid(report), results);
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        const Face& face = topology.faces[f];
        if (face.solve.gates.empty()) continue;
        // Without blocks faces are zones; else they are measured for the sake of their gates.
        ZoneMeasure own;
        Subject subject;
        if (topology.is_3d()) {
            own = measure_zone({face.name, faces[f].points}, grid.physical_dimension);
            subject.zones.push_back(&own);
            subject.walls = measure_walls(
                grid, [&](const BoundaryPatch& patch) { return patch.name == face.name; });
            add_heights_of_blocks(topology, f, report, subject);
        } else {
            subject = zone_of(grid, report, f);
        }
        subject.name = "face '" + face.name + "'";
        add_spacings(face, report, subject);
        add_heights(report, face.name, false, subject);
        append(face.solve.gates, subject, results);
    }
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        const Block& block = topology.blocks[b];
        if (block.solve.gates.empty()) continue;
        Subject subject = zone_of(grid, report, b);
        subject.name = "block '" + block.name + "'";
        for (const auto& side : block.sides) {
            for (const FaceUse& use : side.faces) {
                add_spacings(topology.faces[static_cast<std::size_t>(use.face)], report, subject);
            }
        }
        add_heights(report, block.name, true, subject);
        append(block.solve.gates, subject, results);
    }
    return results;
}

}  // namespace hexweave
