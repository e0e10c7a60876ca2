// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_archive.h"

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/assert.h"

namespace hexweave {

namespace {

template <class T>
inline constexpr bool is_plain =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vec3> ||
    std::is_same_v<T, CadBox> || std::is_same_v<T, std::array<double, 2>>;

class Writer {
public:
    template <class T>
    void raw(T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    template <class Container>
    std::size_t resize(Container& container) {
        std::size_t size = container.size();
        raw(size);
        return size;
    }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

class Reader {
public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}

    template <class T>
    void raw(T& value) {
        HEXWEAVE_ASSERT(at_ + sizeof(T) <= bytes_.size());
        std::memcpy(&value, bytes_.data() + at_, sizeof(T));
        at_ += sizeof(T);
    }
    template <class Container>
    std::size_t resize(Container& container) {
        std::size_t size = 0;
        raw(size);
        container.resize(size);
        return size;
    }

private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

// One description of the data serves writing and reading.

template <class Archive, class T>
void move_through(Archive& archive, T& value);

template <class Archive, class... Parts>
void move_all(Archive& archive, Parts&... parts) {
    (move_through(archive, parts), ...);
}

template <class Archive>
void move_parts(Archive& a, CadCurve& c) {
    move_all(a, c.type, c.polygon.degree, c.polygon.knots, c.polygon.control, c.polygon.weights,
             c.box, c.fault, c.is_point);
}

template <class Archive>
void move_parts(Archive& a, NurbsNet& n) {
    move_all(a, n.degree_u, n.degree_v, n.count_u, n.count_v, n.knots_u, n.knots_v, n.control,
             n.weights);
}

template <class Archive>
void move_parts(Archive& a, CadFace& f) {
    move_all(a, f.type, f.net, f.range_u, f.range_v, f.trimmed, f.edges, f.box, f.fault);
}

template <class Archive>
void move_parts(Archive& a, CadEntity& e) {
    move_all(a, e.number, e.type, e.label, e.name, e.faces, e.curves);
}

template <class Archive>
void move_parts(Archive& a, CadFile& f) {
    move_all(a, f.format, f.unit, f.unit_in_metres, f.several_units, f.entities);
}

template <class Archive, class Item>
void move_parts(Archive& a, std::vector<Item>& items) {
    a.resize(items);
    for (Item& item : items) move_through(a, item);
}

template <class Archive>
void move_parts(Archive& a, std::string& text) {
    a.resize(text);
    for (char& c : text) a.raw(c);
}

template <class Archive, class T>
void move_through(Archive& archive, T& value) {
    if constexpr (is_plain<T>) {
        archive.raw(value);
    } else {
        move_parts(archive, value);
    }
}

}  // namespace

std::string pack(const CadResult& result) {
    CadResult copy = result;
    bool has_file = copy.file.has_value();
    Writer writer;
    move_all(writer, has_file, copy.error);
    if (has_file) move_through(writer, *copy.file);
    return writer.take();
}

CadResult unpack(const std::string& bytes) {
    CadResult result;
    bool has_file = false;
    Reader reader(bytes);
    move_all(reader, has_file, result.error);
    if (has_file) move_through(reader, result.file.emplace());
    return result;
}

}  // namespace hexweave
