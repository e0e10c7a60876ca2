// SPDX-License-Identifier: Apache-2.0
// An entry of a file's `surfaces:`: its family, its parameters and its transforms.
#pragma once

#include <memory>

#include "geometry/surface.h"
#include "topology/shapes.h"

namespace hexweave {

/// The surface of an entry; null where it is faulty.
std::shared_ptr<const Surface> read_surface(Shapes& shapes, const YamlNode& entry);

}  // namespace hexweave
