// SPDX-License-Identifier: Apache-2.0
// What is made of what, so that the two sides of periodic interfaces are exact images.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/periodic_image.h"
#include "topology/boundaries.h"
#include "topology/periodic.h"
#include "topology/periodic_links.h"
#include "topology/periodic_match.h"
#include "topology/text.h"

namespace hexweave {

namespace {

Vertex& vertex(Network& network, int index) {
    return network.topology.vertices[static_cast<std::size_t>(index)];
}

/// The edges that interfaces link.
std::vector<PeriodicLink> edge_links(const Network& network) {
    std::vector<PeriodicLink> links;
    const std::vector<PeriodicInterface>& interfaces = network.topology.periodic;
    for (std::size_t n = 0; n < interfaces.size(); ++n) {
        for (const PeriodicPair& pair : interfaces[n].pairs) {
            for (const EdgeMatch& match : matched_edges(network.topology, pair)) {
                links.push_back({match.from, match.to, match.reversed, static_cast<int>(n)});
            }
        }
    }
    return links;
}

/// The vertices that they link.
std::vector<PeriodicLink> vertex_links(const Network& network) {
    std::vector<PeriodicLink> links;
    for (const PeriodicLink& link : edge_links(network)) {
        const Edge& from = network.edge(link.from);
        const Edge& to = network.edge(link.to);
        links.push_back({from.start, link.reversed ? to.end : to.start, false, link.interface});
        links.push_back({from.end, link.reversed ? to.start : to.end, false, link.interface});
    }
    return links;
}

/// What an image takes from what it is the image of, where its entry asks for it.
std::string asked_of_image(const FaceEntry& entry) {
    if (!entry.surfaces.empty()) return "a surface";
    const auto asked = [](bool side) { return side; };
    if (std::any_of(entry.orthogonal.begin(), entry.orthogonal.end(), asked))
        return "orthogonality";
    const auto& heights = entry.how.heights;
    if (std::any_of(heights.begin(), heights.end(), [](const auto& h) { return h.has_value(); })) {
        return "heights";
    }
    const bool made =
        entry.how.method != Method::elliptic || entry.how.tolerance || entry.how.flat_edge_exponent;
    return made ? "a way of being made" : "";
}

void make_face_image(Network& network, const PeriodicPair& pair, int interface,
                     Diagnostics& diagnostics) {
    const auto n = static_cast<std::size_t>(pair.to);
    Face& face = network.topology.faces[n];
    face.image = ImageOf{pair.from, pair.orientation, interface};
    if (network.face_entries[n] == nullptr) return;
    const std::string asked = asked_of_image(*network.face_entries[n]);
    if (asked.empty()) return;
    const std::string of = quoted(network.face(pair.from).name);
    diagnostics.error(face.place,
                      fmt::format("face {} is the periodic image of face {} and has not {} of its "
                                  "own",
                                  quoted(face.name), of, asked),
                      fmt::format("ask it of face {}", of));
}

/// Moves a vertex that is its own image exactly onto the axis.
void move_onto_axis(Vertex& vertex, const Periodicity& periodicity) {
    const Vec3& angle = periodicity.angle;
    if (angle.x == 0) vertex.position.x = periodicity.center.x;
    if (angle.y == 0) vertex.position.y = periodicity.center.y;
    if (angle.z == 0) vertex.position.z = periodicity.center.z;
}

class VertexImages {
public:
    explicit VertexImages(Network& network)
        : network_(network),
          links_(vertex_links(network)),
          steps_(periodic_steps(links_, network.topology.vertices.size())) {}

    void settle() {
        for (const PeriodicLink& link : links_) {
            if (link.from == link.to) {
                move_onto_axis(vertex(network_, link.to), periodicity(link.interface));
            }
        }
        std::vector<bool> done(steps_.size());
        for (std::size_t v = 0; v < steps_.size(); ++v) settle(static_cast<int>(v), done);
    }

    /// Vertices that two ways lead to.
    void check(Diagnostics& diagnostics) {
        for (const PeriodicLink& link : links_) {
            const PeriodicMap map = periodic_map(periodicity(link.interface));
            const Vertex& from = vertex(network_, link.from);
            const Vertex& to = vertex(network_, link.to);
            const double off = distance(image(map, from.position), to.position);
            if (off <= image_rounding(map, from.position)) continue;
            const std::string name =
                network_.topology.periodic[static_cast<std::size_t>(link.interface)].name;
            diagnostics.error(
                to.place,
                fmt::format("vertex {} is not exactly the image of {} by {}: it is {} away, as an "
                            "image by another way",
                            quoted(to.name), quoted(from.name), quoted(name), number_text(off)),
                "interfaces that meet must agree to round-off: write their maps with the same "
                "parameters");
        }
    }

private:
    const Periodicity& periodicity(int interface) const {
        return network_.topology.periodic[static_cast<std::size_t>(interface)].periodicity;
    }

    void settle(int index, std::vector<bool>& done) {
        const auto v = static_cast<std::size_t>(index);
        if (done[v]) return;
        done[v] = true;
        if (!steps_[v]) return;
        settle(steps_[v]->of, done);
        const Periodicity& forth = periodicity(steps_[v]->interface);
        const PeriodicMap map = periodic_map(steps_[v]->back ? backwards(forth) : forth);
        vertex(network_, index).position = image(map, vertex(network_, steps_[v]->of).position);
    }

    Network& network_;
    std::vector<PeriodicLink> links_;
    std::vector<std::optional<PeriodicStep>> steps_;
};

}  // namespace

void make_images(Network& network, Diagnostics& diagnostics) {
    Topology& topology = network.topology;
    const auto steps = periodic_steps(edge_links(network), topology.edges.size());
    for (std::size_t e = 0; e < steps.size(); ++e) {
        if (!steps[e]) continue;
        const int along = steps[e]->reversed ? -1 : 1;
        topology.edges[e].image =
            ImageOf{steps[e]->of, Orientation{{along, 2, 3}}, steps[e]->interface, steps[e]->back};
    }
    if (!network.three_dimensional) return;
    for (std::size_t n = 0; n < topology.periodic.size(); ++n) {
        for (const PeriodicPair& pair : topology.periodic[n].pairs) {
            make_face_image(network, pair, static_cast<int>(n), diagnostics);
        }
    }
}

void settle_images(Network& network, Diagnostics& diagnostics) {
    if (network.topology.periodic.empty()) return;
    VertexImages images(network);
    images.settle();
    put_vertices_onto_planes(network);
    straighten(network);
    images.check(diagnostics);
}

}  // namespace hexweave
