// SPDX-License-Identifier: Apache-2.0
#include "elliptic/foldover_functional.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elliptic/tiles.h"

namespace hexweave {

namespace {

constexpr double area_weight = 0.5;
constexpr std::size_t cells_per_tile = 512;

/// f and its derivatives by q = |J|^2 and d = det J; f is linear in q.
struct Derivatives {
    double f = 0;
    double f_q = 0;
    double f_d = 0;
    double f_qd = 0;
    double f_dd = 0;
};

double shape_power(double chi, int axes) {
    return axes == 2 ? 1 / chi : 1 / std::cbrt(chi * chi);
}

double density(double q, double d, double epsilon, int axes) {
    const double chi = regularised(d, epsilon);
    return q * shape_power(chi, axes) + area_weight * (d * d + 1) / chi;
}

Derivatives derivatives(double q, double d, double epsilon, int axes) {
    const double root = std::sqrt(epsilon * epsilon + d * d);
    const double chi = regularised(d, epsilon);
    const double slope = chi / root;  // (1 + d / root) / 2
    const double bend = epsilon * epsilon / (2 * root * root * root);
    const double p = 2.0 / axes;
    const double shape = shape_power(chi, axes);
    const double g = area_weight * (d * d + 1) / chi;
    const double r = slope / chi;
    Derivatives result;
    result.f = q * shape + g;
    result.f_q = shape;
    result.f_qd = -p * shape * r;
    result.f_d = q * result.f_qd + 2 * area_weight * d / chi - g * r;
    result.f_dd = q * shape * (p * (p + 1) * r * r - p * bend / chi) + 2 * area_weight / chi -
                  4 * area_weight * d * r / chi + g * (2 * r * r - bend / chi);
    return result;
}

/// A corner of the patch as the functional sees it. Vertex 0 is the corner's node, vertices 1 ...
/// axes the ends of its legs.
template <std::size_t axes>
struct CornerMap {
    std::array<std::array<double, axes + 1>, axes + 1> metric{};  ///< d(q)/2 = metric dx . dx
    std::array<Vec3, axes + 1> stretch;                           ///< dq = 2 sum stretch . dx
    std::array<Vec3, axes + 1> cofactor;                          ///< dd = sum cofactor . dx
    double q = 0;
    double d = 0;

    CornerMap(const TargetCorner& target, const std::array<Vec3, 3>& legs, int sign,
              bool with_metric) {
        const auto& m = target.inverse_gram;
        const double scale = sign * target.inverse_volume;
        cofactor[1] = scale * cross(legs[1], legs[2]);
        cofactor[2] = scale * cross(legs[2], legs[0]);
        if constexpr (axes == 3) {
            cofactor[3] = scale * cross(legs[0], legs[1]);
            stretch[1] = m[0] * legs[0] + m[1] * legs[1] + m[2] * legs[2];
            stretch[2] = m[1] * legs[0] + m[3] * legs[1] + m[4] * legs[2];
            stretch[3] = m[2] * legs[0] + m[4] * legs[1] + m[5] * legs[2];
        } else {
            stretch[1] = m[0] * legs[0] + m[1] * legs[1];
            stretch[2] = m[1] * legs[0] + m[3] * legs[1];
        }
        d = dot(cofactor[1], legs[0]);
        for (std::size_t v = 1; v <= axes; ++v) {
            q += dot(stretch[v], legs[v - 1]);
            stretch[0] -= stretch[v];
            cofactor[0] -= cofactor[v];
        }
        if (with_metric) set_metric(m);
    }

