// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "io/cgns.h"
#include "io/cgns_library.h"
#include "io/cgns_rewrite.h"
#include "io/output_files.h"
#include "io/output_place.h"

namespace hexweave {
namespace {

// Families of type "UserDefined" or "UserDefined:NAME" carry NAME (else their own) in a child node,
// which says to a solver what is meant ("BCOverset").
const std::string user_defined = "UserDefined";

bool is_user_defined(const std::string& type) {
    return type == user_defined || type.starts_with(user_defined + ":");
}

[[noreturn]] void cannot_hold(const std::string& fact) {
    throw UsageError(fmt::format("a CGNS file cannot hold this grid: {}", fact));
}

void require_known_type(const char* what, const std::string& name, const std::string& type) {
    if (is_user_defined(type) || boundary_type(type)) return;
    cannot_hold(
        fmt::format("{} '{}' has the type '{}', which CGNS does not know", what, name, type));
}

BCType_t type_to_write(const std::string& type) {
    return is_user_defined(type) ? BCTypeUserDefined : *boundary_type(type);
}

/// One list of names under the base of a CGNS file: zones, families and the base's own nodes.
void check_names(const MultiblockGrid& grid) {
    std::set<std::string> taken{title_descriptor, provenance_descriptor, "DataClass",
                                "DimensionalUnits"};
    const auto take = [&](const std::string& what, const std::string& name) {
        if (name.empty() || name.size() > longest_cgns_name ||
            name.find('/') != std::string::npos) {
            cannot_hold(fmt::format("the name of {} '{}' must have 1 to {} bytes and no '/'", what,
                                    name, longest_cgns_name));
        }
        if (!taken.insert(name).second) {
            cannot_hold(fmt::format(
                "the name of {} '{}' is taken; zones and families share one list of names", what,
                name));
        }
    };
    for (const Zone& zone : grid.zones) take("zone", zone.name);
    for (const Family& family : grid.families) {
        take("family", family.name);
        require_known_type("family", family.name, family.type);
    }
    for (const BoundaryPatch& patch : grid.patches) {
        if (!patch.type.empty()) require_known_type("patch", patch.name, patch.type);
    }
    if (!grid.units.empty() && !length_unit(grid.units)) {
        cannot_hold(fmt::format("CGNS has no unit '{}' (it has m, cm, mm, ft, in)", grid.units));
    }
}

/// A name not yet in `taken`, to which it is added: `wanted` cut to what CGNS allows, numbered when
/// it is taken.
std::string unique_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted.substr(0, longest_cgns_name);
    for (int number = 2; name.empty() || !taken.insert(name).second; ++number) {
        const std::string ending = fmt::format("_{}", number);
        name = wanted.substr(0, longest_cgns_name - ending.size()) + ending;
    }
    return name;
}

using Range = std::array<cgsize_t, 6>;

/// The nodes of a box as CGNS counts them: from 1, all of begin, then all of end.
Range point_range(const IndexBox& box, int dimension) {
    Range range{};
    for (int axis = 0; axis < dimension; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        range[a] = box.begin[a] + 1;
        range[a + static_cast<std::size_t>(dimension)] = box.end[a] + 1;
    }
    return range;
}

/// Of a planar grid two, but three where an interface turns it: CGNS has as many angles as this,
/// and a plane's own would be the third.
int physical_dimension_of(const MultiblockGrid& grid) {
    for (const Interface& interface : grid.interfaces) {
        if (interface.periodic && interface.periodic->angle != Vec3{}) return 3;
    }
    return grid.physical_dimension;
}

class Writer {
public:
    Writer(const MultiblockGrid& grid, const std::filesystem::path& path,
           std::filesystem::path shown)
        : grid_(grid),
          physical_dimension_(physical_dimension_of(grid)),
          shown_(std::move(shown)),
          file_(path, CG_MODE_WRITE) {
        // libcgns listens to no errors while it opens a file; the system's last one must do.
        if (!file_.is_open()) fail(file_.error_number());
        errors_.listen();
    }

