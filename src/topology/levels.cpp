// SPDX-License-Identifier: Apache-2.0
#include "topology/levels.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/every_nth.h"

namespace hexweave {

namespace {

std::size_t index_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    HEXWEAVE_ASSERT(found != names.end());
    return static_cast<std::size_t>(found - names.begin());
}

void scale(std::optional<double>& size, double by) {
    if (size) *size *= by;
}

/// Sizes of cells become `by` times as large.
struct ScaleLaw {
    double by;

    void operator()(UniformLaw&) const {}
    void operator()(TanhLaw& law) const {
        scale(law.start, by);
        scale(law.end, by);
        if (law.natural) law.natural->size *= by;
    }
    void operator()(GeometricLaw& law) const {
        scale(law.start, by);
        scale(law.end, by);
        if (law.ratio) *law.ratio = std::pow(*law.ratio, by);
    }
    void operator()(ExplicitLaw&) const {}
    void operator()(LikeLaw&) const {}
};

void scale_heights(HeightRequests& heights, double by) {
    for (auto& held : heights) {
        if (!held) continue;
        scale(held->height, by);
        held->growth = std::pow(held->growth, by);
    }
}

}  // namespace

bool GridFamily::nested() const {
    return factor == std::floor(factor);
}

double GridFamily::times_medium(std::size_t of) const {
    return std::pow(factor, static_cast<double>(of) - static_cast<double>(medium));
}

int GridFamily::stride(std::size_t to) const {
    HEXWEAVE_ASSERT(to == level || (nested() && to < level));
    return static_cast<int>(std::lround(std::pow(factor, static_cast<double>(level - to))));
}

std::optional<GridFamily> family_of(const Case& c) {
    if (!c.levels.place.file && c.level.value.empty()) return std::nullopt;
    GridFamily family{c.levels.factor, c.levels.names};
    family.medium = index_of(family.names, middle_level);
    family.wanted = c.level.value.empty() ? family.medium : index_of(family.names, c.level.value);
    family.level = family.nested() ? family.names.size() - 1 : family.wanted;
    return family;
}

Case scaled_to_level(const Case& c, const GridFamily& family) {
    Case scaled = c;
    const double by = 1 / family.times_medium(family.level);
    for (EdgeEntry& edge : scaled.edges) {
        if (edge.spacing) std::visit(ScaleLaw{by}, edge.spacing->value);
    }
    if (scaled.sweep && scaled.sweep->spacing) {
        std::visit(ScaleLaw{by}, scaled.sweep->spacing->value);
    }
    for (FaceEntry& face : scaled.faces) scale_heights(face.how.heights, by);
    for (BlockEntry& block : scaled.blocks) scale_heights(block.how.heights, by);
    return scaled;
}

void refine_heights(HeightRequests& heights, const GridFamily& family) {
    const double refinement = family.times_medium(family.level);
    for (auto& held : heights) {
        if (!held) continue;
        held->first = static_cast<int>(std::lround(refinement));
        held->growth = std::pow(held->growth, 1 / refinement);
    }
}

Topology at_level(const Topology& solved, std::size_t level) {
    Topology topology = solved;
    const int stride = solved.family->stride(level);
    topology.family->level = level;
    topology.provenance += "; level " + topology.family->names[level];
    for (Edge& edge : topology.edges) edge.cells /= stride;
    for (Face& face : topology.faces) {
        face.cells_i /= stride;
        face.cells_j /= stride;
    }
    for (Block& block : topology.blocks) {
        block.extent = every_nth(block.extent, stride);
        for (BlockSide& side : block.sides) {
            for (FaceUse& use : side.faces) {
                for (int& begin : use.begin) begin /= stride;
            }
        }
    }
    if (topology.sweep && !topology.sweep->single) {
        topology.sweep->cells /= stride;
        topology.sweep->stride = stride;
    }
    for (AdjustedCount& adjusted : topology.adjusted_counts) {
        adjusted.asked /= stride;
        adjusted.got /= stride;
    }
    return topology;
}

}  // namespace hexweave
