// SPDX-License-Identifier: Apache-2.0
// Files that were damaged at random, the same every time: each is read, or refused with one
// message.
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/errors.h"
#include "io/cgns_samples.h"
#include "io/grid_file.h"
#include "io/neutral_map.h"
#include "io/plot3d.h"
#include "io/scratch.h"
#include "quality/grid_quality.h"

using namespace hexweave;

namespace {

/// A linear congruential generator: its numbers are the same on every machine.
class Draw {
public:
    explicit Draw(std::uint32_t seed) : state_(seed) {}
    std::size_t below(std::size_t limit) {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<std::size_t>(state_ >> 8U) % limit;
    }

private:
    std::uint32_t state_;
};

/// Cut off, or some of its bytes changed, taken out or doubled.
std::string damaged(std::string text, Draw& draw) {
    if (draw.below(5) == 0) return text.substr(0, draw.below(text.size()));
    for (std::size_t left = 1 + draw.below(4); left > 0; --left) {
        const std::size_t place = draw.below(text.size());
        switch (draw.below(3)) {
            case 0:
                text[place] = static_cast<char>(draw.below(256));
                break;
            case 1:
                text.erase(place, 1 + draw.below(3));
                break;
            default:
                text.insert(place, text, place, 1 + draw.below(3));
                break;
        }
    }
    return text;
}

/// Reads and judges the grid: whether it was refused, with one message that names `named`.
bool is_refused(const std::filesystem::path& path, const std::string& named) {
    try {
        MultiblockGrid grid = read_grid(path);
        name_sides_where_nothing_is_named(grid);
        measure_quality(grid);
        return false;
    } catch (const UsageError& error) {
        const std::string message = error.what();
        INFO(message);
        CHECK(message.find('\n') == std::string::npos);
        CHECK(message.find(named) != std::string::npos);
        return true;
    }
}

}  // namespace

TEST_CASE("Damaged Plot3D files of every form are read or refused, never more") {
    const Scratch scratch;
    for (const Plot3dForm form : {Plot3dForm::text, Plot3dForm::unformatted, Plot3dForm::stream}) {
        write_plot3d(joined_pair(3, 3, rotations(3)[5]), scratch.path("whole.xyz"), form,
                     ByteOrder::little);
        const std::string whole = contents(scratch.path("whole.xyz"));
        Draw draw(7);
        int refused = 0;
        for (int attempt = 0; attempt < 200; ++attempt) {
            INFO(attempt);
            put(scratch.path("damaged.xyz"), damaged(whole, draw));
            if (is_refused(scratch.path("damaged.xyz"), "damaged.xyz")) ++refused;
        }
        CHECK(refused > 50);
    }
}

TEST_CASE("Damaged neutral maps are read or refused, never more") {
    const Scratch scratch;
    const MultiblockGrid grid = joined_pair(3, 3, rotations(3)[5]);
    write_plot3d(grid, scratch.path("grid.xyz"), Plot3dForm::unformatted, ByteOrder::little);
    write_neutral_map(grid, scratch.path("grid.nmf"));
    const std::string whole = contents(scratch.path("grid.nmf"));
    Draw draw(11);
    int refused = 0;
    for (int attempt = 0; attempt < 300; ++attempt) {
        INFO(attempt);
        put(scratch.path("grid.nmf"), damaged(whole, draw));
        if (is_refused(scratch.path("grid.xyz"), "grid.nmf")) ++refused;
    }
    CHECK(refused > 50);
}
