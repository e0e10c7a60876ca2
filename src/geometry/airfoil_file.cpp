// SPDX-License-Identifier: Apache-2.0
#include "geometry/airfoil_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

namespace hexweave {

namespace {

constexpr std::size_t fewest_points_of_a_section = 5;
constexpr std::size_t fewest_points_of_a_half = 3;

/// A point and the line it stands on.
struct FilePoint {
    Vec3 position;
    int line = 0;
};

struct Fault {
    std::string message;
    int line = 0;
};

using Points = std::vector<FilePoint>;

std::string of_line(int line) {
    return "line " + std::to_string(line);
}

/// The words of a line; blanks, tabs, commas and the carriage return separate.
std::vector<std::string> words_of(std::string_view line) {
    constexpr std::string_view separators = " \t\r\v\f,";
    std::vector<std::string> words;
    std::size_t at = line.find_first_not_of(separators);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
        words.emplace_back(line.substr(at, end - at));
        at = line.find_first_not_of(separators, end);
    }
    return words;
}

/// The number that a whole word is (also with Fortran's exponent, 1.0D-3), independent of locale.
std::optional<double> number_of(std::string word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.erase(0, 1);
    for (char& c : word) {
        if (c == 'd' || c == 'D') c = 'e';
    }
    double value = 0;
    const char* const last = word.data() + word.size();
    const auto [end, failure] = std::from_chars(word.data(), last, value);
    if (end != last) return std::nullopt;
    if (failure == std::errc::result_out_of_range) return HUGE_VAL;
    if (failure != std::errc{}) return std::nullopt;
    return value;
}

/// A line as numbers; `all` is false when a word is none.
struct NumberLine {
    int line = 0;
    std::vector<std::string> words;
    std::vector<double> numbers;
    bool all = true;
};

/// The lines that are not empty.
std::vector<NumberLine> lines_of(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) {
        text.remove_prefix(byte_order_mark.size());
    }
    std::vector<NumberLine> lines;
    int count = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        NumberLine line{++count, words_of(text.substr(0, end)), {}, true};
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.words.empty()) continue;
        for (const std::string& word : line.words) {
            const std::optional<double> number = number_of(word);
            if (number) line.numbers.push_back(*number);
            line.all = line.all && number.has_value();
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

/// A title: not a line of two numbers, nor one that was meant as such (it begins with a number that
/// has a decimal point), except the four numbers of an MSES file's box.
bool is_header(const NumberLine& line) {
    if (line.all && line.numbers.size() == 4) return true;
    if (line.all && line.numbers.size() == 2) return false;
    const bool begins_with_decimal =
        number_of(line.words.front()) && line.words.front().find('.') != std::string::npos;
    return !begins_with_decimal;
}

bool is_separator(const NumberLine& line) {
    return line.all && line.numbers.size() == 2 && line.numbers[0] == 999 && line.numbers[1] == 999;
}

/// The fault of a line of coordinates, if it has one.
std::optional<Fault> fault_of(const NumberLine& line) {
    if (is_separator(line)) {
        return Fault{"a separator (999 999): the file holds several sections, one is needed",
                     line.line};
    }
    if (!line.all && line.numbers.empty()) {
        return Fault{"text among the coordinates: '" + line.words.front() + "'", line.line};
    }
    for (const std::string& word : line.words) {
        if (!number_of(word)) return Fault{"not a number: '" + word + "'", line.line};
    }
    if (line.numbers.size() != 2) {
        const std::string found = line.numbers.size() == 1
                                      ? "1 number"
                                      : std::to_string(line.numbers.size()) + " numbers";
        return Fault{"expected two numbers, x and y, found " + found, line.line};
    }
    for (std::size_t k = 0; k < 2; ++k) {
        if (!std::isfinite(line.numbers[k])) {
            return Fault{"not a finite number: '" + line.words[k] + "'", line.line};
        }
    }
    return std::nullopt;
}

std::optional<Fault> read_points(std::string_view text, Points& points) {
    const std::vector<NumberLine> lines = lines_of(text);
    const auto first = std::find_if_not(lines.begin(), lines.end(), is_header);
    if (first == lines.end()) return Fault{"no line of two numbers: not an airfoil's coordinates"};
    for (auto line = first; line != lines.end(); ++line) {
        if (std::optional<Fault> fault = fault_of(*line)) return fault;
        points.push_back({{line->numbers[0], line->numbers[1], 0}, line->line});
    }
    return std::nullopt;
}

double x_of(const FilePoint& point) {
    return point.position.x;
}

/// Is the first line a Lednicer file's counts: whole numbers, far off the points behind it?
bool is_count_line(const Points& points) {
    const Vec3& first = points.front().position;
    const bool whole = first.x == std::floor(first.x) && first.y == std::floor(first.y);
    if (!whole || first.x < 2 || first.y < 2) return false;
    const auto count = static_cast<double>(points.size() - 1);
    if (first.x + first.y == count) return true;
    return std::all_of(points.begin() + 1, points.end(), [&](const FilePoint& p) {
        return std::abs(p.position.x) < 0.5 * first.x && std::abs(p.position.y) < 0.5 * first.y;
    });
}

/// Lednicer blocks, both from the leading edge, joined into one pass over the section.
Points join_blocks(const Points& points, std::size_t first_count) {
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(first_count);
    Points joined(points.begin(), middle);
    std::reverse(joined.begin(), joined.end());
    const bool shared_nose = joined.back().position == middle->position;
    joined.insert(joined.end(), middle + (shared_nose ? 1 : 0), points.end());
    return joined;
}

struct XRange {
    double least;
    double extent;
};

XRange x_range(const Points& points) {
    const auto by_x = [](const FilePoint& a, const FilePoint& b) { return x_of(a) < x_of(b); };
    const auto [least, most] = std::minmax_element(points.begin(), points.end(), by_x);
    return {x_of(*least), x_of(*most) - x_of(*least)};
}

bool begins_at_leading_edge(const Points& points) {
    const XRange range = x_range(points);
    return x_of(points.front()) - range.least < 0.5 * range.extent;
}

/// Brings a section of either order into one pass over it.
std::optional<Fault> arrange_section(Points& points) {
    if (is_count_line(points)) {
        const Vec3 counts = points.front().position;
        const int line = points.front().line;
        points.erase(points.begin());
        if (counts.x + counts.y != static_cast<double>(points.size())) {
            return Fault{"the counts of the two blocks do not add up to the " +
                             std::to_string(points.size()) + " points that follow",
                         line};
        }
        points = join_blocks(points, static_cast<std::size_t>(counts.x));
        return std::nullopt;
    }
    if (points.size() < fewest_points_of_a_section || !begins_at_leading_edge(points)) {
        return std::nullopt;
    }
    // Blocks without counts: x falls back to the leading edge once.
    const double half = 0.5 * x_range(points).extent;
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (x_of(points[k]) < x_of(points[k - 1]) - half) {
            points = join_blocks(points, k);
            return std::nullopt;
        }
    }
    return Fault{
        "the points start at the leading edge and do not come back to it: one side of an "
        "airfoil only, or an order that is neither Selig's nor Lednicer's",
        points.front().line};
}

