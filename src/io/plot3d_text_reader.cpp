// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include "core/fortran_number.h"
#include "core/memory.h"
#include "io/plot3d_source.h"

namespace hexweave {
namespace {

bool separates(char c) {
    return c == ' ' || c == '\n' || c == ',' || c == '\t' || c == '\r';
}

/// Adds what one word says: 1.5, or 3*1.5 for three of them; false when it says no number.
bool add_word(std::string_view word, std::size_t most, std::vector<double>& numbers) {
    std::size_t repeats = 1;
    if (const std::size_t star = word.find('*'); star != std::string_view::npos) {
        const auto [end, error] = std::from_chars(word.data(), word.data() + star, repeats);
        if (error != std::errc{} || end != word.data() + star) return false;
        word.remove_prefix(star + 1);
    }
    // Beyond what a double holds: zero or infinity, as a Fortran program would read it.
    const auto number = fortran_number(word);
    if (!number || repeats > most - std::min(most, numbers.size())) return false;
    numbers.insert(numbers.end(), repeats, number->value);
    return true;
}

std::optional<std::int32_t> whole(double value) {
    if (!(value >= 1 && value <= std::numeric_limits<std::int32_t>::max())) return std::nullopt;
    if (value != std::floor(value)) return std::nullopt;
    return static_cast<std::int32_t>(value);
}

/// The layout whose length is that of the text.
Plot3dLayout find_layout(const std::filesystem::path& path, const std::vector<double>& numbers) {
    const auto head = [&](const Plot3dLayout&, std::size_t place) -> std::optional<std::int32_t> {
        return place < numbers.size() ? whole(numbers[place]) : std::nullopt;
    };
    for (Plot3dLayout& layout : possible_heads(head, numbers.size())) {
        std::size_t length = layout.has_count ? 1 : 0;
        std::size_t nodes = 0;
        for (const Extent& extent : layout.extents) {
            length += static_cast<std::size_t>(layout.dimension) + layout.numbers(extent);
            nodes += extent.nodes();
        }
        layout.has_blanking = length + nodes == numbers.size();
        if (length == numbers.size() || layout.has_blanking) return layout;
    }
    fits_no_layout(path);
}

}  // namespace

std::vector<double> read_numbers(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    const std::size_t most = available_memory() / (2 * sizeof(double));
    std::vector<double> numbers;
    for (std::size_t at = 0; at < text.size();) {
        if (separates(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && !separates(text[end])) ++end;
        const std::string_view word = std::string_view(text).substr(at, end - at);
        if (!add_word(word, most, numbers)) {
            const auto line =
                std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
            constexpr std::size_t shown = 30;
            cannot_read(path, fmt::format("line {}: '{}' is no number of a Plot3D grid", line,
                                          word.substr(0, shown)));
        }
        at = end;
    }
    return numbers;
}

MultiblockGrid read_plot3d_text(const std::filesystem::path& path) {
    const std::vector<double> numbers = read_numbers(path);
    const Plot3dLayout layout = find_layout(path, numbers);
    MultiblockGrid grid = empty_grid(path, layout);
    std::size_t at = (layout.has_count ? 1 : 0) +
                     layout.extents.size() * static_cast<std::size_t>(layout.dimension);
    for (std::size_t block = 0; block < grid.zones.size(); ++block) {
        Zone& zone = grid.zones[block];
        zone.points = PointField(layout.extents[block]);
        const std::size_t nodes = zone.points.extent().nodes();
        for (Field* field : {&zone.points.x, &zone.points.y, &zone.points.z}) {
            if (field == &zone.points.z && layout.dimension == 2) continue;
            std::copy_n(numbers.data() + at, nodes, field->data());
            at += nodes;
        }
        if (!layout.has_blanking) continue;
        const double* blanking = numbers.data() + at;
        if (std::find(blanking, blanking + nodes, 0.0) != blanking + nodes) {
            has_holes(path, zone.name);
        }
        at += nodes;
    }
    return grid;
}

}  // namespace hexweave
