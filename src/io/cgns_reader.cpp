// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/errors.h"
#include "core/periodic_ends.h"
#include "io/cgns.h"
#include "io/cgns_source.h"

namespace hexweave {
namespace {

constexpr std::array<const char*, 3> coordinate_names{"CoordinateX", "CoordinateY", "CoordinateZ"};

void read_descriptors(const CgnsSource& source, GridOutline& grid) {
    int descriptors = 0;
    source.check(cg_ndescriptors(&descriptors));
    for (int number = 1; number <= descriptors; ++number) {
        CgnsName name{};
        char* text = nullptr;
        source.check(cg_descriptor_read(number, name.data(), &text));
        if (text == nullptr) continue;
        if (std::string(name.data()) == title_descriptor) grid.title = text;
        if (std::string(name.data()) == provenance_descriptor) grid.provenance = text;
        cg_free(text);
    }
}

void read_base(const CgnsSource& source, GridOutline& grid) {
    int bases = 0;
    source.check(cg_nbases(source.file(), &bases));
    if (bases < 1) source.cannot_read("it holds no base");
    if (bases > 1 && !source.leaves_out()) {
        source.cannot_read(fmt::format("it holds {} bases; hexweave reads files with one", bases));
    }
    CgnsName name{};
    source.check(cg_base_read(source.file(), CgnsSource::base(), name.data(), &grid.cell_dimension,
                              &grid.physical_dimension));
    if (grid.cell_dimension < 2 || grid.cell_dimension > 3 ||
        grid.physical_dimension < grid.cell_dimension || grid.physical_dimension > 3) {
        source.cannot_read(
            fmt::format("its cells have {} dimensions in a space of {}; hexweave reads 2 in 2, 2 "
                        "in 3 and 3 in 3",
                        grid.cell_dimension, grid.physical_dimension));
    }
    source.check(cg_goto(source.file(), CgnsSource::base(), "end"));
    read_descriptors(source, grid);
}

/// ":NAME" of a user-defined family whose child says more than the family's own name.
std::string read_meaning(const CgnsSource& source, int family, const std::string& family_name) {
    int children = 0;
    source.check(cg_goto(source.file(), CgnsSource::base(), "Family_t", family, "end"));
    source.check(cg_nuser_data(&children));
    if (children != 1) return {};
    CgnsName meaning{};
    source.check(cg_user_data_read(1, meaning.data()));
    return family_name == meaning.data() ? std::string() : fmt::format(":{}", meaning.data());
}

/// Families that say a boundary condition; others (of volumes) are none of ours.
void read_families(const CgnsSource& source, GridOutline& grid) {
    int families = 0;
    source.check(cg_nfamilies(source.file(), CgnsSource::base(), &families));
    for (int number = 1; number <= families; ++number) {
        CgnsName name{};
        int conditions = 0;
        int geometries = 0;
        source.check(cg_family_read(source.file(), CgnsSource::base(), number, name.data(),
                                    &conditions, &geometries));
        if (conditions < 1) continue;
        CgnsName condition{};
        BCType_t type = BCTypeNull;
        source.check(
            cg_fambc_read(source.file(), CgnsSource::base(), number, 1, condition.data(), &type));
        std::string type_name = boundary_type_name(type);
        if (type == BCTypeUserDefined) type_name += read_meaning(source, number, name.data());
        grid.families.push_back({name.data(), type_name});
    }
}

/// A damaged size must not make the machine run out of memory.
void require_memory(const CgnsSource& source, const std::string& zone, const Extent& extent) {
    const double needed = 3.0 * sizeof(double) * extent.ni * extent.nj * extent.nk;
    const double present =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    constexpr double giga = 1e9;
    if (needed <= present) return;
    source.cannot_read(fmt::format("zone '{}' needs {:.3g} GB of memory; this machine has {:.3g}",
                                   zone, needed / giga, present / giga));
}

/// Throws unless the zone has the coordinate, in the unit of those before.
void look_at_coordinate(const CgnsSource& source, int zone, const std::string& name,
                        const std::string& zone_name, std::string& units) {
    int coordinates = 0;
    source.check(cg_ncoords(source.file(), CgnsSource::base(), zone, &coordinates));
    int found = 0;
    for (int number = 1; number <= coordinates; ++number) {
        CgnsName candidate{};
        DataType_t type{};
        source.check(cg_coord_info(source.file(), CgnsSource::base(), zone, number, &type,
                                   candidate.data()));
        if (name == candidate.data()) found = number;
    }
    if (found == 0) source.cannot_read(fmt::format("zone '{}' has no {}", zone_name, name));
    const std::string own = units_of_coordinate(source, zone, found).length;
    if (own.empty() || own == units) return;
    if (!units.empty()) {
        source.cannot_read(fmt::format(
            "{} of zone '{}' is in {} and others are in {}; hexweave reads grids in one unit", name,
            zone_name, own, units));
    }
    units = own;
}

/// Nothing for an unstructured zone that is to be left out.
std::optional<Extent> read_extent(const CgnsSource& source, int number, int cell_dimension,
                                  CgnsName& name) {
    ZoneType_t type{};
    std::array<cgsize_t, 9> size{};
    source.check(cg_zone_type(source.file(), CgnsSource::base(), number, &type));
    source.check(cg_zone_read(source.file(), CgnsSource::base(), number, name.data(), size.data()));
    if (type != Structured) {
        if (source.leaves_out()) return std::nullopt;
        source.cannot_read(fmt::format(
            "zone '{}' is unstructured; hexweave reads structured zones only", name.data()));
    }
    std::array<int, 3> nodes{1, 1, 1};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(cell_dimension); ++axis) {
        if (size[axis] < 2 || size[axis] > std::numeric_limits<int>::max()) {
            source.cannot_read(
                fmt::format("zone '{}' has {} nodes along an axis", name.data(), size[axis]));
        }
        nodes[axis] = static_cast<int>(size[axis]);
    }
    return Extent{nodes[0], nodes[1], nodes[2]};
}

void look_at_zone(const CgnsSource& source, int number, GridOutline& grid) {
    CgnsName name{};
    const std::optional<Extent> extent = read_extent(source, number, grid.cell_dimension, name);
    if (!extent) return;
    for (int axis = 0; axis < grid.physical_dimension; ++axis) {
        look_at_coordinate(source, number, coordinate_names[static_cast<std::size_t>(axis)],
                           name.data(), grid.units);
    }
    grid.zones.push_back({name.data(), *extent, number});
}

Zone read_zone(const CgnsSource& source, const GridOutline& outline, int number) {
    const ZoneOutline& zone = outline.zones[static_cast<std::size_t>(number)];
    require_memory(source, zone.name, zone.extent);
    Zone result{zone.name, PointField(zone.extent)};
    PointField& p = result.points;
    const IndexBox whole{{0, 0, 0}, {zone.extent.ni - 1, zone.extent.nj - 1, zone.extent.nk - 1}};
    read_points(source, outline, number, whole, {p.x.data(), p.y.data(), p.z.data()});
    return result;
}

/// Throws where the two ends of an interface contradict each other.
void require_agreeing_ends(const CgnsSource& source, const GridOutline& outline,
                           const std::vector<Zone>& zones) {
    if (outline.ends_apart.empty()) return;
    PointBox box;
    for (const Zone& zone : zones) {
        for (std::size_t n = 0; n < zone.points.extent().nodes(); ++n) {
            if (is_finite(zone.points[n])) box.include(zone.points[n]);
        }
    }
    const std::vector<std::string> found = contradictions(outline, box);
    if (!found.empty()) source.cannot_read(found.front());
}

MultiblockGrid read_grid(const std::filesystem::path& path) {
    const CgnsSource source(path);
    GridOutline outline = read_outline(source);
    MultiblockGrid grid;
    for (int zone = 0; zone < static_cast<int>(outline.zones.size()); ++zone) {
        grid.zones.push_back(read_zone(source, outline, zone));
    }
    require_agreeing_ends(source, outline, grid.zones);
    grid.title = std::move(outline.title);
    grid.units = std::move(outline.units);
    grid.cell_dimension = outline.cell_dimension;
    grid.physical_dimension = outline.physical_dimension;
    grid.interfaces = std::move(outline.interfaces);
    grid.families = std::move(outline.families);
    grid.patches = std::move(outline.patches);
    grid.provenance = std::move(outline.provenance);
    return grid;
}

}  // namespace

