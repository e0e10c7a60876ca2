// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <vector>

#include "io/byte_writer.h"
#include "io/plot3d.h"
#include "io/plot3d_layout.h"

namespace hexweave {
namespace {

std::vector<const Field*> coordinates(const Zone& zone, int dimension) {
    std::vector<const Field*> fields{&zone.points.x, &zone.points.y};
    if (dimension == 3) fields.push_back(&zone.points.z);
    return fields;
}

/// The numbers at the head of the file after the number of blocks: the sizes.
std::vector<std::int32_t> sizes(const MultiblockGrid& grid) {
    std::vector<std::int32_t> all;
    for (const Zone& zone : grid.zones) {
        for (int axis = 0; axis < grid.physical_dimension; ++axis) {
            all.push_back(zone.points.extent()[axis]);
        }
    }
    return all;
}

void write_text(const MultiblockGrid& grid, ByteWriter& file) {
    constexpr std::size_t per_line = 4;
    file.put(fmt::format("{}\n", grid.zones.size()));
    const std::vector<std::int32_t> all = sizes(grid);
    const auto dimension = static_cast<std::size_t>(grid.physical_dimension);
    for (std::size_t n = 0; n < all.size(); ++n) {
        file.put(fmt::format("{}{}", all[n], (n + 1) % dimension == 0 ? '\n' : ' '));
    }
    fmt::memory_buffer text;
    for (const Zone& zone : grid.zones) {
        const std::size_t nodes = zone.points.extent().nodes();
        for (const Field* field : coordinates(zone, grid.physical_dimension)) {
            for (std::size_t n = 0; n < nodes; ++n) {
                const bool ends = (n + 1) % per_line == 0 || n + 1 == nodes;
                fmt::format_to(std::back_inserter(text), "{}{}", (*field)[n], ends ? '\n' : ' ');
                if (!ends) continue;
                file.put(text.data(), text.size());
                text.clear();
            }
        }
    }
}

/// Numbers as bytes: in the order asked, between counts where the form wants them.
class RecordWriter {
public:
    RecordWriter(ByteWriter& file, Plot3dForm form, ByteOrder byte_order)
        : file_(file), marks_(form == Plot3dForm::unformatted), order_(byte_order) {}

    void begin(std::size_t bytes) {
        left_ = bytes;
        is_first_ = true;
        begin_piece();
    }

    template <class Number>
    void put(const Number* numbers, std::size_t count) {
        constexpr std::size_t at_once = 4096;
        std::vector<unsigned char> bytes;
        for (std::size_t done = 0; done < count; done += at_once) {
            const std::size_t part = std::min(at_once, count - done);
            const auto* first = reinterpret_cast<const unsigned char*>(numbers + done);
            bytes.assign(first, first + part * sizeof(Number));
            to_order(bytes.data(), part, sizeof(Number), order_);
            put_bytes(bytes);
        }
    }

private:
    void mark(std::int32_t count) {
        if (!marks_) return;
        std::array<unsigned char, sizeof count> bytes{};
        std::memcpy(bytes.data(), &count, sizeof count);
        to_order(bytes.data(), 1, sizeof count, order_);
        file_.put(bytes.data(), bytes.size());
    }

    void begin_piece() {
        piece_ = marks_ ? std::min(left_, longest_subrecord) : left_;
        left_ -= piece_;
        piece_left_ = piece_;
        mark(static_cast<std::int32_t>(left_ > 0 ? -static_cast<std::int64_t>(piece_)
                                                 : static_cast<std::int64_t>(piece_)));
    }

    void put_bytes(const std::vector<unsigned char>& bytes) {
        for (std::size_t done = 0; done < bytes.size();) {
            const std::size_t part = std::min(bytes.size() - done, piece_left_);
            file_.put(bytes.data() + done, part);
            done += part;
            piece_left_ -= part;
            if (piece_left_ > 0) continue;
            const auto count = static_cast<std::int64_t>(piece_);
            mark(static_cast<std::int32_t>(is_first_ ? count : -count));
            is_first_ = false;
            if (left_ > 0) begin_piece();
        }
    }

    ByteWriter& file_;
    bool marks_;
    ByteOrder order_;
    std::size_t left_ = 0;        ///< bytes of the record behind this piece
    std::size_t piece_ = 0;       ///< bytes of this piece
    std::size_t piece_left_ = 0;  ///< of which are still to come
    bool is_first_ = true;
};

void write_bytes(const MultiblockGrid& grid, ByteWriter& file, Plot3dForm form,
                 ByteOrder byte_order) {
    RecordWriter records(file, form, byte_order);
    const auto blocks = static_cast<std::int32_t>(grid.zones.size());
    records.begin(sizeof blocks);
    records.put(&blocks, 1);
    const std::vector<std::int32_t> all = sizes(grid);
    records.begin(all.size() * sizeof(std::int32_t));
    records.put(all.data(), all.size());
    for (const Zone& zone : grid.zones) {
        const std::size_t nodes = zone.points.extent().nodes();
        const auto fields = coordinates(zone, grid.physical_dimension);
        records.begin(fields.size() * nodes * sizeof(double));
        for (const Field* field : fields) records.put(field->data(), nodes);
    }
}

}  // namespace

void write_plot3d(const MultiblockGrid& grid, const std::filesystem::path& path, Plot3dForm form,
                  ByteOrder byte_order) {
    ByteWriter file(path);
    if (form == Plot3dForm::text) {
        write_text(grid, file);
    } else {
        write_bytes(grid, file, form, byte_order);
    }
    file.close();
}

}  // namespace hexweave
