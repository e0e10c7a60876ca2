// SPDX-License-Identifier: Apache-2.0
#include "elliptic/conductances.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace hexweave {

namespace {

/// The stretch from one node of the fine network to another, (0, 0) to (1, 1) apart.
struct Joint {
    int from_i;
    int from_j;
    int to_i;
    int to_j;
};

/// The nodes (0,0), (1,0), (0,1), (1,1) of a coarse cell, weighed.
using CellWeights = std::array<double, 4>;

CellWeights bilinear(double f, double g) {
    return {(1 - f) * (1 - g), f * (1 - g), (1 - f) * g, f * g};
}

/// Adds a network between the nodes of coarse cell (i, j) that spends `conductance` times the
/// square of the difference with these weights (which add up to nothing).
void add_to_cell(Conductances& coarse, int i, int j, double conductance, const CellWeights& z) {
    coarse.east(i + 1, j + 1) -= conductance * z[0] * z[1];
    coarse.east(i + 1, j + 2) -= conductance * z[2] * z[3];
    coarse.north(i + 1, j + 1) -= conductance * z[0] * z[2];
    coarse.north(i + 2, j + 1) -= conductance * z[1] * z[3];
    coarse.rising(i + 1, j + 1) -= conductance * z[0] * z[3];
    coarse.falling(i + 1, j + 1) -= conductance * z[1] * z[2];
}

/// Of the 2 x 2 rule on the unit square.
std::array<std::array<double, 2>, 4> gauss_points() {
    const double low = 0.5 - 0.5 / std::sqrt(3.0);
    const double high = 1 - low;
    return {{{low, low}, {high, low}, {low, high}, {high, high}}};
}

}  // namespace

Conductances::Conductances(int nodes_i, int nodes_j)
    : ni(nodes_i),
      nj(nodes_j),
      east({nodes_i + 2, nodes_j + 2, 1}),
      north(east),
      rising(east),
      falling(east) {}

double Conductances::current(const double* values, std::size_t node) const {
    const auto row = static_cast<std::size_t>(ni) + 2;
    const double* v = values + node;
    const auto up = static_cast<std::ptrdiff_t>(row);
    // Opposite neighbours in pairs: a field that is linear along a line of equal conductances then
    // comes to exactly nothing.
    const double along_i = east[node] * (v[1] - v[0]) - east[node - 1] * (v[0] - v[-1]);
    const double along_j = north[node] * (v[up] - v[0]) - north[node - row] * (v[0] - v[-up]);
    const double diagonal =
        rising[node] * (v[up + 1] - v[0]) - rising[node - row - 1] * (v[0] - v[-up - 1]);
    const double other_diagonal =
        falling[node - 1] * (v[up - 1] - v[0]) - falling[node - row] * (v[0] - v[1 - up]);
    return (along_i + along_j) + (diagonal + other_diagonal);
}

double Conductances::across(std::size_t node, int axis) const {
    const auto row = static_cast<std::size_t>(ni) + 2;
    const double diagonals =
        (rising[node] + rising[node - row - 1]) + (falling[node - 1] + falling[node - row]);
    const double direct = axis == 0 ? east[node] + east[node - 1] : north[node] + north[node - row];
    return direct + diagonals;
}

Conductances laplace_conductances(const PointField& points) {
    const Extent extent = points.extent();
    HEXWEAVE_ASSERT(extent.nk == 1 && extent.ni > 1 && extent.nj > 1);
    Conductances network(extent.ni, extent.nj);
    for (int j = 0; j + 1 < extent.nj; ++j) {
        for (int i = 0; i + 1 < extent.ni; ++i) {
            const Vec3 diagonal = points(i + 1, j + 1) - points(i, j);
            const Vec3 other = points(i + 1, j) - points(i, j + 1);
            const Vec3 x_xi = 0.5 * (diagonal + other);
            const Vec3 x_eta = 0.5 * (diagonal - other);
            const double jacobian = norm(cross(x_xi, x_eta));
            const double along_i = 0.5 * dot(x_eta, x_eta) / jacobian;
            const double along_j = 0.5 * dot(x_xi, x_xi) / jacobian;
            const double mixed = 0.5 * dot(x_xi, x_eta) / jacobian;
            network.east(i + 1, j + 1) += along_i;
            network.east(i + 1, j + 2) += along_i;
            network.north(i + 1, j + 1) += along_j;
            network.north(i + 2, j + 1) += along_j;
            network.rising(i + 1, j + 1) = -mixed;
            network.falling(i + 1, j + 1) = mixed;
        }
    }
    return network;
}

