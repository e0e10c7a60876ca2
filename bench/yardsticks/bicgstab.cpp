// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/bicgstab.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexweave::bench {

namespace {

double inner_product(const NodeLattice& lattice, const Nodes& a, const Nodes& b) {
    double sum = 0;
    for_interior(lattice, [&](std::size_t p) { sum += dot(a[p], b[p]); });
    return sum;
}

}  // namespace

LinearSolver::LinearSolver(const NodeLattice& lattice)
    : lattice_(lattice), preconditioner_(lattice) {
    for (Nodes* field : {&remainder_, &direction_, &image_, &preconditioned_, &second_image_}) {
        field->resize(lattice.extent.nodes());
    }
}

bool LinearSolver::solve(const Stencils& stencils, const Nodes& residual,
                         const LinearOptions& options, Nodes& result) {
    preconditioner_.factor(stencils);
    for (Nodes* field : {&result, &direction_, &image_}) {
        std::fill(field->begin(), field->end(), Vec3{});
    }
    remainder_ = residual;
    const double start = inner_product(lattice_, residual, residual);
    const double goal = start * options.reduction * options.reduction;
    double remaining = start;
    double rho = start;  // the residual is its own shadow
    double beta = 0;
    double omega = 0;
    for (int n = 0; n < options.maximum_iterations && remaining > goal; ++n) {
        for_interior(lattice_, [&](std::size_t p) {
            direction_[p] = remainder_[p] + beta * (direction_[p] - omega * image_[p]);
        });
        preconditioner_.solve(direction_, preconditioned_);
        apply_stencils(lattice_, stencils, preconditioned_, image_);
        const double alpha = rho / inner_product(lattice_, residual, image_);
        if (!std::isfinite(alpha)) break;
        for_interior(lattice_, [&](std::size_t p) {
            result[p] -= alpha * preconditioned_[p];
            remainder_[p] -= alpha * image_[p];
        });
        preconditioner_.solve(remainder_, preconditioned_);
        apply_stencils(lattice_, stencils, preconditioned_, second_image_);
        omega = inner_product(lattice_, second_image_, remainder_) /
                inner_product(lattice_, second_image_, second_image_);
        if (!std::isfinite(omega) || omega == 0) break;
        for_interior(lattice_, [&](std::size_t p) {
            result[p] -= omega * preconditioned_[p];
            remainder_[p] -= omega * second_image_[p];
        });
        remaining = inner_product(lattice_, remainder_, remainder_);
        const double last_rho = std::exchange(rho, inner_product(lattice_, residual, remainder_));
        beta = rho / last_rho * (alpha / omega);
    }
    if (!(remaining <= start)) preconditioner_.solve(residual, result);
    return remaining <= goal;
}

}  // namespace hexweave::bench
