// SPDX-License-Identifier: Apache-2.0
#include "elliptic/patch_solver.h"

#include <cmath>

#include "elliptic/tiles.h"

namespace hexweave {

namespace {

constexpr std::size_t nodes_per_tile = 1024;
constexpr std::size_t lines_per_tile = 32;

Vec3 times(const Matrix3& m, const Vec3& v) {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
            m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

Vec3 transposed_times(const Matrix3& m, const Vec3& v) {
    return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
            m[2] * v.x + m[5] * v.y + m[8] * v.z};
}

/// a - u^T p u with symmetric p.
Matrix3 schur_complement(const Matrix3& a, const Matrix3& u, const Matrix3& p) {
    Matrix3 result = a;
    for (std::size_t column = 0; column < 3; ++column) {
        const Vec3 v = transposed_times(u, times(p, {u[column], u[column + 3], u[column + 6]}));
        result[column] -= v.x;
        result[column + 3] -= v.y;
        result[column + 6] -= v.z;
    }
    return result;
}

/// The inverse of a symmetric positive matrix; rounding that made it singular is taken back by
/// raising pivots to a small part of the diagonal.
Matrix3 inverse(const Matrix3& m) {
    constexpr double least_part = 1e-14;
    const auto pivot = [&](double value, double diagonal) {
        const double least = least_part * diagonal;
        return value > least ? value : least > 0 ? least : 1.0;
    };
    const double d0 = pivot(m[0], m[0]);
    const double l10 = m[1] / d0;
    const double l20 = m[2] / d0;
    const double d1 = pivot(m[4] - l10 * m[1], m[4]);
    const double l21 = (m[5] - l20 * m[1]) / d1;
    const double d2 = pivot(m[8] - l20 * m[2] - l21 * l21 * d1, m[8]);
    // Rows of the inverse of the unit lower triangle.
    const double i20 = l10 * l21 - l20;
    const double e00 = 1 / d0 + l10 * l10 / d1 + i20 * i20 / d2;
    const double e01 = -l10 / d1 - i20 * l21 / d2;
    const double e02 = i20 / d2;
    const double e11 = 1 / d1 + l21 * l21 / d2;
    const double e12 = -l21 / d2;
    return {e00, e01, e02, e01, e11, e12, e02, e12, 1 / d2};
}

}  // namespace

PatchSolver::PatchSolver(const Patch& patch) : patch_(patch) {
    const std::size_t count = patch.free.size();
    const std::size_t slot = ahead_along_axis[static_cast<std::size_t>(patch.thin_axis)];
    for (std::size_t f = 0; f < count; ++f) {
        if (patch.behind[f * patch.couplings() + slot] < 0) line_heads_.push_back(f);
    }
    pivots_.resize(count);
    residual_.resize(count);
    preconditioned_.resize(count);
    direction_.resize(count);
    image_.resize(count);
}

void PatchSolver::factorize(const QuadraticModel& model) {
    const std::size_t couplings = patch_.couplings();
    const std::size_t slot = ahead_along_axis[static_cast<std::size_t>(patch_.thin_axis)];
    for_tiles(line_heads_.size(), lines_per_tile, patch_.is_shared(),
              [&](std::size_t, std::size_t begin, std::size_t end) {
                  for (std::size_t line = begin; line < end; ++line) {
                      std::size_t f = line_heads_[line];
                      pivots_[f] = inverse(model.diagonal[f]);
                      for (int next = patch_.ahead[f * couplings + slot]; next >= 0;
                           next = patch_.ahead[f * couplings + slot]) {
                          const auto n = static_cast<std::size_t>(next);
                          pivots_[n] = inverse(schur_complement(
                              model.diagonal[n], model.coupling[f * couplings + slot], pivots_[f]));
                          f = n;
                      }
                  }
              });
}

void PatchSolver::precondition(const QuadraticModel& model, const std::vector<Vec3>& from,
                               std::vector<Vec3>& to) const {
    const std::size_t couplings = patch_.couplings();
    const std::size_t slot = ahead_along_axis[static_cast<std::size_t>(patch_.thin_axis)];
    const auto solve_line = [&](std::size_t f) {
        const auto neighbour = [&](const std::vector<int>& list) {
            return list[f * couplings + slot];
        };
        to[f] = from[f];
        for (int next = neighbour(patch_.ahead); next >= 0; next = neighbour(patch_.ahead)) {
            const auto n = static_cast<std::size_t>(next);
            to[n] = from[n] - transposed_times(model.coupling[f * couplings + slot],
                                               times(pivots_[f], to[f]));
            f = n;
        }
        to[f] = times(pivots_[f], to[f]);
        for (int last = neighbour(patch_.behind); last >= 0; last = neighbour(patch_.behind)) {
            const Vec3 known = to[f];
            f = static_cast<std::size_t>(last);
            to[f] = times(pivots_[f], to[f] - times(model.coupling[f * couplings + slot], known));
        }
    };
    for_tiles(line_heads_.size(), lines_per_tile, patch_.is_shared(),
              [&](std::size_t, std::size_t begin, std::size_t end) {
                  for (std::size_t line = begin; line < end; ++line) solve_line(line_heads_[line]);
              });
}

void PatchSolver::multiply(const QuadraticModel& model, const std::vector<Vec3>& from,
                           std::vector<Vec3>& to) const {
    const std::size_t couplings = patch_.couplings();
    for_tiles(from.size(), nodes_per_tile, patch_.is_shared(),
              [&](std::size_t, std::size_t begin, std::size_t end) {
                  for (std::size_t f = begin; f < end; ++f) {
                      Vec3 sum = times(model.diagonal[f], from[f]);
                      for (std::size_t c = 0; c < couplings; ++c) {
                          const int ahead = patch_.ahead[f * couplings + c];
                          if (ahead >= 0) {
                              sum += times(model.coupling[f * couplings + c],
                                           from[static_cast<std::size_t>(ahead)]);
                          }
                          const int behind = patch_.behind[f * couplings + c];
                          if (behind >= 0) {
                              const auto b = static_cast<std::size_t>(behind);
                              sum += transposed_times(model.coupling[b * couplings + c], from[b]);
                          }
                      }
                      to[f] = sum;
                  }
              });
}

double PatchSolver::product(const std::vector<Vec3>& a, const std::vector<Vec3>& b) const {
    std::vector<double> parts(tile_count(a.size(), nodes_per_tile));
    for_tiles(a.size(), nodes_per_tile, patch_.is_shared(),
              [&](std::size_t tile, std::size_t begin, std::size_t end) {
                  for (std::size_t f = begin; f < end; ++f) parts[tile] += dot(a[f], b[f]);
              });
    double sum = 0;
    for (const double part : parts) sum += part;
    return sum;
}

int PatchSolver::solve(const QuadraticModel& model, double reduction, int most_iterations,
                       std::vector<Vec3>& step) {
    factorize(model);
    const std::size_t count = patch_.free.size();
    step.assign(count, {});
    for (std::size_t f = 0; f < count; ++f) residual_[f] = -model.gradient[f];
    precondition(model, residual_, preconditioned_);
    direction_ = preconditioned_;
    double size = product(residual_, preconditioned_);
    const double enough = reduction * reduction * size;
    int iterations = 0;
    while (iterations < most_iterations && size > enough && size > 0) {
        multiply(model, direction_, image_);
        const double curvature = product(direction_, image_);
        if (!(curvature > 0)) break;
        ++iterations;
        const double length = size / curvature;
        for (std::size_t f = 0; f < count; ++f) {
            step[f] += length * direction_[f];
            residual_[f] -= length * image_[f];
        }
        precondition(model, residual_, preconditioned_);
        const double next = product(residual_, preconditioned_);
        const double ratio = next / size;
        size = next;
        for (std::size_t f = 0; f < count; ++f) {
            direction_[f] = preconditioned_[f] + ratio * direction_[f];
        }
    }
    return iterations;
}

}  // namespace hexweave
