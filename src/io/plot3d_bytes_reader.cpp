// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>

#include "core/errors.h"
#include "io/output_place.h"
#include "io/plot3d_source.h"

namespace hexweave {
namespace {

constexpr std::size_t mark_size = sizeof(std::int32_t);

/// The bytes of a file in one of the ways to understand them.
struct Bytes {
    std::filesystem::path path;
    std::ifstream stream;
    std::size_t size = 0;
    ByteOrder order = ByteOrder::little;
    bool has_marks = false;

    /// False at the end of the file.
    bool get(void* into, std::size_t count) {
        stream.read(static_cast<char*>(into), static_cast<std::streamsize>(count));
        if (stream.bad()) {
            throw MachineError(
                fmt::format("cannot read '{}': {}", path.string(), error_reason(errno)));
        }
        return stream.gcount() == static_cast<std::streamsize>(count);
    }

    std::optional<std::int32_t> mark() {
        std::array<unsigned char, mark_size> bytes{};
        if (!get(bytes.data(), bytes.size())) return std::nullopt;
        to_order(bytes.data(), 1, mark_size, order);
        std::int32_t value = 0;
        std::memcpy(&value, bytes.data(), mark_size);
        return value;
    }

    std::optional<std::int32_t> whole_number_at(std::size_t offset) {
        if (offset + mark_size > size) return std::nullopt;
        stream.clear();
        stream.seekg(static_cast<std::streamoff>(offset));
        return mark();
    }
};

/// Where the n-th whole number of the head begins: behind one mark for the record of the number of
/// blocks, and another two between that record and the sizes.
std::size_t head_offset(const Bytes& bytes, const Plot3dLayout& layout, std::size_t place) {
    std::size_t marks = bytes.has_marks ? 1 : 0;
    if (bytes.has_marks && layout.has_count && place > 0) marks += 2;
    return (place + marks) * mark_size;
}

/// The lengths of all records, found by their marks; nothing where the marks are none.
std::optional<std::vector<std::size_t>> record_lengths(Bytes& bytes) {
    std::vector<std::size_t> lengths;
    std::size_t length = 0;
    for (std::size_t at = 0; at < bytes.size;) {
        const auto opening = bytes.whole_number_at(at);
        if (!opening || *opening == 0) return std::nullopt;
        const auto piece = static_cast<std::size_t>(std::abs(std::int64_t{*opening}));
        if (piece > bytes.size - at) return std::nullopt;
        const auto closing = bytes.whole_number_at(at + mark_size + piece);
        if (!closing || std::abs(std::int64_t{*closing}) != std::abs(std::int64_t{*opening})) {
            return std::nullopt;
        }
        at += 2 * mark_size + piece;
        length += piece;
        if (*opening < 0) continue;  // the record goes on in another piece
        lengths.push_back(std::exchange(length, 0));
    }
    return lengths;
}

/// The lengths that the records of this layout have.
std::vector<std::size_t> expected_lengths(const Plot3dLayout& layout) {
    std::vector<std::size_t> lengths;
    if (layout.has_count) lengths.push_back(mark_size);
    lengths.push_back(layout.extents.size() * static_cast<std::size_t>(layout.dimension) *
                      mark_size);
    for (const Extent& extent : layout.extents) {
        lengths.push_back(layout.numbers(extent) * layout.number_size +
                          (layout.has_blanking ? extent.nodes() * mark_size : 0));
    }
    return lengths;
}

/// Where the points begin: behind the marks of the records before them.
std::size_t head_length(const Bytes& bytes, const Plot3dLayout& layout) {
    const std::size_t records = layout.has_count ? 2 : 1;
    const std::size_t numbers = layout.extents.size() * static_cast<std::size_t>(layout.dimension);
    return (numbers + records - 1 + (bytes.has_marks ? 2 * records : 0)) * mark_size;
}

/// The layout of which the file is exactly as long, record by record where it has them.
std::optional<Plot3dLayout> fitting_layout(Bytes& bytes) {
    const auto lengths = bytes.has_marks ? record_lengths(bytes) : std::vector{bytes.size};
    if (!lengths) return std::nullopt;
    const auto head = [&](const Plot3dLayout& layout, std::size_t place) {
        return bytes.whole_number_at(head_offset(bytes, layout, place));
    };
    for (Plot3dLayout& layout : possible_heads(head, bytes.size / sizeof(float))) {
        for (const std::size_t number_size : {sizeof(double), sizeof(float)}) {
            for (const bool has_blanking : {false, true}) {
                layout.number_size = number_size;
                layout.has_blanking = has_blanking;
                std::vector<std::size_t> wanted = expected_lengths(layout);
                if (!bytes.has_marks) {
                    wanted = {std::accumulate(wanted.begin(), wanted.end(), std::size_t{0})};
                }
                if (wanted == *lengths) return layout;
            }
        }
    }
    return std::nullopt;
}

/// Finds the way to understand the bytes, and leaves it in `bytes`.
Plot3dLayout find_layout(Bytes& bytes) {
    for (const bool has_marks : {true, false}) {
        for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
            bytes.has_marks = has_marks;
            bytes.order = order;
            if (const auto layout = fitting_layout(bytes)) return *layout;
        }
    }
    fits_no_layout(bytes.path);
}

/// Reads what stands in one record, piece by piece.
class Record {
public:
    explicit Record(Bytes& bytes) : bytes_(bytes) { begin_piece(); }

