// SPDX-License-Identifier: Apache-2.0
#include "topology/directions.h"

#include <functional>

#include "core/assert.h"

namespace hexweave {

namespace {

constexpr std::size_t most_solutions = 16;

int end_of(const SideChain& chain, bool at_end) {
    return at_end ? chain.end : chain.start;
}

/// Visits every choice of a chain for each side until `visit` returns false.
void for_each_choice(const std::array<std::vector<SideChain>, 4>& sides,
                     const std::function<bool(const FaceLoop&)>& visit) {
    for (const SideChain& imin : sides[0]) {
        for (const SideChain& imax : sides[1]) {
            for (const SideChain& jmin : sides[2]) {
                for (const SideChain& jmax : sides[3]) {
                    if (!visit({imin, imax, jmin, jmax})) return;
                }
            }
        }
    }
}

}  // namespace

std::vector<SideChain> side_chains(const std::vector<EdgeOfSide>& side) {
    HEXWEAVE_ASSERT(!side.empty());
    std::vector<SideChain> chains;
    for (std::size_t n = 0; n < side.size(); ++n) {
        const EdgeOfSide& next = side[n];
        std::vector<SideChain> longer;
        for (const bool backwards : {false, true}) {
            if (next.reversed && *next.reversed != backwards) continue;
            const EdgeUse use{next.edge, backwards, next.pole};
            if (n == 0) {
                longer.push_back({next.first(backwards), next.last(backwards), {use}});
                continue;
            }
            for (SideChain chain : chains) {
                if (chain.end != next.first(backwards)) continue;
                chain.end = next.last(backwards);
                chain.uses.push_back(use);
                if (longer.size() < most_solutions) longer.push_back(std::move(chain));
            }
        }
        chains = std::move(longer);
    }
    return chains;
}

const std::array<FaceCorner, 4>& face_corners() {
    static constexpr std::array<FaceCorner, 4> corners{{{Side::jmin, false, Side::imin, false},
                                                        {Side::jmin, true, Side::imax, false},
                                                        {Side::jmax, true, Side::imax, true},
                                                        {Side::jmax, false, Side::imin, true}}};
    return corners;
}

std::vector<std::size_t> open_corners(const FaceLoop& loop) {
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < 4; ++n) {
        const FaceCorner& corner = face_corners()[n];
        const SideChain& i_side = loop[static_cast<std::size_t>(corner.along_i)];
        const SideChain& j_side = loop[static_cast<std::size_t>(corner.along_j)];
        if (end_of(i_side, corner.at_end_of_i_side) != end_of(j_side, corner.at_end_of_j_side)) {
            open.push_back(n);
        }
    }
    return open;
}

std::vector<FaceLoop> face_loops(const std::array<std::vector<SideChain>, 4>& sides) {
    std::vector<FaceLoop> loops;
    for_each_choice(sides, [&](const FaceLoop& loop) {
        if (open_corners(loop).empty()) loops.push_back(loop);
        return loops.size() < most_solutions;
    });
    return loops;
}

FaceLoop most_closed_loop(const std::array<std::vector<SideChain>, 4>& sides) {
    FaceLoop best;
    std::size_t fewest = 5;
    for_each_choice(sides, [&](const FaceLoop& loop) {
        const std::size_t open = open_corners(loop).size();
        if (open < fewest) {
            fewest = open;
            best = loop;
        }
        return true;
    });
    return best;
}

}  // namespace hexweave
