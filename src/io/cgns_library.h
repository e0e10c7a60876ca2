// SPDX-License-Identifier: Apache-2.0
// What the CGNS reader, the writer and the rewriting pass share: handles that close themselves, the
// reason behind a failure, and the names that both libraries know by number. Only they include
// it: libcgns puts macros and short enumerators into the global namespace.
#pragma once

#include <cgnslib.h>
#include <hdf5.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace hexweave {

/// The longest name of a CGNS node, in bytes.
inline constexpr std::size_t longest_cgns_name = 32;
/// The only base that is written; and the descriptors on it.
inline constexpr const char* base_name = "Base";
inline constexpr const char* title_descriptor = "Title";
inline constexpr const char* provenance_descriptor = "Provenance";

/// Listens to failing HDF5 calls while it lives: nothing is printed, and the system's error number
/// behind the first failure is kept.
class Hdf5Errors {
public:
    Hdf5Errors();
    Hdf5Errors(const Hdf5Errors&) = delete;
    Hdf5Errors& operator=(const Hdf5Errors&) = delete;
    ~Hdf5Errors();

    /// Listens again; libcgns switches every listener off when it opens a file.
    void listen();
    /// "no space left on device", or `otherwise` when no system call has failed.
    std::string reason(const std::string& otherwise) const;

private:
    H5E_auto2_t former_function_ = nullptr;
    void* former_data_ = nullptr;
    int error_number_ = 0;
};

/// An HDF5 identifier that closes itself.
class Hdf5Handle {
public:
    using Close = herr_t (*)(hid_t);

    Hdf5Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    ~Hdf5Handle() {
        if (id_ >= 0) close_(id_);
    }

    operator hid_t() const { return id_; }
    /// Closes now; false when that fails.
    bool close() { return close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

private:
    hid_t id_;
    Close close_;
};

/// A file opened by libcgns that closes itself.
class CgnsFile {
public:
    /// `mode` is CG_MODE_READ or CG_MODE_WRITE; is_open() tells whether it succeeded.
    CgnsFile(const std::filesystem::path& path, int mode);
    CgnsFile(const CgnsFile&) = delete;
    CgnsFile& operator=(const CgnsFile&) = delete;
    ~CgnsFile();

    operator int() const { return number_; }
    bool is_open() const { return open_; }
    /// The system's error number when opening failed; 0 when it is not known.
    int error_number() const { return error_number_; }
    /// Closes now; false when that fails.
    bool close();

private:
    int number_ = 0;
    int error_number_ = 0;
    bool open_ = false;
};

/// "m" -> Meter; nothing for units that CGNS does not know.
std::optional<LengthUnits_t> length_unit(const std::string& units);
/// Meter -> "m"; an empty string for units that are not known.
std::string unit_symbol(LengthUnits_t unit);

/// "BCWallViscous" -> its number; nothing for a name that CGNS does not know.
std::optional<BCType_t> boundary_type(const std::string& name);
std::string boundary_type_name(BCType_t type);

}  // namespace hexweave
