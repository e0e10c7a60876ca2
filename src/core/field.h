// SPDX-License-Identifier: Apache-2.0
// Fields: one number (or one point) for every node of a structured index space, i fastest.
// A face is a block one node thick: its extent is (ni, nj, 1).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/assert.h"
#include "core/vec3.h"

namespace hexweave {

/// The number of nodes along i, j and k.
struct Extent {
    int ni = 1;
    int nj = 1;
    int nk = 1;

    friend bool operator==(const Extent&, const Extent&) = default;

    int operator[](int axis) const { return axis == 0 ? ni : axis == 1 ? nj : nk; }
    std::size_t nodes() const {
        return static_cast<std::size_t>(ni) * static_cast<std::size_t>(nj) *
               static_cast<std::size_t>(nk);
    }
    /// Cells; an axis that is one node thick does not count (a face has (ni-1)(nj-1) cells).
    std::size_t cells() const {
        std::size_t count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            if ((*this)[axis] > 1) count *= static_cast<std::size_t>((*this)[axis] - 1);
        }
        return count;
    }
    /// The flat position of node (i, j, k).
    std::size_t offset(int i, int j, int k = 0) const {
        HEXWEAVE_ASSERT(i >= 0 && i < ni && j >= 0 && j < nj && k >= 0 && k < nk);
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(ni) *
                   (static_cast<std::size_t>(j) +
                    static_cast<std::size_t>(nj) * static_cast<std::size_t>(k));
    }
};

/// One double for every node.
class Field {
public:
    Field() = default;
    explicit Field(Extent extent, double value = 0)
        : extent_(extent), values_(extent.nodes(), value) {}

    const Extent& extent() const { return extent_; }
    double& operator()(int i, int j, int k = 0) { return values_[extent_.offset(i, j, k)]; }
    double operator()(int i, int j, int k = 0) const { return values_[extent_.offset(i, j, k)]; }
    double& operator[](std::size_t offset) { return values_[offset]; }
    double operator[](std::size_t offset) const { return values_[offset]; }
    double* data() { return values_.data(); }
    const double* data() const { return values_.data(); }

private:
    Extent extent_;
    std::vector<double> values_;
};

/// One point for every node: three fields, components apart.
struct PointField {
    Field x;
    Field y;
    Field z;

    PointField() = default;
    explicit PointField(Extent extent) : x(extent), y(extent), z(extent) {}

    const Extent& extent() const { return x.extent(); }
    Vec3 operator()(int i, int j, int k = 0) const { return (*this)[extent().offset(i, j, k)]; }
    Vec3 operator[](std::size_t offset) const { return {x[offset], y[offset], z[offset]}; }
    void set(int i, int j, int k, const Vec3& p) { set(extent().offset(i, j, k), p); }
    void set(std::size_t offset, const Vec3& p) {
        x[offset] = p.x;
        y[offset] = p.y;
        z[offset] = p.z;
    }
};

}  // namespace hexweave
