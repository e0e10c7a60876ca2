// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/interface_sides.h"
#include "io/cgns_source.h"

namespace hexweave {
namespace {

const ZoneOutline& zone_of(const GridOutline& grid, int zone) {
    return grid.zones[static_cast<std::size_t>(zone)];
}

/// CGNS counts from 1 and lists all of begin, then all of end.
IndexBox to_box(const cgsize_t* range, int cell_dimension) {
    IndexBox box;
    const auto dimension = static_cast<std::size_t>(cell_dimension);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        box.begin[axis] = static_cast<int>(range[axis] - 1);
        box.end[axis] = static_cast<int>(range[axis + dimension] - 1);
    }
    return box;
}

bool lies_in(const IndexBox& box, const Extent& extent) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (const int index : {box.begin[a], box.end[a]}) {
            if (index < 0 || index >= extent[axis]) return false;
        }
    }
    return true;
}

bool is_permutation(const Orientation& orientation, int cell_dimension) {
    std::array<bool, 3> seen{};
    for (const int other : orientation.axes) {
        if (other == 0 || other < -3 || other > 3) return false;
        seen[static_cast<std::size_t>(std::abs(other) - 1)] = true;
    }
    return seen[0] && seen[1] && seen[2] && (cell_dimension == 3 || orientation.axes[2] == 3);
}

/// Whether the transform carries the one box onto the other.
bool boxes_agree(const Interface& interface) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int other = interface.orientation.axes[axis];
        const auto across = static_cast<std::size_t>(std::abs(other) - 1);
        const int own = interface.box.end[axis] - interface.box.begin[axis];
        const int donor = interface.donor_box.end[across] - interface.donor_box.begin[across];
        if (donor != (other > 0 ? own : -own)) return false;
    }
    return true;
}

Interface read_interface(const CgnsSource& source, const GridOutline& grid, int zone, int number) {
    CgnsName name{};
    CgnsName donor{};
    std::array<cgsize_t, 6> range{};
    std::array<cgsize_t, 6> donor_range{};
    std::array<int, 3> transform{1, 2, 3};
    source.check(cg_1to1_read(source.file(), CgnsSource::base(), zone + 1, number, name.data(),
                              donor.data(), range.data(), donor_range.data(), transform.data()));
    const std::string what =
        fmt::format("interface '{}' of zone '{}'", name.data(), zone_of(grid, zone).name);
    const auto place =
        std::find_if(grid.zones.begin(), grid.zones.end(),
                     [&](const ZoneOutline& candidate) { return candidate.name == donor.data(); });
    if (place == grid.zones.end()) {
        source.cannot_read(
            fmt::format("{} leads to '{}', which is not in the file", what, donor.data()));
    }
    const int donor_zone = static_cast<int>(place - grid.zones.begin());
    const Interface result{name.data(),
                           zone,
                           to_box(range.data(), grid.cell_dimension),
                           donor_zone,
                           to_box(donor_range.data(), grid.cell_dimension),
                           Orientation{transform},
                           read_periodicity(source, grid, zone, number)};
    if (!is_permutation(result.orientation, grid.cell_dimension)) {
        source.cannot_read(fmt::format("{} has no valid Transform", what));
    }
    if (!lies_in(result.box, zone_of(grid, zone).extent) ||
        !lies_in(result.donor_box, place->extent)) {
        source.cannot_read(fmt::format("{} lies outside its zones", what));
    }
    if (!boxes_agree(result)) {
        source.cannot_read(fmt::format("{} joins ranges of different sizes", what));
    }
    return forwards(result);
}

/// Whether two readings are the same joint seen from the same side; names do not count, nor what
/// carries one side onto the other.
bool same_joint(const Interface& a, const Interface& b) {
    return a.zone == b.zone && a.donor == b.donor && a.box == b.box && a.donor_box == b.donor_box &&
           a.orientation == b.orientation;
}

/// The rectangle that a range spans or a list of points fills; nothing when it fills none.
std::optional<IndexBox> bounding_box(const std::vector<cgsize_t>& indices, int cell_dimension,
                                     bool must_fill) {
    IndexBox box;
    const auto dimension = static_cast<std::size_t>(cell_dimension);
    auto filled = static_cast<double>(dimension);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        cgsize_t least = std::numeric_limits<cgsize_t>::max();
        cgsize_t most = 0;
        for (std::size_t at = axis; at < indices.size(); at += dimension) {
            least = std::min(least, indices[at]);
            most = std::max(most, indices[at]);
        }
        if (least < 1 || most >= std::numeric_limits<int>::max()) return std::nullopt;
        box.begin[axis] = static_cast<int>(least - 1);
        box.end[axis] = static_cast<int>(most - 1);
        filled *= static_cast<double>(most - least + 1);
    }
    if (must_fill && filled != static_cast<double>(indices.size())) return std::nullopt;
    return box;
}

/// The nodes of a box of faces (of edges in two dimensions), whose indices count cells along the
/// axes that lie in the boundary; nothing for a location that means no such thing.
std::optional<IndexBox> nodes_of(IndexBox box, GridLocation_t location, const Extent& extent,
                                 int cell_dimension) {
    if (location == Vertex) return box;
    int normal = -1;
    if (location == IFaceCenter || location == JFaceCenter || location == KFaceCenter) {
        normal = static_cast<int>(location) - static_cast<int>(IFaceCenter);
    } else if (location == FaceCenter || location == EdgeCenter) {
        for (int axis = cell_dimension - 1; axis >= 0; --axis) {
            const auto a = static_cast<std::size_t>(axis);
            const bool at_end = box.begin[a] == 0 || box.begin[a] == extent[axis] - 1;
            if (box.begin[a] == box.end[a] && at_end) normal = axis;
        }
    }
    if (normal < 0) return std::nullopt;
    for (int axis = 0; axis < cell_dimension; ++axis) {
        if (axis != normal) ++box.end[static_cast<std::size_t>(axis)];
    }
    return box;
}

