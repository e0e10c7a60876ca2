// SPDX-License-Identifier: Apache-2.0
// Points per second of surfaces: evaluation, and inversion (the nearest point of a surface), which
// faces on surfaces spend their time in. surface_rates [CADFILE]: with a file, its first surface
// too.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "geometry/cad.h"
#include "geometry/surface.h"
#include "geometry/surface_projection.h"

namespace {

using namespace hexweave;

constexpr int points_in_row = 128;
constexpr double least_seconds = 0.3;

struct NamedSurface {
    std::string name;
    Surface surface;
};

/// A bicubic B-spline of 13 x 13 points, a wavy sheet.
Surface wavy_sheet() {
    NurbsNet net;
    net.degree_u = net.degree_v = 3;
    net.count_u = net.count_v = 13;
    for (int k = 0; k < net.count_u + 4; ++k) {
        net.knots_u.push_back(std::clamp(k - 3, 0, net.count_u - 3));
    }
    net.knots_v = net.knots_u;
    for (int j = 0; j < net.count_v; ++j) {
        for (int i = 0; i < net.count_u; ++i) {
            net.control.push_back({0.1 * i, 0.1 * j, 0.05 * std::sin(i) * std::cos(j)});
        }
    }
    return nurbs_surface(net);
}

Surface half_wing() {
    const auto position = [](double u, double v) {
        const double x = u * u;
        const double thickness = 0.6 * u * (0.2969 - 0.126 * u - 0.3516 * x * u + 0.1843 * x * x);
        return Vec3{(1 - 0.4 * v) * x + 0.5 * v, (1 - 0.4 * v) * thickness, 1.5 * v};
    };
    return formula_surface(position, {0, 1}, {0, 1});
}

double share(const std::array<double, 2>& range, double f) {
    return range[0] + f * (range[1] - range[0]);
}

SurfaceParameters parameters(const Surface& surface, std::size_t row, std::size_t rows, int n) {
    const double f = (n + 0.5) / points_in_row;
    const double g = (static_cast<double>(row) + 0.5) / static_cast<double>(rows);
    return {share(surface.range_u, f), share(surface.range_v, g)};
}

/// Points per second of a task that does the points of one row.
double rate(const std::function<void(std::size_t row, std::size_t rows)>& task) {
    using Clock = std::chrono::steady_clock;
    for (std::size_t rows = 2;; rows *= 2) {
        const auto begin = Clock::now();
        parallel_for(rows, [&](std::size_t row) { task(row, rows); });
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (seconds > least_seconds) return points_in_row * static_cast<double>(rows) / seconds;
    }
}

/// Keeps results from being optimized away.
volatile double sink = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void print_rates(const NamedSurface& named) {
    const Surface& surface = named.surface;
    const SurfaceProjection projection(surface);
    const auto evaluation = [&](std::size_t row, std::size_t rows) {
        Vec3 sum;
        for (int n = 0; n < points_in_row; ++n) {
            sum += evaluate(surface, parameters(surface, row, rows, n));
        }
        sink = sum.x;
    };
    const auto derivatives = [&](std::size_t row, std::size_t rows) {
        Vec3 sum;
        for (int n = 0; n < points_in_row; ++n) {
            const SurfaceParameters at = parameters(surface, row, rows, n);
            sum += evaluate_derivative_u(surface, at) + evaluate_derivative_v(surface, at);
        }
        sink = sum.x;
    };
    const auto line = [&](std::size_t row, std::size_t rows) {
        SurfaceParameters near = parameters(surface, row, rows, 0);
        for (int n = 0; n < points_in_row; ++n) {
            const Vec3 p = evaluate(surface, parameters(surface, row, rows, n));
            near = projection.nearest_from(p, near).parameters;
        }
        sink = near.u;
    };
    const auto alone = [&](std::size_t row, std::size_t rows) {
        for (int n = 0; n < points_in_row; ++n) {
            const Vec3 p = evaluate(surface, parameters(surface, row, rows, n));
            sink = projection.nearest(p).parameters.u;
        }
    };
    for (const int count : {1, 2}) {
        set_threads(count);
        fmt::print("{:<32} {:>8} {:>12.3g} {:>12.3g} {:>12.3g} {:>12.3g}\n", named.name, count,
                   rate(evaluation), rate(derivatives), rate(line), rate(alone));
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<NamedSurface> surfaces{{"sphere", sphere({0, 0, 0}, 1)},
                                       {"formula of a half wing", half_wing()},
                                       {"bicubic B-spline, 13 x 13", wavy_sheet()}};
    if (argc > 1 && can_read_cad()) {
        std::ifstream stream(argv[1], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        const CadResult read = read_cad(text);
        if (!read.file || read.file->entities.front().faces.empty()) {
            std::fprintf(stderr, "%s: %s\n", argv[1], read.error.c_str());
            return 2;
        }
        const CadFace& face = read.file->entities.front().faces.front();
        surfaces.push_back({fmt::format("CAD, degree {} x {}, {} x {}", face.net.degree_u,
                                        face.net.degree_v, face.net.count_u, face.net.count_v),
                            cad_surface(face, 1)});
    }
    fmt::print("points per second\n{:<32} {:>8} {:>12} {:>12} {:>12} {:>12}\n", "surface",
               "threads", "position", "derivatives", "along a line", "from nothing");
    for (const NamedSurface& surface : surfaces) print_rates(surface);
    return 0;
}
