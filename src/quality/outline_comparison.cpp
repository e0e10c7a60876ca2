// SPDX-License-Identifier: Apache-2.0
#include "quality/outline_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/interface_sides.h"

namespace hexweave {
namespace {

/// What both sides of a comparison share, and what has been found.
struct Comparison {
    const GridOutline& candidate;
    const GridOutline& golden;
    std::vector<std::optional<ZoneMatch>> of_candidate;  ///< by zone of the candidate
    std::vector<std::optional<ZoneMatch>> of_golden;     ///< by zone of the golden grid
    std::vector<Difference> found;

    void tell(const char* kind, std::string text) { found.push_back({kind, std::move(text)}); }
    const ZoneOutline& zone(int index) const {
        return candidate.zones[static_cast<std::size_t>(index)];
    }
};

std::string to_text(const Extent& extent, int axes) {
    std::string text = std::to_string(extent.ni);
    for (int axis = 1; axis < axes; ++axis) text += fmt::format(" x {}", extent[axis]);
    return text;
}

std::string to_text(const Node& node, int axes) {
    std::string text = "[";
    for (int axis = 0; axis < axes; ++axis) {
        text += fmt::format("{}{}", axis > 0 ? ", " : "", node[static_cast<std::size_t>(axis)] + 1);
    }
    return text + "]";
}

std::string to_text(const IndexBox& box, int axes) {
    return to_text(box.begin, axes) + " to " + to_text(box.end, axes);
}

/// "wing", or `none` where there is nothing.
std::string or_none(const std::string& text, const char* none) {
    return text.empty() ? none : text;
}

void compare_units(Comparison& c) {
    if (c.candidate.units != c.golden.units) {
        c.tell("units", fmt::format("the length unit is {}, golden {}",
                                    or_none(c.candidate.units, "not given"),
                                    or_none(c.golden.units, "not given")));
    }
    const auto dimensions = [](const GridOutline& grid) {
        return fmt::format("{} of cells, {} of space", grid.cell_dimension,
                           grid.physical_dimension);
    };
    if (dimensions(c.candidate) != dimensions(c.golden)) {
        c.tell("dimensions", fmt::format("dimensions are {}, golden {}", dimensions(c.candidate),
                                         dimensions(c.golden)));
    }
}

void compare_zones(Comparison& c) {
    for (std::size_t n = 0; n < c.candidate.zones.size(); ++n) {
        const ZoneOutline& own = c.candidate.zones[n];
        const int axes = c.candidate.cell_dimension;
        if (!c.of_candidate[n]) {
            c.tell("zone", fmt::format("zone '{}' ({}) has no counterpart in the golden grid",
                                       own.name, to_text(own.extent, axes)));
            continue;
        }
        const ZoneMatch& match = *c.of_candidate[n];
        const ZoneOutline& other = c.golden.zones[static_cast<std::size_t>(match.golden)];
        if (!(own.extent == own_extent(match.to_golden, other.extent))) {
            c.tell("dimensions", fmt::format("zone '{}' has {} nodes, golden {}", own.name,
                                             to_text(own.extent, axes),
                                             to_text(other.extent, c.golden.cell_dimension)));
        }
    }
    for (std::size_t n = 0; n < c.golden.zones.size(); ++n) {
        if (c.of_golden[n]) continue;
        const ZoneOutline& zone = c.golden.zones[n];
        c.tell("zone", fmt::format("zone '{}' ({}) of the golden grid is missing", zone.name,
                                   to_text(zone.extent, c.golden.cell_dimension)));
    }
}

void compare_families(Comparison& c) {
    const auto find = [](const GridOutline& grid, const std::string& name) {
        return std::find_if(grid.families.begin(), grid.families.end(),
                            [&name](const Family& family) { return family.name == name; });
    };
    for (const Family& family : c.candidate.families) {
        const auto other = find(c.golden, family.name);
        if (other == c.golden.families.end()) {
            c.tell("family", fmt::format("family '{}' ({}) is not in the golden grid", family.name,
                                         family.type));
        } else if (other->type != family.type) {
            c.tell("family", fmt::format("family '{}' is of type {}, golden {}", family.name,
                                         family.type, other->type));
        }
    }
    for (const Family& family : c.golden.families) {
        if (find(c.candidate, family.name) == c.candidate.families.end()) {
            c.tell("family", fmt::format("family '{}' ({}) of the golden grid is missing",
                                         family.name, family.type));
        }
    }
}

/// A box of a golden zone as nodes of its counterpart, running forwards.
IndexBox carried(const Comparison& c, const ZoneMatch& match, const IndexBox& box) {
    const Orientation to_candidate = inverse(match.to_golden);
    const Extent& extent = c.zone(match.candidate).extent;
    IndexBox result{map_node(to_candidate, box.begin, extent),
                    map_node(to_candidate, box.end, extent)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (result.begin[axis] > result.end[axis]) std::swap(result.begin[axis], result.end[axis]);
    }
    return result;
}

struct Boundary {
    int zone = 0;
    IndexBox box;
    std::string family;

