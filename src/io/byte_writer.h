// SPDX-License-Identifier: Apache-2.0
// A file that is written from its beginning to its end, and says so when that fails.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace hexweave {

/// Every member throws MachineError, naming the path and the reason, when the system refuses.
class ByteWriter {
public:
    /// Creates the file, or empties it.
    explicit ByteWriter(const std::filesystem::path& path);
    ByteWriter(const ByteWriter&) = delete;
    ByteWriter& operator=(const ByteWriter&) = delete;
    ~ByteWriter();

    void put(const void* bytes, std::size_t count);
    void put(std::string_view text) { put(text.data(), text.size()); }
    /// To be called at the end: what was buffered may fail only here.
    void close();

private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::FILE* file_;
};

}  // namespace hexweave
