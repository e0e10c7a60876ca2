// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_text.h"

#include <cstddef>
#include <string_view>
#include <utility>

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

CadText prepare_iges(const std::string& text) {
    CadText prepared;
    prepared.text.reserve(text.size());
    constexpr std::string_view sections = "SGDPT";
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
        std::string mended(line);
        const bool overfull = sections[section] == 'P' && line[data_columns] != ' ';
        if (overfull) mended = without_a_blank(line);
        if (mended.empty()) {
            return fault(CadFormat::iges, where + " holds data in column 65, which must be blank");
        }
        prepared.text += mended + "\n";
    }
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
