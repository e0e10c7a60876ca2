// SPDX-License-Identifier: Apache-2.0
// The discrete equations on grids whose answer is known.
#include "elliptic/grid_operator.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/shapes.h"

namespace hexweave {
namespace {

/// The largest component of the operator applied to the points themselves.
double largest_residual(const PointField& points, const ParameterField& parameters) {
    const NodeLattice lattice(points.extent());
    const Nodes x = shapes::nodes_of(points);
    Stencils stencils;
    assemble_stencils(lattice, x, shapes::nodes_of(parameters), stencils);
    Nodes residual(x.size());
    apply_stencils(lattice, stencils, x, residual);
    double largest = 0;
    for (const Vec3& r : residual) {
        largest = std::max({largest, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
    }
    return largest;
}

/// The residual of the grid equations in index coordinates of unit range, for n cells per axis.
double truncation_error(int n, int axes, const shapes::Map& map, const shapes::Map& parameters) {
    const Extent e{n + 1, n + 1, axes == 3 ? n + 1 : 1};
    return largest_residual(shapes::sample(e, map), shapes::sample_parameters(e, parameters)) * n *
           n;
}

Vec3 uniform(double xi, double eta, double zeta) {
    return {xi, eta, zeta};
}

}  // namespace

TEST_CASE("points linear in the parameters solve the discrete equations to rounding") {
    const auto linear = [](double xi, double eta, double zeta) {
        const Vec3 s = shapes::leaning(xi, eta, zeta);
        return Vec3{1 + 2 * s.x - s.y + 0.5 * s.z, s.x + 3 * s.y, 0.25 * s.x - s.y + 2 * s.z};
    };
    for (const Extent e :
         {Extent{17, 9, 1}, Extent{3, 3, 1}, Extent{9, 11, 7}, Extent{9, 3, 5}, Extent{3, 3, 3}}) {
        CHECK(largest_residual(shapes::sample(e, linear),
                               shapes::sample_parameters(e, shapes::leaning)) < 4e-16 * 8);
    }
}

TEST_CASE("the truncation error of exact grids falls with second order") {
    const auto exact = [](double xi, double eta, double zeta) {
        return shapes::annulus(shapes::leaning(xi, eta, zeta));
    };
    const auto exact_uniform = [](double xi, double eta, double zeta) {
        return shapes::annulus({xi, eta, zeta});
    };
    for (const int axes : {2, 3}) {
        for (const bool with_control : {false, true}) {
            const shapes::Map map = with_control ? shapes::Map(exact) : exact_uniform;
            const shapes::Map parameters = with_control ? shapes::leaning : uniform;
            const double coarse = truncation_error(20, axes, map, parameters);
            const double fine = truncation_error(40, axes, map, parameters);
            INFO(axes << " axes, control functions " << with_control << ": " << coarse << ", "
                      << fine);
            CHECK(std::log2(coarse / fine) > 1.8);
            CHECK(std::log2(coarse / fine) < 2.2);
        }
    }
}

TEST_CASE("the truncation error of a wrong grid does not fall") {
    const auto wrong = [](double xi, double eta, double zeta) {
        return shapes::annulus({std::log1p(2 * xi) / std::log(3.0), eta, zeta});
    };
    for (const int axes : {2, 3}) {
        const double coarse = truncation_error(20, axes, wrong, uniform);
        const double fine = truncation_error(40, axes, wrong, uniform);
        CHECK(fine > 0.9 * coarse);
        CHECK(fine > 0.1);
    }
}

TEST_CASE("the centre of every stencil is minus one") {
    const shapes::Problem block = shapes::wavy_cube(7);
    const NodeLattice lattice(block.points.extent());
    Stencils stencils;
    assemble_stencils(lattice, shapes::nodes_of(block.points), shapes::nodes_of(block.parameters),
                      stencils);
    for_interior(lattice, [&](std::size_t p) {
        const auto& c = stencils[p].second;
        CHECK(2 * (c[0] + c[1] + c[2]) == Approx(1).epsilon(1e-14));
    });
}

TEST_CASE("points collapsed into one have the stencil of a uniform orthogonal grid") {
    const Extent e{3, 3, 1};
    const NodeLattice lattice(e);
    Stencils stencils;
    assemble_stencils(lattice, Nodes(9, Vec3{1, 2, 3}),
                      shapes::nodes_of(shapes::sample_parameters(e, uniform)), stencils);
    CHECK(stencils[4].second == std::array{0.25, 0.25, 0.0});
    CHECK(stencils[4].mixed == std::array{0.0, 0.0, 0.0});
    CHECK(stencils[4].first == std::array{0.0, 0.0, 0.0});
}

}  // namespace hexweave
