// SPDX-License-Identifier: Apache-2.0
#include "faces/orthogonal_face.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "faces/face_grid.h"
#include "faces/hand_built.h"
#include "faces/transfinite_face.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

const double pi = std::acos(-1.0);
constexpr std::array<bool, 4> all_four{true, true, true, true};
constexpr std::array<bool, 4> bottom_and_top{false, false, true, true};

struct Solved {
    PointField points;
    ParameterField parameters;
    SolveResult result;
};

/// The elliptic grid of the straight-line map whose boundary is that of `shape` on the unit square.
Solved solved(int ni, int nj, const std::function<Vec3(double, double)>& shape,
              const EllipticOptions& options = {1e-6, 200}) {
    Solved grid{PointField({ni + 1, nj + 1, 1}), {}, {}};
    for (int j = 0; j <= nj; ++j) {
        for (int i = 0; i <= ni; ++i) {
            grid.points.set(i, j, 0,
                            shape(static_cast<double>(i) / ni, static_cast<double>(j) / nj));
        }
    }
    grid.parameters = straight_line_map(grid.points);
    interpolate_face(grid.points, grid.parameters);
    grid.result = solve_elliptic(grid.points, grid.parameters, options);
    return grid;
}

/// The edge functions of a map.
EdgeFunctions boundary_values(const ParameterField& map) {
    const Extent e = map.s.extent();
    EdgeFunctions values;
    for (int j = 0; j < e.nj; ++j) {
        values[0].push_back(map.t(0, j));
        values[1].push_back(map.t(e.ni - 1, j));
    }
    for (int i = 0; i < e.ni; ++i) {
        values[2].push_back(map.s(i, 0));
        values[3].push_back(map.s(i, e.nj - 1));
    }
    return values;
}

/// A quarter annulus between radii 1 and 3 whose points are evenly spaced round its inside and
/// crowded on its outside: grid lines between them slant. Counter-clockwise from +x, j outwards.
Vec3 slanting_annulus(double u, double v) {
    const double turn = u - 0.5 * v * u * (1 - u);
    const double angle = 0.5 * pi * (1 - turn);
    const double radius = 1 + 2 * v * (0.3 + 0.7 * v);
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// Degrees between the first intervals off side j and the radii there, at most.
double worst_slant(const PointField& x, bool at_jmax) {
    const Extent e = x.extent();
    const int wall = at_jmax ? e.nj - 1 : 0;
    const int next = at_jmax ? e.nj - 2 : 1;
    double worst = 0;
    for (int i = 0; i < e.ni; ++i) {
        const Vec3 radius = x(i, wall);
        const Vec3 interval = x(i, next) - radius;
        const double angle =
            std::atan2(norm(cross(radius, interval)), std::abs(dot(radius, interval)));
        worst = std::max(worst, angle * 180 / pi);
    }
    return worst;
}

bool same_bits(const PointField& a, const PointField& b) {
    return greatest_distance(a, b) == 0;
}

}  // namespace

TEST_CASE("on a grid of rectangles harmonic edge functions are the arc lengths") {
    const auto law = clustered(1e-3);
    const Solved grid = solved(20, 13, [&](double u, double v) {
        return Vec3{3 * law(u), v * v, 0};
    });
    const HarmonicEdges edges = harmonic_edges(grid.points, grid.parameters, all_four, 1e-10);
    CHECK(edges.end == OrthogonalityEnd::all_passes);
    const EdgeFunctions lengths = boundary_values(straight_line_map(grid.points));
    for (std::size_t side = 0; side < 4; ++side) {
        for (std::size_t n = 0; n < lengths[side].size(); ++n) {
            CHECK(edges.functions[side][n] == Approx(lengths[side][n]).margin(1e-12));
        }
    }
}

TEST_CASE("edge functions round an annulus near the angle and log r with second order") {
    std::vector<double> errors;
    for (const int n : {12, 24, 48}) {
        const Solved grid = solved(n, n, slanting_annulus);
        const HarmonicEdges edges = harmonic_edges(grid.points, grid.parameters, all_four, 1e-9);
        REQUIRE(edges.end == OrthogonalityEnd::all_passes);
        double error = 0;
        for (int k = 0; k <= n; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const Vec3 left = grid.points(0, k), bottom = grid.points(k, 0),
                       top = grid.points(k, n);
            error = std::max(
                {error, std::abs(edges.functions[0][at] - std::log(norm(left)) / std::log(3)),
                 std::abs(edges.functions[2][at] - std::atan2(bottom.x, bottom.y) / (pi / 2)),
                 std::abs(edges.functions[3][at] - std::atan2(top.x, top.y) / (pi / 2))});
        }
        errors.push_back(error);
    }
    INFO(errors[0] << ", " << errors[1] << ", " << errors[2]);
    CHECK(std::log2(errors[0] / errors[1]) > 1.7);
    CHECK(std::log2(errors[1] / errors[2]) > 1.8);
}

