// SPDX-License-Identifier: Apache-2.0
// Blocks whose sides are made of several faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "blocks/assemble.h"
#include "blocks/soundness.h"
#include "edges/edge_grid.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

using Generator = std::minstd_rand;

/// How many faces a side has along its first and second axis: 1 or 2.
using Split = std::array<int, 2>;

/// The cells of the two parts of the box along each axis of space, and where it is divided: so that
/// the points along its edges have equal distances.
constexpr std::array<std::array<int, 2>, 3> cells_of_parts{{{2, 3}, {4, 2}, {3, 3}}};

double fraction(int axis, int station) {
    const auto& parts = cells_of_parts[static_cast<std::size_t>(axis)];
    return station == 0   ? 0
           : station == 2 ? 1
                          : static_cast<double>(parts[0]) / (parts[0] + parts[1]);
}

/// A trilinear map of the unit cube.
Vec3 shape(double u, double v, double w) {
    return {2 * u + 0.3 * v * w, 1.5 * v - 0.2 * u * w + 0.1 * u, w + 0.25 * u * v * w};
}

/// The text of a case: a box, divided in two along each axis, with sides of one or more faces in
/// any orientation.
class SplitBox {
public:
    /// `axes` takes the block's axes to those of space.
    SplitBox(const Orientation& axes, const std::array<Split, 6>& splits, unsigned seed)
        : axes_(axes), generator_(seed) {
        std::string sides;
        for (const Side side : all_sides) {
            sides += fmt::format("{}: {}, ", side_name(side),
                                 side_text(side, splits[static_cast<std::size_t>(side)]));
        }
        text_ = "vertices:\n" + vertices_ + "edges:\n" + edges_ + "faces:\n" + faces_;
        text_ += "blocks:\n  box: {" + sides + "METHOD}\n";
        text_ += "boundaries:\n  all: {type: BCWall, sides: [" + names_ + "]}\n";
    }

    std::string text(const std::string& method) const {
        std::string text = text_;
        return text.replace(text.find("METHOD"), 6, "method: " + method);
    }

private:
    bool toss() { return generator_() % 2 == 1; }

    Node in_space(const Node& block_node) const { return map_node(axes_, block_node, {3, 3, 3}); }

    std::string vertex(const Node& n) {
        const std::string name = fmt::format("p{}{}{}", n[0], n[1], n[2]);
        if (known_.insert(name).second) {
            const Vec3 p = shape(fraction(0, n[0]), fraction(1, n[1]), fraction(2, n[2]));
            vertices_ += fmt::format("  {}: [{:.17g}, {:.17g}, {:.17g}]\n", name, p.x, p.y, p.z);
        }
        return name;
    }

    /// The straight edge between two nodes of the block's lattice.
    std::string edge(const Node& block_a, const Node& block_b) {
        Node a = in_space(block_a);
        Node b = in_space(block_b);
        if (b < a) std::swap(a, b);
        const std::string from = vertex(a);
        const std::string to = vertex(b);
        const std::string name = "e_" + from + to;
        if (!known_.insert(name).second) return name;
        int cells = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (int part = a[axis]; part < b[axis]; ++part) {
                cells += cells_of_parts[axis][static_cast<std::size_t>(part)];
            }
        }
        const bool turned = toss();
        edges_ += fmt::format("  {}: {{from: {}, to: {}, cells: {}}}\n", name, turned ? to : from,
                              turned ? from : to, cells);
        return name;
    }

    /// The edges from one station to another along an axis of the block: in two where the line is
    /// an edge of the block or another face ends there.
    std::vector<std::string> chain(Node from, int axis, int to, bool divided) {
        const auto a = static_cast<std::size_t>(axis);
        std::vector<std::string> edges;
        while (from[a] < to) {
            Node next = from;
            next[a] = divided ? from[a] + 1 : to;
            edges.push_back(edge(from, next));
            from = next;
        }
        return edges;
    }

    std::string list(std::vector<std::string> edges, bool backwards) {
        if (backwards) std::reverse(edges.begin(), edges.end());
        return fmt::format("[{}]", fmt::join(edges, ", "));
    }

    /// The face of a side between two stations along each of its axes; its name.
    std::string face(Side side, const Split& split, const Split& begin, const Split& end) {
        const std::array<int, 2> axes = tangential_axes(side);
        std::array<std::vector<std::string>, 4> sides;
        for (std::size_t own = 0; own < 2; ++own) {
            for (std::size_t max = 0; max < 2; ++max) {
                Node from{};
                from[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? 2 : 0;
                const int station = max == 1 ? end[own] : begin[own];
                from[static_cast<std::size_t>(axes[own])] = station;
                from[static_cast<std::size_t>(axes[1 - own])] = begin[1 - own];
                const bool divided = station != 1 || split[1 - own] == 2;
                sides[2 * own + max] = chain(from, axes[1 - own], end[1 - own], divided);
            }
        }
        if (toss()) sides = {sides[2], sides[3], sides[0], sides[1]};
        std::array<bool, 2> flipped{toss(), toss()};
        if (flipped[0]) std::swap(sides[0], sides[1]);
        if (flipped[1]) std::swap(sides[2], sides[3]);
        const std::string name = fmt::format("{}_{}{}", side_name(side), begin[0], begin[1]);
        faces_ +=
            fmt::format("  {}: {{imin: {}, imax: {}, jmin: {}, jmax: {}, method: algebraic}}\n",
                        name, list(sides[0], flipped[1]), list(sides[1], flipped[1]),
                        list(sides[2], flipped[0]), list(sides[3], flipped[0]));
        names_ += names_.empty() ? name : ", " + name;
        return name;
    }

    std::string side_text(Side side, const Split& split) {
        std::vector<std::string> rows;
        std::vector<std::string> all;
        for (int b = 0; b < split[1]; ++b) {
            std::vector<std::string> row;
            for (int a = 0; a < split[0]; ++a) {
                const auto end = [](int parts, int n) { return parts == 1 ? 2 : n + 1; };
                row.push_back(face(side, split, {a, b}, {end(split[0], a), end(split[1], b)}));
            }
            all.insert(all.end(), row.begin(), row.end());
            rows.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
        }
        if (all.size() == 1) return all.front();
        const bool strip = all.size() == 2 && toss();
        return fmt::format("[{}]", fmt::join(strip ? all : rows, ", "));
    }

    Orientation axes_;
    Generator generator_;
    std::set<std::string> known_;
    std::string vertices_;
    std::string edges_;
    std::string faces_;
    std::string names_;
    std::string text_;
};

