// SPDX-License-Identifier: Apache-2.0
#include "elliptic/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace hexweave::shapes {

namespace {

const double pi = std::acos(-1.0);

template <class Visit>
void for_nodes(const Extent& e, Visit&& visit) {
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) visit(i, j, k);
        }
    }
}

bool on_boundary(const Extent& e, int i, int j, int k) {
    return i == 0 || i == e.ni - 1 || j == 0 || j == e.nj - 1 ||
           (e.nk > 1 && (k == 0 || k == e.nk - 1));
}

/// Normalized arc length of the nodes of a curve.
std::vector<double> arc_length(int n, const std::function<Vec3(int)>& at) {
    std::vector<double> s{0};
    for (int q = 1; q < n; ++q) s.push_back(s.back() + distance(at(q - 1), at(q)));
    for (double& value : s) value /= s.back();
    return s;
}

}  // namespace

PointField sample(const Extent& extent, const Map& map) {
    PointField points(extent);
    const auto fraction = [](int index, int nodes) {
        return nodes == 1 ? 0.0 : static_cast<double>(index) / (nodes - 1);
    };
    for_nodes(extent, [&](int i, int j, int k) {
        points.set(i, j, k,
                   map(fraction(i, extent.ni), fraction(j, extent.nj), fraction(k, extent.nk)));
    });
    return points;
}

ParameterField sample_parameters(const Extent& extent, const Map& map) {
    PointField sampled = sample(extent, map);
    return {std::move(sampled.x), std::move(sampled.y), std::move(sampled.z)};
}

ParameterField straight_line_parameters(const PointField& points) {
    const Extent e = points.extent();
    const auto s_low = arc_length(e.ni, [&](int i) { return points(i, 0); });
    const auto s_high = arc_length(e.ni, [&](int i) { return points(i, e.nj - 1); });
    const auto t_low = arc_length(e.nj, [&](int j) { return points(0, j); });
    const auto t_high = arc_length(e.nj, [&](int j) { return points(e.ni - 1, j); });
    ParameterField parameters{Field(e), Field(e), Field(e)};
    for_nodes(e, [&](int i, int j, int k) {
        const auto a = static_cast<std::size_t>(i);
        const auto b = static_cast<std::size_t>(j);
        const double ds = s_high[a] - s_low[a];
        const double dt = t_high[b] - t_low[b];
        const double s = (s_low[a] + ds * t_low[b]) / (1 - ds * dt);
        parameters.s(i, j, k) = s;
        parameters.t(i, j, k) = t_low[b] + dt * s;
    });
    return parameters;
}

void interpolate(PointField& points, const ParameterField& parameters) {
    const Extent e = points.extent();
    const PointField x = points;
    for_nodes(e, [&](int i, int j, int k) {
        if (on_boundary(e, i, j, k)) return;
        const std::array<int, 3> node{i, j, k};
        const std::array<double, 3> at{parameters.s(i, j, k), parameters.t(i, j, k),
                                       parameters.u(i, j, k)};
        // The Boolean sum over all non-empty sets of axes along which the node is projected.
        Vec3 sum;
        for (int set = 1; set < (e.nk == 1 ? 4 : 8); ++set) {
            for (int ends = 0; ends < 8; ++ends) {
                if ((ends & ~set) != 0) continue;
                std::array<int, 3> n = node;
                double weight = -1;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (((set >> axis) & 1) == 0) continue;
                    const bool high = ((ends >> axis) & 1) != 0;
                    n[axis] = high ? e[static_cast<int>(axis)] - 1 : 0;
                    weight *= high ? -at[axis] : at[axis] - 1;
                }
                sum += weight * x(n[0], n[1], n[2]);
            }
        }
        points.set(i, j, k, sum);
    });
}

void scatter(PointField& points, const Vec3& low, const Vec3& high) {
    std::mt19937 random(20260607);
    const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const Extent e = points.extent();
    for_nodes(e, [&](int i, int j, int k) {
        const Vec3 f{fraction(), fraction(), fraction()};
        if (on_boundary(e, i, j, k)) return;
        const Vec3 d = high - low;
        points.set(i, j, k, low + Vec3{f.x * d.x, f.y * d.y, f.z * d.z});
    });
}