    void get(unsigned char* into, std::size_t count) {
        while (count > 0) {
            if (bytes_.has_marks && left_ == 0) next_piece();
            const std::size_t part = bytes_.has_marks ? std::min(count, left_) : count;
            if (!bytes_.get(into, part)) fits_no_layout(bytes_.path);
            into += part;
            count -= part;
            left_ -= bytes_.has_marks ? part : 0;
        }
    }

    void end() {
        if (!bytes_.has_marks) return;
        const auto closing = bytes_.mark();
        if (left_ != 0 || more_ || !closing || std::abs(std::int64_t{*closing}) != piece_) {
            fits_no_layout(bytes_.path);
        }
    }

private:
    void begin_piece() {
        if (!bytes_.has_marks) return;
        const auto opening = bytes_.mark();
        if (!opening || *opening == 0) fits_no_layout(bytes_.path);
        more_ = *opening < 0;
        piece_ = std::abs(std::int64_t{*opening});
        left_ = static_cast<std::size_t>(piece_);
    }

    void next_piece() {
        const auto closing = bytes_.mark();
        if (!more_ || !closing || std::abs(std::int64_t{*closing}) != piece_) {
            fits_no_layout(bytes_.path);
        }
        begin_piece();
    }

    Bytes& bytes_;
    std::int64_t piece_ = 0;
    std::size_t left_ = 0;
    bool more_ = false;
};

void read_doubles(Record& record, ByteOrder order, double* into, std::size_t count) {
    auto* bytes = reinterpret_cast<unsigned char*>(into);
    record.get(bytes, count * sizeof(double));
    to_order(bytes, count, sizeof(double), order);
}

void read_floats(Record& record, ByteOrder order, double* into, std::size_t count) {
    constexpr std::size_t at_once = 4096;
    std::vector<float> some(at_once);
    for (std::size_t done = 0; done < count; done += at_once) {
        const std::size_t part = std::min(at_once, count - done);
        auto* bytes = reinterpret_cast<unsigned char*>(some.data());
        record.get(bytes, part * sizeof(float));
        to_order(bytes, part, sizeof(float), order);
        std::copy_n(some.begin(), part, into + done);
    }
}

/// Whether one of the `nodes` is blanked out.
bool read_blanking(Record& record, std::size_t nodes) {
    std::vector<unsigned char> flags(nodes * mark_size);
    record.get(flags.data(), flags.size());
    for (std::size_t n = 0; n < nodes; ++n) {
        const auto* flag = flags.data() + n * mark_size;
        if (std::all_of(flag, flag + mark_size, [](unsigned char byte) { return byte == 0; })) {
            return true;
        }
    }
    return false;
}

void read_zone(Bytes& bytes, const Plot3dLayout& layout, const Extent& extent, Zone& zone) {
    zone.points = PointField(extent);
    Record record(bytes);
    const auto read = layout.number_size == sizeof(double) ? read_doubles : read_floats;
    read(record, bytes.order, zone.points.x.data(), extent.nodes());
    read(record, bytes.order, zone.points.y.data(), extent.nodes());
    if (layout.dimension == 3) read(record, bytes.order, zone.points.z.data(), extent.nodes());
    if (layout.has_blanking && read_blanking(record, extent.nodes())) {
        has_holes(bytes.path, zone.name);
    }
    record.end();
}

}  // namespace

MultiblockGrid read_plot3d_bytes(const std::filesystem::path& path) {
    Bytes bytes{path, std::ifstream(path, std::ios::binary), std::filesystem::file_size(path)};
    const Plot3dLayout layout = find_layout(bytes);
    MultiblockGrid grid = empty_grid(path, layout);
    bytes.stream.clear();
    bytes.stream.seekg(static_cast<std::streamoff>(head_length(bytes, layout)));
    for (std::size_t block = 0; block < grid.zones.size(); ++block) {
        read_zone(bytes, layout, layout.extents[block], grid.zones[block]);
    }
    return grid;
}

}  // namespace hexweave
