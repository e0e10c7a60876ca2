// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/cgns_source.h"

namespace hexweave {
namespace {

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

Condition read_condition(const CgnsSource& source, const ZoneOutline& zone, int number) {
    Condition condition;
    std::array<int, 3> normal{};
    cgsize_t normal_size = 0;
    DataType_t normal_type{};
    int data_sets = 0;
    source.check(cg_boco_info(source.file(), CgnsSource::base(), zone.number, number,
                              condition.name.data(), &condition.type, &condition.set,
                              &condition.points, normal.data(), &normal_size, &normal_type,
                              &data_sets));
    condition.what =
        fmt::format("boundary condition '{}' of zone '{}'", condition.name.data(), zone.name);
    return condition;
}

/// Nothing where a condition that covers no rectangle is to be left out.
std::optional<IndexBox> read_nodes(const CgnsSource& source, const GridOutline& grid, int zone,
                                   int number, const Condition& condition) {
    const auto& [name, extent, zone_number] = zone_of(grid, zone);
    const bool is_range = condition.set == PointRange || condition.set == ElementRange;
    const bool is_list = condition.set == PointList || condition.set == ElementList;
    std::optional<IndexBox> box;
    if ((is_range && condition.points == 2) || (is_list && condition.points > 0)) {
        std::vector<cgsize_t> indices(static_cast<std::size_t>(condition.points) *
                                      static_cast<std::size_t>(grid.cell_dimension));
        source.check(cg_boco_read(source.file(), CgnsSource::base(), zone_number, number,
                                  indices.data(), nullptr));
        box = bounding_box(indices, grid.cell_dimension, is_list);
    }
    if (!box && source.leaves_out()) return std::nullopt;
    if (!box) {
        source.cannot_read(fmt::format("{} is not a rectangle of nodes or faces", condition.what));
    }
    GridLocation_t location = Vertex;
    source.check(cg_boco_gridlocation_read(source.file(), CgnsSource::base(), zone_number, number,
                                           &location));
    box = nodes_of(*box, location, extent, grid.cell_dimension);
    if (!box) {
        source.cannot_read(
            fmt::format("{} has a GridLocation that hexweave does not know", condition.what));
    }
    if (!lies_in(*box, extent)) {
        source.cannot_read(fmt::format("{} lies outside the zone", condition.what));
    }
    return box;
}

/// The family that a boundary condition names; one called like its literal type when it names none.
int read_family(const CgnsSource& source, int zone, int number, const Condition& condition,
                std::vector<Family>& families) {
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone, "ZoneBC_t", 1, "BC_t",
                         number, "end"));
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

bool lies_in(const IndexBox& box, const Extent& extent) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (const int index : {box.begin[a], box.end[a]}) {
            if (index < 0 || index >= extent[axis]) return false;
        }
    }
    return true;
}

void read_patches(const CgnsSource& source, GridOutline& grid) {
    for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
        const ZoneOutline& outline = zone_of(grid, zone);
        int count = 0;
        source.check(cg_nbocos(source.file(), CgnsSource::base(), outline.number, &count));
        for (int number = 1; number <= count; ++number) {
            const Condition condition = read_condition(source, outline, number);
            const auto box = read_nodes(source, grid, zone, number, condition);
            if (!box) continue;
            const int family =
                read_family(source, outline.number, number, condition, grid.families);
            grid.patches.push_back(
                {condition.name.data(), zone, *box, family,
                 own_type(condition.type, grid.families[static_cast<std::size_t>(family)])});
        }
    }
}

}  // namespace hexweave
