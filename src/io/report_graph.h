// SPDX-License-Identifier: Apache-2.0
// The topology of a grid as a graph: zones, the interfaces that join them, the families that bound
// them. An SVG element to stand in a page; every mark tells in a <title> what it is.
#pragma once

#include <string>

#include "core/multiblock.h"

namespace hexweave {

/// Zones are boxes, placed by springs along their interfaces (the same picture for the same grid);
/// families are rings in their colours beside the zones that they bound.
std::string topology_graph(const MultiblockGrid& grid);

/// The text with the characters escaped that mean something in HTML and SVG.
std::string escape_html(const std::string& text);

}  // namespace hexweave
