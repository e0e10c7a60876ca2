// SPDX-License-Identifier: Apache-2.0
// The topology in the making: every entity with the entry that it came from, and whether it could
// be resolved. What depends on a faulty entity is left out silently: its fault has been reported.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "topology/case.h"
#include "topology/names.h"
#include "topology/topology.h"

namespace hexweave {

struct DraftVertex {
    Vertex vertex;
    const VertexEntry* entry = nullptr;
    bool sound = false;
    bool used = false;
};

/// `edge.start` and `edge.end` are -1 where the vertex is unknown. `entry` is null for a made edge.
struct DraftEdge {
    Edge edge;
    const EdgeEntry* entry = nullptr;
    bool sound = false;
    bool used = false;
};

/// `entry` is null for a made face.
struct DraftFace {
    Face face;
    const FaceEntry* entry = nullptr;
    bool sound = false;
    bool used = false;
};

/// `corners_known` for a block given by its corners, once their names and edges are found.
struct DraftBlock {
    Block block;
    const BlockEntry* entry = nullptr;
    bool corners_known = false;
    bool sound = false;
};

/// The edges between two vertices; more than one is a choice that corners cannot make.
struct EdgesBetween {
    std::vector<int> edges;
    bool reported = false;
};

struct Draft {
    const Case& c;
    Diagnostics& diagnostics;
    std::vector<bool> curve_used;
    std::vector<bool> surface_used;
    std::vector<DraftVertex> vertices;
    std::vector<DraftEdge> edges;
    std::vector<DraftFace> faces;
    std::vector<DraftBlock> blocks;
    std::map<std::array<int, 2>, EdgesBetween> edges_between;  ///< by vertices, ascending
    /// An entry could not be read, or corners not be resolved: what they use is not known.
    bool uses_lost = false;
    std::vector<PutOnSurface> put_on_surface;
    NameTable curve_names{"curve"};
    NameTable surface_names{"surface"};
    NameTable vertex_names{"vertex"};
    NameTable edge_names{"edge"};
    NameTable face_names{"face"};

    Draft(const Case& the_case, Diagnostics& the_diagnostics)
        : c(the_case), diagnostics(the_diagnostics), uses_lost(the_diagnostics.has_errors()) {}

    bool three_dimensional() const { return !c.blocks.empty(); }
    DraftVertex& vertex(int index) { return vertices[static_cast<std::size_t>(index)]; }
    DraftEdge& edge(int index) { return edges[static_cast<std::size_t>(index)]; }
    DraftFace& face(int index) { return faces[static_cast<std::size_t>(index)]; }
    const std::string& vertex_name(int index) { return vertex(index).vertex.name; }
    const std::string& edge_name(int index) { return edge(index).edge.name; }
    const std::string& face_name(int index) { return face(index).face.name; }
};

/// The sound and used part of a draft. Counts, laws and boundaries are resolved on it.
struct Network {
    Topology topology;
    std::vector<const EdgeEntry*> edge_entries;    ///< as topology.edges; null for a made edge
    std::vector<const FaceEntry*> face_entries;    ///< as topology.faces; null for a made face
    std::vector<const BlockEntry*> block_entries;  ///< as topology.blocks
    NameTable edge_names{"edge"};
    NameTable face_names{"face"};
    bool three_dimensional = false;
    /// Nothing was left out as faulty, so that something missing may be called missing.
    bool intact = true;

    Edge& edge(int index) { return topology.edges[static_cast<std::size_t>(index)]; }
    const Edge& edge(int index) const { return topology.edges[static_cast<std::size_t>(index)]; }
    const Face& face(int index) const { return topology.faces[static_cast<std::size_t>(index)]; }
};

/// The surfaces of these names, marked used; none where one is unknown or could not be built.
std::vector<std::shared_ptr<const Surface>> use_surfaces(Draft& draft,
                                                         const std::vector<Name>& names);
/// "surface 'a'", "surfaces 'a' and 'b'".
std::string surfaces_text(const std::vector<Name>& names);
/// Places a vertex that was given by a place on a surface.
void place_on_surface(Draft& draft, DraftVertex& vertex, const OnSurface& where);
/// The curve that an edge without `along` follows on its surfaces: the image of a straight line
/// between the parameters of its ends; on several surfaces the straight line between its ends,
/// moved to the nearest points. False after an error.
bool place_across_surfaces(Draft& draft, DraftEdge& edge);
/// A curve put onto an edge's surfaces; null after an error.
std::shared_ptr<const Curve> put_onto_surfaces(Draft& draft, const Curve& curve,
                                               const EdgeEntry& entry);
/// Notes how far a curve was from an edge's surfaces, of the piece that the edge is.
void note_put_edge(Draft& draft, const DraftEdge& edge, const Curve& curve);
/// Notes in the tables what is known of names besides the entities: for messages about unknown
/// ones.
void note_other_names(Draft& draft);
/// Names of the curves and surfaces; names and positions of the vertices.
void place_vertices(Draft& draft);
/// The pieces of curves (straight lines) that the drawn edges are.
void place_edges(Draft& draft);
/// Gives an edge the straight line between two points, which differ.
void make_straight(Edge& edge, const Vec3& start, const Vec3& end);
/// How an entity is made: its entry, completed from the solver's section.
SolveRequest solve_request(const Case& c, const MethodEntry& how);
/// Enters every face and block; joins the faces given by their corners, and makes the straight
/// edges that these and the blocks given by their corners need.
void place_corners(Draft& draft);
/// Directions of the edges of every face given by its sides.
void join_faces(Draft& draft);
/// Finds or makes the faces of every block given by its corners.
void join_corner_blocks(Draft& draft);
/// Orientations of the faces of every block given by its faces.
void join_blocks(Draft& draft);
/// Warns of what nothing uses; not of what is faulty, nor of a kind of which a name is unknown:
/// that one may be meant.
void warn_unused(Draft& draft);
/// Keeps what is sound and part of the grid.
Network sound_part(Draft& draft);

}  // namespace hexweave
