// SPDX-License-Identifier: Apache-2.0
// An entry of a file's `curves:`: its family, its transforms, and the data files that it names.
#pragma once

#include <memory>

#include "geometry/curve.h"
#include "topology/shapes.h"

namespace hexweave {

/// The curve of an entry; null where it is faulty.
std::shared_ptr<const Curve> read_curve(Shapes& shapes, const YamlNode& entry);

}  // namespace hexweave
