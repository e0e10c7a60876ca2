// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <limits>
#include <string>
#include <utility>

#include "core/errors.h"
#include "io/cgns.h"
#include "io/cgns_source.h"
#include "io/output_files.h"

namespace hexweave {
namespace {

/// The length unit at the current node; empty when none is given.
std::string read_units() {
    MassUnits_t mass{};
    LengthUnits_t length{};
    TimeUnits_t time{};
    TemperatureUnits_t temperature{};
    AngleUnits_t angle{};
    if (cg_units_read(&mass, &length, &time, &temperature, &angle) != CG_OK) return {};
    return unit_symbol(length);
}

void read_descriptors(const CgnsSource& source, MultiblockGrid& grid) {
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

void read_base(const CgnsSource& source, MultiblockGrid& grid) {
    int bases = 0;
    source.check(cg_nbases(source.file(), &bases));
    if (bases < 1) source.cannot_read("it holds no base");
    if (bases > 1) {
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
    grid.units = read_units();
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
void read_families(const CgnsSource& source, MultiblockGrid& grid) {
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

/// Reads one coordinate as doubles, and its units when the base has none.
void read_coordinate(const CgnsSource& source, int zone, const std::string& name,
                     const std::string& zone_name, Field& values, std::string& units) {
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
    const Extent& extent = values.extent();
    const std::array<cgsize_t, 3> first{1, 1, 1};
    const std::array<cgsize_t, 3> last{extent.ni, extent.nj, extent.nk};
    source.check(cg_coord_read(source.file(), CgnsSource::base(), zone, name.c_str(), RealDouble,
                               first.data(), last.data(), values.data()));
    if (!units.empty()) return;
    source.check(cg_goto(source.file(), CgnsSource::base(), "Zone_t", zone, "GridCoordinates_t", 1,
                         "DataArray_t", found, "end"));
    units = read_units();
}

Extent read_extent(const CgnsSource& source, int number, int cell_dimension, CgnsName& name) {
    ZoneType_t type{};
    std::array<cgsize_t, 9> size{};
    source.check(cg_zone_type(source.file(), CgnsSource::base(), number, &type));
    source.check(cg_zone_read(source.file(), CgnsSource::base(), number, name.data(), size.data()));
    if (type != Structured) {
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
    return {nodes[0], nodes[1], nodes[2]};
}

void read_zone(const CgnsSource& source, int number, MultiblockGrid& grid) {
    CgnsName name{};
    const Extent extent = read_extent(source, number, grid.cell_dimension, name);
    require_memory(source, name.data(), extent);
    Zone zone{name.data(), PointField(extent)};
    read_coordinate(source, number, "CoordinateX", zone.name, zone.points.x, grid.units);
    read_coordinate(source, number, "CoordinateY", zone.name, zone.points.y, grid.units);
    if (grid.physical_dimension == 3) {
        read_coordinate(source, number, "CoordinateZ", zone.name, zone.points.z, grid.units);
    }
    grid.zones.push_back(std::move(zone));
}

MultiblockGrid read_grid(const std::filesystem::path& path) {
    const CgnsSource source(path);
    MultiblockGrid grid;
    read_base(source, grid);
    read_families(source, grid);
    int zones = 0;
    source.check(cg_nzones(source.file(), CgnsSource::base(), &zones));
    if (zones < 1) source.cannot_read("it holds no zones");
    for (int zone = 1; zone <= zones; ++zone) read_zone(source, zone, grid);
    read_interfaces(source, grid);
    read_patches(source, grid);
    return grid;
}

/// The child's part of `rehearse`: reads the file, writes the error there is to `answer`.
[[noreturn]] void read_and_answer(const std::filesystem::path& path, int answer) {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGABRT, SIGFPE}) {
        std::signal(signal_number, SIG_DFL);
    }
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        read_grid(path);
    } catch (const UsageError& error) {
        const std::string text = error.what();
        if (write(answer, text.data(), text.size()) < 0) _exit(1);
    } catch (const std::exception&) {
        // The machine's failure (out of memory), not the file's: the parent will meet it as well.
    }
    _exit(0);
}

/// Reads the file in a child process first, and throws what it met: on damaged files libcgns and
/// HDF5 run over the ends of their arrays, or call exit.
void rehearse(const std::filesystem::path& path) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw MachineError("cannot make a pipe");
    const pid_t child = fork();
    if (child == 0) read_and_answer(path, ends[1]);
    close(ends[1]);
    std::string text;
    std::array<char, 4096> part{};
    ssize_t size = 0;
    do {
        size = read(ends[0], part.data(), part.size());
        if (size > 0) text.append(part.data(), static_cast<std::size_t>(size));
    } while (size > 0 || (size < 0 && errno == EINTR));
    close(ends[0]);
    if (child < 0) throw MachineError("cannot start another process");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (!text.empty()) throw UsageError(text);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw UsageError(fmt::format("cannot read '{}': it is damaged", path.string()));
    }
}

}  // namespace

CgnsSource::CgnsSource(const std::filesystem::path& path) : path_(path), file_(path, CG_MODE_READ) {
    if (!file_.is_open()) {
        int type = CG_FILE_NONE;
        if (cg_is_cgns(path_.c_str(), &type) != CG_OK) cannot_read("it is not a CGNS file");
        damaged();
    }
    errors_.listen();
}

void CgnsSource::cannot_read(const std::string& fact) const {
    throw UsageError(fmt::format("cannot read '{}': {}", path_.string(), fact));
}

void CgnsSource::damaged() const {
    cannot_read(fmt::format("it is damaged ({})", cg_get_error()));
}

MultiblockGrid read_cgns(const std::filesystem::path& path) {
    const auto cannot_read = [&](const std::string& reason) {
        throw UsageError(fmt::format("cannot read '{}': {}", path.string(), reason));
    };
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
        cannot_read(errno == ENOENT ? "no such file" : error_reason(errno));
    }
    if (S_ISDIR(status.st_mode)) cannot_read("it is a folder");
    if (!S_ISREG(status.st_mode)) cannot_read("it is not a regular file");
    if (access(path.c_str(), R_OK) != 0) cannot_read(error_reason(errno));
    rehearse(path);
    return read_grid(path);
}

}  // namespace hexweave
