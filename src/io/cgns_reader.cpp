// SPDX-License-Identifier: Apache-2.0
#include "io/cgns.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.h"
#include "io/cgns_interface.h"
#include "io/cgns_library.h"
#include "io/output_files.h"

namespace hexweave {
namespace {

using Name = std::array<char, longest_cgns_name + 1>;

class Reader {
public:
    explicit Reader(const std::filesystem::path& path) : path_(path), file_(path, CG_MODE_READ) {
        if (!file_.is_open()) damaged();
        errors_.listen();
    }

    MultiblockGrid read() {
        read_base();
        read_families();
        int zones = 0;
        check(cg_nzones(file_, base_, &zones));
        if (zones < 1) cannot_read("it holds no zones");
        for (int zone = 1; zone <= zones; ++zone) read_zone(zone);
        for (int zone = 1; zone <= zones; ++zone) read_interfaces(zone);
        for (int zone = 1; zone <= zones; ++zone) read_patches(zone);
        return std::move(grid_);
    }

private:
    [[noreturn]] void cannot_read(const std::string& fact) const {
        throw UsageError("cannot read '" + path_.string() + "': " + fact);
    }
    [[noreturn]] void damaged() const {
        cannot_read("it is damaged or no CGNS file (" + std::string(cg_get_error()) + ")");
    }

    /// Every function of libcgns answers with zero when it succeeds.
    void check(int answer) const {
        if (answer != CG_OK) damaged();
    }

    void read_base() {
        int bases = 0;
        check(cg_nbases(file_, &bases));
        if (bases < 1) cannot_read("it holds no base");
        if (bases > 1) {
            cannot_read("it holds " + std::to_string(bases) +
                        " bases; hexweave reads files with one");
        }
        Name name{};
        check(cg_base_read(file_, base_, name.data(), &grid_.cell_dimension,
                           &grid_.physical_dimension));
        if (grid_.cell_dimension < 2 || grid_.cell_dimension > 3 ||
            grid_.physical_dimension < grid_.cell_dimension || grid_.physical_dimension > 3) {
            cannot_read("its cells have " + std::to_string(grid_.cell_dimension) +
                        " dimensions in a space of " + std::to_string(grid_.physical_dimension) +
                        "; hexweave reads 2 in 2, 2 in 3 and 3 in 3");
        }
        check(cg_goto(file_, base_, "end"));
        grid_.units = read_units();
        int descriptors = 0;
        check(cg_ndescriptors(&descriptors));
        for (int number = 1; number <= descriptors; ++number) read_descriptor(number);
    }

    void read_descriptor(int number) {
        Name name{};
        char* text = nullptr;
        check(cg_descriptor_read(number, name.data(), &text));
        if (text == nullptr) return;
        if (std::string(name.data()) == title_descriptor) grid_.title = text;
        if (std::string(name.data()) == provenance_descriptor) grid_.provenance = text;
        cg_free(text);
    }

    /// The length unit at the current node; empty when none is given.
    static std::string read_units() {
        MassUnits_t mass{};
        LengthUnits_t length{};
        TimeUnits_t time{};
        TemperatureUnits_t temperature{};
        AngleUnits_t angle{};
        if (cg_units_read(&mass, &length, &time, &temperature, &angle) != CG_OK) return {};
        return unit_symbol(length);
    }

    /// Families that say a boundary condition; others (of volumes) are none of ours.
    void read_families() {
        int families = 0;
        check(cg_nfamilies(file_, base_, &families));
        for (int number = 1; number <= families; ++number) {
            Name name{};
            int conditions = 0;
            int geometries = 0;
            check(cg_family_read(file_, base_, number, name.data(), &conditions, &geometries));
            if (conditions < 1) continue;
            Name condition{};
            BCType_t type = BCTypeNull;
            check(cg_fambc_read(file_, base_, number, 1, condition.data(), &type));
            std::string type_name = boundary_type_name(type);
            if (type == BCTypeUserDefined) type_name += read_meaning(number, name.data());
            grid_.families.push_back({name.data(), type_name});
        }
    }

    /// ":NAME" of a user-defined family whose child says more than the family's own name.
    std::string read_meaning(int family, const std::string& family_name) const {
        int children = 0;
        check(cg_goto(file_, base_, "Family_t", family, "end"));
        check(cg_nuser_data(&children));
        if (children != 1) return {};
        Name meaning{};
        check(cg_user_data_read(1, meaning.data()));
        return family_name == meaning.data() ? "" : std::string(":") + meaning.data();
    }

