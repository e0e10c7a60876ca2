// SPDX-License-Identifier: Apache-2.0
// Topologies and edge grids built by hand for tests: quadrilaterals and hexahedra between vertices,
// joined wherever they name the same vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "edges/edge_grid.h"
#include "topology/topology.h"

namespace hexweave::test {

inline double identity_law(double t) {
    return t;
}
inline Vec3 identity_shape(const Vec3& p) {
    return p;
}

inline std::string numbered(char letter, int index) {
    std::string name(1, letter);
    name += std::to_string(index);
    return name;
}

struct HandBuilt {
    Topology topology;
    std::vector<EdgeGrid> edges;

    /// Of edges made from now on: fractions of the straight line between the vertices, and where
    /// its points go. Vertices are moved by the shape when they are made.
    std::function<double(double)> law = identity_law;
    std::function<Vec3(const Vec3&)> shape = identity_shape;
    Method method = Method::algebraic;
    std::vector<Vec3> reference;  ///< vertices before the shape

    int vertex(const Vec3& p) {
        reference.push_back(p);
        const int index = static_cast<int>(topology.vertices.size());
        topology.vertices.push_back({numbered('v', index), shape(p), {}});
        return index;
    }

    /// An edge with given points; its ends become the vertices' positions.
    int edge(int a, int b, std::vector<Vec3> points) {
        points.front() = position(a);
        points.back() = position(b);
        Edge made;
        const int index = static_cast<int>(topology.edges.size());
        made.name = numbered('e', index);
        made.start = a;
        made.end = b;
        made.cells = static_cast<int>(points.size()) - 1;
        topology.edges.push_back(made);
        edges.push_back({std::move(points), {}, {}});
        return index;
    }

    /// An edge of the current law and shape.
    int edge(int a, int b, int cells) {
        std::vector<Vec3> points;
        for (int n = 0; n <= cells; ++n) {
            const double f = law(static_cast<double>(n) / cells);
            points.push_back(shape(lerp(reference[at(a)], reference[at(b)], f)));
        }
        return edge(a, b, std::move(points));
    }

    /// The edge between two vertices, made where there is none.
    EdgeUse between(int a, int b, int cells) {
        for (std::size_t n = 0; n < topology.edges.size(); ++n) {
            const Edge& e = topology.edges[n];
            if (e.start == a && e.end == b) return {static_cast<int>(n), false};
            if (e.start == b && e.end == a) return {static_cast<int>(n), true};
        }
        return {edge(a, b, cells), false};
    }

    /// A face of four sides imin, imax, jmin, jmax.
    int face(const std::array<std::vector<EdgeUse>, 4>& sides) {
        Face made;
        const int index = static_cast<int>(topology.faces.size());
        made.name = numbered('f', index);
        made.sides = sides;
        made.cells_i = cells(sides[2]);
        made.cells_j = cells(sides[0]);
        made.corners = {start(sides[2].front()), start(sides[1].front()), end(sides[3].back()),
                        end(sides[0].back())};
        made.solve.method = method;
        topology.faces.push_back(made);
        return index;
    }

    /// The face with these corners (any order), made where there is none.
    int quadrilateral(const std::array<int, 4>& corners, int cells_i, int cells_j) {
        for (std::size_t n = 0; n < topology.faces.size(); ++n) {
            if (std::is_permutation(corners.begin(), corners.end(),
                                    topology.faces[n].corners.begin())) {
                return static_cast<int>(n);
            }
        }
        return face({{{between(corners[0], corners[3], cells_j)},
                      {between(corners[1], corners[2], cells_j)},
                      {between(corners[0], corners[1], cells_i)},
                      {between(corners[3], corners[2], cells_i)}}});
    }

    /// A block between eight vertices in the order of the CGNS hexahedron.
    int hexahedron(const std::array<int, 8>& corners, const std::array<int, 3>& cells_ijk) {
        constexpr std::array<std::array<std::size_t, 4>, 6> of_side{
            {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};
        Block made;
        const int index = static_cast<int>(topology.blocks.size());
        made.name = numbered('b', index);
        made.corners = corners;
        made.extent = {cells_ijk[0] + 1, cells_ijk[1] + 1, cells_ijk[2] + 1};
        made.solve.method = method;
        for (const Side side : all_sides) {
            const auto n = static_cast<std::size_t>(side);
            std::array<int, 4> vertices{};
            for (std::size_t c = 0; c < 4; ++c) vertices[c] = corners[of_side[n][c]];
            const auto axes = tangential_axes(side);
            const int used =
                quadrilateral(vertices, cells_ijk[at(axes[0])], cells_ijk[at(axes[1])]);
            made.sides[n].faces = {
                {used, orientation_of(vertices, topology.faces[at(used)].corners)}};
        }
        topology.blocks.push_back(made);
        topology.planar = false;
        return index;
    }

    /// One boundary of all edges (faces, with blocks) that are used once.
    void bound_the_rest() {
        Boundary boundary{{"outside", "BCFarfield"}, {}, {}};
        const std::size_t count = topology.is_3d() ? topology.faces.size() : topology.edges.size();
        for (std::size_t n = 0; n < count; ++n) {
            if (uses(static_cast<int>(n)) == 1) boundary.sides.push_back(static_cast<int>(n));
        }
        topology.boundaries.push_back(boundary);
    }

    const Vec3& position(int v) const { return topology.vertices[at(v)].position; }

private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }
    int start(const EdgeUse& use) const {
        const Edge& e = topology.edges[at(use.edge)];
        return use.reversed ? e.end : e.start;
    }
    int end(const EdgeUse& use) const { return start({use.edge, !use.reversed}); }
    int cells(const std::vector<EdgeUse>& side) const {
        int sum = 0;
        for (const EdgeUse& use : side) sum += topology.edges[at(use.edge)].cells;
        return sum;
    }
    static Orientation orientation_of(const std::array<int, 4>& side,
                                      const std::array<int, 4>& corners) {
        constexpr std::array<Node, 4> corner_nodes{Node{0, 0, 0}, Node{1, 0, 0}, Node{1, 1, 0},
                                                   Node{0, 1, 0}};
        for (const Orientation& o : face_orientations()) {
            bool fits = true;
            for (std::size_t c = 0; c < 4; ++c) {
                const Node image = map_node(o, corner_nodes[c], {2, 2, 1});
                const auto where = std::find(corner_nodes.begin(), corner_nodes.end(), image);
                fits =
                    fits && side[c] == corners[at(static_cast<int>(where - corner_nodes.begin()))];
            }
            if (fits) return o;
        }
        return {};
    }
    int uses(int entity) const {
        int count = 0;
        if (topology.is_3d()) {
            for (const Block& b : topology.blocks) {
                for (const BlockSide& side : b.sides) {
                    for (const FaceUse& use : side.faces) count += use.face == entity;
                }
            }
        } else {
            for (const Face& f : topology.faces) {
                for (const auto& side : f.sides) {
                    for (const EdgeUse& use : side) count += use.edge == entity;
                }
            }
        }
        return count;
    }
};

/// Fractions that begin with steps of about `first`: f(0) = 0, f(1) = 1, strictly increasing.
inline std::function<double(double)> clustered(double first) {
    return [first](double t) { return first * t + (1 - first) * t * t * t; };
}

/// The greatest distance between the nodes of two fields of one extent.
inline double greatest_distance(const PointField& a, const PointField& b) {
    double greatest = 0;
    for (std::size_t n = 0; n < a.extent().nodes(); ++n) {
        greatest = std::max(greatest, distance(a[n], b[n]));
    }
    return greatest;
}

}  // namespace hexweave::test
