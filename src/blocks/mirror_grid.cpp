// SPDX-License-Identifier: Apache-2.0
#include "blocks/mirror_grid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/coordinate.h"
#include "core/interface_sides.h"

namespace hexweave {

namespace {

/// The grid before it was mirrored, and what is wanted of its image.
struct Half {
    const MultiblockGrid& grid;
    const MirrorCopy& mirror;
    int zones;  ///< the image of zone z is zone z + zones

    const Extent& extent(int zone) const {
        return grid.zones[static_cast<std::size_t>(zone)].points.extent();
    }
};

Vec3 mirrored(Vec3 p, const AxisPlane& plane) {
    double& across = coordinate(p, plane.axis);
    across = 2 * plane.value - across;
    return p;
}

Node mirrored(Node n, const Extent& extent) {
    n[0] = extent.ni - 1 - n[0];
    return n;
}

IndexBox mirrored(const IndexBox& box, const Extent& extent) {
    return {mirrored(box.begin, extent), mirrored(box.end, extent)};
}

/// With the ends along i changed, so that it runs forwards there if `box` did.
IndexBox mirrored_forwards(const IndexBox& box, const Extent& extent) {
    IndexBox image = mirrored(box, extent);
    std::swap(image.begin[0], image.end[0]);
    return image;
}

Zone mirrored(const Zone& zone, const AxisPlane& plane) {
    const Extent e = zone.points.extent();
    Zone image{zone.name + mirror_suffix, PointField(e)};
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                image.points.set(e.ni - 1 - i, j, k, mirrored(zone.points(i, j, k), plane));
            }
        }
    }
    return image;
}

/// A turn about a mirrored axis runs the other way round.
Periodicity mirrored(const Periodicity& periodicity, const AxisPlane& plane) {
    Periodicity image{mirrored(periodicity.center, plane), Vec3{} - periodicity.angle,
                      periodicity.translation};
    double& turn = coordinate(image.angle, plane.axis);
    turn = 0 - turn;
    double& way = coordinate(image.translation, plane.axis);
    way = 0 - way;
    return image;
}

/// The orientation where i runs backwards in both index spaces.
Orientation mirrored(const Orientation& orientation) {
    Orientation image = orientation;
    for (std::size_t own = 0; own < 3; ++own) {
        const bool own_i = own == 0;
        const bool other_i = std::abs(image.axes[own]) == 1;
        if (own_i != other_i) image.axes[own] = -image.axes[own];
    }
    return image;
}

Interface mirrored(const Half& half, const Interface& interface) {
    Interface image = interface;
    image.name += mirror_suffix;
    image.zone += half.zones;
    image.donor += half.zones;
    image.box = mirrored(interface.box, half.extent(interface.zone));
    image.donor_box = mirrored(interface.donor_box, half.extent(interface.donor));
    image.orientation = mirrored(interface.orientation);
    if (image.periodic) image.periodic = mirrored(*image.periodic, half.mirror.plane);
    return forwards(image);
}

/// The interface of a patch on the plane with its own image. Axes along the plane run as in the
/// image, i backwards; across it the zones go on from each other.
Interface at_plane(const Half& half, const BoundaryPatch& patch) {
    const Extent& extent = half.extent(patch.zone);
    Interface interface {
        patch.name, patch.zone, patch.box, patch.zone + half.zones,
            mirrored(patch.box, extent), Orientation {
            { -1, 2, 3 }
        }
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = extent[static_cast<int>(axis)] - 1;
        if (last == 0 || patch.box.begin[axis] != patch.box.end[axis]) continue;
        interface.orientation.axes[axis] = -interface.orientation.axes[axis];
        break;
    }
    return interface;
}

/// The families of some patches of the half and of the image.
using FamilyPlaces = std::vector<std::array<int, 2>>;

/// Families of the whole: without that at the plane, and with those of the image where they are
/// apart. Tells for every family of the half its new place, and that of its image.
FamilyPlaces renew_families(const Half& half, MultiblockGrid& grid) {
    FamilyPlaces places;
    grid.families.clear();
    for (std::size_t n = 0; n < half.grid.families.size(); ++n) {
        const int number = static_cast<int>(n);
        const int place = static_cast<int>(grid.families.size());
        const bool has_patches =
            std::any_of(half.grid.patches.begin(), half.grid.patches.end(),
                        [&](const BoundaryPatch& patch) { return patch.family == number; });
        const bool apart = half.mirror.families_apart && has_patches;
        places.push_back({place, apart ? place + 1 : place});
        if (number == half.mirror.boundary) continue;
        const Family& family = half.grid.families[n];
        grid.families.push_back(family);
        if (apart) grid.families.push_back({family.name + mirror_suffix, family.type});
    }
    return places;
}

}  // namespace

MultiblockGrid with_mirror_image(const MultiblockGrid& half_grid, const MirrorCopy& mirror) {
    const Half half{half_grid, mirror, static_cast<int>(half_grid.zones.size())};
    MultiblockGrid grid = half_grid;
    for (const Zone& zone : half_grid.zones) grid.zones.push_back(mirrored(zone, mirror.plane));
    for (const Interface& interface : half_grid.interfaces) {
        grid.interfaces.push_back(mirrored(half, interface));
    }
    const FamilyPlaces families = renew_families(half, grid);
    grid.patches.clear();
    for (const BoundaryPatch& patch : half_grid.patches) {
        if (patch.family == mirror.boundary) {
            grid.interfaces.push_back(at_plane(half, patch));
            continue;
        }
        const auto [own, of_image] = families[static_cast<std::size_t>(patch.family)];
        grid.patches.push_back({patch.name, patch.zone, patch.box, own});
        grid.patches.push_back({patch.name, patch.zone + half.zones,
                                mirrored_forwards(patch.box, half.extent(patch.zone)), of_image});
    }
    return grid;
}

}  // namespace hexweave