/// What a BC_t node says about itself, before its points.
struct Condition {
    std::string what;  ///< for messages: which one it is
    CgnsName name{};
    BCType_t type{};
    PointSetType_t set{};
    cgsize_t points = 0;
};

Condition read_condition(const CgnsSource& source, const std::string& zone_name, int zone,
                         int number) {
    Condition condition;
    std::array<int, 3> normal{};
    cgsize_t normal_size = 0;
    DataType_t normal_type{};
    int data_sets = 0;
    source.check(cg_boco_info(
        source.file(), CgnsSource::base(), zone + 1, number, condition.name.data(), &condition.type,
        &condition.set, &condition.points, normal.data(), &normal_size, &normal_type, &data_sets));
    condition.what =
        fmt::format("boundary condition '{}' of zone '{}'", condition.name.data(), zone_name);
    return condition;
}

IndexBox read_nodes(const CgnsSource& source, const GridOutline& grid, int zone, int number,
                    const Condition& condition) {
    const Extent& extent = zone_of(grid, zone).extent;
    const bool is_range = condition.set == PointRange || condition.set == ElementRange;
    const bool is_list = condition.set == PointList || condition.set == ElementList;
    std::optional<IndexBox> box;
    if ((is_range && condition.points == 2) || (is_list && condition.points > 0)) {
        std::vector<cgsize_t> indices(static_cast<std::size_t>(condition.points) *
                                      static_cast<std::size_t>(grid.cell_dimension));
        source.check(cg_boco_read(source.file(), CgnsSource::base(), zone + 1, number,
                                  indices.data(), nullptr));
        box = bounding_box(indices, grid.cell_dimension, is_list);
    }
    if (!box) {
        source.cannot_read(fmt::format("{} is not a rectangle of nodes or faces", condition.what));
    }
    GridLocation_t location = Vertex;
    source.check(
        cg_boco_gridlocation_read(source.file(), CgnsSource::base(), zone + 1, number, &location));
    box = nodes_of(*box, location, extent, grid.cell_dimension);
    if (!box) {
        source.cannot_read(
            fmt::format("{} has a GridLocation that hexweave does not know", condition.what));
    }
    if (!lies_in(*box, extent)) {
        source.cannot_read(fmt::format("{} lies outside the zone", condition.what));
    }
    return *box;
}

/// The family that a boundary condition names; one called like its literal type when it names none.
int read_family(const CgnsSource& source, int zone, int number, const Condition& condition,
                std::vector<Family>& families) {
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone + 1, "ZoneBC_t", 1,
                         "BC_t", number, "end"));
    CgnsName name{};
    const int answer = cg_famname_read(name.data());
    if (answer != CG_OK && answer != CG_NODE_NOT_FOUND) source.damaged();
    if (answer == CG_NODE_NOT_FOUND && condition.type == FamilySpecified) {
        source.cannot_read(
            fmt::format("{} leaves its type to a family and names none", condition.what));
    }
    const std::string type = boundary_type_name(condition.type);
    const std::string family = answer == CG_OK ? name.data() : type;
    const auto place = std::find_if(families.begin(), families.end(), [&](const Family& candidate) {
        return candidate.name == family;
    });
    const int index = static_cast<int>(place - families.begin());
    if (place == families.end()) {
        families.push_back(
            {family, condition.type == FamilySpecified ? "UserDefined" : type, true});
    }
    return index;
}

/// What a boundary condition says its type is, where its family does not say the same; empty where
/// it leaves the type to its family.
std::string own_type(BCType_t type, const Family& family) {
    if (!family.undeclared && (type == FamilySpecified || type == BCTypeNull)) return {};
    const std::string name = boundary_type_name(type == FamilySpecified ? BCTypeUserDefined : type);
    // The family's "UserDefined:NAME" says more.
    return family.type == name || family.type.starts_with(name + ":") ? std::string() : name;
}

}  // namespace

void read_interfaces(const CgnsSource& source, GridOutline& grid) {
    std::vector<TwoEnds> awaited;  // those read on their first side, and what the second is to say
    for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
        int count = 0;
        source.check(cg_n1to1(source.file(), CgnsSource::base(), zone + 1, &count));
        for (int number = 1; number <= count; ++number) {
            const Interface found = read_interface(source, grid, zone, number);
            const auto same =
                std::find_if(awaited.begin(), awaited.end(),
                             [&](const TwoEnds& ends) { return same_joint(ends.second, found); });
            if (same == awaited.end()) {
                awaited.push_back({found, other_side(found)});
                grid.interfaces.push_back(found);
                continue;
            }
            if (!(same->second.periodic == found.periodic)) {
                grid.ends_apart.push_back({same->first, found});
            }
            awaited.erase(same);
        }
    }
}

void read_patches(const CgnsSource& source, GridOutline& grid) {
    for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
        int count = 0;
        source.check(cg_nbocos(source.file(), CgnsSource::base(), zone + 1, &count));
        for (int number = 1; number <= count; ++number) {
            const Condition condition =
                read_condition(source, zone_of(grid, zone).name, zone, number);
            const IndexBox box = read_nodes(source, grid, zone, number, condition);
            const int family = read_family(source, zone, number, condition, grid.families);
            grid.patches.push_back(
                {condition.name.data(), zone, box, family,
                 own_type(condition.type, grid.families[static_cast<std::size_t>(family)])});
        }
    }
}

}  // namespace hexweave
