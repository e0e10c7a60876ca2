// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "io/neutral_map.h"
#include "io/neutral_map_faces.h"

namespace hexweave {
namespace {

/// CGNS types for the words that NASA's programs write; the beginning of a word counts.
constexpr std::array<std::pair<std::string_view, const char*>, 20> known_types{
    {{"VISCOUS", "BCWallViscous"},
     {"TANGENCY", "BCWallInviscid"},
     {"WALL", "BCWall"},
     {"SYM", "BCSymmetryPlane"},
     {"FAR", "BCFarfield"},
     {"RIEMANN", "BCFarfield"},
     {"FREESTREAM", "BCFarfield"},
     {"SUBSONIC_INFLOW", "BCInflowSubsonic"},
     {"SUBSONIC_OUTFLOW", "BCOutflowSubsonic"},
     {"SUPERSONIC_INFLOW", "BCInflowSupersonic"},
     {"SUPERSONIC_OUTFLOW", "BCOutflowSupersonic"},
     {"BACK_PRESSURE", "BCOutflowSubsonic"},
     {"EXTRAPOLATE", "BCExtrapolate"},
     {"INFLOW", "BCInflow"},
     {"OUTFLOW", "BCOutflow"},
     {"POLE", "BCDegenerateLine"},
     {"SINGULAR_AXIS", "BCDegenerateLine"},
     {"COLLAPSED", "BCDegenerateLine"},
     {"BLOCK_INTERFACE", "UserDefined"},
     {"UNPROCESSED", "UserDefined"}}};

/// One word of a line; what was quoted is a type even if it looks like a number.
using Words = std::vector<std::string>;

Words split(std::string_view line) {
    Words words;
    for (std::size_t at = 0; at < line.size();) {
        const char c = line[at];
        if (c == ' ' || c == '\t' || c == ',' || c == '\\' || c == '\r') {
            ++at;
            continue;
        }
        const bool quoted = c == '\'' || c == '"';
        const std::size_t begin = quoted ? at + 1 : at;
        const std::size_t end =
            quoted ? line.find(c, begin) : line.find_first_of(" \t,\\\r", begin);
        words.emplace_back(line.substr(begin, end == std::string_view::npos ? end : end - begin));
        if (end == std::string_view::npos) break;
        at = end + (quoted ? 1 : 0);
    }
    return words;
}

std::optional<int> whole(const std::string& word) {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// A face's range of nodes: `box` runs as it is written.
struct Range {
    int zone = 0;
    std::size_t face = 0;
    IndexBox box;
};

class MapReader {
public:
    MapReader(std::filesystem::path path, MultiblockGrid& grid)
        : path_(std::move(path)), grid_(grid), stream_(path_, std::ios::binary) {}

    void read() {
        read_sizes();
        while (const auto words = next_line()) read_entry(*words);
        if (stream_.bad()) fail("it cannot be read");
    }

private:
    [[noreturn]] void fail(const std::string& fact) const {
        throw UsageError(fmt::format("cannot read '{}', line {}: {}", path_.string(), line_, fact));
    }

    /// The words of the next line that holds some; comments of ours are taken in on the way.
    std::optional<Words> next_line() {
        for (std::string line; std::getline(stream_, line);) {
            ++line_;
            const std::size_t begin = line.find_first_not_of(" \t");
            if (begin != std::string::npos && line[begin] == '#') {
                read_comment(std::string_view(line).substr(begin));
                continue;
            }
            if (Words words = split(line); !words.empty()) return words;
        }
        return std::nullopt;
    }

    void read_comment(std::string_view line) {
        const std::string_view start(map_comment);
        if (!line.starts_with(start)) return;
        line.remove_prefix(start.size());
        if (line.ends_with('\r')) line.remove_suffix(1);
        const std::size_t space = line.find(' ');
        if (space == std::string_view::npos) return;
        const std::string_view key = line.substr(0, space);
        const std::string value(line.substr(space + 1));
        if (key == "title") grid_.title = value;
        if (key == "units") grid_.units = value;
        if (key == "provenance") grid_.provenance = value;
        if (key == "zone") zone_name_ = value;
        if (key == "name") entry_name_ = value;
        if (key == "type") entry_type_ = value;
        if (key == "periodic") read_periodicity(split(value));
        const std::size_t gap = value.find(' ');
        if (key == "family" && gap != std::string::npos) {
            grid_.families.push_back({value.substr(gap + 1), value.substr(0, gap)});
        }
    }

    void read_periodicity(const Words& words) {
        std::array<double, 9> values{};
        bool understood = words.size() == values.size();
        for (std::size_t n = 0; understood && n < values.size(); ++n) {
            const char* end = words[n].data() + words[n].size();
            const auto result = std::from_chars(words[n].data(), end, values[n]);
            understood = result.ec == std::errc{} && result.ptr == end;
        }
        if (!understood) fail("a periodicity is nine numbers: center, angles, translation");
        periodic_ = Periodicity{{values[0], values[1], values[2]},
                                {values[3], values[4], values[5]},
                                {values[6], values[7], values[8]}};
    }

    int integer(const Words& words, std::size_t place) const {
        const auto value = place < words.size() ? whole(words[place]) : std::nullopt;
        if (!value) {
            fail(place < words.size() ? fmt::format("'{}' is not a whole number", words[place])
                                      : "numbers are lacking");
        }
        return *value;
    }

    void read_sizes() {
        const auto count = next_line();
        if (!count) fail("it is empty");
        if (integer(*count, 0) != static_cast<int>(grid_.zones.size()) || count->size() != 1) {
            fail(fmt::format("it is the map of a grid of {} blocks, and there are {}",
                             fmt::join(*count, " "), grid_.zones.size()));
        }
        for (Zone& zone : grid_.zones) {
            const auto words = next_line();
            if (!words) fail("sizes of blocks are lacking");
            const Extent size{integer(*words, 1), integer(*words, 2), integer(*words, 3)};
            sizes_.push_back(size);
            if (!zone_name_.empty()) zone.name = std::exchange(zone_name_, {});
        }
        find_left_out_axis();
    }

    /// A surface may have the map of a grid one or two nodes thick in some direction.
    void find_left_out_axis() {
        for (const int axis : {-1, 0, 1, 2}) {
            left_out_ = axis;
            bool agrees = true;
            for (std::size_t zone = 0; zone < sizes_.size(); ++zone) {
                const Extent& extent = grid_.zones[zone].points.extent();
                if (axis < 0) {
                    agrees = agrees && sizes_[zone] == extent;
                    continue;
                }
                const Extent& size = sizes_[zone];
                const std::array<int, 2> rest{size[axis == 0 ? 1 : 0], size[axis == 2 ? 1 : 2]};
                agrees = agrees && size[axis] <= 2 && extent.nk == 1 &&
                         rest == std::array{extent.ni, extent.nj};
            }
            if (agrees) return;
        }
        fail("the sizes of the blocks are not those of the grid beside it");
    }

    Range read_range(const Words& words, std::size_t first) const {
        Range range;
        range.zone = integer(words, first) - 1;
        if (range.zone < 0 || range.zone >= static_cast<int>(sizes_.size())) {
            fail(fmt::format("there is no block {}", range.zone + 1));
        }
        const int number = integer(words, first + 1);
        if (number < 1 || number > static_cast<int>(map_faces.size())) {
            fail(fmt::format("there is no face {}", number));
        }
        range.face = static_cast<std::size_t>(number) - 1;
        const MapFace& face = map_faces[range.face];
        const auto normal = static_cast<std::size_t>(axis_of(face.side));
        const Extent& size = sizes_[static_cast<std::size_t>(range.zone)];
        const int place = is_max(face.side) ? size[axis_of(face.side)] - 1 : 0;
        range.box.begin[normal] = place;
        range.box.end[normal] = place;
        range.box.begin[face.primary] = integer(words, first + 2) - 1;
        range.box.end[face.primary] = integer(words, first + 3) - 1;
        range.box.begin[face.secondary] = integer(words, first + 4) - 1;
        range.box.end[face.secondary] = integer(words, first + 5) - 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int index : {range.box.begin[axis], range.box.end[axis]}) {
                if (index < 0 || index >= size[static_cast<int>(axis)]) {
                    fail(fmt::format("node {} lies outside block {}", index + 1, range.zone + 1));
                }
            }
        }
        return range;
    }