    void write() {
        write_base();
        for (const Family& family : grid_.families) write_family(family);
        zone_numbers_.resize(grid_.zones.size());
        for (std::size_t zone = 0; zone < grid_.zones.size(); ++zone) {
            write_zone(grid_.zones[zone], zone_numbers_[zone]);
        }
        write_interfaces();
        write_patches();
        if (!file_.close()) fail();
    }

private:
    [[noreturn]] void fail(int error_number = 0) const {
        const std::string otherwise =
            error_number != 0 ? error_reason(error_number) : cg_get_error();
        throw MachineError(
            fmt::format("cannot write '{}': {}", shown_.string(), errors_.reason(otherwise)));
    }

    /// Every function of libcgns answers with zero when it succeeds.
    void check(int answer) const {
        if (answer != CG_OK) fail();
    }

    /// Class and units, on the base and again on each coordinate array: some readers look at only
    /// one of the two places.
    void write_units() const {
        const auto unit = length_unit(grid_.units);
        check(cg_dataclass_write(unit ? Dimensional : NormalizedByUnknownDimensional));
        if (unit) check(cg_units_write(Kilogram, *unit, Second, Kelvin, Radian));
    }

    void write_base() {
        check(cg_base_write(file_, base_name, grid_.cell_dimension, physical_dimension_, &base_));
        check(cg_goto(file_, base_, "end"));
        if (!grid_.title.empty()) check(cg_descriptor_write(title_descriptor, grid_.title.c_str()));
        if (!grid_.provenance.empty()) {
            check(cg_descriptor_write(provenance_descriptor, grid_.provenance.c_str()));
        }
        write_units();
    }

    void write_family(const Family& family) const {
        int number = 0;
        int condition = 0;
        check(cg_family_write(file_, base_, family.name.c_str(), &number));
        check(
            cg_fambc_write(file_, base_, number, "FamBC", type_to_write(family.type), &condition));
        if (!is_user_defined(family.type)) return;
        const std::string meaning =
            family.type.size() > user_defined.size() + 1
                ? family.type.substr(user_defined.size() + 1, longest_cgns_name)
                : family.name;
        check(cg_goto(file_, base_, "Family_t", number, "end"));
        check(cg_user_data_write(meaning.c_str()));
    }

    // No FamilyName on the zone itself: a solver that finds one wants a family of volumes.
    void write_zone(const Zone& zone, int& number) const {
        const Extent& extent = zone.points.extent();
        std::array<cgsize_t, 9> size{};
        const auto dimension = static_cast<std::size_t>(grid_.cell_dimension);
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            size[axis] = extent[static_cast<int>(axis)];
            size[axis + dimension] = extent[static_cast<int>(axis)] - 1;
        }
        check(cg_zone_write(file_, base_, zone.name.c_str(), size.data(), Structured, &number));
        write_coordinate(number, "CoordinateX", zone.points.x);
        write_coordinate(number, "CoordinateY", zone.points.y);
        if (physical_dimension_ == 3) write_coordinate(number, "CoordinateZ", zone.points.z);
    }

    void write_coordinate(int zone, const char* name, const Field& values) const {
        int number = 0;
        check(cg_coord_write(file_, base_, zone, RealDouble, name, values.data(), &number));
        check(cg_goto(file_, base_, "Zone_t", zone, "GridCoordinates_t", 1, "DataArray_t", number,
                      "end"));
        write_units();
        const std::array<double, 5> length{0, 1, 0, 0, 0};
        check(cg_exponents_write(RealDouble, length.data()));
    }

    void write_interfaces() const {
        std::vector<std::set<std::string>> taken(grid_.zones.size());
        for (const Interface& interface : grid_.interfaces) {
            write_interface_side(interface, taken);
            write_interface_side(other_side(interface), taken);
        }
    }