    void set_metric(const std::array<double, 6>& m) {
        constexpr std::array<std::array<std::size_t, 3>, 3> place{
            {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
        for (std::size_t v = 1; v <= axes; ++v) {
            for (std::size_t w = 1; w <= axes; ++w) {
                const double value = m[place[v - 1][w - 1]];
                metric[v][w] = value;
                metric[0][w] -= value;
                metric[v][0] -= value;
                metric[0][0] += value;
            }
        }
    }
};

void add_product(Matrix3& matrix, const Vec3& a, const Vec3& b) {
    matrix[0] += a.x * b.x;
    matrix[1] += a.x * b.y;
    matrix[2] += a.x * b.z;
    matrix[3] += a.y * b.x;
    matrix[4] += a.y * b.y;
    matrix[5] += a.y * b.z;
    matrix[6] += a.z * b.x;
    matrix[7] += a.z * b.y;
    matrix[8] += a.z * b.z;
}

/// The corner of a cell at vertex v of corner c.
constexpr int vertex_corner(int c, std::size_t v) {
    return v == 0 ? c : c ^ (1 << (v - 1));
}

/// The place in `nodes_ahead` of the step between two corners of a cell, the way that leads ahead.
std::size_t coupling_between(int from, int to, std::size_t axes) {
    Node step{};
    Node back{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        step[axis] = ((to >> axis) & 1) - ((from >> axis) & 1);
        back[axis] = -step[axis];
    }
    std::size_t slot = 0;
    while (slot < nodes_ahead.size() && nodes_ahead[slot] != step && nodes_ahead[slot] != back) {
        ++slot;
    }
    return slot;
}

using CouplingTable = std::array<std::array<std::size_t, 8>, 8>;

/// coupling_between for all pairs of corners; used for those that differ along one or two axes.
template <std::size_t axes>
const CouplingTable& coupling_table() {
    static const auto table = [] {
        CouplingTable all{};
        for (int from = 0; from < (1 << axes); ++from) {
            for (int to = 0; to < (1 << axes); ++to) {
                all[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)] =
                    coupling_between(from, to, axes);
            }
        }
        return all;
    }();
    return table;
}

template <std::size_t axes>
void add_corner(const Patch& patch, std::size_t cell, int c, double epsilon,
                QuadraticModel& model) {
    const std::size_t t = cell * (std::size_t{1} << axes) + static_cast<std::size_t>(c);
    const TargetCorner& target = patch.targets[t];
    if (target.inverse_volume == 0) return;
    const CornerMap<axes> map(target, corner_legs(patch, cell, c),
                              corner_sign(c, static_cast<int>(axes)), true);
    Derivatives f = derivatives(map.q, map.d, epsilon, static_cast<int>(axes));
    // Positive on the span of J and its cofactors, where 2 f_q is the curvature along J.
    f.f_dd = std::max(f.f_dd, 2 * f.f_qd * f.f_qd * map.q / f.f_q);
    const auto& table = coupling_table<axes>();
    for (std::size_t v = 0; v <= axes; ++v) {
        const int own_corner = vertex_corner(c, v);
        const int own = patch.free_of[static_cast<std::size_t>(
            patch.cells[cell][static_cast<std::size_t>(own_corner)])];
        if (own < 0) continue;
        const auto o = static_cast<std::size_t>(own);
        model.gradient[o] += 2 * f.f_q * map.stretch[v] + f.f_d * map.cofactor[v];
        const Vec3 left = 2 * f.f_qd * map.stretch[v] + f.f_dd * map.cofactor[v];
        const Vec3 right = 2 * f.f_qd * map.cofactor[v];
        for (std::size_t w = 0; w <= axes; ++w) {
            const int other_corner = vertex_corner(c, w);
            const int other = patch.free_of[static_cast<std::size_t>(
                patch.cells[cell][static_cast<std::size_t>(other_corner)])];
            if (other < own) continue;
            const std::size_t coupling =
                table[static_cast<std::size_t>(own_corner)][static_cast<std::size_t>(other_corner)];
            Matrix3& block =
                v == w ? model.diagonal[o] : model.coupling[o * patch.couplings() + coupling];
            add_product(block, left, map.cofactor[w]);
            add_product(block, right, map.stretch[w]);
            const double m = 2 * f.f_q * map.metric[v][w];
            block[0] += m;
            block[4] += m;
            block[8] += m;
        }
    }
}

template <std::size_t axes>
void assemble_slab(const Patch& patch, std::size_t slab, double epsilon, QuadraticModel& model) {
    for (std::size_t cell = patch.slabs[slab]; cell < patch.slabs[slab + 1]; ++cell) {
        for (int c = 0; c < (1 << axes); ++c) add_corner<axes>(patch, cell, c, epsilon, model);
    }
}

template <std::size_t axes>
FunctionalValue evaluate_cells(const Patch& patch, double epsilon, std::size_t begin,
                               std::size_t end) {
    FunctionalValue value{0, std::numeric_limits<double>::infinity()};
    for (std::size_t cell = begin; cell < end; ++cell) {
        for (int c = 0; c < (1 << axes); ++c) {
            const std::size_t t = cell * (std::size_t{1} << axes) + static_cast<std::size_t>(c);
            if (patch.targets[t].inverse_volume == 0) continue;
            const CornerMap<axes> map(patch.targets[t], corner_legs(patch, cell, c),
                                      corner_sign(c, static_cast<int>(axes)), false);
            value.energy += density(map.q, map.d, epsilon, static_cast<int>(axes));
            value.least_determinant = std::min(value.least_determinant, map.d);
        }
    }
    return value;
}

}  // namespace

double regularised(double determinant, double epsilon) {
    const double root = std::sqrt(epsilon * epsilon + determinant * determinant);
    // The same number twice; the second does not cancel where the first would.
    return determinant > 0 ? (determinant + root) / 2
                           : epsilon * epsilon / (2 * (root - determinant));
}

FunctionalValue evaluate(const Patch& patch, double epsilon) {
    const std::size_t cells = patch.cells.size();
    const std::size_t tiles = tile_count(cells, cells_per_tile);
    std::vector<FunctionalValue> parts(tiles);
    for_tiles(cells, cells_per_tile, patch.is_shared(),
              [&](std::size_t tile, std::size_t begin, std::size_t end) {
                  parts[tile] = patch.axes == 3 ? evaluate_cells<3>(patch, epsilon, begin, end)
                                                : evaluate_cells<2>(patch, epsilon, begin, end);
              });
    FunctionalValue sum{0, std::numeric_limits<double>::infinity()};
    for (const FunctionalValue& part : parts) {
        sum.energy += part.energy;
        sum.least_determinant = std::min(sum.least_determinant, part.least_determinant);
    }
    return sum;
}

void assemble(const Patch& patch, double epsilon, QuadraticModel& model) {
    model.gradient.assign(patch.free.size(), {});
    model.diagonal.assign(patch.free.size(), {});
    model.coupling.assign(patch.free.size() * patch.couplings(), {});
    const std::size_t slabs = patch.slabs.size() - 1;
    for (std::size_t colour = 0; colour < 2; ++colour) {
        for_tiles((slabs + 1 - colour) / 2, 1, patch.is_shared(),
                  [&](std::size_t pair, std::size_t, std::size_t) {
                      const std::size_t slab = 2 * pair + colour;
                      if (patch.axes == 3) {
                          assemble_slab<3>(patch, slab, epsilon, model);
                      } else {
                          assemble_slab<2>(patch, slab, epsilon, model);
                      }
                  });
    }
}

}  // namespace hexweave
