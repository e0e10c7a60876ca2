// SPDX-License-Identifier: Apache-2.0
// Names: which entity each one means, what to suggest for an unknown one, and the canonical names
// of edges and faces that the user did not draw.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "topology/case.h"

namespace hexweave {

/// What the index of a known name may be instead of an index.
inline constexpr int dropped_unused = -1;  ///< no part of the grid
inline constexpr int dropped_faulty = -2;  ///< at fault, and reported as such

/// What a vertex is called in hints.
inline constexpr const char* a_vertex = "a vertex";

/// The names of one kind of entity.
class NameTable {
public:
    /// `kind` in the singular: "vertex".
    explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

    /// The first of equal names counts; reading has reported the others.
    void add(const std::string& name, int index) { index_.emplace(name, index); }
    std::optional<int> find(const std::string& name) const;
    /// As `find`; reports an unknown name. An empty name is one that could not be read: silent.
    std::optional<int> require(const Name& name, Diagnostics& diagnostics);
    /// Reports a name that is not there.
    void tell_unknown(const Name& name, Diagnostics& diagnostics) const;
    /// Reports it and remembers that one was asked for.
    void report_unknown(const Name& name, Diagnostics& diagnostics);
    /// Whether a name was asked for that is not there: one of those that are there may be meant.
    bool unknown_asked() const { return unknown_asked_; }
    /// Notes a name that is no such entity but something else, "a vertex", for hints.
    void note_other(const std::string& name, const std::string& what) { others_[name] = what; }
    /// Notes the condition of an entry that is left out.
    void note_left_out(const LeftOutEntry& entry) { left_out_[entry.name] = entry.when; }
    /// Some of the names are not known: none is told as unknown.
    void set_incomplete() { incomplete_ = true; }
    /// Nor are those that begin with this: "root.".
    void set_lost(const std::string& scope) { lost_scopes_.push_back(scope); }
    /// Notes that what the canonical name `made` would stand for was drawn, under a name of its
    /// own: for the hint when somebody asks for `made`.
    void note_drawn(const std::string& made, const std::string& drawn);
    /// The index i becomes new_index[i].
    void renumber(const std::vector<int>& new_index);

private:
    bool is_lost(const std::string& name) const;
    /// Whether a name has the form of one that is made, "a-b", of vertices that there are.
    bool is_made_of_vertices(const std::string& name) const;
    std::string hint_for(const Name& name) const;

    std::string kind_;
    std::map<std::string, int> index_;
    std::map<std::string, std::vector<std::string>> drawn_;
    std::map<std::string, std::string> others_;
    std::map<std::string, Place> left_out_;
    std::vector<std::string> lost_scopes_;
    bool incomplete_ = false;
    bool unknown_asked_ = false;
};

/// An edge as it was named; `reversed` when spelled against its own direction ("b-a" for "a-b").
struct NamedEdge {
    int edge = 0;
    bool reversed = false;
};

/// Finds an edge by its name or, for one that was made, by its two vertices in either order.
std::optional<NamedEdge> find_edge(const NameTable& edges, const std::string& name);
/// Finds a face by its name or, for one that was made, by its corners in any cyclic order.
std::optional<int> find_face(const NameTable& faces, const std::string& name);

/// Whether a name is of one of these instances, "root.".
bool is_in_scope(const std::string& name, const std::vector<std::string>& scopes);

/// Tells the use of a name whose entry is left out for its condition. `kind` in the singular.
void tell_left_out(const std::string& kind, const Name& name, const Place& when,
                   Diagnostics& diagnostics);

/// 'name'
std::string quoted(const std::string& name);
/// 'a', 'b' and 'c'; with more than `most` names the first ones and a count.
std::string listed(const std::vector<std::string>& names, std::size_t most = 6);

/// The canonical name of an edge that nobody drew, between two vertices: "a-b" with a < b. More
/// than 32 bytes (what CGNS can hold) are cut and end in a hash.
std::string made_edge_name(const std::string& a, const std::string& b);
/// The order in which a made face takes its corners: from the alphabetically smallest on to the
/// smaller of its two neighbours, and round. Positions in the cycle given.
std::array<std::size_t, 4> canonical_cycle(const std::array<std::string, 4>& corners);
/// The canonical name of a face that nobody drew: "a-b-c-d" in its canonical cycle.
std::string made_face_name(const std::array<std::string, 4>& corners);
/// The canonical form of any spelling of a made name: "b-a", "c-d-a-b"; other names stay as they
/// are.
std::string canonical_name(const std::string& name);

}  // namespace hexweave