MultiblockGrid generated(const Topology& topology) {
    const auto edges = make_edges(topology);
    const auto faces = make_faces(topology, edges);
    return assemble(topology, faces, make_blocks(topology, faces));
}

/// The greatest distance of the box's nodes from those of the trilinear map.
double error_of(const PointField& points, const Orientation& axes) {
    const Extent in_space{6, 7, 7};
    REQUIRE(points.extent() == own_extent(axes, in_space));
    double greatest = 0;
    for (int k = 0; k < points.extent().nk; ++k) {
        for (int j = 0; j < points.extent().nj; ++j) {
            for (int i = 0; i < points.extent().ni; ++i) {
                const Node n = map_node(axes, {i, j, k}, in_space);
                const Vec3 exact = shape(n[0] / 5.0, n[1] / 6.0, n[2] / 6.0);
                greatest = std::max(greatest, distance(points(i, j, k), exact));
            }
        }
    }
    return greatest;
}

std::vector<Orientation> rotations() {
    std::vector<Orientation> result;
    std::array<int, 3> axes{1, 2, 3};
    do {
        for (unsigned signs = 0; signs < 8; ++signs) {
            Orientation o{axes};
            for (std::size_t a = 0; a < 3; ++a) {
                if (signs & (1U << a)) o.axes[a] = -o.axes[a];
            }
            if (determinant(o) == 1) result.push_back(o);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return result;
}

}  // namespace

TEST_CASE("sides of several faces give the same block as single faces, however all are turned") {
    const auto all = rotations();
    Generator generator(7);
    for (unsigned n = 0; n < 144; ++n) {
        std::array<Split, 6> splits;
        splits.fill({1, 1});
        // One side split in every way, then all of them at random.
        if (n < 24) splits[n / 4] = {1 + static_cast<int>(n % 2), 1 + static_cast<int>(n / 2 % 2)};
        for (std::size_t s = 0; s < 6 && n >= 24; ++s) {
            splits[s] = {1 + static_cast<int>(generator() % 2),
                         1 + static_cast<int>(generator() % 2)};
        }
        const Orientation& axes = all[n % 24];
        const SplitBox box(axes, splits, n + 1);
        INFO(box.text("algebraic"));
        REQUIRE(faults(box.text("algebraic")) == "");
        const Topology topology = resolved(box.text("algebraic"));
        REQUIRE(broken_promise(topology) == "");
        const MultiblockGrid grid = generated(topology);
        CHECK(error_of(grid.zones[0].points, axes) < 1e-13);
        CHECK(grid.patches.size() == topology.faces.size());
        check_sound(grid);
    }
}

TEST_CASE("an elliptic block does not know of how many faces its sides are made") {
    std::array<Split, 6> splits;
    splits.fill({1, 1});
    const SplitBox whole({}, splits, 1);
    splits = {{{2, 1}, {1, 2}, {2, 2}, {1, 1}, {2, 1}, {2, 2}}};
    const SplitBox divided({}, splits, 5);
    const MultiblockGrid a = generated(resolved(whole.text("elliptic")));
    const MultiblockGrid b = generated(resolved(divided.text("elliptic")));
    double greatest = 0;
    for (std::size_t n = 0; n < a.zones[0].points.extent().nodes(); ++n) {
        greatest = std::max(greatest, distance(a.zones[0].points[n], b.zones[0].points[n]));
    }
    CHECK(greatest < 1e-8);
}
