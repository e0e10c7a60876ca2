// SPDX-License-Identifier: Apache-2.0
#include "bench/block_from_sides.h"

#include <utility>

#include "blocks/bilinear_map.h"
#include "blocks/block_boundary.h"
#include "blocks/flat_edges.h"
#include "blocks/transfinite_block.h"
#include "faces/straight_line_map.h"
#include "faces/transfinite_face.h"

namespace hexweave::bench {

namespace {

constexpr EllipticOptions side_options{1e-8, 400};

/// The six sides of a block as faces of their own, turned in no way.
std::vector<FaceGrid> side_faces(const PointField& block) {
    std::vector<FaceGrid> faces;
    for (const Side side : all_sides) {
        const auto [a_axis, b_axis] = tangential_axes(side);
        FaceGrid face;
        face.points = PointField(Extent{block.extent()[a_axis], block.extent()[b_axis], 1});
        for (int b = 0; b < face.points.extent().nj; ++b) {
            for (int a = 0; a < face.points.extent().ni; ++a) {
                const Node n = side_node(side, a, b, block.extent());
                face.points.set(a, b, 0, block(n[0], n[1], n[2]));
            }
        }
        faces.push_back(std::move(face));
    }
    return faces;
}

/// Which of the four edges along `axis` it is, at these ends of the other two axes.
std::size_t edge_number(int axis, int other, bool other_max, bool third_max) {
    const bool other_is_lower = other < 3 - axis - other;
    return other_is_lower ? (other_max ? 1U : 0U) + (third_max ? 2U : 0U)
                          : (third_max ? 1U : 0U) + (other_max ? 2U : 0U);
}

/// The exponent at the ends of all edges that lie in a flat one.
PerBlockEdge<EndExponents> edge_exponents(const PointField& boundary, double exponent) {
    PerBlockEdge<EndExponents> exponents{};
    if (exponent == 1) return exponents;
    Block block;
    block.extent = boundary.extent();
    for (std::size_t side = 0; side < 6; ++side) {
        block.sides[side].faces[0].face = static_cast<int>(side);
    }
    const PerBlockEdge<bool> flat = flat_edges(block, side_faces(boundary));
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t number = 0; number < 4; ++number) {
            if (!flat[static_cast<std::size_t>(axis)][number]) continue;
            const std::array<int, 2> across{axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
            const std::array<bool, 2> max{number % 2 == 1, number / 2 == 1};
            for (std::size_t leg = 0; leg < 2; ++leg) {
                for (const bool station : {false, true}) {
                    const std::size_t ending =
                        edge_number(across[leg], axis, station, max[1 - leg]);
                    EndExponents& ends = exponents[static_cast<std::size_t>(across[leg])][ending];
                    (max[leg] ? ends.end : ends.start) = exponent;
                }
            }
        }
    }
    return exponents;
}

}  // namespace

PointField sampled_face(int ni, int nj, const SurfaceMap& map) {
    PointField face(Extent{ni, nj, 1});
    for (int j = 0; j < nj; ++j) {
        for (int i = 0; i < ni; ++i) {
            face.set(i, j, 0,
                     map(static_cast<double>(i) / (ni - 1), static_cast<double>(j) / (nj - 1)));
        }
    }
    return face;
}

PointField solved_face(const std::vector<Vec3>& jmin, const std::vector<Vec3>& jmax,
                       const std::vector<Vec3>& imin, const std::vector<Vec3>& imax, bool& sound) {
    const int ni = static_cast<int>(jmin.size());
    const int nj = static_cast<int>(imin.size());
    PointField face(Extent{ni, nj, 1});
    for (int j = 0; j < nj; ++j) {
        face.set(0, j, 0, imin[static_cast<std::size_t>(j)]);
        face.set(ni - 1, j, 0, imax[static_cast<std::size_t>(j)]);
    }
    for (int i = 0; i < ni; ++i) {
        face.set(i, 0, 0, jmin[static_cast<std::size_t>(i)]);
        face.set(i, nj - 1, 0, jmax[static_cast<std::size_t>(i)]);
    }
    Problem problem = start_grid("", std::move(face));
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, side_options);
    sound = sound && result.status == SolveStatus::converged;
    return std::move(problem.points);
}

std::vector<Vec3> row(const PointField& face, int j) {
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(face.extent().ni));
    for (int i = 0; i < face.extent().ni; ++i) points.push_back(face(i, j));
    return points;
}

std::vector<Vec3> column(const PointField& face, int i) {
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(face.extent().nj));
    for (int j = 0; j < face.extent().nj; ++j) points.push_back(face(i, j));
    return points;
}

PointField block_between(const PointField& kmin, const PointField& kmax,
                         const std::array<std::vector<Vec3>, 4>& rays, bool& sound) {
    const int ni = kmin.extent().ni;
    const int nj = kmin.extent().nj;
    const int nk = static_cast<int>(rays[0].size());
    PointField block(Extent{ni, nj, nk});
    const PointField imin = solved_face(column(kmin, 0), column(kmax, 0), rays[0], rays[2], sound);
    const PointField imax =
        solved_face(column(kmin, ni - 1), column(kmax, ni - 1), rays[1], rays[3], sound);
    const PointField jmin = solved_face(row(kmin, 0), row(kmax, 0), rays[0], rays[1], sound);
    const PointField jmax =
        solved_face(row(kmin, nj - 1), row(kmax, nj - 1), rays[2], rays[3], sound);
    for (int k = 0; k < nk; ++k) {
        for (int j = 0; j < nj; ++j) {
            block.set(0, j, k, imin(j, k));
            block.set(ni - 1, j, k, imax(j, k));
        }
        for (int i = 0; i < ni; ++i) {
            block.set(i, 0, k, jmin(i, k));
            block.set(i, nj - 1, k, jmax(i, k));
        }
    }
    for (int j = 0; j < nj; ++j) {
        for (int i = 0; i < ni; ++i) {
            block.set(i, j, 0, kmin(i, j));
            block.set(i, j, nk - 1, kmax(i, j));
        }
    }
    return block;
}

Problem start_grid(const std::string& name, PointField boundary, double flat_edge_exponent) {
    Problem problem{name, std::move(boundary), {}};
    if (problem.points.extent().nk == 1) {
        problem.parameters = straight_line_map(problem.points);
        interpolate_face(problem.points, problem.parameters);
    } else {
        problem.parameters =
            bilinear_map(problem.points, edge_exponents(problem.points, flat_edge_exponent));
        interpolate_block(problem.points, problem.parameters);
    }
    return problem;
}

}  // namespace hexweave::bench
