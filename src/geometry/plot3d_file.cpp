// SPDX-License-Identifier: Apache-2.0
#include "geometry/plot3d_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/fortran_number.h"

namespace hexweave {

namespace {

constexpr std::string_view blanks = " \t\r\n,";
constexpr int most_points = 10'000'000;

std::optional<double> number_of(std::string_view word) {
    const auto number = fortran_number(word);
    return number && !number->out_of_range ? std::optional(number->value) : std::nullopt;
}

int words_of_line(std::string_view text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    int words = 0;
    bool inside = false;
    for (const char c : line) {
        const bool blank = blanks.find(c) != std::string_view::npos;
        words += !blank && !inside ? 1 : 0;
        inside = !blank;
    }
    return words;
}

/// The numbers of a text, one after the other. What is wrong first ends them.
class Numbers {
public:
    explicit Numbers(std::string_view text) : text_(text) { skip_blanks(); }

    bool at_end() const { return failed() || (repeats_ == 0 && text_.empty()); }
    bool failed() const { return !error_.empty(); }
    const std::string& error() const { return error_; }
    int error_line() const { return error_line_; }
    int line() const { return line_; }
    int words_on_line() const { return words_of_line(text_); }

    void fail(std::string error, int line) {
        if (failed()) return;
        error_ = std::move(error);
        error_line_ = line;
    }

    /// 0 after a fault. Precondition: not at the end.
    double next() {
        if (repeats_ > 0) {
            --repeats_;
            return value_;
        }
        const std::string_view word = text_.substr(0, text_.find_first_of(blanks));
        const std::size_t star = word.find('*');
        if (star != std::string_view::npos) {
            const double times = number_of(word.substr(0, star)).value_or(0);
            const bool count = times >= 1 && times <= most_points && times == std::floor(times);
            repeats_ = count ? static_cast<int>(times) - 1 : 0;
            if (!count) fail_at(word);
        }
        const auto value = number_of(star == std::string_view::npos ? word : word.substr(star + 1));
        if (!value) fail_at(word);
        if (value && !std::isfinite(*value)) fail("a number is not finite", line_);
        if (failed()) return 0;
        value_ = *value;
        text_.remove_prefix(word.size());
        skip_blanks();
        return value_;
    }

    /// A count from 1 on; 1 after a fault.
    int next_count() {
        const int line = line_;
        if (at_end()) fail("the file ends before its counts", 0);
        const double value = failed() ? 0 : next();
        if (value >= 1 && value <= most_points && value == std::floor(value)) {
            return static_cast<int>(value);
        }
        fail("a count must be a whole number from 1 to " + std::to_string(most_points), line);
        return 1;
    }

private:
    void fail_at(std::string_view word) {
        constexpr std::size_t longest = 30;
        const bool plain =
            std::all_of(word.begin(), word.end(), [](char c) { return c > ' ' && c <= '~'; });
        fail((plain ? "'" + std::string(word.substr(0, longest)) + "'" : "this") +
                 " is not a number",
             line_);
    }

    void skip_blanks() {
        while (!text_.empty() && blanks.find(text_.front()) != std::string_view::npos) {
            if (text_.front() == '\n') ++line_;
            text_.remove_prefix(1);
        }
    }

    std::string_view text_;
    int line_ = 1;
    int repeats_ = 0;
    double value_ = 0;
    std::string error_;
    int error_line_ = 0;
};

using Counts = std::array<int, 3>;

/// The points of a block; what is more than most_points is not told apart.
std::size_t points_of(const Counts& counts) {
    std::size_t points = 1;
    for (const int count : counts) {
        points = std::min(points * static_cast<std::size_t>(count), std::size_t{most_points} + 1);
    }
    return points;
}

Counts read_counts(Numbers& numbers, bool of_surface) {
    const int line = numbers.line();
    Counts counts{};
    for (int& count : counts) count = numbers.next_count();
    if (of_surface && std::count(counts.begin(), counts.end(), 1) != 1) {
        numbers.fail("one of the three counts must be 1 for a surface, not " +
                         std::to_string(counts[0]) + " " + std::to_string(counts[1]) + " " +
                         std::to_string(counts[2]),
                     line);
    }
    return counts;
}

/// The blocks of a file, and the one that is asked for.
struct Blocks {
    std::vector<Counts> counts;
    std::size_t chosen = 0;
};

/// The head of a file, no block after a fault. Counts that do not make the chosen block a surface
/// are one.
Blocks read_head(Numbers& numbers, std::optional<int> block) {
    const int line = numbers.line();
    const int count = numbers.words_on_line() == 1 ? numbers.next_count() : 1;
    if (!block && count > 1) {
        numbers.fail(
            "the file holds " + std::to_string(count) + " blocks: say with 'block' which one",
            line);
    } else if (block && *block > count) {
        numbers.fail("there is no block " + std::to_string(*block) + ": the file holds " +
                         std::to_string(count),
                     line);
    }
    Blocks blocks;
    blocks.chosen = static_cast<std::size_t>(block.value_or(1)) - 1;
    std::size_t points = 0;
    for (int b = 0; b < count && !numbers.failed(); ++b) {
        blocks.counts.push_back(read_counts(numbers, blocks.counts.size() == blocks.chosen));
        points += points_of(blocks.counts.back());
        if (points > most_points) numbers.fail("there are too many points", 0);
    }
    return numbers.failed() ? Blocks() : blocks;
}

/// All coordinates of a file of so many points; none are missing and none are left over but after a
/// fault.
std::vector<double> read_coordinates(Numbers& numbers, std::size_t points) {
    std::vector<double> values;
    while (!numbers.at_end() && values.size() <= 3 * points) values.push_back(numbers.next());
    if (values.size() < 3 * points) {
        numbers.fail("there are " + std::to_string(values.size()) + " coordinates, not 3 times " +
                         std::to_string(points),
                     numbers.line());
    } else if (values.size() > 3 * points) {
        numbers.fail("more stands behind the " + std::to_string(3 * points) + " coordinates",
                     numbers.line());
    }
    return values;
}

/// Without points after a fault.
ControlMesh read_mesh(Numbers& numbers, std::optional<int> block) {
    const Blocks blocks = read_head(numbers, block);
    std::size_t all = 0;
    std::size_t before = 0;
    for (std::size_t b = 0; b < blocks.counts.size(); ++b) {
        if (b < blocks.chosen) before += points_of(blocks.counts[b]);
        all += points_of(blocks.counts[b]);
    }
    const std::vector<double> values = read_coordinates(numbers, all);
    if (numbers.failed()) return {};
    const Counts& counts = blocks.counts[blocks.chosen];
    ControlMesh mesh{
        counts[0] == 1 ? counts[1] : counts[0], counts[2] == 1 ? counts[1] : counts[2], {}};
    const std::size_t points = points_of(counts);
    const double* const x = values.data() + 3 * before;
    mesh.points.reserve(points);
    for (std::size_t n = 0; n < points; ++n) {
        mesh.points.push_back({x[n], x[n + points], x[n + 2 * points]});
    }
    return mesh;
}

}  // namespace

Plot3dSurface read_plot3d_surface(std::string_view text, std::optional<int> block) {
    Numbers numbers(text);
    Plot3dSurface surface;
    surface.mesh = read_mesh(numbers, block);
    surface.error = numbers.error();
    surface.line = numbers.error_line();
    return surface;
}

}  // namespace hexweave
