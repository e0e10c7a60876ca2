// SPDX-License-Identifier: Apache-2.0
#include "topology/source_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/utf8.h"

namespace hexweave {

namespace {

bool is_control(std::string_view text) {
    const auto c = static_cast<unsigned char>(text.front());
    if (c == '\r') return text.size() < 2 || text[1] != '\n';
    return (c < 0x20 && c != '\t' && c != '\n') || c == 0x7F;
}

bool check_characters(const SourcePlaces& places, Diagnostics& diagnostics) {
    const std::string_view text = places.text();
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = decode_utf8(text.substr(at));
        if (!character.valid) {
            diagnostics.error(places.at(at),
                              fmt::format("byte 0x{:02X} is not valid UTF-8",
                                          static_cast<unsigned char>(text[at])),
                              "save the file as UTF-8");
            return false;
        }
        if (is_control(text.substr(at))) {
            diagnostics.error(places.at(at),
                              fmt::format("control character 0x{:02X} in the text",
                                          static_cast<unsigned char>(text[at])),
                              "remove it");
            return false;
        }
        at += character.bytes;
    }
    return true;
}

bool check_indentation(const SourcePlaces& places, Diagnostics& diagnostics) {
    const std::string_view text = places.text();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t first = std::min(text.find_first_not_of(" \t\r", begin), end);
        const std::size_t tab = text.substr(begin, first - begin).find('\t');
        if (tab != std::string_view::npos && first < end) {
            diagnostics.error(places.at(begin + tab), "a tab in the indentation",
                              "indent with spaces");
            return false;
        }
        begin = end + 1;
    }
    return true;
}

}  // namespace

SourcePlaces::SourcePlaces(std::shared_ptr<const SourceFile> source)
    : source_(std::move(source)), text_(source_->text), line_begins_{0} {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') line_begins_.push_back(i + 1);
    }
}

Place SourcePlaces::at(std::size_t offset, int length) const {
    offset = std::min(offset, text_.size());
    const auto line = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset) - 1;
    std::size_t from = *line;
    int column = 1;
    if (last_offset_ >= from && last_offset_ <= offset) {
        from = last_offset_;
        column = last_column_;
    }
    column += count_characters(text_.substr(from, offset - from));
    last_offset_ = offset;
    last_column_ = column;
    return {source_, static_cast<int>(line - line_begins_.begin()) + 1, column, length};
}

int count_characters(std::string_view text) {
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](char c) { return !is_utf8_continuation(c); }));
}

std::string shown(const std::string& text) {
    constexpr std::size_t longest = 60;
    std::string line = text;
    if (line.size() > longest) {
        std::size_t end = longest - 3;
        while (end > 0 && is_utf8_continuation(line[end])) --end;
        line = line.substr(0, end) + "...";
    }
    for (char& c : line) c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    return line;
}

bool check_text(const SourcePlaces& places, Diagnostics& diagnostics) {
    return check_characters(places, diagnostics) && check_indentation(places, diagnostics);
}

}  // namespace hexweave
