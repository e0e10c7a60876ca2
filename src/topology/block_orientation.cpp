// SPDX-License-Identifier: Apache-2.0
#include "topology/block_orientation.h"

#include <cstddef>

namespace hexweave {

namespace {

constexpr std::size_t most_solutions = 16;

/// For every face its sides as seen from the block in each of the eight orientations.
using Frames = std::array<std::array<FrameSides, 8>, 6>;

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
    explicit Search(const FacesOfBlock& faces) : faces_(faces) {
        for (std::size_t side = 0; side < 6; ++side) {
            for (std::size_t o = 0; o < 8; ++o) {
                frames_[side][o] = sides_in_frame(faces.sides[side], face_orientations()[o]);
            }
        }
    }

    std::vector<BlockOrientations> solutions() {
        extend(0);
        return std::move(solutions_);
    }

private:
    void extend(std::size_t side) {
        if (solutions_.size() >= most_solutions) return;
        if (side == 6) {
            BlockOrientations solution;
            for (std::size_t s = 0; s < 6; ++s) solution[s] = face_orientations()[chosen_[s]];
            solutions_.push_back(solution);
            return;
        }
        for (std::size_t o = 0; o < 8; ++o) {
            const auto& required = faces_.required[side];
            if (required && *required != face_orientations()[o]) continue;
            chosen_[side] = o;
            if (fits(side)) extend(side + 1);
        }
    }

    bool fits(std::size_t side) const {
        for (std::size_t other = 0; other < side; ++other) {
            const Side a = all_sides[side];
            const Side b = all_sides[other];
            if (axis_of(a) == axis_of(b)) continue;
            if (!agree(a, frames_[side][chosen_[side]], b, frames_[other][chosen_[other]])) {
                return false;
            }
        }
        return true;
    }

    const FacesOfBlock& faces_;
    Frames frames_;
    std::array<std::size_t, 6> chosen_{};
    std::vector<BlockOrientations> solutions_;
};

bool share_a_side(const FrameSides& a, const FrameSides& b) {
    for (const auto& side_a : a) {
        for (const auto& side_b : b) {
            if (side_a == side_b || side_a == backwards(side_b)) return true;
        }
    }
    return false;
}

}  // namespace

std::vector<BlockOrientations> block_orientations(const FacesOfBlock& faces) {
    return Search(faces).solutions();
}

std::vector<std::pair<Side, Side>> strangers(const FacesOfBlock& faces) {
    std::vector<std::pair<Side, Side>> pairs;
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = a + 1; b < 6; ++b) {
            if (a / 2 != b / 2 && !share_a_side(faces.sides[a], faces.sides[b])) {
                pairs.emplace_back(all_sides[a], all_sides[b]);
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