std::vector<double> geometric(int n, double first) {
    double low = 1;
    double high = 10;
    const auto length = [&](double ratio) {
        return first * (std::pow(ratio, n) - 1) / (ratio - 1);
    };
    for (int bisection = 0; bisection < 100; ++bisection) {
        const double middle = 0.5 * (low + high);
        (length(middle) > 1 ? high : low) = middle;
    }
    std::vector<double> positions;
    for (int q = 0; q <= n; ++q) positions.push_back(first * (std::pow(high, q) - 1) / (high - 1));
    positions.back() = 1;
    return positions;
}

Problem meander(int ni, int nj, double angle) {
    constexpr int pieces = 4096;
    std::vector<Vec3> wall{{}};
    for (int q = 0; q < pieces; ++q) {
        const double u = (q + 0.5) / pieces;
        const double r = std::min(1.0, 8 * std::min(u, 1 - u));
        const double phi = angle * r * r * (3 - 2 * r) * std::sin(8 * pi * u);
        wall.push_back(wall.back() + Vec3{std::cos(phi), std::sin(phi), 0});
    }
    double highest = 0;
    const double scale = 4 / wall.back().x;
    for (Vec3& p : wall) {
        p = scale * p;
        highest = std::max(highest, p.y);
    }
    const double top = highest + 1;
    const auto layers = geometric(nj - 1, 1e-4 / top);
    Problem problem{PointField({ni, nj, 1}), {}};
    for (int i = 0; i < ni; ++i) {
        const int piece = i * pieces / (ni - 1);
        problem.points.set(i, 0, 0, wall[static_cast<std::size_t>(piece)]);
        problem.points.set(i, nj - 1, 0, {4.0 * i / (ni - 1), top, 0});
    }
    for (int j = 0; j < nj; ++j) {
        const double f = layers[static_cast<std::size_t>(j)];
        problem.points.set(0, j, 0, lerp(wall.front(), {0, top, 0}, f));
        problem.points.set(ni - 1, j, 0, lerp(wall.back(), {4, top, 0}, f));
    }
    problem.parameters = straight_line_parameters(problem.points);
    interpolate(problem.points, problem.parameters);
    return problem;
}

Problem ring(int ni, int nj, double first) {
    Problem problem{PointField({ni, nj, 1}), {}};
    const std::vector<double> f = geometric(nj - 1, first);
    for (int i = 0; i < ni; ++i) {
        const double angle = i == ni - 1 ? 0 : 2 * pi * i / (ni - 1);
        problem.points.set(i, 0, 0, {0.5 * std::cos(angle), 0.06 * std::sin(angle), 0});
        problem.points.set(i, nj - 1, 0, {20 * std::cos(angle), 20 * std::sin(angle), 0});
    }
    for (int j = 1; j < nj - 1; ++j) {
        for (const int i : {0, ni - 1}) {
            problem.points.set(i, j, 0, {0.5 + 19.5 * f[static_cast<std::size_t>(j)], 0, 0});
        }
    }
    problem.parameters = straight_line_parameters(problem.points);
    interpolate(problem.points, problem.parameters);
    return problem;
}

Problem clustered_saddle(int ni, int nj, double first) {
    const std::vector<double> f = geometric(nj - 1, first);
    const auto along_j = [&](double eta) {
        return f[static_cast<std::size_t>(std::lround(eta * (nj - 1)))];
    };
    Problem problem;
    problem.points = sample({ni, nj, 1}, [&](double xi, double eta, double) {
        const Vec3 p = annulus({along_j(eta), 1 - xi * (0.8 + 0.2 * xi), 0});
        return Vec3{p.x, p.y, 0.1 * p.x * p.y + 0.2 * std::sin(2 * p.x)};
    });
    problem.parameters = straight_line_parameters(problem.points);
    interpolate(problem.points, problem.parameters);
    return problem;
}

