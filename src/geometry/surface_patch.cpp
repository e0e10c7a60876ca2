// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

bool same_turn(double a, double b, const std::array<double, 2>& range, bool closed) {
    return !closed || std::abs(b - a) < 0.5 * (range[1] - range[0]);
}

}  // namespace

PatchSides sides_on_surface(const SurfaceProjection& projection,
                            const std::array<std::vector<Vec3>, 4>& sides) {
    const auto& [imin, imax, jmin, jmax] = sides;
    const std::size_t i = jmin.size() - 1;
    const std::size_t j = imin.size() - 1;
    std::vector<Vec3> loop(jmin.begin(), jmin.end() - 1);
    loop.insert(loop.end(), imax.begin(), imax.end() - 1);
    loop.insert(loop.end(), jmax.rbegin(), jmax.rend() - 1);
    loop.insert(loop.end(), imin.rbegin(), imin.rend() - 1);
    // From the middle of a side: in corners parameters may not be unique.
    const std::size_t start = i / 2;
    std::vector<Vec3> line(loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
    line.insert(line.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start) + 1);
    const std::vector<SurfacePoint> found = projection.along(line);

    PatchSides patch;
    const SurfaceParameters& first = found.front().parameters;
    const SurfaceParameters& last = found.back().parameters;
    const Surface& surface = projection.surface();
    patch.closes = same_turn(first.u, last.u, surface.range_u, surface.closed_u) &&
                   same_turn(first.v, last.v, surface.range_v, surface.closed_v);
    const auto at = [&](std::size_t n) { return found[(n + loop.size() - start) % loop.size()]; };
    for (std::size_t n = 0; n <= i; ++n) {
        patch.sides[2].push_back(at(n));
        patch.sides[3].push_back(at(i + j + (i - n)));
    }
    for (std::size_t n = 0; n <= j; ++n) {
        patch.sides[0].push_back(at(i + j + i + (j - n)));
        patch.sides[1].push_back(at(i + n));
    }
    return patch;
}

}  // namespace hexweave