    void read_entry(const Words& words) {
        constexpr std::size_t range_words = 6;
        const std::string word = map_word(words[0]);
        const Range range = read_range(words, 1);
        const std::string name = std::exchange(entry_name_, {});
        const std::string type = std::exchange(entry_type_, {});
        if (word == "PATCHED") fail("interfaces that are not one-to-one are not read");
        const bool joins_periodic = word == periodic_word && words.size() > 1 + range_words;
        if (joins_periodic && !periodic_) fail("what carries one side onto the other is not said");
        if (word != "ONE_TO_ONE" && !joins_periodic) {
            if (words.size() > 1 + range_words) fail("a boundary has six numbers");
            add_patch(words[0], name, type, range);
            return;
        }
        const std::string swap =
            words.size() == 2 + 2 * range_words ? map_word(words.back()) : std::string();
        const bool swaps = swap == "TRUE" || swap == ".TRUE." || swap == "T";
        if (!swaps && swap != "FALSE" && swap != ".FALSE." && swap != "F") {
            fail("a one-to-one interface has twelve numbers, then TRUE or FALSE");
        }
        add_interface(name, range, read_range(words, 1 + range_words), swaps);
        if (joins_periodic) grid_.interfaces.back().periodic = std::exchange(periodic_, {});
    }

