// SPDX-License-Identifier: Apache-2.0
#include "elliptic/fold_count.h"

#include <algorithm>
#include <array>

namespace hexweave {

namespace {

/// Normals of the four corners of face cell (i, j), in the order of the corners of a face.
std::array<Vec3, 4> corner_normals(const PointField& x, int i, int j) {
    const std::array<Vec3, 4> corner{x(i, j), x(i + 1, j), x(i + 1, j + 1), x(i, j + 1)};
    std::array<Vec3, 4> normals;
    for (std::size_t c = 0; c < 4; ++c) {
        normals[c] = cross(corner[(c + 1) % 4] - corner[c], corner[(c + 3) % 4] - corner[c]);
    }
    return normals;
}

Vec3 sum(const std::array<Vec3, 4>& v) {
    return v[0] + v[1] + v[2] + v[3];
}

bool is_planar(const PointField& x) {
    const std::size_t nodes = x.extent().nodes();
    for (std::size_t p = 0; p < nodes; ++p) {
        if (x.z[p] != x.z[0]) return false;
    }
    return true;
}

long count_folded_face(const PointField& x) {
    const Extent& e = x.extent();
    Vec3 face_normal;
    for (int j = 0; j + 1 < e.nj; ++j) {
        for (int i = 0; i + 1 < e.ni; ++i) face_normal += sum(corner_normals(x, i, j));
    }
    const bool planar = is_planar(x);
    long folded = 0;
    for (int j = 0; j + 1 < e.nj; ++j) {
        for (int i = 0; i + 1 < e.ni; ++i) {
            const auto normals = corner_normals(x, i, j);
            const Vec3 positive = planar ? face_normal : sum(normals);
            folded += std::any_of(normals.begin(), normals.end(),
                                  [&](const Vec3& n) { return !(dot(n, positive) > 0); });
        }
    }
    return folded;
}

/// Whether one of the eight corners of block cell (i, j, k) is not right-handed.
bool is_folded(const PointField& x, int i, int j, int k) {
    for (int corner = 0; corner < 8; ++corner) {
        const int di = corner & 1;
        const int dj = (corner >> 1) & 1;
        const int dk = (corner >> 2) & 1;
        const Vec3 a1 = x(i + 1, j + dj, k + dk) - x(i, j + dj, k + dk);
        const Vec3 a2 = x(i + di, j + 1, k + dk) - x(i + di, j, k + dk);
        const Vec3 a3 = x(i + di, j + dj, k + 1) - x(i + di, j + dj, k);
        if (!(triple(a1, a2, a3) > 0)) return true;
    }
    return false;
}

}  // namespace

long count_folded(const PointField& points) {
    const Extent& e = points.extent();
    if (e.nk == 1) return count_folded_face(points);
    long folded = 0;
    for (int k = 0; k + 1 < e.nk; ++k) {
        for (int j = 0; j + 1 < e.nj; ++j) {
            for (int i = 0; i + 1 < e.ni; ++i) folded += is_folded(points, i, j, k);
        }
    }
    return folded;
}

}  // namespace hexweave