    auto key() const { return std::tie(zone, box.begin, box.end, family); }
};

/// A joint from one of its two sides, always the same one.
struct Joint {
    Interface side;

    auto key() const {
        return std::tie(side.zone, side.box.begin, side.box.end, side.donor, side.donor_box.begin,
                        side.donor_box.end, side.orientation.axes);
    }
};

/// What only the first and what only the second of two lists holds; equal ones cancel one by one.
template <class T>
void keep_unlike(std::vector<T>& first, std::vector<T>& second) {
    const auto before = [](const T& a, const T& b) { return a.key() < b.key(); };
    std::sort(first.begin(), first.end(), before);
    std::sort(second.begin(), second.end(), before);
    std::vector<T> only_first;
    std::vector<T> only_second;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(only_first), before);
    std::set_difference(second.begin(), second.end(), first.begin(), first.end(),
                        std::back_inserter(only_second), before);
    first = std::move(only_first);
    second = std::move(only_second);
}

/// The first of `others` that `alike` accepts, taken out.
template <class T, class Alike>
std::optional<T> take(std::vector<T>& others, Alike&& alike) {
    const auto place = std::find_if(others.begin(), others.end(), alike);
    if (place == others.end()) return std::nullopt;
    T found = *place;
    others.erase(place);
    return found;
}

std::vector<Boundary> boundaries_of_candidate(const Comparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.candidate.patches) {
        if (!c.of_candidate[static_cast<std::size_t>(patch.zone)]) continue;
        list.push_back({patch.zone, carried(c, {patch.zone, 0, {}}, patch.box),
                        c.candidate.families[static_cast<std::size_t>(patch.family)].name});
    }
    return list;
}

std::vector<Boundary> boundaries_of_golden(const Comparison& c) {
    std::vector<Boundary> list;
    for (const BoundaryPatch& patch : c.golden.patches) {
        const auto& match = c.of_golden[static_cast<std::size_t>(patch.zone)];
        if (!match) continue;
        list.push_back({match->candidate, carried(c, *match, patch.box),
                        c.golden.families[static_cast<std::size_t>(patch.family)].name});
    }
    return list;
}

void compare_boundaries(Comparison& c) {
    std::vector<Boundary> own = boundaries_of_candidate(c);
    std::vector<Boundary> golden = boundaries_of_golden(c);
    keep_unlike(own, golden);
    const int axes = c.candidate.cell_dimension;
    const auto where = [&c, axes](const Boundary& b) {
        return fmt::format("zone '{}', nodes {}", c.zone(b.zone).name, to_text(b.box, axes));
    };
    // A family that was changed first, then a range, so that one fault is told once.
    std::vector<Boundary> rest;
    for (const Boundary& b : own) {
        const auto other =
            take(golden, [&b](const Boundary& g) { return g.zone == b.zone && g.box == b.box; });
        if (!other) {
            rest.push_back(b);
            continue;
        }
        c.tell("boundary", fmt::format("{}: the boundary is of family '{}', golden '{}'", where(b),
                                       b.family, other->family));
    }
    for (const Boundary& b : rest) {
        const auto other = take(
            golden, [&b](const Boundary& g) { return g.zone == b.zone && g.family == b.family; });
        c.tell("boundary", other ? fmt::format("{}: boundary '{}', golden nodes {}", where(b),
                                               b.family, to_text(other->box, axes))
                                 : fmt::format("{}: boundary '{}' is not in the golden grid",
                                               where(b), b.family));
    }
    for (const Boundary& g : golden) {
        c.tell("boundary",
               fmt::format("{}: boundary '{}' of the golden grid is missing", where(g), g.family));
    }
}

/// Of the two sides always the same.
Joint canonical(const Interface& interface) {
    const Joint one{forwards(interface)};
    const Joint other{other_side(interface)};
    return other.key() < one.key() ? other : one;
}

std::vector<Joint> joints_of_candidate(const Comparison& c) {
    std::vector<Joint> list;
    for (const Interface& interface : c.candidate.interfaces) {
        if (!c.of_candidate[static_cast<std::size_t>(interface.zone)] ||
            !c.of_candidate[static_cast<std::size_t>(interface.donor)]) {
            continue;
        }
        list.push_back(canonical(interface));
    }
    return list;
}

