// SPDX-License-Identifier: Apache-2.0
// Surfaces through arrays of points, and the files that hold them.
#include "geometry/control_mesh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plot3d_file.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

/// Points of a shape at uneven parameters.
ControlMesh mesh_of(const std::function<Vec3(double, double)>& shape, const std::vector<double>& u,
                    const std::vector<double>& v) {
    ControlMesh mesh{static_cast<int>(u.size()), static_cast<int>(v.size()), {}};
    for (const double b : v) {
        for (const double a : u) mesh.points.push_back(shape(a, b));
    }
    return mesh;
}

std::vector<double> uneven(int count) {
    std::vector<double> values;
    for (int n = 0; n < count; ++n) {
        const double t = static_cast<double>(n) / (count - 1);
        values.push_back(t + 0.12 * std::sin(2 * pi * t));
    }
    return values;
}

/// A mesh that leans and crowds, so that no line of it is straight.
Vec3 crooked(double a, double b) {
    return {a + 0.1 * std::sin(2 * pi * b) * a * (1 - a), b + 0.15 * std::sin(3 * a) * b * (1 - b),
            std::sin(4 * a) * std::cos(3 * b)};
}

/// A torus about z, closed both ways, from different places than those of the points.
Vec3 torus(double a, double b) {
    const double u = 2 * pi * a;
    const double v = 2 * pi * b;
    const double r = 3 + std::cos(v);
    return {r * std::cos(u), r * std::sin(u), std::sin(v)};
}

ControlMesh torus_mesh(int nu, int nv) {
    ControlMesh mesh = mesh_of(torus, uneven(nu), uneven(nv));
    // To the bit, as in a file.
    const auto count_u = static_cast<std::size_t>(nu);
    const auto count_v = static_cast<std::size_t>(nv);
    for (std::size_t j = 0; j < count_v; ++j) {
        mesh.points[j * count_u + count_u - 1] = mesh.points[j * count_u];
    }
    for (std::size_t i = 0; i < count_u; ++i) {
        mesh.points[(count_v - 1) * count_u + i] = mesh.points[i];
    }
    return mesh;
}

/// The greatest jump of a derivative across the breaks, by its size.
double greatest_jump(const Surface& s) {
    double worst = 0;
    const auto compare = [&](const Vec3& before, const Vec3& behind) {
        worst = std::max(worst, distance(before, behind) / norm(behind));
    };
    for (int n = 0; n <= 30; ++n) {
        const double other = n / 30.0;
        for (const double at : s.breaks_u) {
            const double before = std::nextafter(at, 0.0);
            compare(s.derivative_u(before, other), s.derivative_u(at, other));
            compare(s.derivative_v(before, other), s.derivative_v(at, other));
        }
        for (const double at : s.breaks_v) {
            const double before = std::nextafter(at, 0.0);
            compare(s.derivative_u(other, before), s.derivative_u(other, at));
            compare(s.derivative_v(other, before), s.derivative_v(other, at));
        }
    }
    return worst;
}

