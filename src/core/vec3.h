// SPDX-License-Identifier: Apache-2.0
// Points and vectors of three-dimensional space. Planar grids have z = 0.
#pragma once

#include <cmath>

namespace hexweave {

struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a) {
    return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(double f, const Vec3& a) {
    return {f * a.x, f * a.y, f * a.z};
}
constexpr Vec3 operator*(const Vec3& a, double f) {
    return f * a;
}
constexpr Vec3 operator/(const Vec3& a, double f) {
    return {a.x / f, a.y / f, a.z / f};
}
constexpr Vec3& operator+=(Vec3& a, const Vec3& b) {
    return a = a + b;
}
constexpr Vec3& operator-=(Vec3& a, const Vec3& b) {
    return a = a - b;
}

constexpr double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Six times the volume of the tetrahedron spanned by a, b and c; positive when right-handed.
constexpr double triple(const Vec3& a, const Vec3& b, const Vec3& c) {
    return dot(a, cross(b, c));
}

inline double norm(const Vec3& a) {
    return std::sqrt(dot(a, a));
}
inline double distance(const Vec3& a, const Vec3& b) {
    return norm(b - a);
}
inline bool is_finite(const Vec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// The point at fraction f of the way from a to b; exactly a at 0 and b at 1.
constexpr Vec3 lerp(const Vec3& a, const Vec3& b, double f) {
    return (1 - f) * a + f * b;
}

}  // namespace hexweave
