// SPDX-License-Identifier: Apache-2.0
// Bytes of a source text: from offsets to places, and what no text file may hold.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace hexweave {

/// Places in one source by byte offset. Offsets count from behind a byte order mark.
class SourcePlaces {
public:
    explicit SourcePlaces(std::shared_ptr<const SourceFile> source);

    /// The text without its byte order mark.
    std::string_view text() const { return text_; }
    /// Line and column (in characters) of a byte; the end of the text for an offset beyond it.
    Place at(std::size_t offset, int length = 1) const;

private:
    std::shared_ptr<const SourceFile> source_;
    std::string_view text_;
    std::vector<std::size_t> line_begins_;
    /// Where the last question was answered: the next is mostly further along the same line.
    mutable std::size_t last_offset_ = 0;
    mutable int last_column_ = 1;
};

/// Characters (not bytes) of UTF-8 text.
int count_characters(std::string_view text);

/// A user's text as it may stand in a message: one line of bounded length.
std::string shown(const std::string& text);

/// Errors for what is not text: broken UTF-8, control characters, lone carriage returns, and tabs
/// in the indentation of a line. The first of each kind is told; false when there was one.
bool check_text(const SourcePlaces& places, Diagnostics& diagnostics);

}  // namespace hexweave