/// Completes a symmetric half by its mirror image.
std::optional<Fault> arrange_half(Points& points) {
    if (points.size() < fewest_points_of_a_half) return std::nullopt;
    const int first_line = points.front().line;
    if (!begins_at_leading_edge(points)) std::reverse(points.begin(), points.end());
    const FilePoint nose = points.front();
    const XRange range = x_range(points);
    const bool reaches_trailing_edge = x_of(points.back()) - range.least > 0.5 * range.extent;
    if (!begins_at_leading_edge(points) || !reaches_trailing_edge) {
        return Fault{"a whole section where a symmetric half is expected", first_line};
    }
    if (std::abs(nose.position.y) > 1e-9 * range.extent) {
        return Fault{"the leading edge of a symmetric half must lie at y = 0", nose.line};
    }
    points.front().position.y = 0;
    Points whole(points.rbegin(), points.rend());
    for (std::size_t k = 1; k < points.size(); ++k) {
        const Vec3& p = points[k].position;
        whole.push_back({{p.x, 0 - p.y, 0}, points[k].line});
    }
    points = std::move(whole);
    return std::nullopt;
}

std::optional<Fault> check_distinct(const Points& points) {
    const double least = 1e-12 * x_range(points).extent;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const FilePoint& a = points[k - 1];
        const FilePoint& b = points[k];
        if (distance(a.position, b.position) <= least) {
            return Fault{"the same point as on " + of_line(std::min(a.line, b.line)),
                         std::max(a.line, b.line)};
        }
    }
    return std::nullopt;
}

/// Twice the area that the section encloses, positive when it runs counter-clockwise: along the
/// upper side first.
double doubled_area(const Points& points) {
    const Vec3& origin = points.front().position;
    double sum = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
        sum += cross(points[k - 1].position - origin, points[k].position - origin).z;
    }
    return sum;
}

std::optional<Fault> arrange(AirfoilContent content, Points& points) {
    const bool half = content == AirfoilContent::symmetric_half;
    std::optional<Fault> fault = half ? arrange_half(points) : arrange_section(points);
    if (fault) return fault;
    const std::size_t fewest = half ? fewest_points_of_a_half : fewest_points_of_a_section;
    if (points.size() < fewest) {
        return Fault{"only " + std::to_string(points.size()) +
                     " points; an airfoil needs at least " + std::to_string(fewest)};
    }
    if (std::optional<Fault> same = check_distinct(points)) return same;
    const double extent = x_range(points).extent;
    const double area = doubled_area(points);
    if (std::abs(area) <= 1e-9 * extent * extent) {
        return Fault{"the points enclose no area: not an airfoil"};
    }
    if (area < 0) std::reverse(points.begin(), points.end());
    return std::nullopt;
}

}  // namespace

AirfoilPoints read_airfoil(std::string_view text, AirfoilContent content) {
    Points points;
    std::optional<Fault> fault = read_points(text, points);
    if (!fault) fault = arrange(content, points);
    if (fault) return {{}, fault->message, fault->line};
    AirfoilPoints read;
    for (const FilePoint& point : points) read.points.push_back(point.position);
    return read;
}

}  // namespace hexweave