    /// Axis n of the map as an axis of the grid.
    std::size_t kept(std::size_t axis) const {
        return left_out_ >= 0 && static_cast<int>(axis) > left_out_ ? axis - 1 : axis;
    }

    IndexBox without_left_out(const IndexBox& box) const {
        if (left_out_ < 0) return box;
        IndexBox flat;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (static_cast<int>(axis) == left_out_) continue;
            flat.begin[kept(axis)] = box.begin[axis];
            flat.end[kept(axis)] = box.end[axis];
        }
        return flat;
    }

    bool is_left_out(const Range& range) const {
        const int normal = axis_of(map_faces[range.face].side);
        return left_out_ >= 0 ? normal == left_out_ : normal >= grid_.cell_dimension;
    }

    void add_patch(const std::string& family, const std::string& name, const std::string& type,
                   const Range& range) {
        if (is_left_out(range)) return;
        IndexBox box = without_left_out(range.box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (box.begin[axis] > box.end[axis]) std::swap(box.begin[axis], box.end[axis]);
        }
        const auto place = std::find_if(grid_.families.begin(), grid_.families.end(),
                                        [&](const Family& known) { return known.name == family; });
        const int index = static_cast<int>(place - grid_.families.begin());
        if (place == grid_.families.end()) grid_.families.push_back({family, type_of(family)});
        grid_.patches.push_back({name.empty() ? family : name, range.zone, box, index, type});
    }

    static std::string type_of(const std::string& family) {
        const std::string word = map_word(family);
        for (const auto& [start, type] : known_types) {
            if (word.starts_with(start)) return type;
        }
        return "UserDefined";
    }

    void add_interface(const std::string& name, const Range& own, const Range& other, bool swaps) {
        if (is_left_out(own) || is_left_out(other)) fail("it joins sides of another grid");
        const MapFace& from = map_faces[own.face];
        const MapFace& to = map_faces[other.face];
        std::array<int, 3> axes{};
        const auto join = [&](std::size_t axis, std::size_t across) {
            const int nodes = own.box.end[axis] - own.box.begin[axis];
            const int others = other.box.end[across] - other.box.begin[across];
            if (std::abs(nodes) != std::abs(others)) {
                fail("the two sides of the interface have different numbers of nodes");
            }
            const int way = (nodes < 0) == (others < 0) ? 1 : -1;
            axes[axis] = way * (static_cast<int>(across) + 1);
        };
        join(from.primary, swaps ? to.secondary : to.primary);
        join(from.secondary, swaps ? to.primary : to.secondary);
        const int through = is_max(from.side) == is_max(to.side) ? -1 : 1;
        axes[static_cast<std::size_t>(axis_of(from.side))] = through * (axis_of(to.side) + 1);
        const Orientation orientation{without_left_out_axis(axes)};
        if (grid_.cell_dimension == 2 && orientation.axes[2] != 3) {
            fail("the interface does not join edges of a planar grid; is Swap right?");
        }
        grid_.interfaces.push_back(
            forwards({name.empty() ? fmt::format("interface{}", grid_.interfaces.size() + 1) : name,
                      own.zone, without_left_out(own.box), other.zone, without_left_out(other.box),
                      orientation, std::nullopt}));
    }

    std::array<int, 3> without_left_out_axis(const std::array<int, 3>& axes) const {
        if (left_out_ < 0) return axes;
        std::array<int, 3> flat{1, 2, 3};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (static_cast<int>(axis) == left_out_) continue;
            const int across = axes[axis];
            const auto other = static_cast<std::size_t>(std::abs(across) - 1);
            if (static_cast<int>(other) == left_out_) {
                fail("the interface joins a grid line with the direction that is left out");
            }
            flat[kept(axis)] = (across > 0 ? 1 : -1) * (static_cast<int>(kept(other)) + 1);
        }
        return flat;
    }

    std::filesystem::path path_;
    MultiblockGrid& grid_;
    std::ifstream stream_;
    int line_ = 0;
    std::vector<Extent> sizes_;
    int left_out_ = -1;  ///< the axis of the map that a planar grid does not have
    std::string zone_name_;
    std::string entry_name_;
    std::string entry_type_;
    std::optional<Periodicity> periodic_;
};

}  // namespace

void read_neutral_map(const std::filesystem::path& path, MultiblockGrid& grid) {
    MapReader(path, grid).read();
}

}  // namespace hexweave