/// The farthest that the interpolant of a torus with n by n points is off it.
double torus_error(int n) {
    const Surface s = control_surface(torus_mesh(n, n));
    double worst = 0;
    for (int j = 0; j < 97; ++j) {
        for (int i = 0; i < 97; ++i) {
            const Vec3 p = evaluate(s, {i / 97.0, j / 97.0});
            const double off = std::hypot(std::hypot(p.x, p.y) - 3, p.z) - 1;
            worst = std::max(worst, std::abs(off));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("the surface of a control mesh passes through its points to the bit") {
    const ControlMesh mesh = mesh_of(crooked, uneven(9), uneven(12));
    REQUIRE(fault_of(mesh).empty());
    const Surface s = control_surface(mesh);
    REQUIRE(s.breaks_u.size() == 7);
    REQUIRE(s.breaks_v.size() == 10);
    for (std::size_t j = 0; j < 12; ++j) {
        for (std::size_t i = 0; i < 9; ++i) {
            const double u = i == 0 ? 0 : i == 8 ? 1 : s.breaks_u[i - 1];
            const double v = j == 0 ? 0 : j == 11 ? 1 : s.breaks_v[j - 1];
            CHECK(evaluate(s, {u, v}) == mesh.points[i + 9 * j]);
        }
    }
}

TEST_CASE("the surface of a control mesh is continuously differentiable, across its seams too") {
    CHECK(greatest_jump(control_surface(mesh_of(crooked, uneven(9), uneven(12)))) < 1e-13);
    const Surface ring = control_surface(torus_mesh(12, 9));
    CHECK(greatest_jump(ring) < 1e-12);
    CHECK(ring.closed_u);
    CHECK(ring.closed_v);
    for (int n = 0; n <= 20; ++n) {
        const double t = n / 20.0;
        CHECK(distance(ring.derivative_u(0, t), ring.derivative_u(1, t)) < 1e-12);
        CHECK(distance(ring.derivative_v(0, t), ring.derivative_v(1, t)) < 1e-12);
        CHECK(distance(ring.derivative_v(t, 0), ring.derivative_v(t, 1)) < 1e-12);
    }
}

TEST_CASE("bilinear shapes are met to rounding, bicubic ones where the parameters are theirs") {
    const auto twisted = [](double a, double b) {
        return Vec3{2 * a + b, a - 3 * b, 0.5 - a + 2 * b};
    };
    for (const int count : {2, 3, 4, 7}) {
        const Surface s = control_surface(mesh_of(twisted, uneven(count), uneven(count + 1)));
        for (int n = 0; n < 50; ++n) {
            const double u = n / 49.0;
            const double v = std::fmod(7.7 * u, 1.0);
            CHECK(distance(evaluate(s, {u, v}), twisted(u, v)) < 3e-14);
            CHECK(distance(s.derivative_u(u, v), {2, 1, -1}) < 1e-12);
        }
    }
    // So flat that its distances are those of its plane to 1e-13.
    constexpr double flat = 1e-7;
    const auto cubic = [](double a, double b) {
        const double z = (1 + a - 2 * a * a + 3 * a * a * a) * (2 - b + b * b - b * b * b);
        return Vec3{a, b, flat * z};
    };
    const Surface s = control_surface(mesh_of(cubic, uneven(8), uneven(6)));
    for (int n = 0; n < 50; ++n) {
        const double u = n / 49.0;
        const double v = std::fmod(7.7 * u, 1.0);
        CHECK(std::abs(evaluate(s, {u, v}).z - cubic(u, v).z) < 1e-12 * flat);
    }
}

TEST_CASE("the error of a control mesh's surface falls with the fourth power of its step") {
    const double coarse = torus_error(17);
    const double fine = torus_error(33);
    CHECK(fine < 1e-3);
    CHECK(std::log2(coarse / fine) > 3.7);
}

TEST_CASE("lines of points that collapse are told, poles are not faults") {
    ControlMesh mesh = mesh_of(crooked, uneven(5), uneven(4));
    for (std::size_t i = 0; i < 5; ++i) mesh.points[i] = mesh.points[0];
    CHECK(fault_of(mesh).empty());
    mesh = mesh_of(crooked, {0, 0.5, 0.5, 1}, uneven(4));
    CHECK(fault_of(mesh) == "the lines of points 2 and 3 of equal u coincide");
    mesh = mesh_of(crooked, uneven(4), {0, 0, 1});
    CHECK(fault_of(mesh) == "the lines of points 1 and 2 of equal v coincide");
    mesh = mesh_of(crooked, {0.5}, uneven(4));
    CHECK(fault_of(mesh) == "a surface needs at least two points each way, not 1 times 4");
    mesh = mesh_of(crooked, uneven(4), uneven(4));
    mesh.points[7].y = std::numeric_limits<double>::quiet_NaN();
    CHECK(fault_of(mesh) == "a point is infinite");
}

TEST_CASE("a Plot3D file of one surface is read, with and without the number of blocks") {
    const std::vector<Vec3> points{{0, 0, 5}, {1, 0, 5}, {2, 0, 5},
                                   {0, 1, 5}, {1, 1, 5}, {2.5, 1, 5}};
    for (const std::string head : {"1\n3 2 1\n", "  3 2 1\n", "1\n 3, 2,\n1\n", "1\r\n3 1 2\r\n"}) {
        INFO(head);
        const Plot3dSurface read =
            read_plot3d_surface(head + "0 1 2 0\n1 +2.5D0\n3*0 1,1 1e0\n6*5.0");
        CHECK(read.error.empty());
        CHECK(read.mesh.count_u == 3);
        CHECK(read.mesh.count_v == 2);
        CHECK(read.mesh.points == points);
    }
}

TEST_CASE("one surface of a Plot3D file of several blocks is read") {
    // Two surfaces and, between them, a volume that nobody asks for.
    const std::string text =
        "3\n2 2 1  2 2 2\n1 2 3\n0 1 0 1  0 0 1 1  4*7\n8*1 8*2 8*3\n"
        "0 0 0 0 0 0  0 1 0 1 0 1  0 0 1 1 2 2\n";
    const Plot3dSurface first = read_plot3d_surface(text, 1);
    CHECK(first.error.empty());
    CHECK(first.mesh.points == std::vector<Vec3>{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}, {1, 1, 7}});
    const Plot3dSurface third = read_plot3d_surface(text, 3);
    CHECK(third.error.empty());
    CHECK(third.mesh.count_u == 2);
    CHECK(third.mesh.count_v == 3);
    CHECK(third.mesh.points ==
          std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {0, 0, 2}, {0, 1, 2}});
    const Plot3dSurface second = read_plot3d_surface(text, 2);
    CHECK(second.line == 2);
    CHECK(second.error == "one of the three counts must be 1 for a surface, not 2 2 2");
    CHECK(read_plot3d_surface("2 2 1\n0 1 0 1\n0 0 1 1\n4*0", 1).error.empty());
}

TEST_CASE("what is wrong with a Plot3D file is told with its line") {
    const auto fault = [](const std::string& text, std::optional<int> block = std::nullopt) {
        const Plot3dSurface read = read_plot3d_surface(text, block);
        return std::to_string(read.line) + ": " + read.error;
    };
    CHECK(fault("") == "0: the file ends before its counts");
    CHECK(fault("# mesh\n2 2 1\n") == "1: '#' is not a number");
    CHECK(fault("2\n2 2 1\n2 2 1\n") == "1: the file holds 2 blocks: say with 'block' which one");
    CHECK(fault("2\n2 2 1\n2 2 1\n", 3) == "1: there is no block 3: the file holds 2");
    CHECK(fault("2 2 1\n12*0", 2) == "1: there is no block 2: the file holds 1");
    CHECK(fault("2\n2 2 1\n2 2 1\n23*0\n", 1) == "5: there are 23 coordinates, not 3 times 8");
    CHECK(fault("9\n2 2 1\n", 1) == "0: the file ends before its counts");
    CHECK(fault("2\n2 2 1\n9999999 2 1\n", 1) == "0: there are too many points");
    CHECK(fault("1\n2 2 2\n") == "2: one of the three counts must be 1 for a surface, not 2 2 2");
    CHECK(fault("1\n2 1 1\n") == "2: one of the three counts must be 1 for a surface, not 2 1 1");
    CHECK(fault("1\n2 2.5 1\n") == "2: a count must be a whole number from 1 to 10000000");
    CHECK(fault("1\n-2 2 1\n") == "2: a count must be a whole number from 1 to 10000000");
    CHECK(fault("2 2 1\n1 2 3 4\n1 2 3 4\n1 2 3\n") ==
          "5: there are 11 coordinates, not 3 times 4");
    CHECK(fault("2 2 1\n1 2 3 4\n1 2 3 4\n1 2 3 4\n5") ==
          "5: more stands behind the 12 coordinates");
    CHECK(fault("2 2 1\n1 2 3 4\n1 nan 3 4\n1 2 3 4\n") == "3: a number is not finite");
    CHECK(fault("2 2 1\n1 2 3 4\n1 1e999 3 4\n") == "3: '1e999' is not a number");
    CHECK(fault("2 2 1\n1 2 3 4\n1 0*3 3 4\n") == "3: '0*3' is not a number");
    CHECK(fault("2 2 1\n1 2 3 4\n1 \x80 3 4\n") == "3: this is not a number");
}
