// SPDX-License-Identifier: Apache-2.0
#include "elliptic/target_cells.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "elliptic/fold_count.h"

namespace hexweave {

namespace {

constexpr double least_scaled_jacobian = 0.15;
constexpr double least_base_sine = 0.39;

/// A target of three (two) lengths and the cosines between them: 01, 02, 12.
TargetCorner target_of(const std::array<double, 3>& length, const std::array<double, 3>& cosine,
                       int axes) {
    const auto [u, v, w] = cosine;
    const auto [a, b, c] = length;
    TargetCorner target;
    if (axes == 2) {
        const double area = 1 - u * u;
        target.inverse_gram = {
            1 / (area * a * a), -u / (area * a * b), 0, 1 / (area * b * b), 0, 0};
        target.inverse_volume = 1 / (std::sqrt(area) * a * b);
        return target;
    }
    const double volume = 1 - u * u - v * v - w * w + 2 * u * v * w;
    target.inverse_gram = {(1 - w * w) / (volume * a * a), (v * w - u) / (volume * a * b),
                           (u * w - v) / (volume * a * c), (1 - v * v) / (volume * b * b),
                           (u * v - w) / (volume * b * c), (1 - u * u) / (volume * c * c)};
    target.inverse_volume = 1 / (std::sqrt(volume) * a * b * c);
    return target;
}

TargetCorner sheared_face_corner(const std::array<Vec3, 3>& legs, int sign) {
    const double a = norm(legs[0]);
    const double b = norm(legs[1]);
    double cosine = dot(legs[0], legs[1]) / (a * b);
    const double sine = sign * triple(legs[0], legs[1], legs[2]) / (a * b);
    if (sine < least_scaled_jacobian) {
        const double opened = std::max(std::abs(sine), least_scaled_jacobian);
        cosine = std::copysign(std::sqrt(std::max(0.0, 1 - opened * opened)), cosine);
    }
    return target_of({a, b, 1}, {cosine, 0, 0}, 2);
}

/// The grid's boundary edges, from which the lengths of all others are blended.
class BoundaryLengths {
public:
    explicit BoundaryLengths(const PointField& grid)
        : grid_(grid), axes_(grid.extent().nk == 1 ? 2 : 3) {
        for (int axis = 0; axis < axes_; ++axis) {
            fraction_[static_cast<std::size_t>(axis)] = mean_fractions(axis);
        }
        for (int axis = 0; axis < axes_; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            length_[a] = Field(grid.extent());
            parallel_for(static_cast<std::size_t>(grid.extent().nk),
                         [&](std::size_t k) { fill(axis, static_cast<int>(k)); });
        }
    }

    /// Of the edge from `node` to the next node along the axis.
    double at(const Node& node, int axis) const {
        return length_[static_cast<std::size_t>(axis)](node[0], node[1], node[2]);
    }

private:
    double edge(Node node, int axis) const {
        const Vec3 from = grid_(node[0], node[1], node[2]);
        ++node[static_cast<std::size_t>(axis)];
        return distance(from, grid_(node[0], node[1], node[2]));
    }

    /// Arc length along an axis, the mean of the grid's edges along it; from 0 to 1.
    std::vector<double> mean_fractions(int axis) const {
        const auto a = static_cast<std::size_t>(axis);
        const Extent& e = grid_.extent();
        std::vector<double> mean(static_cast<std::size_t>(e[axis]), 0.0);
        for (int corner = 0; corner < 8; ++corner) {
            if (((corner >> axis) & 1) != 0) continue;
            Node node{(corner & 1) * (e.ni - 1), ((corner >> 1) & 1) * (e.nj - 1),
                      ((corner >> 2) & 1) * (e.nk - 1)};
            std::vector<double> arc{0};
            for (node[a] = 0; node[a] + 1 < e[axis]; ++node[a]) {
                arc.push_back(arc.back() + edge(node, axis));
            }
            if (!(arc.back() > 0)) continue;  // collapsed
            for (std::size_t n = 0; n < arc.size(); ++n) mean[n] += arc[n] / arc.back();
        }
        const double whole = mean.back();
        for (std::size_t n = 0; n < mean.size(); ++n) {
            mean[n] = whole > 0 ? mean[n] / whole : static_cast<double>(n) / (e[axis] - 1);
        }
        return mean;
    }

