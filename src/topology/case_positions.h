// SPDX-License-Identifier: Apache-2.0
// Where the vertices of a case lie, before anything is resolved.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/vec3.h"
#include "topology/case.h"

namespace hexweave {

class Positions {
public:
    explicit Positions(const Case& c);

    /// Nothing for a vertex that is unknown or at fault; resolving tells so.
    std::optional<Vec3> of(const std::string& vertex) const;
    /// The diagonal of the box round all vertices.
    double size() const { return size_; }

private:
    std::map<std::string, Vec3> positions_;
    double size_ = 0;
};

}  // namespace hexweave
