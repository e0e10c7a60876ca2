// SPDX-License-Identifier: Apache-2.0
#include "topology/block_orientation.h"

#include <algorithm>
#include <cstddef>

namespace hexweave {

namespace {

constexpr std::size_t most_solutions = 16;

/// For every side the ways in which its faces fit together.
using Choices = std::array<std::vector<SideArrangement>, 6>;

Choices choices_of(const FacesOfBlock& faces) {
    Choices choices;
    for (std::size_t side = 0; side < 6; ++side) choices[side] = side_arrangements(faces[side]);
    return choices;
}

/// Where the edge that `side` shares with the adjacent side `neighbour` stands in the frame of
/// `side`.
std::size_t shared_position(Side side, Side neighbour) {
    const std::size_t own = tangential_axes(side)[0] == axis_of(neighbour) ? 0 : 1;
    return 2 * own + (is_max(neighbour) ? 1 : 0);
}

/// Whether two frames agree on the edge that adjacent sides share: both run along the block's third
/// axis.
bool agree(Side a, const FrameSides& frame_a, Side b, const FrameSides& frame_b) {
    return frame_a[shared_position(a, b)] == frame_b[shared_position(b, a)];
}

class Search {
public:
    explicit Search(const FacesOfBlock& faces) : choices_(choices_of(faces)) {}

    std::vector<BlockArrangement> solutions() {
        extend(0);
        return std::move(solutions_);
    }

private:
    const SideArrangement& chosen(std::size_t side) const { return choices_[side][chosen_[side]]; }

    void extend(std::size_t side) {
        if (solutions_.size() >= most_solutions) return;
        if (side == 6) {
            BlockArrangement solution;
            for (std::size_t s = 0; s < 6; ++s) solution[s] = chosen(s);
            solutions_.push_back(std::move(solution));
            return;
        }
        for (std::size_t n = 0; n < choices_[side].size(); ++n) {
            chosen_[side] = n;
            if (fits(side)) extend(side + 1);
        }
    }

    bool fits(std::size_t side) const {
        for (std::size_t other = 0; other < side; ++other) {
            const Side a = all_sides[side];
            const Side b = all_sides[other];
            if (axis_of(a) == axis_of(b)) continue;
            if (!agree(a, chosen(side).frame, b, chosen(other).frame)) return false;
        }
        return true;
    }

    Choices choices_;
    std::array<std::size_t, 6> chosen_{};
    std::vector<BlockArrangement> solutions_;
};

bool can_agree(Side a, const std::vector<SideArrangement>& of_a, Side b,
               const std::vector<SideArrangement>& of_b) {
    return std::any_of(of_a.begin(), of_a.end(), [&](const SideArrangement& own) {
        return std::any_of(of_b.begin(), of_b.end(), [&](const SideArrangement& other) {
            return agree(a, own.frame, b, other.frame);
        });
    });
}

}  // namespace

std::vector<BlockArrangement> block_arrangements(const FacesOfBlock& faces) {
    return Search(faces).solutions();
}

std::vector<std::pair<Side, Side>> strangers(const FacesOfBlock& faces) {
    const Choices choices = choices_of(faces);
    std::vector<std::pair<Side, Side>> pairs;
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = a + 1; b < 6; ++b) {
            if (a / 2 != b / 2 && !can_agree(all_sides[a], choices[a], all_sides[b], choices[b])) {
                pairs.emplace_back(all_sides[a], all_sides[b]);
            }
        }
    }
    return pairs;
}

std::vector<ChainPair> chains_between(const FacesOfBlock& faces, Side a, Side b) {
    std::vector<ChainPair> pairs;
    const auto of_b = side_arrangements(faces[static_cast<std::size_t>(b)]);
    for (const SideArrangement& own : side_arrangements(faces[static_cast<std::size_t>(a)])) {
        for (const SideArrangement& other : of_b) {
            ChainPair pair{own.frame[shared_position(a, b)], other.frame[shared_position(b, a)]};
            if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) {
                pairs.push_back(std::move(pair));
            }
        }
    }
    return pairs;
}

std::vector<Orientation> matching_orientations(const FrameSides& face, const FrameSides& asked) {
    std::vector<Orientation> matching;
    for (const Orientation& o : face_orientations()) {
        if (sides_in_frame(face, o) == asked) matching.push_back(o);
    }
    return matching;
}

}  // namespace hexweave