    void read_zone(int number) {
        Name name{};
        ZoneType_t type{};
        check(cg_zone_type(file_, base_, number, &type));
        std::array<cgsize_t, 9> size{};
        check(cg_zone_read(file_, base_, number, name.data(), size.data()));
        const std::string zone = "zone '" + std::string(name.data()) + "' ";
        if (type != Structured) {
            cannot_read(zone + "is unstructured; hexweave reads structured zones only");
        }
        std::array<int, 3> nodes{1, 1, 1};
        for (std::size_t axis = 0; axis < dimension(); ++axis) {
            if (size[axis] < 2 || size[axis] > std::numeric_limits<int>::max()) {
                cannot_read(zone + "has " + std::to_string(size[axis]) + " nodes along an axis");
            }
            nodes[axis] = static_cast<int>(size[axis]);
        }
        const Extent extent{nodes[0], nodes[1], nodes[2]};
        require_memory(zone, extent);
        Zone result{name.data(), PointField(extent)};
        read_coordinate(number, zone, "CoordinateX", result.points.x);
        read_coordinate(number, zone, "CoordinateY", result.points.y);
        if (grid_.physical_dimension == 3) {
            read_coordinate(number, zone, "CoordinateZ", result.points.z);
        }
        grid_.zones.push_back(std::move(result));
    }

    /// A damaged size must not make the machine run out of memory.
    void require_memory(const std::string& zone, const Extent& extent) const {
        const double needed = 3.0 * sizeof(double) * extent.ni * extent.nj * extent.nk;
        const double present = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                               static_cast<double>(sysconf(_SC_PAGE_SIZE));
        if (needed <= present) return;
        throw MachineError("cannot read '" + path_.string() + "': " + zone + "needs " +
                           std::to_string(needed / 1e9) + " GB of memory, this machine has " +
                           std::to_string(present / 1e9));
    }

    void read_coordinate(int zone, const std::string& zone_name, const std::string& name,
                         Field& values) {
        int coordinates = 0;
        check(cg_ncoords(file_, base_, zone, &coordinates));
        int found = 0;
        for (int number = 1; number <= coordinates; ++number) {
            Name candidate{};
            DataType_t type{};
            check(cg_coord_info(file_, base_, zone, number, &type, candidate.data()));
            if (name == candidate.data()) found = number;
        }
        if (found == 0) cannot_read(zone_name + "has no " + name);
        const std::array<cgsize_t, 3> first{1, 1, 1};
        const std::array<cgsize_t, 3> last{values.extent().ni, values.extent().nj,
                                           values.extent().nk};
        check(cg_coord_read(file_, base_, zone, name.c_str(), RealDouble, first.data(), last.data(),
                            values.data()));
        if (!grid_.units.empty()) return;
        check(cg_goto(file_, base_, "Zone_t", zone, "GridCoordinates_t", 1, "DataArray_t", found,
                      "end"));
        grid_.units = read_units();
    }

    std::size_t dimension() const { return static_cast<std::size_t>(grid_.cell_dimension); }

    /// CGNS counts from 1 and lists all of begin, then all of end.
    IndexBox to_box(const cgsize_t* range) const {
        IndexBox box;
        for (std::size_t axis = 0; axis < dimension(); ++axis) {
            box.begin[axis] = static_cast<int>(range[axis] - 1);
            box.end[axis] = static_cast<int>(range[axis + dimension()] - 1);
        }
        return box;
    }

    bool lies_in(const IndexBox& box, int zone) const {
        const Extent& extent = grid_.zones[static_cast<std::size_t>(zone)].points.extent();
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            for (const int index : {box.begin[a], box.end[a]}) {
                if (index < 0 || index >= extent[axis]) return false;
            }
        }
        return true;
    }

    void read_interfaces(int zone) {
        int count = 0;
        check(cg_n1to1(file_, base_, zone, &count));
        for (int number = 1; number <= count; ++number) {
            const Interface found = read_interface(zone, number);
            const auto same = std::find(awaited_.begin(), awaited_.end(), AwaitedSide{found});
            if (same != awaited_.end()) {
                awaited_.erase(same);
                continue;
            }
            awaited_.push_back({other_side(found)});
            grid_.interfaces.push_back(found);
        }
    }

