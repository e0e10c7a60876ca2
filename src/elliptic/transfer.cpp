// SPDX-License-Identifier: Apache-2.0
#include "elliptic/transfer.h"

#include "core/parallel.h"

namespace hexweave {

namespace {

constexpr int cost_of_node = 4;

/// How much of the upper neighbour a node between two coarse ones takes.
float share(double below, double here, double above) {
    const double whole = above - below;
    const double share = whole == 0 ? 0.5 : (here - below) / whole;
    return share >= 0 && share <= 1 ? static_cast<float>(share) : 0.5F;
}

/// Whether index n of an axis lies between two coarse nodes.
bool is_between(int n, int count, bool halved) {
    return halved && n % 2 == 1 && n < count - 1;
}

/// Rows (j, k) of a level, as one loop.
template <class Task>
void for_rows(const Level& level, int cost, Task&& task) {
    const int nj = level.extent.nj;
    parallel_blocks(nj * level.extent.nk, cost, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) task(n % nj, n / nj);
    });
}

/// Adds to the row (j, k) its share of a row between it and the next coarse one: the row `between`,
/// whose far neighbour along the axis of `parameter` lies at `far`. Rows are given by their
/// offsets.
void gather_row(Level& level, int axis, int j, int k, int between_j, int between_k, int far_j,
                int far_k) {
    const int length = level.shape.length();
    const std::ptrdiff_t component = static_cast<std::ptrdiff_t>(axis) * length;
    const double* const own = level.parameters.row(j, k) + component;
    const double* const middle = level.parameters.row(between_j, between_k) + component;
    const double* const far = level.parameters.row(far_j, far_k) + component;
    float* const to = level.residuals.row(j, k);
    const float* const from = level.residuals.row(between_j, between_k);
    for (int i = 0; i < length; ++i) {
        const float part = 1.0F - share(own[i], middle[i], far[i]);
        for (int c = 0; c < level.components; ++c) {
            to[c * length + i] += part * from[c * length + i];
        }
    }
}

/// Gathers the rows (axis 1) or layers (axis 2) between coarse ones into these.
void gather_across(Level& level, int axis) {
    const int count = level.extent[axis];
    for_rows(level, level.extent.ni * cost_of_node, [&](int j, int k) {
        const int n = axis == 1 ? j : k;
        if (is_between(n, count, true) || n == 0 || n == count - 1) return;
        for (const int side : {-1, 1}) {
            if (!is_between(n + side, count, true)) continue;
            if (axis == 1) {
                gather_row(level, axis, j, k, j + side, k, j + 2 * side, k);
            } else {
                gather_row(level, axis, j, k, j, k + side, j, k + 2 * side);
            }
        }
    });
}

/// Adds to every coarse node of a row its shares of the nodes between, in place. Of a row of n
/// nodes the even ones are coarse (and the last); even node m lies between the odd ones m - 1 and
/// m.
void gather_between(const RowShape& shape, const double* s, int components, float* row) {
    const std::ptrdiff_t odd = shape.segments()[1].first;
    const std::ptrdiff_t length = shape.length();
    const int pairs = (shape.nodes() - 1) / 2;  // nodes between two coarse ones
    for (int m = 0; m < pairs; ++m) {
        const float part = share(s[m], s[odd + m], s[m + 1]);
        for (int c = 0; c < components; ++c) {
            float* const v = row + c * length;
            v[m] += (1.0F - part) * v[odd + m];
            v[m + 1] += part * v[odd + m];
        }
    }
}

/// coarse row <- the coarse nodes of the finer row, the nodes between gathered where i is halved.
void gather_along(Level& finer, Level& coarse, int j, int k) {
    const bool halved = coarse.halved[0];
    const int fine_j = finer_index(j, finer.extent.nj, coarse.halved[1]);
    const int fine_k = finer_index(k, finer.extent.nk, coarse.halved[2]);
    float* from = finer.residuals.row(fine_j, fine_k);
    float* to = coarse.residuals.row(j, k);
    if (halved) {
        gather_between(finer.shape, finer.parameters.row(fine_j, fine_k), finer.components, from);
    }
    for (int c = 0; c < finer.components; ++c) {
        for_coarse_nodes(finer.shape, coarse.shape, halved,
                         [=](std::ptrdiff_t fine, std::ptrdiff_t here) { to[here] = from[fine]; });
        from += finer.shape.length();
        to += coarse.shape.length();
    }
}

/// Fills the nodes between the coarse ones of a row.
void interpolate_between(const RowShape& shape, const double* s, int components, float* row) {
    const std::ptrdiff_t odd = shape.segments()[1].first;
    const std::ptrdiff_t length = shape.length();
    const int pairs = (shape.nodes() - 1) / 2;
    for (int c = 0; c < components; ++c) {
        float* const v = row + c * length;
        float* const between = v + odd;
        for (int m = 0; m < pairs; ++m) {
            const float part = share(s[m], s[odd + m], s[m + 1]);
            between[m] = (1.0F - part) * v[m] + part * v[m + 1];
        }
    }
}

