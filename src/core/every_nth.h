// SPDX-License-Identifier: Apache-2.0
// The coarser grid in a grid: every n-th node along each axis, to the bit.
#pragma once

#include "core/field.h"

namespace hexweave {

/// Precondition: the cells along each axis (none along one that is a node thick) are a multiple of
/// `stride`.
inline Extent every_nth(const Extent& extent, int stride) {
    const auto nodes = [stride](int n) { return (n - 1) / stride + 1; };
    return {nodes(extent.ni), nodes(extent.nj), nodes(extent.nk)};
}

inline Field every_nth(const Field& field, int stride) {
    Field result(every_nth(field.extent(), stride));
    const Extent e = result.extent();
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                result(i, j, k) = field(i * stride, j * stride, k * stride);
            }
        }
    }
    return result;
}

inline PointField every_nth(const PointField& points, int stride) {
    PointField result;
    result.x = every_nth(points.x, stride);
    result.y = every_nth(points.y, stride);
    result.z = every_nth(points.z, stride);
    return result;
}

}  // namespace hexweave