Problem clustered_block(const Extent& extent, double first) {
    const std::vector<double> f = geometric(extent.nk - 1, first);
    const auto along_k = [&](double zeta) {
        return f[static_cast<std::size_t>(std::lround(zeta * (extent.nk - 1)))];
    };
    Problem problem;
    problem.points = sample(extent, [&](double xi, double eta, double zeta) {
        const double height = along_k(zeta);
        const double turn = 0.6 * xi + 0.3 * height;
        const double floor = 0.1 * std::sin(2 * pi * xi) * std::sin(pi * eta);
        const double across = eta - 0.5 + 0.1 * std::sin(pi * xi);
        return Vec3{2 * xi + 0.3 * height * height,
                    across * std::cos(turn) - height * std::sin(turn),
                    across * std::sin(turn) + height * std::cos(turn) + (1 - height) * floor};
    });
    problem.parameters = sample_parameters(extent, [&](double xi, double eta, double zeta) {
        return Vec3{xi, eta, along_k(zeta)};
    });
    interpolate(problem.points, problem.parameters);
    return problem;
}

Problem wavy_cube(int n) {
    const Extent e{n, n, n};
    const auto sine = [](double v) { return std::sin(2 * pi * v); };
    Problem problem{sample(e,
                           [&](double u, double v, double w) {
                               return Vec3{u + 0.16 * sine(v) * std::cos(pi * w),
                                           v + 0.16 * sine(w) * std::cos(2 * pi * u),
                                           w + 0.16 * sine(u) * sine(v)};
                           }),
                    sample_parameters(e, [](double u, double v, double w) {
                        return Vec3{u, v, w};
                    })};
    interpolate(problem.points, problem.parameters);
    return problem;
}

void fold(Problem& problem) {
    const Extent e = problem.points.extent();
    for_nodes(e, [&](int i, int j, int k) {
        if (on_boundary(e, i, j, k)) return;
        const double s = problem.parameters.s(i, j, k);
        const double t = problem.parameters.t(i, j, k);
        const double u = problem.parameters.u(i, j, k);
        const double size = 0.5 * std::sin(pi * s) * std::sin(pi * t) * std::sin(pi * u);
        const Vec3 way{std::sin(9 * t + 3 * u), std::cos(8 * u - 5 * s), std::sin(7 * s + 9 * t)};
        problem.points.set(i, j, k, problem.points(i, j, k) + size * way);
    });
}

Vec3 leaning(double xi, double eta, double zeta) {
    const double bump = std::sin(pi * xi) * std::sin(pi * eta);
    return {xi * (0.6 + 0.4 * xi) + 0.05 * bump * (1 + zeta), eta + 0.1 * bump * std::cos(zeta),
            zeta * (1.3 - 0.3 * zeta) + 0.05 * std::sin(pi * zeta) * (xi - eta)};
}

Vec3 annulus(const Vec3& s) {
    const double r = std::pow(3.0, s.x);
    return {r * std::cos(pi * s.y / 2), r * std::sin(pi * s.y / 2), s.z};
}

std::vector<Vec3> nodes_of(const PointField& points) {
    std::vector<Vec3> nodes;
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) nodes.push_back(points[p]);
    return nodes;
}

std::vector<Vec3> nodes_of(const ParameterField& parameters) {
    std::vector<Vec3> nodes;
    for (std::size_t p = 0; p < parameters.s.extent().nodes(); ++p) {
        nodes.push_back({parameters.s[p], parameters.t[p], parameters.u[p]});
    }
    return nodes;
}

double difference_in_cells(const PointField& grid, const PointField& reference) {
    const Extent e = grid.extent();
    double largest = 0;
    for_nodes(e, [&](int i, int j, int k) {
        if (on_boundary(e, i, j, k)) return;
        const Vec3 x = reference(i, j, k);
        double cell =
            std::min({distance(x, reference(i - 1, j, k)), distance(x, reference(i + 1, j, k)),
                      distance(x, reference(i, j - 1, k)), distance(x, reference(i, j + 1, k))});
        if (e.nk > 1) {
            cell = std::min(
                {cell, distance(x, reference(i, j, k - 1)), distance(x, reference(i, j, k + 1))});
        }
        largest = std::max(largest, distance(grid(i, j, k), x) / cell);
    });
    return largest;
}

}  // namespace hexweave::shapes