GridOutline read_outline(const CgnsSource& source) {
    GridOutline grid;
    read_base(source, grid);
    read_families(source, grid);
    int zones = 0;
    source.check(cg_nzones(source.file(), CgnsSource::base(), &zones));
    if (zones < 1) source.cannot_read("it holds no zones");
    for (int zone = 1; zone <= zones; ++zone) look_at_zone(source, zone, grid);
    if (grid.zones.empty()) source.cannot_read("it holds no structured zones");
    read_interfaces(source, grid);
    read_patches(source, grid);
    return grid;
}

void read_points(const CgnsSource& source, const GridOutline& grid, int zone, const IndexBox& box,
                 const std::array<double*, 3>& to) {
    std::array<cgsize_t, 3> first{};
    std::array<cgsize_t, 3> last{};
    std::size_t nodes = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = box.begin[axis] + 1;
        last[axis] = box.end[axis] + 1;
        nodes *= static_cast<std::size_t>(box.end[axis] - box.begin[axis] + 1);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (static_cast<int>(axis) >= grid.physical_dimension) {
            std::fill_n(to[axis], nodes, 0.0);
            continue;
        }
        source.check(cg_coord_read(source.file(), CgnsSource::base(), zone_of(grid, zone).number,
                                   coordinate_names[axis], RealDouble, first.data(), last.data(),
                                   to[axis]));
    }
}

MultiblockGrid read_cgns(const std::filesystem::path& path) {
    require_readable(path);
    rehearse(path, [&path] { read_grid(path); });
    return read_grid(path);
}

}  // namespace hexweave