/// The changes at the coarse nodes of the row of `finer` that is coarse row (j, k), and between
/// them.
void interpolate_along(Level& finer, const Level& coarse, int j, int k) {
    const bool halved = coarse.halved[0];
    const int fine_j = finer_index(j, finer.extent.nj, coarse.halved[1]);
    const int fine_k = finer_index(k, finer.extent.nk, coarse.halved[2]);
    float* const row = finer.corrections.row(fine_j, fine_k);
    for (int c = 0; c < finer.components; ++c) {
        const double* const old = finer.points.row(fine_j, fine_k) + c * finer.shape.length();
        const double* const now = coarse.points.row(j, k) + c * coarse.shape.length();
        float* const to = row + static_cast<std::ptrdiff_t>(c) * finer.shape.length();
        for_coarse_nodes(finer.shape, coarse.shape, halved,
                         [=](std::ptrdiff_t fine, std::ptrdiff_t here) {
                             to[fine] = static_cast<float>(now[here] - old[fine]);
                         });
    }
    if (halved) {
        interpolate_between(finer.shape, finer.parameters.row(fine_j, fine_k), finer.components,
                            row);
    }
}

/// Fills the rows (axis 1) or layers (axis 2) between coarse ones.
void interpolate_across(Level& level, int axis, const std::array<bool, 3>& halved) {
    const int length = level.shape.length();
    const std::ptrdiff_t component = static_cast<std::ptrdiff_t>(axis) * length;
    for_rows(level, length * cost_of_node, [&](int j, int k) {
        const int n = axis == 1 ? j : k;
        if (!is_between(n, level.extent[axis], true)) return;
        // Layers are filled last; until then only coarse layers hold anything.
        if (axis == 1 && is_between(k, level.extent.nk, halved[2])) return;
        const int dj = axis == 1 ? 1 : 0;
        const int dk = axis == 2 ? 1 : 0;
        const double* const below = level.parameters.row(j - dj, k - dk) + component;
        const double* const here = level.parameters.row(j, k) + component;
        const double* const above = level.parameters.row(j + dj, k + dk) + component;
        const float* const first = level.corrections.row(j - dj, k - dk);
        const float* const second = level.corrections.row(j + dj, k + dk);
        float* const to = level.corrections.row(j, k);
        for (int i = 0; i < length; ++i) {
            const float part = share(below[i], here[i], above[i]);
            for (int c = 0; c < level.components; ++c) {
                to[c * length + i] =
                    (1.0F - part) * first[c * length + i] + part * second[c * length + i];
            }
        }
    });
}

}  // namespace

void integrate_residuals(Level& level) {
    const std::ptrdiff_t length = level.shape.length();
    for_rows(level, level.extent.ni * cost_of_node, [&](int j, int k) {
        const float* const weights = level.weights.row(j, k);
        float* const residuals = level.residuals.row(j, k);
        for (int c = 0; c < level.components; ++c) {
            for (std::ptrdiff_t i = 0; i < length; ++i) residuals[c * length + i] *= weights[i];
        }
    });
}

void restrict_residuals(Level& finer, Level& coarse) {
    if (coarse.halved[2]) gather_across(finer, 2);
    if (coarse.halved[1]) gather_across(finer, 1);
    for_rows(coarse, coarse.extent.ni * cost_of_node, [&](int j, int k) {
        const bool boundary = j == 0 || j == coarse.extent.nj - 1 ||
                              (coarse.axes == 3 && (k == 0 || k == coarse.extent.nk - 1));
        if (!boundary) gather_along(finer, coarse, j, k);
    });
}

void interpolate_changes(Level& finer, const Level& coarse) {
    for_rows(coarse, 2 * coarse.extent.ni * cost_of_node,
             [&](int j, int k) { interpolate_along(finer, coarse, j, k); });
    if (coarse.halved[1]) interpolate_across(finer, 1, coarse.halved);
    if (coarse.halved[2]) interpolate_across(finer, 2, coarse.halved);
}

void add_corrections(Level& level, double factor) {
    const Extent& e = level.extent;
    const std::ptrdiff_t length = level.shape.length();
    for_rows(level, e.ni * cost_of_node, [&](int j, int k) {
        if (j == 0 || j == e.nj - 1 || (level.axes == 3 && (k == 0 || k == e.nk - 1))) return;
        for (int c = 0; c < level.components; ++c) {
            double* const x = level.points.row(j, k) + c * length;
            const float* const v = level.corrections.row(j, k) + c * length;
            const double first = x[0];
            double& end = x[level.shape.at(e.ni - 1)];
            const double last = end;
            for (std::ptrdiff_t i = 0; i < length; ++i) x[i] += factor * static_cast<double>(v[i]);
            x[0] = first;
            end = last;
            if (level.steps.empty()) continue;
            float* const sum = level.steps.row(j, k) + c * length;
            for (std::ptrdiff_t i = 0; i < length; ++i) sum[i] += static_cast<float>(factor) * v[i];
        }
    });
}

}  // namespace hexweave
