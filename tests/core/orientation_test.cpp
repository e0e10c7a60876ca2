// SPDX-License-Identifier: Apache-2.0
#include "core/orientation.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "core/multiblock.h"

using namespace hexweave;

namespace {

using Matrix = std::array<std::array<int, 3>, 3>;

std::vector<Orientation> all_orientations() {
    std::vector<Orientation> result;
    std::array<int, 3> axes{1, 2, 3};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Orientation o{axes};
            for (std::size_t a = 0; a < 3; ++a) {
                if ((signs >> a) & 1) o.axes[a] = -o.axes[a];
            }
            result.push_back(o);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return result;
}

/// The matrix T of the CGNS standard (SIDS, 1-to-1 interface connectivity):
/// T(row, column) = sign(Transform[column]) where row + 1 = |Transform[column]|, else 0.
Matrix cgns_matrix(const Orientation& o) {
    Matrix t{};
    for (std::size_t column = 0; column < 3; ++column) {
        const int axis = o.axes[column];
        t[static_cast<std::size_t>(std::abs(axis) - 1)][column] = axis > 0 ? 1 : -1;
    }
    return t;
}

int matrix_determinant(const Matrix& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
        }
    }
    return c;
}

}  // namespace

TEST_CASE("the 48 signed permutations form a group") {
    const auto all = all_orientations();
    REQUIRE(all.size() == 48);
    const Orientation identity;
    for (const Orientation& a : all) {
        CHECK(compose(a, identity) == a);
        CHECK(compose(identity, a) == a);
        CHECK(compose(a, inverse(a)) == identity);
        CHECK(compose(inverse(a), a) == identity);
        for (const Orientation& b : all) {
            const Orientation ab = compose(a, b);
            CHECK(std::count(all.begin(), all.end(), ab) == 1);
            CHECK(inverse(ab) == compose(inverse(b), inverse(a)));
            CHECK(determinant(ab) == determinant(a) * determinant(b));
        }
    }
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Orientation& a = all[n];
        const Orientation& b = all[(7 * n + 3) % 48];
        const Orientation& c = all[(11 * n + 5) % 48];
        CHECK(compose(compose(a, b), c) == compose(a, compose(b, c)));
    }
}

TEST_CASE("composing and the determinant agree with the matrices of the CGNS standard") {
    for (const Orientation& a : all_orientations()) {
        CHECK(determinant(a) == matrix_determinant(cgns_matrix(a)));
        for (const Orientation& b : all_orientations()) {
            CHECK(cgns_matrix(compose(a, b)) == product(cgns_matrix(b), cgns_matrix(a)));
        }
    }
}

TEST_CASE("mapping a node there and back is the identity, and maps corners to corners") {
    const Extent other{3, 4, 6};
    for (const Orientation& o : all_orientations()) {
        const Extent own = own_extent(o, other);
        CHECK(own.nodes() == other.nodes());
        CHECK(own_extent(inverse(o), own) == other);
        std::set<Node> images;
        for (int k = 0; k < own.nk; ++k) {
            for (int j = 0; j < own.nj; ++j) {
                for (int i = 0; i < own.ni; ++i) {
                    const Node image = map_node(o, {i, j, k}, other);
                    CHECK(map_node(inverse(o), image, own) == Node{i, j, k});
                    images.insert(image);
                    for (std::size_t a = 0; a < 3; ++a) {
                        CHECK((image[a] >= 0 && image[a] < other[static_cast<int>(a)]));
                    }
                }
            }
        }
        CHECK(images.size() == own.nodes());
    }
}

TEST_CASE("composed mappings of nodes are mappings of the composition") {
    const Extent other{3, 4, 6};
    for (const Orientation& a : all_orientations()) {
        for (const Orientation& b : all_orientations()) {
            const Extent middle = own_extent(b, other);
            const Extent own = own_extent(a, middle);
            CHECK(own == own_extent(compose(a, b), other));
            const Node n{own.ni - 1, 1, 0};
            CHECK(map_node(b, map_node(a, n, middle), other) == map_node(compose(a, b), n, other));
        }
    }
}

TEST_CASE("a shared part maps by the relation of CGNS: Index2 = T (Index1 - Begin1) + Begin2") {
    const Node begin{2, 0, 5};
    const Node other_begin{7, 9, 11};
    for (const Orientation& o : all_orientations()) {
        const Matrix t = cgns_matrix(o);
        const Node n{4, 3, 6};
        Node expected = other_begin;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t c = 0; c < 3; ++c) expected[row] += t[row][c] * (n[c] - begin[c]);
        }
        CHECK(map_node(o, n, begin, other_begin) == expected);
        CHECK(map_node(o, begin, begin, other_begin) == other_begin);
    }
}

TEST_CASE("the donor node of an interface's box ends are the ends of its donor box") {
    const Interface seam{"seam",       0, {{0, 0, 0}, {0, 4, 2}}, 1, {{8, 4, 2}, {8, 0, 0}},
                         {{1, -2, -3}}};
    CHECK(donor_node(seam, seam.box.begin) == seam.donor_box.begin);
    CHECK(donor_node(seam, seam.box.end) == seam.donor_box.end);
    CHECK(donor_node(seam, {0, 1, 2}) == Node{8, 3, 0});
}

TEST_CASE("a face has eight orientations, closed under composition") {
    const auto& faces = face_orientations();
    for (const Orientation& a : faces) {
        CHECK(a.axes[2] == 3);
        CHECK(std::count(faces.begin(), faces.end(), a) == 1);
        CHECK(std::count(faces.begin(), faces.end(), inverse(a)) == 1);
        for (const Orientation& b : faces) {
            CHECK(std::count(faces.begin(), faces.end(), compose(a, b)) == 1);
        }
    }
}

TEST_CASE("orientations are written as users write them") {
    CHECK(to_string(Orientation{{1, -3, 2}}, 3) == "[i, -k, j]");
    CHECK(to_string(Orientation{{-2, 1, 3}}, 2) == "[-j, i]");
}

TEST_CASE("a side's box holds exactly the nodes of that side") {
    const Extent extent{3, 4, 5};
    CHECK(side_box(Side::imin, extent) == IndexBox{{0, 0, 0}, {0, 3, 4}});
    CHECK(side_box(Side::imax, extent) == IndexBox{{2, 0, 0}, {2, 3, 4}});
    CHECK(side_box(Side::jmin, extent) == IndexBox{{0, 0, 0}, {2, 0, 4}});
    CHECK(side_box(Side::jmax, extent) == IndexBox{{0, 3, 0}, {2, 3, 4}});
    CHECK(side_box(Side::kmin, extent) == IndexBox{{0, 0, 0}, {2, 3, 0}});
    CHECK(side_box(Side::kmax, extent) == IndexBox{{0, 0, 4}, {2, 3, 4}});
}

TEST_CASE("sides know their name, axis and end") {
    CHECK(side_name(Side::jmax) == "jmax");
    for (const Side side : all_sides) {
        CHECK(is_max(side) == (side_name(side).substr(1) == "max"));
        CHECK(axis_of(side) == side_name(side)[0] - 'i');
        const auto [a, b] = tangential_axes(side);
        CHECK((a < b && a != axis_of(side) && b != axis_of(side)));
    }
}
