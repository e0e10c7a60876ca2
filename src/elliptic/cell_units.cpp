// SPDX-License-Identifier: Apache-2.0
#include "elliptic/cell_units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexweave {

namespace {

/// Of a cell as flat as this (its base vectors about one degree from a common plane) a displacement
/// is measured as if it were that thick.
constexpr double least_sine_of_measure = 0.02;

/// 1 / value with |value| no less than `least`, the sign kept; 0 where both are zero.
double guarded_inverse(double value, double least) {
    const double size = std::max(std::abs(value), least);
    return size == 0 ? 0 : (value < 0 ? -1 / size : 1 / size);
}

CellFrame face_frame(const Vec3& a1, const Vec3& a2, double least_sine) {
    const Vec3 normal = cross(a1, a2);
    const double area = norm(normal);
    const double least = least_sine * norm(a1) * norm(a2);
    const double inverse = guarded_inverse(area, least);
    const Vec3 n = guarded_inverse(area, 0) * normal;
    return {inverse * cross(a2, n), inverse * cross(n, a1), std::sqrt(inverse) * n};
}

CellFrame block_frame(const Vec3& a1, const Vec3& a2, const Vec3& a3, double least_sine) {
    const Vec3 b1 = cross(a2, a3);
    const double least = least_sine * norm(a1) * norm(a2) * norm(a3);
    const double inverse = guarded_inverse(dot(a1, b1), least);
    return {inverse * b1, inverse * cross(a3, a1), inverse * cross(a1, a2)};
}

}  // namespace

CellFrame cell_frame(const NodeLattice& lattice, const Nodes& points, std::size_t offset,
                     double least_sine) {
    const Vec3* x = points.data() + offset;
    const Strides& d = lattice.strides;
    const Vec3 a1 = 0.5 * (x[d[0]] - x[-d[0]]);
    const Vec3 a2 = 0.5 * (x[d[1]] - x[-d[1]]);
    if (lattice.axes == 2) return face_frame(a1, a2, least_sine);
    return block_frame(a1, a2, 0.5 * (x[d[2]] - x[-d[2]]), least_sine);
}

double largest_displacement(const NodeLattice& lattice, const Nodes& points,
                            const Nodes& displacement) {
    double largest = 0;
    for_interior(lattice, [&](std::size_t p) {
        const CellFrame frame = cell_frame(lattice, points, p, least_sine_of_measure);
        const Vec3 c = frame.cells(displacement[p]);
        for (const double component : {c.x, c.y, c.z}) {
            const double size = std::abs(component);
            // NaN is kept: it compares false with whatever comes after it.
            if (size > largest || std::isnan(size)) largest = size;
        }
    });
    return largest;
}

double rounding_in_cells(const NodeLattice& lattice, const Nodes& points) {
    double largest = 0;
    for_interior(lattice, [&](std::size_t p) {
        const CellFrame frame = cell_frame(lattice, points, p, least_sine_of_measure);
        for (const Vec3& row : {frame.row_1, frame.row_2, frame.row_3}) {
            const Vec3& x = points[p];
            largest = std::max(
                largest, std::abs(row.x * x.x) + std::abs(row.y * x.y) + std::abs(row.z * x.z));
        }
    });
    return std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace hexweave
