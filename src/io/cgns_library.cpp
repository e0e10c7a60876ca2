// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_library.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "io/cgns.h"
#include "io/output_place.h"

namespace hexweave {
namespace {

struct NamedUnit {
    const char* symbol;
    LengthUnits_t unit;
};
constexpr std::array<NamedUnit, 5> named_units{
    {{"m", Meter}, {"mm", Millimeter}, {"cm", Centimeter}, {"in", Inch}, {"ft", Foot}}};

// HDF5's file driver writes the number of the failed system call into its description.
extern "C" herr_t find_error_number(unsigned /*depth*/, const H5E_error2_t* record, void* found) {
    constexpr const char* key = "errno = ";
    const char* place = record->desc == nullptr ? nullptr : std::strstr(record->desc, key);
    int& number = *static_cast<int*>(found);
    if (place != nullptr && number == 0) number = std::atoi(place + std::strlen(key));
    return 0;
}

extern "C" herr_t note_error(hid_t stack, void* found) {
    return H5Ewalk2(stack, H5E_WALK_UPWARD, find_error_number, found);
}

}  // namespace

void prepare_hdf5() {
    // Locks protect a file from a second writer; ours are private until renamed, and some network
    // file systems have no locks. HDF5 reads this when it starts.
    setenv("HDF5_USE_FILE_LOCKING", "BEST_EFFORT", 0);
    H5dont_atexit();
}

Hdf5Errors::Hdf5Errors() {
    H5Eget_auto2(H5E_DEFAULT, &former_function_, &former_data_);
    listen();
}

Hdf5Errors::~Hdf5Errors() {
    H5Eset_auto2(H5E_DEFAULT, former_function_, former_data_);
}

void Hdf5Errors::listen() {
    H5Eset_auto2(H5E_DEFAULT, note_error, &error_number_);
}

std::string Hdf5Errors::reason(const std::string& otherwise) const {
    return error_number_ != 0 ? error_reason(error_number_) : otherwise;
}

CgnsFile::CgnsFile(const std::filesystem::path& path, int mode) {
    // Said explicitly: the environment could ask for the older format.
    if (mode == CG_MODE_WRITE) cg_set_file_type(CG_FILE_HDF5);
    errno = 0;
    open_ = cg_open(path.c_str(), mode, &number_) == CG_OK;
    if (!open_) error_number_ = errno;
}

CgnsFile::~CgnsFile() {
    if (open_) cg_close(number_);
}

bool CgnsFile::close() {
    open_ = false;
    return cg_close(number_) == CG_OK;
}

std::optional<LengthUnits_t> length_unit(const std::string& units) {
    for (const NamedUnit& known : named_units) {
        if (units == known.symbol) return known.unit;
    }
    return std::nullopt;
}

std::string unit_symbol(LengthUnits_t unit) {
    for (const NamedUnit& known : named_units) {
        if (unit == known.unit) return known.symbol;
    }
    return {};
}

std::optional<BCType_t> boundary_type(const std::string& name) {
    for (int type = 0; type < NofValidBCTypes; ++type) {
        if (name == BCTypeName[type]) return static_cast<BCType_t>(type);
    }
    return std::nullopt;
}

std::string boundary_type_name(BCType_t type) {
    return type >= 0 && type < NofValidBCTypes ? BCTypeName[type] : "Null";
}

}  // namespace hexweave
