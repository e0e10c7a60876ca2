// SPDX-License-Identifier: Apache-2.0
#include "bench/block_from_sides.h"

#include <utility>

#include "blocks/bilinear_map.h"
#include "blocks/transfinite_block.h"
#include "faces/straight_line_map.h"
#include "faces/transfinite_face.h"

namespace hexweave::bench {

namespace {

constexpr EllipticOptions side_options{1e-8, 400};

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
    for (int i = 0; i < face.extent().ni; ++i) points.push_back(face(i, j));
    return points;
}

std::vector<Vec3> column(const PointField& face, int i) {
    std::vector<Vec3> points;
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

Problem start_grid(const std::string& name, PointField boundary) {
    Problem problem{name, std::move(boundary), {}};
    if (problem.points.extent().nk == 1) {
        problem.parameters = straight_line_map(problem.points);
        interpolate_face(problem.points, problem.parameters);
    } else {
        problem.parameters = bilinear_map(problem.points);
        interpolate_block(problem.points, problem.parameters);
    }
    return problem;
}

}  // namespace hexweave::bench