    /// The logarithm of a boundary edge; a collapsed edge counts as very short.
    double log_edge(const Node& node, int axis) const {
        return std::log(std::max(edge(node, axis), 1e-300));
    }

    double blended(const Node& node, int axis) const {
        const Extent& e = grid_.extent();
        const int b = (axis + 1) % axes_;
        const auto at_end = [&](Node n, int along, int end) {
            n[static_cast<std::size_t>(along)] = end == 0 ? 0 : e[along] - 1;
            return n;
        };
        const auto weight = [&](int along, int end) {
            const auto n = static_cast<std::size_t>(node[static_cast<std::size_t>(along)]);
            const double f = fraction_[static_cast<std::size_t>(along)][n];
            return end == 0 ? 1 - f : f;
        };
        double sum = 0;
        for (int end = 0; end < 2; ++end) {
            const Node low = at_end(node, b, end);
            sum += weight(b, end) * log_edge(low, axis);
            if (axes_ == 2) continue;
            const int c = (axis + 2) % 3;
            sum += weight(c, end) * log_edge(at_end(node, c, end), axis);
            for (int other = 0; other < 2; ++other) {
                sum -= weight(b, end) * weight(c, other) * log_edge(at_end(low, c, other), axis);
            }
        }
        return std::exp(sum);
    }

    void fill(int axis, int k) {
        const Extent& e = grid_.extent();
        const auto a = static_cast<std::size_t>(axis);
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Node node{i, j, k};
                if (node[a] + 1 < e[axis]) length_[a](i, j, k) = blended(node, axis);
            }
        }
    }

    const PointField& grid_;
    int axes_;
    std::array<std::vector<double>, 3> fraction_;
    std::array<Field, 3> length_;
};

/// Whether interior nodes have a say in a corner: not all of its nodes are fixed, and those of its
/// legs that are fixed span a length or an area.
bool is_curable(const Patch& patch, std::size_t cell, int c, const std::array<Vec3, 3>& legs) {
    const auto is_fixed = [&](int vertex) {
        const int node = corner_node(patch, cell, c, vertex);
        return patch.free_of[static_cast<std::size_t>(node)] < 0;
    };
    if (!is_fixed(0)) return true;
    Vec3 fixed;
    int count = 0;
    for (int axis = 0; axis < patch.axes; ++axis) {
        if (!is_fixed(axis + 1)) continue;
        const Vec3& leg = legs[static_cast<std::size_t>(axis)];
        if (!(dot(leg, leg) > 0)) return false;
        const Vec3 area = cross(fixed, leg);
        if (count == 1 &&
            !(dot(area, area) > fold_limit * fold_limit * dot(fixed, fixed) * dot(leg, leg))) {
            return false;
        }
        fixed = leg;
        ++count;
    }
    return count < patch.axes;
}

/// A length for a leg that has none: that of the others.
double positive_length(const std::array<Vec3, 3>& legs, int axis, int axes) {
    double length = norm(legs[static_cast<std::size_t>(axis)]);
    for (int other = 1; other < axes && !(length > 0); ++other) {
        length = norm(legs[static_cast<std::size_t>((axis + other) % axes)]);
    }
    return length;
}

TargetCorner own_target(const Patch& patch, int c, const std::array<Vec3, 3>& legs) {
    std::array<double, 3> length{1, 1, 1};
    bool has_lengths = true;
    for (int axis = 0; axis < patch.axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        length[a] = positive_length(legs, axis, patch.axes);
        has_lengths &= dot(legs[a], legs[a]) > 0;
        if (!(length[a] > 0)) return {};
    }
    if (!has_lengths) return target_of(length, {}, patch.axes);
    return sheared_corner(legs, corner_sign(c, patch.axes), patch.axes, patch.thin_axis);
}

