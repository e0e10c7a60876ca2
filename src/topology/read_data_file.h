// SPDX-License-Identifier: Apache-2.0
// Data files that a case names: found, read, and their faults shown with their lines.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/vec3.h"
#include "topology/read_values.h"

namespace hexweave {

/// The path of the file that a node names, relative to the folder of the file that it stands in.
std::filesystem::path path_of_file(const YamlNode& node);

/// The contents of the file that a node names. Its name is the one written.
std::shared_ptr<const SourceFile> read_data_file(Reading& reading, const YamlNode& node,
                                                 const std::string& what);

/// An error at the node that names a data file, with a note at a line of that file (0: none).
/// `hint` says what such a file holds.
void tell_file_fault(Reading& reading, const YamlNode& node,
                     const std::shared_ptr<const SourceFile>& file, const std::string& fault,
                     int line, const std::string& hint);

/// Points from a text, two or three numbers a line, separated by blanks or commas; empty lines and
/// what follows a '#' are skipped. `what` is the node's, for messages.
std::optional<std::vector<Vec3>> read_point_file(Reading& reading, const YamlNode& node,
                                                 const std::string& what);

}  // namespace hexweave
