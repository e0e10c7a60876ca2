// SPDX-License-Identifier: Apache-2.0
#include "topology/side_arrangement.h"

#include <algorithm>
#include <array>

namespace hexweave {

namespace {

constexpr std::size_t most_arrangements = 64;

/// Places the faces one after the other, each beside those to its left and below.
class Placing {
public:
    Placing(const SideFaces& side, int columns)
        : side_(side), columns_(columns), chosen_(side.faces.size()) {
        for (const FrameSides& face : side.faces) {
            auto& frames = frames_.emplace_back();
            for (std::size_t o = 0; o < 8; ++o) {
                frames[o] = sides_in_frame(face, face_orientations()[o]);
            }
        }
        place(0);
    }

    std::vector<SideArrangement> arrangements() { return std::move(arrangements_); }
    std::size_t most_placed() const { return most_placed_; }

private:
    const FrameSides& frame(std::size_t face) const { return frames_[face][chosen_[face]]; }

    bool fits(std::size_t face) const {
        const auto columns = static_cast<std::size_t>(columns_);
        const bool beside = face % columns == 0 || frame(face)[0] == frame(face - 1)[1];
        return beside && (face < columns || frame(face)[2] == frame(face - columns)[3]);
    }

    /// Whether a collapsed face looks the same in an earlier orientation: it then is the same.
    bool repeats(std::size_t face, std::size_t orientation) const {
        const auto& frames = frames_[face];
        const auto* const own = frames.begin() + orientation;
        return std::find(frames.begin(), own, *own) != own;
    }

    void place(std::size_t face) {
        most_placed_ = std::max(most_placed_, face);
        if (arrangements_.size() >= most_arrangements) return;
        if (face == chosen_.size()) {
            enter();
            return;
        }
        for (std::size_t o = 0; o < 8; ++o) {
            const auto& required = side_.required[face];
            if (required && *required != face_orientations()[o]) continue;
            if (!required && side_.collapsed[face] && repeats(face, o)) continue;
            chosen_[face] = o;
            if (fits(face)) place(face + 1);
        }
    }

    void enter() {
        SideArrangement arrangement{columns_, {}, {}};
        std::vector<FrameSides> frames;
        for (std::size_t face = 0; face < chosen_.size(); ++face) {
            arrangement.orientations.push_back(face_orientations()[chosen_[face]]);
            frames.push_back(frame(face));
        }
        arrangement.frame = joined_frame(frames, columns_);
        arrangements_.push_back(std::move(arrangement));
    }

    const SideFaces& side_;
    int columns_;
    std::vector<std::array<FrameSides, 8>> frames_;
    std::vector<std::size_t> chosen_;
    std::size_t most_placed_ = 0;
    std::vector<SideArrangement> arrangements_;
};

/// The numbers of faces in a row that are to be tried.
std::vector<int> columns_to_try(const SideFaces& side) {
    if (!side.strip || side.faces.size() == 1) return {side.columns};
    return {static_cast<int>(side.faces.size()), 1};
}

}  // namespace

std::vector<SideArrangement> side_arrangements(const SideFaces& side) {
    std::vector<SideArrangement> all;
    for (const int columns : columns_to_try(side)) {
        for (SideArrangement& arrangement : Placing(side, columns).arrangements()) {
            all.push_back(std::move(arrangement));
        }
    }
    return all;
}

std::size_t fitting_faces(const SideFaces& side) {
    SideFaces free = side;
    std::fill(free.required.begin(), free.required.end(), std::nullopt);
    std::size_t most = 0;
    for (const int columns : columns_to_try(free)) {
        most = std::max(most, Placing(free, columns).most_placed());
    }
    return most;
}

bool share_a_side(const FrameSides& a, const FrameSides& b) {
    for (const auto& side_a : a) {
        for (const auto& side_b : b) {
            if (side_a == side_b || side_a == backwards(side_b)) return true;
        }
    }
    return false;
}

}  // namespace hexweave
