// SPDX-License-Identifier: Apache-2.0
// Units in a CGNS file: as SIDS has it, what a node says holds for all nodes inside it that say
// nothing else.
#include <array>
#include <optional>

#include "core/length_unit.h"
#include "io/cgns_source.h"

namespace hexweave {
namespace {

constexpr double degree = 0.017453292519943295;

/// Takes over what the current node says.
void take_units(NodeUnits& units) {
    MassUnits_t mass{};
    LengthUnits_t length{};
    TimeUnits_t time{};
    TemperatureUnits_t temperature{};
    AngleUnits_t angle{};
    if (cg_units_read(&mass, &length, &time, &temperature, &angle) != CG_OK) return;
    if (length != LengthUnitsNull) units.length = unit_symbol(length);
    if (angle == Degree) units.radians = degree;
    if (angle == Radian) units.radians = 1;
}

/// Of the base, then of the zone.
NodeUnits units_of_zone(const CgnsSource& source, int zone) {
    NodeUnits units;
    source.check(cg_goto(source.file(), CgnsSource::base(), "end"));
    take_units(units);
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone, "end"));
    take_units(units);
    return units;
}

/// Of a part ("RotationAngle") of the periodicity of a one-to-one interface.
NodeUnits units_of_periodicity(const CgnsSource& source, int zone, int interface,
                               const char* part) {
    NodeUnits units = units_of_zone(source, zone);
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone,
                         "ZoneGridConnectivity_t", 1, "GridConnectivity1to1_t", interface,
                         "GridConnectivityProperty_t", 1, "Periodic_t", 1, "end"));
    take_units(units);
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone,
                         "ZoneGridConnectivity_t", 1, "GridConnectivity1to1_t", interface,
                         "GridConnectivityProperty_t", 1, "Periodic_t", 1, part, 0, "end"));
    take_units(units);
    return units;
}

}  // namespace

NodeUnits units_of_coordinate(const CgnsSource& source, int zone, int coordinate) {
    NodeUnits units = units_of_zone(source, zone);
    source.check(
        cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone, "GridCoordinates_t", 1, "end"));
    take_units(units);
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone, "GridCoordinates_t", 1,
                         "DataArray_t", coordinate, "end"));
    take_units(units);
    return units;
}

std::optional<Periodicity> read_periodicity(const CgnsSource& source, const GridOutline& grid,
                                            int zone, int number) {
    const int zone_number = zone_of(grid, zone).number;
    std::array<float, 3> center{};
    std::array<float, 3> angle{};
    std::array<float, 3> translation{};
    const int answer = cg_1to1_periodic_read(source.file(), CgnsSource::base(), zone_number, number,
                                             center.data(), angle.data(), translation.data());
    if (answer == CG_NODE_NOT_FOUND) return std::nullopt;
    source.check(answer);
    const auto units = [&](const char* part) {
        return units_of_periodicity(source, zone_number, number, part);
    };
    const auto length_factor = [&](const char* part) {
        const std::string length = units(part).length;
        const bool another = !length.empty() && !grid.units.empty() && length != grid.units;
        return another ? metres_in(length) / metres_in(grid.units) : 1;
    };
    const auto vector = [](double factor, const std::array<float, 3>& v) {
        return factor * Vec3{v[0], v[1], v[2]};
    };
    return Periodicity{vector(length_factor("RotationCenter"), center),
                       vector(units("RotationAngle").radians, angle),
                       vector(length_factor("Translation"), translation)};
}

}  // namespace hexweave