Conductances element_conductances(const PointField& points) {
    const Extent extent = points.extent();
    HEXWEAVE_ASSERT(extent.nk == 1 && extent.ni > 1 && extent.nj > 1);
    Conductances network(extent.ni, extent.nj);
    for (int j = 0; j + 1 < extent.nj; ++j) {
        for (int i = 0; i + 1 < extent.ni; ++i) {
            for (const auto& [f, g] : gauss_points()) {
                const Vec3 x_xi = lerp(points(i + 1, j) - points(i, j),
                                       points(i + 1, j + 1) - points(i, j + 1), g);
                const Vec3 x_eta = lerp(points(i, j + 1) - points(i, j),
                                        points(i + 1, j + 1) - points(i + 1, j), f);
                const double weight = 0.25 / norm(cross(x_xi, x_eta));
                const Vec3 along_i = weight * x_eta;
                const Vec3 along_j = weight * x_xi;
                // The slopes along xi and eta of the functions that are 1 at one corner.
                const CellWeights xi{g - 1, 1 - g, -g, g};
                const CellWeights eta{f - 1, -f, 1 - f, f};
                const auto joint = [&](std::size_t m, std::size_t n) {
                    return dot(along_i, x_xi) * (xi[m] * eta[n] + xi[n] * eta[m]) -
                           dot(along_i, x_eta) * xi[m] * xi[n] -
                           dot(along_j, x_xi) * eta[m] * eta[n];
                };
                network.east(i + 1, j + 1) += joint(0, 1);
                network.east(i + 1, j + 2) += joint(2, 3);
                network.north(i + 1, j + 1) += joint(0, 2);
                network.north(i + 2, j + 1) += joint(1, 3);
                network.rising(i + 1, j + 1) += joint(0, 3);
                network.falling(i + 1, j + 1) += joint(1, 2);
            }
        }
    }
    return network;
}

AxisCoarsening::AxisCoarsening(int fine_nodes)
    : fine(fine_nodes), coarse(fine_nodes > 3 ? fine_nodes / 2 + 1 : fine_nodes) {}

int AxisCoarsening::fine_node(int coarse_node) const {
    return keeps_all() ? coarse_node : std::min(2 * coarse_node, fine - 1);
}

int AxisCoarsening::cell_of(int fine_node_index) const {
    return std::min(keeps_all() ? fine_node_index : fine_node_index / 2, coarse - 2);
}

double AxisCoarsening::fraction(int fine_node_index, int cell) const {
    const int low = fine_node(cell);
    return static_cast<double>(fine_node_index - low) / (fine_node(cell + 1) - low);
}

Conductances coarsen(const Conductances& fine, const AxisCoarsening& along_i,
                     const AxisCoarsening& along_j) {
    Conductances coarse(along_i.coarse, along_j.coarse);
    const auto add = [&](const Joint& joint, double conductance) {
        if (conductance == 0) return;
        const int i = along_i.cell_of(std::min(joint.from_i, joint.to_i));
        const int j = along_j.cell_of(std::min(joint.from_j, joint.to_j));
        const CellWeights from =
            bilinear(along_i.fraction(joint.from_i, i), along_j.fraction(joint.from_j, j));
        const CellWeights to =
            bilinear(along_i.fraction(joint.to_i, i), along_j.fraction(joint.to_j, j));
        CellWeights difference{};
        for (std::size_t n = 0; n < 4; ++n) difference[n] = to[n] - from[n];
        add_to_cell(coarse, i, j, conductance, difference);
    };
    for (int j = 0; j < fine.nj; ++j) {
        for (int i = 0; i < fine.ni; ++i) {
            add({i, j, i + 1, j}, fine.east(i + 1, j + 1));
            add({i, j, i, j + 1}, fine.north(i + 1, j + 1));
            add({i, j, i + 1, j + 1}, fine.rising(i + 1, j + 1));
            add({i + 1, j, i, j + 1}, fine.falling(i + 1, j + 1));
        }
    }
    return coarse;
}

}  // namespace hexweave