TEST_CASE("sides that are not asked keep their arc lengths") {
    const Solved grid = solved(15, 11, slanting_annulus);
    const HarmonicEdges edges =
        harmonic_edges(grid.points, grid.parameters, {false, false, true, false}, 1e-8);
    const EdgeFunctions lengths = boundary_values(straight_line_map(grid.points));
    CHECK(edges.functions[0] == lengths[0]);
    CHECK(edges.functions[1] == lengths[1]);
    CHECK(edges.functions[3] == lengths[3]);
    CHECK(edges.functions[2] != lengths[2]);
}

TEST_CASE("grid lines meet the sides asked at right angles, the nearer the finer the grid") {
    for (const int n : {24, 48}) {
        Solved grid = solved(n, n, slanting_annulus);
        const PointField before = grid.points;
        CHECK(worst_slant(before, true) > 10);
        make_orthogonal(grid.points, grid.parameters, bottom_and_top, 2, {1e-6, 200}, grid.result);
        REQUIRE(grid.result.orthogonality);
        CHECK(grid.result.orthogonality->end == OrthogonalityEnd::all_passes);
        CHECK(grid.result.orthogonality->passes == 2);
        CHECK(grid.result.orthogonality->edge_cycles > 0);
        CHECK(grid.result.folded_after == 0);
        const double worst =
            std::max(worst_slant(grid.points, false), worst_slant(grid.points, true));
        INFO("worst slant " << worst);
        CHECK(worst < 60.0 / n);
        for (int i = 0; i <= n; ++i) {
            CHECK(grid.points(i, 0) == before(i, 0));
            CHECK(grid.points(i, n) == before(i, n));
        }
    }
}

TEST_CASE("edge functions increase however much the grid slants, and more passes make up for it") {
    // A wave with overhangs: the lines between it and the top are far from upright.
    const auto wave = [](double u, double v) {
        const double shift = 0.05 * std::sin(pi * u) * std::sin(8 * pi * u);
        const double rise = 0.22 * std::sin(4 * pi * u);
        return Vec3{u - (1 - v) * shift, (1 - v) * rise + v * (0.1 + 0.9 * v), 0};
    };
    Solved grid = solved(64, 24, wave);
    REQUIRE(grid.result.folded_after == 0);
    const HarmonicEdges edges =
        harmonic_edges(grid.points, grid.parameters, {false, false, true, false}, 1e-8);
    CHECK(edges.end == OrthogonalityEnd::all_passes);
    CHECK(edges.limited > 0);
    for (const auto& line : edges.functions) {
        CHECK(line.front() == 0);
        CHECK(line.back() == 1);
        CHECK(std::adjacent_find(line.begin(), line.end(), std::greater_equal<>()) == line.end());
    }
    make_orthogonal(grid.points, grid.parameters, {false, false, true, false}, 2, {1e-4, 200},
                    grid.result);
    CHECK(grid.result.orthogonality->passes > 2);
    CHECK(grid.result.folded_after == 0);
}

TEST_CASE("the passes' cycles and displacements are told one after another") {
    Solved grid = solved(16, 16, slanting_annulus);
    const SolveResult first = grid.result;
    make_orthogonal(grid.points, grid.parameters, all_four, 2, {1e-6, 200}, grid.result);
    CHECK(grid.result.cycles > first.cycles);
    CHECK(grid.result.history.size() > first.history.size());
    CHECK(std::equal(first.history.begin(), first.history.end(), grid.result.history.begin()));
    CHECK(grid.result.folded_before == first.folded_before);
    CHECK(grid.result.status == SolveStatus::converged);
}

TEST_CASE("a wide corner at an orthogonal side takes one pass, elsewhere there are two") {
    const std::array<bool, 4> at_imin_jmin{true, false, false, false};
    CHECK(orthogonal_passes(all_four, {}) == 2);
    CHECK(orthogonal_passes(all_four, at_imin_jmin) == 1);
    CHECK(orthogonal_passes({true, false, false, false}, at_imin_jmin) == 1);
    CHECK(orthogonal_passes({false, false, true, false}, at_imin_jmin) == 1);
    CHECK(orthogonal_passes({false, true, false, true}, at_imin_jmin) == 2);
    const std::array<bool, 4> at_imin_jmax{false, false, false, true};
    CHECK(orthogonal_passes({false, false, false, true}, at_imin_jmax) == 1);
    CHECK(orthogonal_passes({false, true, true, false}, at_imin_jmax) == 2);
}

