// SPDX-License-Identifier: Apache-2.0
// A level of the hierarchy from points and parameters, for tests of the parts of a cycle.
#pragma once

#include <random>

#include "elliptic/level.h"
#include "elliptic/shapes.h"

namespace hexweave::shapes {

inline void add_work(Level& level) {
    level.stencils = RowArray<float>(level.extent, level.axes == 3 ? 9 : 5);
    level.weights = RowArray<float>(level.extent, 1);
    level.residuals = RowArray<float>(level.extent, level.components);
    level.corrections = RowArray<float>(level.extent, level.components);
    level.right_hand_sides = RowArray<double>(level.extent, level.components);
}

/// `components`: 2 for a face in a plane of constant z.
inline Level level_of(const PointField& points, const ParameterField& parameters, int components) {
    Level level;
    level.extent = points.extent();
    level.axes = level.extent.nk > 1 ? 3 : 2;
    level.components = components;
    level.shape = RowShape(level.extent.ni);
    level.points = RowArray<double>(level.extent, components);
    level.parameters = RowArray<double>(level.extent, level.axes);
    store(points.x, 0, level.points);
    store(points.y, 1, level.points);
    if (components == 3) store(points.z, 2, level.points);
    store(parameters.s, 0, level.parameters);
    store(parameters.t, 1, level.parameters);
    if (level.axes == 3) store(parameters.u, 2, level.parameters);
    add_work(level);
    return level;
}

/// Component c at node (i, j, k).
template <class T>
T& at(RowArray<T>& rows, const Level& level, int i, int j, int k, int c = 0) {
    return rows.row(j, k)[c * level.shape.length() + level.shape.at(i)];
}
template <class T>
T at(const RowArray<T>& rows, const Level& level, int i, int j, int k, int c = 0) {
    return rows.row(j, k)[c * level.shape.length() + level.shape.at(i)];
}

/// Calls visit(i, j, k) for every interior node.
template <class Visit>
void for_inside(const Level& level, Visit&& visit) {
    for (int k = level.first_k(); k <= level.last_k(); ++k) {
        for (int j = 1; j < level.extent.nj - 1; ++j) {
            for (int i = 1; i < level.extent.ni - 1; ++i) visit(i, j, k);
        }
    }
}

/// Numbers from -1 to 1 at the interior nodes, the same every time.
inline void fill_inside(const Level& level, RowArray<float>& rows, int components, unsigned seed) {
    std::mt19937 random(seed);
    for_inside(level, [&](int i, int j, int k) {
        for (int c = 0; c < components; ++c) {
            at(rows, level, i, j, k, c) =
                static_cast<float>(static_cast<double>(random()) / 2147483648.0 - 1);
        }
    });
}

}  // namespace hexweave::shapes
