// SPDX-License-Identifier: Apache-2.0
#include "faces/surface_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "elliptic/laplace_solver.h"
#include "elliptic/untangle.h"
#include "faces/folded_start.h"
#include "faces/map_inverse.h"
#include "faces/transfinite_face.h"
#include "geometry/surface_patch.h"

namespace hexweave {

namespace {

/// The harmonic functions' accuracy in shares of that of the grid, both in cells.
constexpr double share_of_tolerance = 1e-2;

std::vector<Vec3> points_of_side(const PointField& points, Side side) {
    const Extent e = points.extent();
    const bool along_j = axis_of(side) == 0;
    std::vector<Vec3> line;
    for (int n = 0; n < (along_j ? e.nj : e.ni); ++n) {
        const int across = is_max(side) ? (along_j ? e.ni : e.nj) - 1 : 0;
        line.push_back(along_j ? points(across, n) : points(n, across));
    }
    return line;
}

/// The parameters of the boundary nodes.
PointField boundary_parameters(const SurfaceProjection& projection, const PointField& points) {
    const Extent e = points.extent();
    const PatchSides patch = sides_on_surface(
        projection, {points_of_side(points, Side::imin), points_of_side(points, Side::imax),
                     points_of_side(points, Side::jmin), points_of_side(points, Side::jmax)});
    PointField at(e);
    const auto set = [&](int i, int j, const SurfacePoint& p) {
        at.set(i, j, 0, {p.parameters.u, p.parameters.v, 0});
    };
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
    : projection_(surface), at_(boundary_parameters(projection_, points)) {
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

SolveResult SurfaceFace::solve(PointField& points, const ParameterField& parameters,
                               const EllipticOptions& options) {
    constexpr int patience = 5;  // passes without progress
    SolveResult result;
    result.tolerance = options.tolerance;
    result.folded_before = count_folded(points);
    const Extent e = points.extent();
    if (e.ni < 3 || e.nj < 3) {
        result.status = SolveStatus::converged;
        result.folded_after = result.folded_before;
        return result;
    }
    result.status = SolveStatus::not_converged;
    const LaplaceOptions laplace{share_of_tolerance * options.tolerance,
                                 LaplaceOptions().maximum_cycles};
    PointField best = at_;
    double least = INFINITY;
    int idle = 0;
    for (int pass = 0; pass < options.maximum_cycles && idle < patience; ++pass) {
        const LaplaceHierarchy hierarchy(element_conductances(points));
        // What they are to be is what they are, in the end.
        Field s = parameters.s;
        Field t = parameters.t;
        bool solved = true;
        for (Field* field : {&s, &t}) {
            const LaplaceResult found =
                solve_laplace(hierarchy, {true, true, true, true}, laplace, *field);
            result.cycles += found.cycles;
            solved = solved && found.converged;
        }
        if (!solved) break;
        result.displacement = move_nodes(s, t, parameters);
        evaluate_interior(points);
        if (!result.history.empty()) {
            result.rate = result.displacement / result.history.back();
        }
        result.history.push_back(result.displacement);
        ++idle;
        if (result.displacement < least) {
            least = result.displacement;
            best = at_;
            idle = 0;
        }
        const double remaining = result.rate > 0 && result.rate < 1
                                     ? result.displacement * result.rate / (1 - result.rate)
                                     : result.displacement;
        if (remaining < options.tolerance) {
            result.status = SolveStatus::converged;
            break;
        }
    }
    if (result.status != SolveStatus::converged) {
        at_ = best;
        evaluate_interior(points);
    }
    result.folded_after = count_folded(points);
    return result;
}

}  // namespace hexweave