std::vector<Joint> joints_of_golden(const Comparison& c) {
    std::vector<Joint> list;
    for (const Interface& interface : c.golden.interfaces) {
        const auto& zone = c.of_golden[static_cast<std::size_t>(interface.zone)];
        const auto& donor = c.of_golden[static_cast<std::size_t>(interface.donor)];
        if (!zone || !donor) continue;
        const auto place = [&c](const ZoneMatch& match, const Node& node) {
            return map_node(inverse(match.to_golden), node, c.zone(match.candidate).extent);
        };
        Interface seen = interface;
        seen.zone = zone->candidate;
        seen.donor = donor->candidate;
        seen.box = {place(*zone, interface.box.begin), place(*zone, interface.box.end)};
        seen.donor_box = {place(*donor, interface.donor_box.begin),
                          place(*donor, interface.donor_box.end)};
        seen.orientation =
            compose(compose(zone->to_golden, interface.orientation), inverse(donor->to_golden));
        list.push_back(canonical(seen));
    }
    return list;
}

std::string to_text(const Comparison& c, const Joint& joint) {
    const int axes = c.candidate.cell_dimension;
    return fmt::format("zone '{}', nodes {}, joined to zone '{}', nodes {}, axes {}",
                       c.zone(joint.side.zone).name, to_text(joint.side.box, axes),
                       c.zone(joint.side.donor).name, to_text(joint.side.donor_box, axes),
                       to_string(joint.side.orientation, axes));
}

/// Whether two periodicities are the same in the single precision in which files keep them.
bool same_periodicity(const std::optional<Periodicity>& a, const std::optional<Periodicity>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    const auto near = [](const Vec3& p, const Vec3& q) {
        constexpr double single = 1e-6;
        return distance(p, q) <= single * std::max(norm(p), norm(q));
    };
    return near(a->center, b->center) && near(a->angle, b->angle) &&
           near(a->translation, b->translation);
}

std::string to_text(const std::optional<Periodicity>& periodic) {
    if (!periodic) return "not periodic";
    const auto vector = [](const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); };
    return fmt::format("periodic by rotation {} about {} and translation {}",
                       vector(periodic->angle), vector(periodic->center),
                       vector(periodic->translation));
}

/// Joints of the same nodes whose periodicity differs.
void compare_periodicity(Comparison& c, const std::vector<Joint>& own,
                         const std::vector<Joint>& golden) {
    for (const Joint& joint : own) {
        const auto other = std::find_if(golden.begin(), golden.end(), [&joint](const Joint& g) {
            return g.key() == joint.key();
        });
        if (other == golden.end() || same_periodicity(joint.side.periodic, other->side.periodic)) {
            continue;
        }
        c.tell("interface",
               fmt::format("{}: {}, golden {}", to_text(c, joint), to_text(joint.side.periodic),
                           to_text(other->side.periodic)));
    }
}

void compare_interfaces(Comparison& c) {
    std::vector<Joint> own = joints_of_candidate(c);
    std::vector<Joint> golden = joints_of_golden(c);
    compare_periodicity(c, own, golden);
    keep_unlike(own, golden);
    for (const Joint& joint : own) {
        const auto other = take(golden, [&joint](const Joint& g) {
            return g.side.zone == joint.side.zone && g.side.donor == joint.side.donor;
        });
        c.tell("interface",
               other ? fmt::format("{}; golden: {}", to_text(c, joint), to_text(c, *other))
                     : fmt::format("{}: not in the golden grid", to_text(c, joint)));
    }
    for (const Joint& joint : golden) {
        c.tell("interface", fmt::format("{}: missing", to_text(c, joint)));
    }
}

}  // namespace

std::vector<Difference> compare_outlines(const GridOutline& candidate, const GridOutline& golden,
                                         const std::vector<ZoneMatch>& matches) {
    Comparison c{candidate, golden, {}, {}, {}};
    c.of_candidate.resize(candidate.zones.size());
    c.of_golden.resize(golden.zones.size());
    for (const ZoneMatch& match : matches) {
        c.of_candidate[static_cast<std::size_t>(match.candidate)] = match;
        c.of_golden[static_cast<std::size_t>(match.golden)] = match;
    }
    compare_units(c);
    compare_zones(c);
    compare_families(c);
    compare_boundaries(c);
    compare_interfaces(c);
    return std::move(c.found);
}

}  // namespace hexweave
