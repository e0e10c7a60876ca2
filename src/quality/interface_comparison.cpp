// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/interface_sides.h"
#include "core/periodic_ends.h"
#include "quality/outline_parts.h"

namespace hexweave {
namespace {

/// A joint from one of its two sides, always the same one.
struct Joint {
    Interface side;

    auto key() const {
        return std::tie(side.zone, side.box.begin, side.box.end, side.donor, side.donor_box.begin,
                        side.donor_box.end, side.orientation.axes);
    }
};

/// Of the two sides always the same.
Joint canonical(const Interface& interface) {
    const Joint one{forwards(interface)};
    const Joint other{other_side(interface)};
    return other.key() < one.key() ? other : one;
}

std::vector<Joint> joints_of_candidate(const OutlineComparison& c) {
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

std::vector<Joint> joints_of_golden(const OutlineComparison& c) {
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

std::string to_text(const OutlineComparison& c, const Joint& joint) {
    const int axes = c.candidate.cell_dimension;
    return fmt::format("zone '{}', nodes {}, joined to zone '{}', nodes {}, axes {}",
                       c.zone(joint.side.zone).name, to_text(joint.side.box, axes),
                       c.zone(joint.side.donor).name, to_text(joint.side.donor_box, axes),
                       to_string(joint.side.orientation, axes));
}

/// Joints of the same nodes whose periodicity differs.
void compare_periodicity(OutlineComparison& c, const std::vector<Joint>& own,
                         const std::vector<Joint>& golden) {
    for (const Joint& joint : own) {
        const auto other = std::find_if(golden.begin(), golden.end(), [&joint](const Joint& g) {
            return g.key() == joint.key();
        });
        if (other == golden.end() ||
            same_periodicity(joint.side.periodic, other->side.periodic, c.golden_box)) {
            continue;
        }
        c.tell("interface",
               fmt::format("{}: {}, golden {}", to_text(c, joint), to_text(joint.side.periodic),
                           to_text(other->side.periodic)));
    }
}

}  // namespace

void compare_interfaces(OutlineComparison& c) {
    std::vector<Joint> own = joints_of_candidate(c);
    std::vector<Joint> golden = joints_of_golden(c);
    compare_periodicity(c, own, golden);
    for (std::string& text : contradictions(c.candidate, c.golden_box)) {
        c.tell("interface", std::move(text));
    }
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

}  // namespace hexweave