template <class Target>
void set_targets(Patch& patch, Target&& target) {
    const int corners = patch.corners();
    patch.targets.assign(patch.cells.size() * static_cast<std::size_t>(corners), {});
    for (std::size_t cell = 0; cell < patch.cells.size(); ++cell) {
        for (int c = 0; c < corners; ++c) {
            const auto legs = corner_legs(patch, cell, c);
            if (!is_curable(patch, cell, c, legs)) continue;
            patch.targets[cell * static_cast<std::size_t>(corners) + static_cast<std::size_t>(c)] =
                target(cell, c, legs);
        }
    }
}

}  // namespace

TargetCorner sheared_corner(const std::array<Vec3, 3>& legs, int sign, int axes, int thin_axis) {
    if (axes == 2) return sheared_face_corner(legs, sign);
    const auto k = static_cast<std::size_t>(thin_axis);
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const std::array<double, 3> length{norm(legs[0]), norm(legs[1]), norm(legs[2])};
    const Vec3 a = legs[i] / length[i];
    const Vec3 b = legs[j] / length[j];
    const Vec3 c = legs[k] / length[k];
    const Vec3 area = sign * cross(a, b);
    const double sine = norm(area);
    // Half the angle between a and b, by its cosine and sine.
    double half_cosine = norm(a + b) / 2;
    double half_sine = norm(a - b) / 2;
    if (!(half_cosine > 0 && half_sine > 0 && sine > 0)) return target_of(length, {}, 3);
    // The third leg by its components along the bisector of a and b, from a to b, and the normal.
    Vec3 third{dot(c, a + b) / (2 * half_cosine), dot(c, b - a) / (2 * half_sine),
               dot(c, area) / sine};
    if (sine * third.z < least_scaled_jacobian) {
        if (sine < least_base_sine) {
            const double least_half = std::asin(least_base_sine) / 2;
            const double half = std::clamp(std::atan2(half_sine, half_cosine), least_half,
                                           std::acos(0.0) - least_half);
            half_cosine = std::cos(half);
            half_sine = std::sin(half);
        }
        const double height = least_scaled_jacobian / (2 * half_cosine * half_sine);
        const double flat = std::hypot(third.x, third.y);
        third.z = std::max(std::abs(third.z), flat * height / std::sqrt(1 - height * height));
        third = third / norm(third);
    }
    const double along_a = half_cosine * third.x - half_sine * third.y;
    const double along_b = half_cosine * third.x + half_sine * third.y;
    const double between = half_cosine * half_cosine - half_sine * half_sine;
    // Cosines in the order 01, 02, 12.
    std::array<double, 3> cosine{};
    const auto place = [](std::size_t p, std::size_t q) { return p + q - 1; };
    cosine[place(i, j)] = between;
    cosine[place(i, k)] = along_a;
    cosine[place(j, k)] = along_b;
    return target_of(length, cosine, 3);
}

void aim_at_sheared_cells(Patch& patch) {
    set_targets(patch, [&](std::size_t, int c, const std::array<Vec3, 3>& legs) {
        return own_target(patch, c, legs);
    });
}

void aim_at_boxes(Patch& patch, const PointField& grid) {
    const BoundaryLengths lengths(grid);
    const Extent& e = grid.extent();
    set_targets(patch, [&](std::size_t cell, int c, const std::array<Vec3, 3>&) {
        std::array<double, 3> length{1, 1, 1};
        for (int axis = 0; axis < patch.axes; ++axis) {
            const std::size_t low = patch.nodes[static_cast<std::size_t>(
                patch.cells[cell][static_cast<std::size_t>(c & ~(1 << axis))])];
            const std::size_t row = low / static_cast<std::size_t>(e.ni);
            const Node node{static_cast<int>(low % static_cast<std::size_t>(e.ni)),
                            static_cast<int>(row % static_cast<std::size_t>(e.nj)),
                            static_cast<int>(row / static_cast<std::size_t>(e.nj))};
            length[static_cast<std::size_t>(axis)] = lengths.at(node, axis);
        }
        return target_of(length, {}, patch.axes);
    });
}

}  // namespace hexweave
