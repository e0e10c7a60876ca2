// SPDX-License-Identifier: Apache-2.0
// `include:`: the sections of other files, merged with those of the file that names them.
#pragma once

#include <vector>

#include "topology/read_case.h"
#include "topology/read_values.h"

namespace hexweave {

/// The tree of a file with all that it includes, directly or not, before its own entries. Every
/// place in an included file says who includes it. Told are files that cannot be read or are
/// included twice, names that two files define, and sections that can stand only once. Notes in
/// `reading` the files and the parameters that they are given. The conditions of includes may use
/// the parameters of the file that they stand in, as overridden.
YamlNode merge_includes(Reading& reading, YamlNode root);

/// Whether the file is of the one format that there is.
bool check_version(Reading& reading, const YamlNode& root);

/// Every place of a tree is used by `user`.
void mark_used_by(YamlNode& node, const std::shared_ptr<const Note>& user);

}  // namespace hexweave
