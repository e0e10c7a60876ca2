// SPDX-License-Identifier: Apache-2.0
#include "io/byte_writer.h"

#include <cerrno>
#include <utility>

#include "io/output_place.h"

namespace hexweave {

ByteWriter::ByteWriter(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wbe")) {
    if (file_ == nullptr) fail();
}

ByteWriter::~ByteWriter() {
    if (file_ != nullptr) std::fclose(file_);
}

void ByteWriter::put(const void* bytes, std::size_t count) {
    if (std::fwrite(bytes, 1, count, file_) != count) fail();
}

void ByteWriter::close() {
    if (std::fclose(std::exchange(file_, nullptr)) != 0) fail();
}

void ByteWriter::fail() const {
    cannot_write(path_, error_reason(errno));
}

}  // namespace hexweave
