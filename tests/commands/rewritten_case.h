// SPDX-License-Identifier: Apache-2.0
// Cases rewritten as YAML trees: reordered, renamed, moved through space. Knows which keys hold
// names, points and lengths, and nothing else of the program.
#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <map>
#include <string>

namespace hexweave::testing {

/// A mapping of the same keys, each value replaced by change(key, value).
template <class Change>
YAML::Node with_each(const YAML::Node& mapping, Change&& change) {
    YAML::Node result(YAML::NodeType::Map);
    for (const auto& entry : mapping) {
        const auto key = entry.first.as<std::string>();
        result[key] = change(key, entry.second);
    }
    return result;
}

/// A file of the source tree, files that it names given by absolute paths.
YAML::Node case_of(const std::string& path);

std::string text_of(const YAML::Node& node);

/// The entries of all sections but `parameters`, the sections themselves, and the sides of every
/// boundary in another order.
YAML::Node reordered(const YAML::Node& written, unsigned seed);

/// New names of everything that has one; their alphabetical order is that of the old ones
/// backwards.
std::map<std::string, std::string> new_names(const YAML::Node& written);

/// The same case under other names, in references too: `-a`, `a-b`.
YAML::Node renamed(const YAML::Node& written, const std::map<std::string, std::string>& names);

/// A linear map of space, as the rows of its matrix and as the program's own transform of curves.
struct Motion {
    std::string transform;  ///< as in a list of `transform`: "{rotate: pi / 2}"
    std::array<std::array<double, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    double length = 1;  ///< by which it multiplies lengths
};

/// Every point, direction and length of a case moved; curves and surfaces by a transform of what
/// they were. Planes (`plane: "y = 0"`) are kept where an axis becomes an axis.
YAML::Node moved(const YAML::Node& written, const Motion& motion);

/// Faces (where there are no blocks) or blocks with their i axis backwards: what a mirror made
/// left-handed becomes right-handed. Strips of faces must run along i.
YAML::Node along_minus_i(const YAML::Node& written);

/// Every face with j and -i for its i and j, every block with j, k, i for its i, j, k.
YAML::Node turned_axes(const YAML::Node& written);

/// The case as a component `whole`, used once as the instance `it` with a transform as in Motion;
/// its parameters stay those of the file.
YAML::Node as_instance(const YAML::Node& written, const std::string& transform);

}  // namespace hexweave::testing
