// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <utility>

#include "geometry/length_units.h"

namespace hexweave {

namespace {

constexpr std::size_t section_column = 72;  // counted from 0
constexpr std::size_t data_columns = 64;    // of a parameter line

constexpr std::string_view step_begin = "ISO-10303-21;";
constexpr std::string_view step_end = "END-ISO-10303-21;";

/// The text from `begin` on up to the end of the line, which `next` is behind.
std::string_view line_at(std::string_view text, std::size_t begin, std::size_t& next) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    next = std::min(end + 1, text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

/// S, G, D, P or T; 0 where the line is not one of an IGES file.
char section_of(std::string_view line) {
    if (line.size() <= section_column) return 0;
    const char section = line[section_column];
    return std::string_view("SGDPT").find(section) == std::string_view::npos ? '\0' : section;
}

/// A parameter line with a blank less in front of one of its numbers; nothing where none can be
/// spared, or where a string (as in 4HWING) may be on the line.
std::string without_a_blank(std::string_view line) {
    const std::string_view data = line.substr(0, data_columns + 1);
    if (data.find('H') != std::string_view::npos) return {};
    std::size_t blank = data.find(' ');
    while (blank != std::string_view::npos && blank > 0 && data[blank - 1] != ',') {
        blank = data.find(' ', blank + 1);
    }
    if (blank == std::string_view::npos) return {};
    std::string mended(line);
    mended.erase(blank, 1);
    mended.insert(data_columns, 1, ' ');
    return mended;
}

CadText fault(CadFormat format, std::string error) {
    return {format, {}, std::move(error)};
}

/// The parameters of the global section, from the data of its lines. A string is written with its
/// length, as in 4HINCH; the first two parameters are the delimiters.
class GlobalParameters {
public:
    explicit GlobalParameters(std::string_view data) : rest_(data) {}

    std::string next() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
        const std::size_t digits = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
        std::string value;
        if (digits > 0 && digits < 4 && digits < rest_.size() && rest_[digits] == 'H') {
            const auto length = static_cast<std::size_t>(std::stoi(std::string(rest_)));
            value = rest_.substr(digits + 1, length);
            rest_.remove_prefix(std::min(digits + 1 + length, rest_.size()));
        }
        // One that delimits parameters is itself the first of them.
        if (first_ && value.size() == 1) delimiter_ = value.front();
        first_ = false;
        const std::size_t end = std::min(rest_.find_first_of(delimiters()), rest_.size());
        if (value.empty()) value = without_blanks(rest_.substr(0, end));
        if (end < rest_.size() && rest_[end] == delimiter_) rest_.remove_prefix(end + 1);
        return value;
    }

private:
    std::string delimiters() const { return {delimiter_, ';'}; }

    static std::string without_blanks(std::string_view text) {
        std::string kept(text);
        kept.erase(std::remove(kept.begin(), kept.end(), ' '), kept.end());
        return kept;
    }

    std::string_view rest_;
    char delimiter_ = ',';
    bool first_ = true;
};

/// The unit that the global section gives by a number or, for number 3, by a name.
std::string iges_unit(std::string_view global) {
    constexpr int flag_index = 14;
    constexpr std::array<std::string_view, 12> by_flag{"",  "in", "mm",  "",   "ft", "mi",
                                                       "m", "km", "mil", "um", "cm", "uin"};
    GlobalParameters parameters(global);
    for (int n = 1; n < flag_index; ++n) parameters.next();
    const std::string flag = parameters.next();
    std::string name = parameters.next();
    for (std::size_t n = 1; n < by_flag.size(); ++n) {
        if (flag == std::to_string(n) && !by_flag.at(n).empty()) return std::string(by_flag.at(n));
    }
    if (flag != "3") return {};
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name == "inch") return "in";
    return find_length_unit(name) == nullptr ? std::string() : name;
}

CadText prepare_iges(const std::string& text) {
    CadText prepared;
    prepared.text.reserve(text.size());
    constexpr std::string_view sections = "SGDPT";
    std::string global;
    std::size_t section = 0;
    std::size_t next = 0;
    int number = 0;
    for (std::size_t at = 0; at < text.size() && sections[section] != 'T'; at = next) {
        const std::string_view line = line_at(text, at, next);
        const std::string where = "line " + std::to_string(++number);
        const std::size_t found = sections.find(section_of(line));
        if (found == std::string_view::npos) {
            return fault(CadFormat::iges, where +
                                              " is not of an IGES file: it has no letter S, G, "
                                              "D, P or T in column 73");
        }
        if (found < section) return fault(CadFormat::iges, where + " is of an earlier section");
        section = found;
        if (sections[section] == 'G') global += line.substr(0, section_column);
        std::string mended(line);
        const bool overfull = sections[section] == 'P' && line[data_columns] != ' ';
        if (overfull) mended = without_a_blank(line);
        if (mended.empty()) {
            return fault(CadFormat::iges, where + " holds data in column 65, which must be blank");
        }
        prepared.text += mended + "\n";
    }
    prepared.unit = iges_unit(global);
    if (sections[section] == 'T') return prepared;
    return fault(CadFormat::iges, "the IGES file is cut short: it has no terminate section");
}

}  // namespace

CadText prepare_cad_text(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return fault(CadFormat::iges, "it is empty");
    if (text.compare(begin, step_begin.size(), step_begin) == 0) {
        if (text.rfind(step_end) != std::string::npos) return {CadFormat::step, text, {}};
        return fault(CadFormat::step,
                     "the STEP file is cut short: it does not end with " + std::string(step_end));
    }
    std::size_t next = 0;
    const char first = section_of(line_at(text, 0, next));
    if (first == 'S' || first == 'G') return prepare_iges(text);
    return fault(CadFormat::iges, "it is neither an IGES nor a STEP file");
}

}  // namespace hexweave
