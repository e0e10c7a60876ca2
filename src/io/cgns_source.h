// SPDX-License-Identifier: Apache-2.0
// A CGNS file while it is read: the parts of the reader share it.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/grid_outline.h"
#include "io/cgns_library.h"

namespace hexweave {

/// Room for a name that libcgns writes.
using CgnsName = std::array<char, longest_cgns_name + 1>;

/// What becomes of the parts of a file that are no structured grid: further bases, unstructured
/// zones, boundary conditions that cover no rectangle.
enum class OtherParts { refused, left_out };

/// An open file; of several bases the first one. The functions below throw UsageError.
class CgnsSource {
public:
    explicit CgnsSource(const std::filesystem::path& path, OtherParts parts = OtherParts::refused);

    int file() const { return file_; }
    bool leaves_out() const { return parts_ == OtherParts::left_out; }
    static constexpr int base() { return 1; }

    [[noreturn]] void cannot_read(const std::string& fact) const;
    [[noreturn]] void damaged() const;
    /// Every function of libcgns answers with zero when it succeeds.
    void check(int answer) const {
        if (answer != CG_OK) damaged();
    }

private:
    std::filesystem::path path_;
    OtherParts parts_;
    Hdf5Errors errors_;
    CgnsFile file_;
};

inline const ZoneOutline& zone_of(const GridOutline& grid, int zone) {
    return grid.zones[static_cast<std::size_t>(zone)];
}

/// Whether a zone of this extent has all nodes of the box.
bool lies_in(const IndexBox& box, const Extent& extent);

/// Everything but the coordinates, and what else the file holds.
GridOutline read_outline(const CgnsSource& source);

/// Reads the points of a box of one zone, which runs forwards, as doubles, i fastest, to x, y and
/// z; zeros to z where the space has two dimensions.
void read_points(const CgnsSource& source, const GridOutline& grid, int zone, const IndexBox& box,
                 const std::array<double*, 3>& to);

/// Units as they hold at a node: those of the nearest of it and the nodes around it that say any.
struct NodeUnits {
    std::string length;  ///< "m"; empty when none is known
    double radians = 1;  ///< in a unit of angle
};

/// Of a coordinate; zones and coordinates are counted from 1.
NodeUnits units_of_coordinate(const CgnsSource& source, int zone, int coordinate);

/// What carries the two sides of one-to-one interface `number` of a zone of `grid` onto each other,
/// in the grid's unit of length and in radians; nothing where they are the same points.
std::optional<Periodicity> read_periodicity(const CgnsSource& source, const GridOutline& grid,
                                            int zone, int number);

/// Adds the one-to-one interfaces of all zones of `grid`, each once, on the side that comes first;
/// also both ends of those whose ends may contradict each other.
void read_interfaces(const CgnsSource& source, GridOutline& grid);

/// Adds the boundary conditions of all zones of `grid` as patches, and the families that the file
/// does not declare: one called like its type for each literal type without a family. A patch whose
/// own type is not its family's keeps it.
void read_patches(const CgnsSource& source, GridOutline& grid);

/// The nodes of the file that no function here reads, and those that were left out of `outline`, by
/// kind, in the order of the tree.
std::vector<OtherNodes> find_other_nodes(const CgnsSource& source, const GridOutline& outline);

/// Throws UsageError unless `path` is a file that this process may read.
void require_readable(const std::filesystem::path& path);

/// Makes a child process one that may die quietly: signals end it, it dumps no core, prints
/// nothing.
void become_expendable();

/// Calls reader() in a child process and throws what it met: on damaged files libcgns and HDF5 run
/// over the ends of their arrays, or call exit.
void rehearse(const std::filesystem::path& path, const std::function<void()>& reader);

}  // namespace hexweave