    Interface read_interface(int zone, int number) const {
        Name name{};
        Name donor{};
        std::array<cgsize_t, 6> range{};
        std::array<cgsize_t, 6> donor_range{};
        std::array<int, 3> transform{1, 2, 3};
        check(cg_1to1_read(file_, base_, zone, number, name.data(), donor.data(), range.data(),
                           donor_range.data(), transform.data()));
        const auto& zones = grid_.zones;
        const auto place = std::find_if(zones.begin(), zones.end(), [&](const Zone& candidate) {
            return candidate.name == donor.data();
        });
        const std::string what = "interface '" + std::string(name.data()) + "' of zone '" +
                                 zones[static_cast<std::size_t>(zone - 1)].name + "' ";
        if (place == zones.end()) {
            cannot_read(what + "leads to '" + donor.data() + "', which is not in the file");
        }
        const Interface result{name.data(),
                               zone - 1,
                               to_box(range.data()),
                               static_cast<int>(place - zones.begin()),
                               to_box(donor_range.data()),
                               Orientation{transform}};
        if (!is_permutation(result.orientation)) cannot_read(what + "has no valid Transform");
        if (!lies_in(result.box, result.zone) || !lies_in(result.donor_box, result.donor)) {
            cannot_read(what + "lies outside its zones");
        }
        if (!boxes_agree(result)) cannot_read(what + "joins ranges of different sizes");
        return forwards(result);
    }

    bool is_permutation(const Orientation& orientation) const {
        std::array<bool, 3> seen{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int other = orientation.axes[axis];
            if (other == 0 || other < -3 || other > 3) return false;
            seen[static_cast<std::size_t>(std::abs(other) - 1)] = true;
        }
        return seen[0] && seen[1] && seen[2] && (dimension() == 3 || orientation.axes[2] == 3);
    }

