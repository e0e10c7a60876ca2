// SPDX-License-Identifier: Apache-2.0
#include "faces/surface_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/parallel.h"
#include "elliptic/untangle.h"
#include "faces/arc_length.h"
#include "faces/folded_start.h"
#include "faces/map_inverse.h"
#include "faces/pole_parameters.h"
#include "faces/transfinite_face.h"
#include "geometry/surface_patch.h"

namespace hexweave {

namespace {

/// The parameters of the boundary nodes; notes how far they are off the surface.
PointField boundary_parameters(const SurfaceProjection& projection, const PointField& points,
                               OffSurface& off) {
    const Extent e = points.extent();
    const PatchSides patch = sides_on_surface(
        projection, {grid_line(points, {0, 0, 0}, 1), grid_line(points, {e.ni - 1, 0, 0}, 1),
                     grid_line(points, {0, 0, 0}, 0), grid_line(points, {0, e.nj - 1, 0}, 0)});
    PointField at(e);
    const auto set = [&](int i, int j, const SurfacePoint& p) {
        at.set(i, j, 0, {p.parameters.u, p.parameters.v, 0});
        off.include(p.distance, points(i, j));
    };
    off.size = projection.size();
    for (int j = 0; j < e.nj; ++j) {
        set(0, j, patch.sides[0][static_cast<std::size_t>(j)]);
        set(e.ni - 1, j, patch.sides[1][static_cast<std::size_t>(j)]);
    }
    for (int i = 0; i < e.ni; ++i) {
        set(i, 0, patch.sides[2][static_cast<std::size_t>(i)]);
        set(i, e.nj - 1, patch.sides[3][static_cast<std::size_t>(i)]);
    }
    return at;
}

/// What the parameters are to be multiplied with so that they are lengths, in the mean.
std::array<double, 2> length_scales(const Surface& surface) {
    constexpr int samples = 8;
    std::array<double, 2> sums{};
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            const auto at = [](const std::array<double, 2>& range, int n) {
                return range[0] + (range[1] - range[0]) * (n + 0.5) / samples;
            };
            const SurfaceParameters middle{at(surface.range_u, i), at(surface.range_v, j)};
            sums[0] += norm(evaluate_derivative_u(surface, middle));
            sums[1] += norm(evaluate_derivative_v(surface, middle));
        }
    }
    return {sums[0] / (samples * samples), sums[1] / (samples * samples)};
}

void scale(PointField& at, const std::array<double, 2>& factors) {
    for (std::size_t n = 0; n < at.extent().nodes(); ++n) {
        at.x[n] *= factors[0];
        at.y[n] *= factors[1];
    }
}

/// Untangles in the plane of the parameters, measured as lengths.
void unfold_parameters(PointField& at, const Surface& surface, const ParameterField& parameters) {
    PointField in_plane = at;
    const std::array<double, 2> factors = length_scales(surface);
    scale(in_plane, factors);
    const auto untangling = untangle(in_plane, [&] {
        PointField transfinite = in_plane;
        interpolate_face(transfinite, parameters);
        return transfinite;
    });
    if (!untangling) return;
    scale(in_plane, {1 / factors[0], 1 / factors[1]});
    const Extent e = at.extent();
    for (int j = 1; j < e.nj - 1; ++j) {
        for (int i = 1; i < e.ni - 1; ++i) at.set(i, j, 0, in_plane(i, j));
    }
}

}  // namespace

SurfaceFace::SurfaceFace(const Surface& surface, const PointField& points,
                         const ParameterField& parameters, bool start_folded)
    : projection_(surface), at_(boundary_parameters(projection_, points, off_)), kept_(at_) {
    spread_poles(surface, points, at_);
    interpolate_face(at_, parameters);
    if (start_folded) fold_interior(at_);
    unfold_parameters(at_, surface, parameters);
}

void SurfaceFace::evaluate_interior(PointField& points) const {
    const Extent e = points.extent();
    if (e.nj < 3) return;
    parallel_for(static_cast<std::size_t>(e.nj - 2), [&](std::size_t row) {
        const int j = static_cast<int>(row) + 1;
        for (int i = 1; i < e.ni - 1; ++i) {
            points.set(i, j, 0, evaluate(projection_.surface(), {at_.x(i, j), at_.y(i, j)}));
        }
    });
}

void SurfaceFace::project_interior(PointField& points) {
    const Extent e = points.extent();
    if (e.nj < 3) return;
    parallel_for(static_cast<std::size_t>(e.nj - 2), [&](std::size_t row) {
        const int j = static_cast<int>(row) + 1;
        for (int i = 1; i < e.ni - 1; ++i) {
            const SurfacePoint foot =
                projection_.nearest_from(points(i, j), {at_.x(i, j), at_.y(i, j)});
            at_.set(i, j, 0, {foot.parameters.u, foot.parameters.v, 0});
            points.set(i, j, 0, foot.position);
        }
    });
}

double SurfaceFace::move_nodes(const Field& s, const Field& t, const ParameterField& wanted) {
    const Extent e = s.extent();
    PointField moved = at_;
    std::vector<double> farthest(static_cast<std::size_t>(e.nj), 0.0);
    parallel_for(static_cast<std::size_t>(e.nj - 2), [&](std::size_t row) {
        const int j = static_cast<int>(row) + 1;
        CellPlace place{0, j, 0.5, 0.5};
        for (int i = 1; i < e.ni - 1; ++i) {
            place = place_of(s, t, {wanted.s(i, j), wanted.t(i, j)}, place);
            moved.set(i, j, 0, {place.of(at_.x), place.of(at_.y), 0});
            farthest[row] = std::max({farthest[row], std::abs(place.i + place.alpha - i),
                                      std::abs(place.j + place.beta - j)});
        }
    });
    at_ = std::move(moved);
    return *std::max_element(farthest.begin(), farthest.end());
}

BoundFace SurfaceFace::bound() {
    BoundFace face;
    face.move = [this](PointField& points, const Field& s, const Field& t,
                       const ParameterField& wanted) {
        const double moved = move_nodes(s, t, wanted);
        evaluate_interior(points);
        return moved;
    };
    face.project = [this](PointField& points) { project_interior(points); };
    face.keep = [this](const PointField&) { kept_ = at_; };
    face.restore = [this](PointField& points) {
        at_ = kept_;
        evaluate_interior(points);
    };
    return face;
}

}  // namespace hexweave
