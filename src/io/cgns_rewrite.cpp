// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_rewrite.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "io/cgns_library.h"

namespace hexweave {
namespace {

/// The bytes that are copied at once; one plane of a larger array when that is more.
constexpr std::size_t slab_bytes = std::size_t{16} << 20U;

class Rewriter {
public:
    explicit Rewriter(std::filesystem::path shown)
        : shown_(std::move(shown)),
          group_creation_(group_creation(H5P_GROUP_CREATE)),
          data_creation_(property_list(H5P_DATASET_CREATE)) {
        check(H5Pset_obj_track_times(data_creation_, false));
        check(H5Pset_fill_time(data_creation_, H5D_FILL_TIME_NEVER));
    }

    void copy_file(const std::filesystem::path& from, const std::filesystem::path& to) {
        const Hdf5Handle access = file_access();
        const Hdf5Handle source = own(H5Fopen(from.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
        const Hdf5Handle creation = group_creation(H5P_FILE_CREATE);
        Hdf5Handle target = own(H5Fcreate(to.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose);
        {
            const Hdf5Handle source_root = own(H5Gopen2(source, "/", H5P_DEFAULT), H5Gclose);
            const Hdf5Handle target_root = own(H5Gopen2(target, "/", H5P_DEFAULT), H5Gclose);
            copy_attributes(source_root, target_root);
            copy_members(source_root, target_root, true);
        }
        check(H5Fflush(target, H5F_SCOPE_GLOBAL));
        if (!target.close()) fail();
    }

private:
    [[noreturn]] void fail() const {
        throw MachineError(fmt::format("cannot write '{}': {}", shown_.string(),
                                       errors_.reason("the HDF5 library failed")));
    }

    /// Every HDF5 function answers with a negative number when it fails.
    template <class Answer>
    Answer check(Answer answer) const {
        if (answer < 0) fail();
        return answer;
    }

    Hdf5Handle own(hid_t id, Hdf5Handle::Close close) const { return {check(id), close}; }

    Hdf5Handle property_list(hid_t property_class) const {
        return own(H5Pcreate(property_class), H5Pclose);
    }

    Hdf5Handle file_access() const {
        Hdf5Handle list = property_list(H5P_FILE_ACCESS);
        check(H5Pset_fclose_degree(list, H5F_CLOSE_STRONG));
        // libcgns 3 refuses files of the newest formats.
        check(H5Pset_libver_bounds(list, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST));
        // The cache counts bytes on the disk; in memory the many small nodes are 20 times as large.
        constexpr std::size_t cache_bytes = std::size_t{2} << 20U;
        H5AC_cache_config_t cache{};
        cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
        check(H5Pget_mdc_config(list, &cache));
        cache.max_size = cache_bytes;
        check(H5Pset_mdc_config(list, &cache));
        return list;
    }

    /// Readers want the children of a node in the order in which they were made.
    Hdf5Handle group_creation(hid_t property_class) const {
        Hdf5Handle list = property_list(property_class);
        check(H5Pset_link_creation_order(list, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
        check(H5Pset_obj_track_times(list, false));
        return list;
    }

    static void clear_after_end(std::vector<char>& text) {
        std::fill(std::find(text.begin(), text.end(), '\0'), text.end(), '\0');
    }

    void copy_attributes(hid_t source, hid_t target) const {
        H5O_info_t info;
        check(H5Oget_info(source, &info));
        for (hsize_t index = 0; index < info.num_attrs; ++index) {
            copy_attribute(own(H5Aopen_by_idx(source, ".", H5_INDEX_NAME, H5_ITER_INC, index,
                                              H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose),
                           target);
        }
    }

    void copy_attribute(hid_t source, hid_t target) const {
        std::string name(static_cast<std::size_t>(check(H5Aget_name(source, 0, nullptr))), '\0');
        check(H5Aget_name(source, name.size() + 1, name.data()));
        const Hdf5Handle type = own(H5Aget_type(source), H5Tclose);
        const Hdf5Handle space = own(H5Aget_space(source), H5Sclose);
        const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space)));
        std::vector<char> value(count * H5Tget_size(type));
        check(H5Aread(source, type, value.data()));
        if (H5Tget_class(type) == H5T_STRING) clear_after_end(value);
        const Hdf5Handle copy =
            own(H5Acreate2(target, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        check(H5Awrite(copy, type, value.data()));
    }

    // The two texts beside the root, the format and the version of HDF5, have stray bytes too.
    void copy_members(hid_t source, hid_t target, bool is_root) const {
        H5G_info_t group;
        check(H5Gget_info(source, &group));
        for (hsize_t index = 0; index < group.nlinks; ++index) {
            const std::string name = member_name(source, index);
            const Hdf5Handle member = own(H5Oopen(source, name.c_str(), H5P_DEFAULT), H5Oclose);
            if (H5Iget_type(member) == H5I_DATASET) {
                copy_data(member, target, name, is_root);
            } else {
                const Hdf5Handle copy =
                    own(H5Gcreate2(target, name.c_str(), H5P_DEFAULT, group_creation_, H5P_DEFAULT),
                        H5Gclose);
                copy_attributes(member, copy);
                copy_members(member, copy, false);
            }
        }
    }

    std::string member_name(hid_t group, hsize_t index) const {
        const auto ask = [&](char* text, std::size_t size) {
            return check(H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, index,
                                            text, size, H5P_DEFAULT));
        };
        std::string name(static_cast<std::size_t>(ask(nullptr, 0)), '\0');
        ask(name.data(), name.size() + 1);
        return name;
    }

    void copy_data(hid_t source, hid_t target, const std::string& name, bool is_text) const {
        const Hdf5Handle type = own(H5Dget_type(source), H5Tclose);
        const Hdf5Handle space = own(H5Dget_space(source), H5Sclose);
        Hdf5Handle copy = own(
            H5Dcreate2(target, name.c_str(), type, space, H5P_DEFAULT, data_creation_, H5P_DEFAULT),
            H5Dclose);

        const auto rank = static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space)));
        std::vector<hsize_t> extent(rank);
        check(H5Sget_simple_extent_dims(space, extent.data(), nullptr));
        std::size_t row = H5Tget_size(type);
        for (std::size_t axis = 1; axis < rank; ++axis) row *= extent[axis];
        const hsize_t rows = rank == 0 ? 1 : extent[0];
        const hsize_t most = std::max<hsize_t>(1, slab_bytes / std::max<std::size_t>(1, row));
        std::vector<char> slab;
        for (hsize_t first = 0; first < rows; first += most) {
            std::vector<hsize_t> begin(rank, 0);
            std::vector<hsize_t> size = extent;
            if (rank > 0) {
                begin[0] = first;
                size[0] = std::min(most, rows - first);
                check(H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, size.data(),
                                          nullptr));
            }
            const Hdf5Handle memory =
                rank == 0
                    ? own(H5Screate(H5S_SCALAR), H5Sclose)
                    : own(H5Screate_simple(static_cast<int>(rank), size.data(), nullptr), H5Sclose);
            slab.resize(row * (rank == 0 ? 1 : size[0]));
            check(H5Dread(source, type, memory, space, H5P_DEFAULT, slab.data()));
            if (is_text) clear_after_end(slab);
            check(H5Dwrite(copy, type, memory, space, H5P_DEFAULT, slab.data()));
        }
        if (!copy.close()) fail();
    }

    std::filesystem::path shown_;
    Hdf5Errors errors_;
    Hdf5Handle group_creation_;
    Hdf5Handle data_creation_;
};

}  // namespace

void rewrite_cgns_tree(const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::filesystem::path& shown) {
    Rewriter(shown).copy_file(from, to);
}

}  // namespace hexweave