TEST_CASE("a pass that does not converge is undone and told") {
    Solved grid = solved(24, 24, slanting_annulus);
    const PointField before = grid.points;
    const int cycles = grid.result.cycles;
    make_orthogonal(grid.points, grid.parameters, all_four, 2, {1e-6, 1}, grid.result);
    CHECK(same_bits(grid.points, before));
    CHECK(grid.result.status == SolveStatus::converged);
    CHECK(grid.result.cycles == cycles + 1);
    REQUIRE(grid.result.orthogonality);
    CHECK(grid.result.orthogonality->passes == 0);
    CHECK(grid.result.orthogonality->passes_asked == 2);
    CHECK(grid.result.orthogonality->end == OrthogonalityEnd::not_converged);
}

TEST_CASE("from a grid that did not converge or is folded no pass begins") {
    Solved grid = solved(24, 24, slanting_annulus, {1e-6, 1});
    REQUIRE(grid.result.status == SolveStatus::not_converged);
    const PointField before = grid.points;
    make_orthogonal(grid.points, grid.parameters, all_four, 2, {1e-6, 200}, grid.result);
    CHECK(same_bits(grid.points, before));
    CHECK(grid.result.orthogonality->end == OrthogonalityEnd::not_converged);
    Solved folded = solved(8, 8, slanting_annulus);
    folded.result.folded_after = 3;
    make_orthogonal(folded.points, folded.parameters, all_four, 2, {1e-6, 200}, folded.result);
    CHECK(folded.result.orthogonality->end == OrthogonalityEnd::folded);
    CHECK(folded.result.orthogonality->passes == 0);
}

TEST_CASE("the mirror image of a face gets the mirror image of the orthogonal grid") {
    Solved grid = solved(20, 14, slanting_annulus, {1e-9, 200});
    Solved mirrored = solved(20, 14,
                             [](double u, double v) {
                                 const Vec3 p = slanting_annulus(1 - u, v);
                                 return Vec3{-p.x, p.y, 0};
                             },
                             {1e-9, 200});
    make_orthogonal(grid.points, grid.parameters, {true, false, true, true}, 2, {1e-9, 200},
                    grid.result);
    make_orthogonal(mirrored.points, mirrored.parameters, {false, true, true, true}, 2, {1e-9, 200},
                    mirrored.result);
    double worst = 0;
    for (int j = 0; j <= 14; ++j) {
        for (int i = 0; i <= 20; ++i) {
            const Vec3 p = mirrored.points(20 - i, j);
            worst = std::max(worst, distance(grid.points(i, j), {-p.x, p.y, 0}));
        }
    }
    CHECK(worst < 1e-8);
}

TEST_CASE("two faces that share an orthogonal edge have grid lines without a kink there") {
    // A sheared strip of two faces; the edge between them is upright, what it joins is not.
    HandBuilt built;
    built.method = Method::elliptic;
    built.shape = [](const Vec3& p) { return Vec3{p.x, p.y + 0.4 * std::abs(p.x) * (1 - p.y), 0}; };
    const int a = built.vertex({-1, 0, 0}), b = built.vertex({0, 0, 0}),
              c = built.vertex({1, 0, 0});
    const int d = built.vertex({1, 1, 0}), e = built.vertex({0, 1, 0}),
              f = built.vertex({-1, 1, 0});
    const auto left = static_cast<std::size_t>(built.quadrilateral({a, b, e, f}, 40, 40));
    const auto right = static_cast<std::size_t>(built.quadrilateral({b, c, d, e}, 40, 40));
    const auto worst_kink = [&] {
        const auto faces = make_faces(built.topology, built.edges);
        double worst = 0;
        // Near its ends the edge meets sides that are not at right angles to it.
        for (int j = 15; j <= 25; ++j) {
            const Vec3 on = faces[right].points(0, j);
            const Vec3 back = on - faces[left].points(39, j);
            const Vec3 ahead = faces[right].points(1, j) - on;
            worst =
                std::max(worst, std::atan2(norm(cross(back, ahead)), dot(back, ahead)) * 180 / pi);
        }
        return worst;
    };
    CHECK(worst_kink() > 10);
    built.topology.faces[left].orthogonal = {false, true, false, false};
    built.topology.faces[right].orthogonal = {true, false, false, false};
    CHECK(worst_kink() < 2);
}