    void write_interface_side(const Interface& side,
                              std::vector<std::set<std::string>>& taken) const {
        const auto zone = static_cast<std::size_t>(side.zone);
        const std::string name = unique_name(side.name, taken[zone]);
        const Range own = point_range(side.box, grid_.cell_dimension);
        const Range donor = point_range(side.donor_box, grid_.cell_dimension);
        int number = 0;
        check(cg_1to1_write(file_, base_, zone_numbers_[zone], name.c_str(),
                            grid_.zones[static_cast<std::size_t>(side.donor)].name.c_str(),
                            own.data(), donor.data(), side.orientation.axes.data(), &number));
        if (side.periodic) write_periodicity(zone_numbers_[zone], number, *side.periodic);
    }

    void write_periodicity(int zone, int number, const Periodicity& periodic) const {
        // A zero has no sign, so that what was read is written alike.
        const auto single = [](const Vec3& vector) {
            const Vec3 v = vector + Vec3{};
            return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y),
                                        static_cast<float>(v.z)};
        };
        check(cg_1to1_periodic_write(file_, base_, zone, number, single(periodic.center).data(),
                                     single(periodic.angle).data(),
                                     single(periodic.translation).data()));
        const std::array<double, 5> length{0, 1, 0, 0, 0};
        const std::array<double, 5> angle{0, 0, 0, 0, 1};
        write_units_of(zone, number, "RotationCenter", length);
        write_units_of(zone, number, "RotationAngle", angle);
        write_units_of(zone, number, "Translation", length);
    }

    /// Units beside a part of a periodicity, where solvers look for them.
    void write_units_of(int zone, int interface, const char* part,
                        const std::array<double, 5>& exponents) const {
        check(cg_goto(file_, base_, "Zone_t", zone, "ZoneGridConnectivity_t", 1,
                      "GridConnectivity1to1_t", interface, "GridConnectivityProperty_t", 1,
                      "Periodic_t", 1, part, 0, "end"));
        write_units();
        check(cg_exponents_write(RealDouble, exponents.data()));
    }

    void write_patches() const {
        std::vector<std::set<std::string>> taken(grid_.zones.size());
        for (const BoundaryPatch& patch : grid_.patches) {
            const auto index = static_cast<std::size_t>(patch.zone);
            const int zone = zone_numbers_[index];
            const std::string name = unique_name(patch.name, taken[index]);
            const Range range = point_range(patch.box, grid_.cell_dimension);
            const BCType_t type = patch.type.empty() ? FamilySpecified : type_to_write(patch.type);
            int number = 0;
            check(cg_boco_write(file_, base_, zone, name.c_str(), type, PointRange, 2, range.data(),
                                &number));
            check(cg_boco_gridlocation_write(file_, base_, zone, number, Vertex));
            check(cg_goto(file_, base_, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end"));
            check(cg_famname_write(
                grid_.families[static_cast<std::size_t>(patch.family)].name.c_str()));
        }
    }

    const MultiblockGrid& grid_;
    int physical_dimension_;
    std::filesystem::path shown_;
    Hdf5Errors errors_;
    CgnsFile file_;
    int base_ = 0;
    std::vector<int> zone_numbers_;
};

/// libcgns counts the nodes of a zone in 32 bits, and does not say when they overflow.
void check_sizes(const MultiblockGrid& grid, const std::filesystem::path& shown) {
    for (const Zone& zone : grid.zones) {
        const std::size_t nodes = zone.points.extent().nodes();
        if (nodes > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
            throw MachineError(
                fmt::format("cannot write '{}': zone '{}' has {} nodes, more than the 2147483647 "
                            "that libcgns can "
                            "count",
                            shown.string(), zone.name, nodes));
        }
    }
}

}  // namespace

void write_cgns(const MultiblockGrid& grid, const std::filesystem::path& path) {
    check_names(grid);
    check_sizes(grid, path);
    const TemporaryFile tree(path, path);
    Writer(grid, tree.path(), path).write();
    rewrite_cgns_tree(tree.path(), path, path);
}

}  // namespace hexweave
