// SPDX-License-Identifier: Apache-2.0
// Numbers, counts and places as reports write them.
#pragma once

#include <cstddef>
#include <string>

#include "core/orientation.h"
#include "core/vec3.h"

namespace hexweave {

/// 1234567 as "1,234,567".
std::string grouped(std::size_t number);

/// "1 cell", "2 cells"; "1 pass", "2 passes".
std::string counted(std::size_t number, const std::string& one, const std::string& more);
std::string counted(std::size_t number, const std::string& one);

/// A node or cell by its indices from 1, along as many axes: "(3, 1, 20)".
std::string node_text(const Node& node, int axes);

/// "(0.5, 0, 1)", six digits.
std::string place_text(const Vec3& p);

}  // namespace hexweave
