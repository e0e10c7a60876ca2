// SPDX-License-Identifier: Apache-2.0
// A finished multiblock grid: zones, what joins them, what bounds them. What the writers write, the
// readers read and the measures measure; it knows nothing of how the grid was made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/field.h"
#include "core/orientation.h"

namespace hexweave {

/// One structured block of nodes: extent (ni, nj, nk), nk = 1 for a face of a 2D or surface grid.
struct Zone {
    std::string name;
    PointField points;
};

/// What carries the nodes of an interface's own zone onto those of its donor, where they are not
/// the same points (CGNS: Periodic_t): a rotation about `center` by `angle` about x, y and z, in
/// radians, or a translation.
struct Periodicity {
    Vec3 center;
    Vec3 angle;
    Vec3 translation;

    friend bool operator==(const Periodicity&, const Periodicity&) = default;
};

/// What carries the donor's nodes back, for a turn about one of the axes or a translation.
inline Periodicity backwards(const Periodicity& periodicity) {
    return {periodicity.center, Vec3{} - periodicity.angle, Vec3{} - periodicity.translation};
}

/// A one-to-one interface, stored once; the writers write it on both sides. `box` runs forwards;
/// `donor_box` holds the donor nodes of box.begin and box.end. `orientation` takes the axes of
/// `zone` to those of `donor`. Zone and donor may be the same (a cut).
struct Interface {
    std::string name;
    int zone = 0;
    IndexBox box;
    int donor = 0;
    IndexBox donor_box;
    Orientation orientation;
    std::optional<Periodicity> periodic = std::nullopt;
};

/// The node of the donor zone that node `n` of the interface's own zone falls on.
inline Node donor_node(const Interface& interface, const Node& n) {
    return map_node(interface.orientation, n, interface.box.begin, interface.donor_box.begin);
}

/// A boundary condition family: its name and the name of its CGNS BCType ("BCWallViscous").
struct Family {
    std::string name;
    std::string type;
    /// A file names it and does not say its type, which is that of its first patch.
    bool undeclared = false;
};

/// A part of one zone's boundary that belongs to a family. `name` is the face (edge) it came from;
/// `type` is its own CGNS BCType, where a file says another than the family's.
struct BoundaryPatch {
    std::string name;
    int zone = 0;
    IndexBox box;
    int family = 0;
    std::string type = {};
};

/// The type of a patch: its own, or that of its family.
inline const std::string& type_of(const BoundaryPatch& patch, const std::vector<Family>& families) {
    return patch.type.empty() ? families[static_cast<std::size_t>(patch.family)].type : patch.type;
}

struct MultiblockGrid {
    std::string title;
    std::string units;           ///< "m", "mm", ...; empty when unknown
    int cell_dimension = 3;      ///< 2 or 3
    int physical_dimension = 3;  ///< 2 or 3
    std::vector<Zone> zones;
    std::vector<Interface> interfaces;
    std::vector<Family> families;
    std::vector<BoundaryPatch> patches;
    std::string provenance;  ///< version, hash of the config, overrides; no date, no host, no path
};

}  // namespace hexweave