    static bool boxes_agree(const Interface& interface) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int other = interface.orientation.axes[axis];
            const auto across = static_cast<std::size_t>(std::abs(other) - 1);
            const int own = interface.box.end[axis] - interface.box.begin[axis];
            const int donor = interface.donor_box.end[across] - interface.donor_box.begin[across];
            if (donor != (other > 0 ? own : -own)) return false;
        }
        return true;
    }

    void read_patches(int zone) {
        int count = 0;
        check(cg_nbocos(file_, base_, zone, &count));
        for (int number = 1; number <= count; ++number) read_patch(zone, number);
    }

    void read_patch(int zone, int number) {
        Name name{};
        BCType_t type{};
        PointSetType_t set{};
        cgsize_t points = 0;
        std::array<int, 3> normal{};
        cgsize_t normal_size = 0;
        DataType_t normal_type{};
        int data_sets = 0;
        check(cg_boco_info(file_, base_, zone, number, name.data(), &type, &set, &points,
                           normal.data(), &normal_size, &normal_type, &data_sets));
        const std::string what = "boundary condition '" + std::string(name.data()) + "' of zone '" +
                                 grid_.zones[static_cast<std::size_t>(zone - 1)].name + "' ";
        const std::optional<IndexBox> range = read_box(zone, number, set, points);
        if (!range) cannot_read(what + "is not a rectangle of nodes or faces");
        const std::optional<IndexBox> box = to_nodes(zone, number, *range);
        if (!box) cannot_read(what + "has a GridLocation that hexweave does not know");
        if (!lies_in(*box, zone - 1)) cannot_read(what + "lies outside the zone");
        grid_.patches.push_back(
            {name.data(), zone - 1, *box, read_family(zone, number, type, what)});
    }

    /// The rectangle that a range spans or a list of points fills; nothing when it fills none.
    std::optional<IndexBox> read_box(int zone, int number, PointSetType_t set,
                                     cgsize_t points) const {
        const bool is_range = set == PointRange || set == ElementRange;
        const bool is_list = set == PointList || set == ElementList;
        if (!(is_range && points == 2) && !(is_list && points > 0)) return std::nullopt;
        std::vector<cgsize_t> indices(static_cast<std::size_t>(points) * dimension());
        check(cg_boco_read(file_, base_, zone, number, indices.data(), nullptr));
        IndexBox box;
        double filled = 1;
        for (std::size_t axis = 0; axis < dimension(); ++axis) {
            cgsize_t least = std::numeric_limits<cgsize_t>::max();
            cgsize_t most = 0;
            for (std::size_t at = axis; at < indices.size(); at += dimension()) {
                least = std::min(least, indices[at]);
                most = std::max(most, indices[at]);
            }
            if (least < 1) return std::nullopt;
            box.begin[axis] = static_cast<int>(least - 1);
            box.end[axis] = static_cast<int>(most - 1);
            filled *= static_cast<double>(most - least + 1);
        }
        if (is_list && filled != static_cast<double>(points)) return std::nullopt;
        return box;
    }

    /// The nodes of a box of faces (of edges in two dimensions), whose indices count cells along
    /// the axes that lie in the boundary.
    std::optional<IndexBox> to_nodes(int zone, int number, IndexBox box) const {
        GridLocation_t location = Vertex;
        check(cg_boco_gridlocation_read(file_, base_, zone, number, &location));
        if (location == Vertex) return box;
        const Extent& extent = grid_.zones[static_cast<std::size_t>(zone - 1)].points.extent();
        int normal = -1;
        if (location == IFaceCenter || location == JFaceCenter || location == KFaceCenter) {
            normal = static_cast<int>(location) - static_cast<int>(IFaceCenter);
        } else if (location == FaceCenter || location == EdgeCenter) {
            for (int axis = grid_.cell_dimension - 1; axis >= 0; --axis) {
                const auto a = static_cast<std::size_t>(axis);
                const bool at_end = box.begin[a] == 0 || box.begin[a] == extent[axis] - 1;
                if (box.begin[a] == box.end[a] && at_end) normal = axis;
            }
        }
        if (normal < 0) return std::nullopt;
        for (int axis = 0; axis < grid_.cell_dimension; ++axis) {
            if (axis != normal) ++box.end[static_cast<std::size_t>(axis)];
        }
        return box;
    }

    /// The family that a boundary condition names; one called like its literal type when it names
    /// none.
    int read_family(int zone, int number, BCType_t type, const std::string& what) {
        check(cg_goto(file_, base_, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end"));
        Name name{};
        const int answer = cg_famname_read(name.data());
        if (answer != CG_OK && answer != CG_NODE_NOT_FOUND) damaged();
        const std::string type_name = boundary_type_name(type);
        if (answer == CG_NODE_NOT_FOUND && type == FamilySpecified) {
            cannot_read(what + "leaves its type to a family and names none");
        }
        const std::string family = answer == CG_OK ? name.data() : type_name;
        auto& families = grid_.families;
        const auto place =
            std::find_if(families.begin(), families.end(),
                         [&](const Family& candidate) { return candidate.name == family; });
        const int index = static_cast<int>(place - families.begin());
        if (place == families.end()) {
            families.push_back({family, type == FamilySpecified ? "UserDefined" : type_name});
        }
        return index;
    }

    /// The second side of an interface that was read on its first.
    struct AwaitedSide {
        Interface side;
        friend bool operator==(const AwaitedSide& a, const AwaitedSide& b) {
            return a.side.zone == b.side.zone && a.side.donor == b.side.donor &&
                   a.side.box == b.side.box && a.side.donor_box == b.side.donor_box &&
                   a.side.orientation == b.side.orientation;
        }
    };

    std::filesystem::path path_;
    Hdf5Errors errors_;
    CgnsFile file_;
    int base_ = 1;
    MultiblockGrid grid_;
    std::vector<AwaitedSide> awaited_;
};

}  // namespace

MultiblockGrid read_cgns(const std::filesystem::path& path) {
    const auto cannot_read = [&](const std::string& reason) {
        throw UsageError("cannot read '" + path.string() + "': " + reason);
    };
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
        cannot_read(errno == ENOENT ? "no such file" : error_reason(errno));
    }
    if (S_ISDIR(status.st_mode)) cannot_read("it is a folder");
    if (!S_ISREG(status.st_mode)) cannot_read("it is not a regular file");
    if (access(path.c_str(), R_OK) != 0) cannot_read(error_reason(errno));
    int type = CG_FILE_NONE;
    const Hdf5Errors quiet;
    if (cg_is_cgns(path.c_str(), &type) != CG_OK) cannot_read("it is not a CGNS file");
    return Reader(path).read();
}

}  // namespace hexweave
