// SPDX-License-Identifier: Apache-2.0
// Cases moved through space, and with other axes for their faces and blocks.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/commands/rewritten_case.h"

namespace hexweave::testing {
namespace {

/// One coordinate of a moved point: no arithmetic where an axis becomes an axis.
std::string coordinate(const std::array<double, 3>& row, const YAML::Node& point) {
    std::string sum;
    for (std::size_t n = 0; n < point.size(); ++n) {
        if (row[n] == 0) continue;
        const std::string of = "(" + point[n].Scalar() + ")";
        const std::string size =
            std::abs(row[n]) == 1 ? "" : fmt::format("{} * ", std::abs(row[n]));
        sum += (row[n] < 0 ? " - " : sum.empty() ? "" : " + ") + size + of;
    }
    return sum.empty() ? "0" : sum;
}

YAML::Node moved_point(const YAML::Node& point, const Motion& motion) {
    YAML::Node result(YAML::NodeType::Sequence);
    const bool planar = point.size() == 2 && motion.rows[2][0] == 0 && motion.rows[2][1] == 0;
    for (std::size_t n = 0; n < (planar ? 2 : 3); ++n) {
        result.push_back(coordinate(motion.rows[n], point));
    }
    return result;
}

/// "y = span" where y becomes -x: "x = -(span)".
YAML::Node moved_plane(const YAML::Node& plane, const Motion& motion) {
    static const std::regex form("\\s*([xyz])\\s*=\\s*(.*)");
    std::smatch match;
    const std::string text = plane.Scalar();
    std::regex_match(text, match, form);
    const auto axis = static_cast<std::size_t>(match[1].str()[0] - 'x');
    for (std::size_t n = 0; n < 3; ++n) {
        const double factor = motion.rows[n][axis];
        if (std::abs(factor) != motion.length) continue;
        return YAML::Node(fmt::format("{} = {} * ({})", "xyz"[n], factor, match[2].str()));
    }
    return YAML::Node();
}

bool is_left_handed(const Motion& motion) {
    const auto& [a, b, c] = motion.rows;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) <
           0;
}

YAML::Node longer(const YAML::Node& length, const Motion& motion) {
    if (motion.length == 1 || !length.IsScalar()) return length;
    return YAML::Node(fmt::format("{} * ({})", motion.length, length.Scalar()));
}

YAML::Node moved_value(const std::string& key, const YAML::Node& value, const Motion& motion) {
    static const std::set<std::string> points{"point",     "near",   "through",
                                              "translate", "center", "axis"};
    static const std::set<std::string> lengths{"start",  "end",    "natural",
                                               "within", "height", "gap"};
    if (points.count(key) == 1) return moved_point(value, motion);
    if (lengths.count(key) == 1) return longer(value, motion);
    if (key == "angle" && is_left_handed(motion)) return YAML::Node("-(" + value.Scalar() + ")");
    if (key == "plane") return moved_plane(value, motion);
    if (key == "curve" || key == "along" || key == "surface") {
        return YAML::Node(value.Scalar() + "_moved");
    }
    if (!value.IsMap()) return value;
    YAML::Node result = with_each(value, [&](const std::string& inner, const YAML::Node& held) {
        return moved_value(inner, held, motion);
    });
    if (result["plane"] && result["plane"].IsNull()) result.remove("plane");
    return result;
}

/// Beside each curve (surface) what becomes of it.
YAML::Node with_images(const YAML::Node& section, const Motion& motion) {
    YAML::Node result = YAML::Clone(section);
    for (const auto& entry : section) {
        const auto name = entry.first.as<std::string>();
        YAML::Node image(YAML::NodeType::Map);
        image["of"] = name;
        image["transform"].push_back(YAML::Load(motion.transform));
        result[name + "_moved"] = image;
    }
    return result;
}

/// `-edge` for `+edge` and the reverse; nothing changes where the direction is not said.
YAML::Node against(const YAML::Node& side) {
    std::string text = side.Scalar();
    if (text.front() == '-' || text.front() == '+') text.front() = text.front() == '-' ? '+' : '-';
    return YAML::Node(text);
}

YAML::Node reversed_list(const YAML::Node& list) {
    if (list.IsScalar()) return against(list);
    YAML::Node result(YAML::NodeType::Sequence);
    for (std::size_t n = list.size(); n-- > 0;) result.push_back(against(list[n]));
    return result;
}

/// Other axes for a face or a block.
struct Relabelling {
    std::map<std::string, std::string> side;  ///< what a side is called now, by what it was called
    std::vector<std::size_t> corners;         ///< of the new corners, which old ones they are
    std::set<std::string> backwards;  ///< new sides whose edges or faces are listed the other way
};

const Relabelling face_along_minus_i{
    {{"imin", "imax"}, {"imax", "imin"}}, {1, 0, 3, 2}, {"jmin", "jmax"}};
/// The new i is the old j, the new j the old i backwards.
const Relabelling face_turned{
    {{"jmin", "imin"}, {"jmax", "imax"}, {"imax", "jmin"}, {"imin", "jmax"}},
    {1, 2, 3, 0},
    {"imin", "imax"}};
/// Strips of faces must run along i.
const Relabelling block_along_minus_i{{{"imin", "imax"}, {"imax", "imin"}},
                                      {1, 0, 3, 2, 5, 4, 7, 6},
                                      {"jmin", "jmax", "kmin", "kmax"}};
/// The new i, j, k are the old j, k, i.
const Relabelling block_turned{{{"jmin", "imin"},
                                {"jmax", "imax"},
                                {"kmin", "jmin"},
                                {"kmax", "jmax"},
                                {"imin", "kmin"},
                                {"imax", "kmax"}},
                               {0, 3, 7, 4, 1, 2, 6, 5},
                               {}};

/// The sides that a mapping's keys, or a list, or a word name.
YAML::Node with_sides(const YAML::Node& node, const Relabelling& relabelling) {
    const auto now = [&](const std::string& word) {
        const auto found = relabelling.side.find(word);
        return found == relabelling.side.end() ? word : found->second;
    };
    if (node.IsScalar()) return YAML::Node(now(node.Scalar()));
    if (node.IsSequence()) {
        YAML::Node result(YAML::NodeType::Sequence);
        for (const auto& item : node) result.push_back(with_sides(item, relabelling));
        return result;
    }
    YAML::Node result(YAML::NodeType::Map);
    for (const auto& entry : node) result[now(entry.first.as<std::string>())] = entry.second;
    return result;
}

YAML::Node relabelled_entity(const YAML::Node& entity, const Relabelling& relabelling) {
    return with_each(with_sides(entity, relabelling),
                     [&](const std::string& key, const YAML::Node& value) {
                         if (relabelling.backwards.count(key) == 1) return reversed_list(value);
                         if (key == "orthogonal" || key == "heights")
                             return with_sides(value, relabelling);
                         if (key != "corners") return value;
                         YAML::Node corners(YAML::NodeType::Sequence);
                         for (const std::size_t old : relabelling.corners)
                             corners.push_back(value[old]);
                         return corners;
                     });
}

YAML::Node relabelled(const YAML::Node& written, const std::string& section,
                      const Relabelling& relabelling) {
    return with_each(written, [&](const std::string& key, const YAML::Node& entities) {
        if (key != section) return entities;
        return with_each(entities, [&](const std::string&, const YAML::Node& entity) {
            return relabelled_entity(entity, relabelling);
        });
    });
}

}  // namespace

YAML::Node moved(const YAML::Node& written, const Motion& motion) {
    return with_each(written, [&](const std::string& key, const YAML::Node& section) {
        if (key == "curves" || key == "surfaces") return with_images(section, motion);
        if (!section.IsMap() || key == "parameters") return section;
        return with_each(section, [&](const std::string&, const YAML::Node& entity) {
            if (key == "vertices" && entity.IsSequence()) return moved_point(entity, motion);
            return moved_value("", entity, motion);
        });
    });
}

YAML::Node along_minus_i(const YAML::Node& written) {
    return written["blocks"] ? relabelled(written, "blocks", block_along_minus_i)
                             : relabelled(written, "faces", face_along_minus_i);
}

YAML::Node turned_axes(const YAML::Node& written) {
    return relabelled(relabelled(written, "faces", face_turned), "blocks", block_turned);
}

}  // namespace hexweave::testing
