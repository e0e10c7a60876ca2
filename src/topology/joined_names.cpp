// SPDX-License-Identifier: Apache-2.0
#include "topology/joined_names.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "topology/names.h"

namespace hexweave {

namespace {

std::string last_of(const std::map<std::string, std::string>& joined, std::string name) {
    for (auto next = joined.find(name); next != joined.end(); next = joined.find(name)) {
        name = next->second;
    }
    return name;
}

void join(std::map<std::string, std::string>& joined, const std::string& inside,
          const std::string& outside) {
    const std::string a = last_of(joined, inside);
    const std::string b = last_of(joined, outside);
    if (a != b) joined[a] = b;
}

/// A made name with its vertices renamed, "a-b"; any other as it is.
std::string made_name(const JoinedNames& joined, const std::string& name) {
    std::string whole;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('-', begin), name.size());
        if (begin > 0) whole += '-';
        whole += joined.vertex(name.substr(begin, end - begin));
        begin = end + 1;
    }
    return whole;
}

std::string side_name(const JoinedNames& joined, const std::string& name) {
    const std::string edge = joined.edge(name).name;
    if (edge != name) return edge;
    const std::string face = joined.face(name);
    if (face != name) return face;
    return name.find('-') == std::string::npos ? name : made_name(joined, name);
}

void rename(const JoinedNames& joined, SignedName& edge) {
    const JoinedEdge other = joined.edge(edge.value);
    edge.value =
        other.name.find('-') == std::string::npos ? other.name : made_name(joined, other.name);
    if (edge.sign_given && other.reversed) edge.reversed = !edge.reversed;
}

void rename(const JoinedNames& joined, EdgeEntry& edge) {
    edge.from.value = joined.vertex(edge.from.value);
    edge.to.value = joined.vertex(edge.to.value);
    if (!edge.spacing) return;
    if (auto* like = std::get_if<LikeLaw>(&edge.spacing->value)) rename(joined, like->edge);
}

void rename(const JoinedNames& joined, FaceEntry& face) {
    if (auto* corners = std::get_if<1>(&face.shape)) {
        for (Name& corner : *corners) corner.value = joined.vertex(corner.value);
        return;
    }
    for (auto& side : std::get<0>(face.shape)) {
        for (SignedName& edge : side) rename(joined, edge);
    }
}

void rename(const JoinedNames& joined, BlockEntry& block) {
    if (auto* corners = std::get_if<1>(&block.shape)) {
        for (Name& corner : *corners) corner.value = joined.vertex(corner.value);
        return;
    }
    for (BlockSideEntry& side : std::get<0>(block.shape)) {
        for (FaceUseEntry& use : side.faces) use.face.value = side_name(joined, use.face.value);
    }
}

void rename(const JoinedNames& joined, std::vector<Name>& sides) {
    for (Name& side : sides) side.value = side_name(joined, side.value);
}

/// The curves and surfaces of entries that go.
struct Forgotten {
    std::set<std::string> curves;
    std::set<std::string> surfaces;

    void add(const VertexEntry& vertex) {
        if (const auto* on = std::get_if<OnCurve>(&vertex.where)) curves.insert(on->curve.value);
        if (const auto* on = std::get_if<OnSurface>(&vertex.where)) add(on->surfaces);
    }
    void add(const EdgeEntry& edge) {
        if (edge.along) curves.insert(edge.along->value);
        add(edge.surfaces);
    }
    void add(const FaceEntry& face) { add(face.surfaces); }
    void add(const std::vector<Name>& names) {
        for (const Name& name : names) surfaces.insert(name.value);
    }
};

template <class Entry, class Stays>
void keep(std::vector<Entry>& entries, Forgotten& forgotten, Stays stays) {
    for (const Entry& entry : entries) {
        if (!stays(entry.name.value)) forgotten.add(entry);
    }
    std::erase_if(entries, [&](const Entry& entry) { return !stays(entry.name.value); });
}

}  // namespace

void JoinedNames::join_vertex(const std::string& inside, const std::string& outside) {
    join(vertices_, inside, outside);
}

void JoinedNames::join_edge(const std::string& inside, const JoinedEdge& outside) {
    if (inside != outside.name) edges_[inside] = outside;
}

void JoinedNames::join_face(const std::string& inside, const std::string& outside) {
    join(faces_, inside, outside);
}

std::string JoinedNames::vertex(const std::string& name) const {
    return last_of(vertices_, name);
}

JoinedEdge JoinedNames::edge(const std::string& name) const {
    JoinedEdge edge{name, false};
    for (auto next = edges_.find(name); next != edges_.end(); next = edges_.find(edge.name)) {
        edge = {next->second.name, edge.reversed != next->second.reversed};
    }
    return edge;
}

std::string JoinedNames::face(const std::string& name) const {
    return last_of(faces_, name);
}

std::vector<JoinedPart> settled(const JoinedNames& joined, const std::vector<JoinedPart>& parts) {
    std::vector<JoinedPart> known;
    std::set<std::pair<std::string, std::string>> seen;
    for (JoinedPart part : parts) {
        const JoinedEdge edge = joined.edge(part.name);
        part.outside = part.kind == "vertex" ? joined.vertex(part.name)
                       : part.kind == "edge" ? edge.name
                                             : joined.face(part.name);
        part.reversed = part.kind == "edge" && edge.reversed;
        if (part.outside == part.name || !seen.emplace(part.kind, part.name).second) continue;
        known.push_back(std::move(part));
    }
    return known;
}

void rename_joined(Case& c, const JoinedNames& joined) {
    Forgotten forgotten;
    keep(c.vertices, forgotten, [&](const std::string& n) { return joined.vertex(n) == n; });
    keep(c.edges, forgotten, [&](const std::string& n) { return joined.edge(n).name == n; });
    keep(c.faces, forgotten, [&](const std::string& n) { return joined.face(n) == n; });
    for (CurveEntry& curve : c.curves) {
        curve.used_by_curve |= forgotten.curves.contains(curve.name.value);
    }
    for (SurfaceEntry& surface : c.surfaces) {
        surface.used_by_surface |= forgotten.surfaces.contains(surface.name.value);
    }
    for (EdgeEntry& edge : c.edges) rename(joined, edge);
    for (FaceEntry& face : c.faces) rename(joined, face);
    for (BlockEntry& block : c.blocks) rename(joined, block);
    for (BoundaryEntry& boundary : c.boundaries) rename(joined, boundary.sides);
    for (PeriodicEntry& periodic : c.periodic) {
        rename(joined, periodic.from);
        rename(joined, periodic.to);
    }
}

SpacingEntry reversed_law(const SpacingEntry& law) {
    SpacingEntry other = law;
    if (auto* tanh = std::get_if<TanhLaw>(&other)) std::swap(tanh->start, tanh->end);
    if (auto* geometric = std::get_if<GeometricLaw>(&other)) {
        std::swap(geometric->start, geometric->end);
        if (geometric->ratio) geometric->ratio = 1 / *geometric->ratio;
    }
    if (auto* places = std::get_if<ExplicitLaw>(&other)) {
        std::reverse(places->values.begin(), places->values.end());
        for (double& value : places->values) value = 1 - value;
        if (places->formula) {
            places->formula = [forwards = places->formula](double t) {
                return 1 - forwards(1 - t);
            };
        }
    }
    if (auto* like = std::get_if<LikeLaw>(&other)) {
        like->edge.reversed = !like->edge.reversed;
        like->edge.sign_given = true;
    }
    return other;
}

}  // namespace hexweave
