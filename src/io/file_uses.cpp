// SPDX-License-Identifier: Apache-2.0
#include "io/file_uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "core/errors.h"
#include "io/output_place.h"

namespace hexweave {
namespace {

namespace fs = std::filesystem;

/// An output, and where it would stand: an absolute path, links followed.
struct Placed {
    const FileUse* use;
    fs::path at;
};

std::string described(const FileUse& use) {
    return fmt::format("{} '{}'", use.role, use.path.string());
}

bool exists_and_is(const fs::path& one, const fs::path& other) {
    std::error_code absent;
    return fs::equivalent(one, other, absent);
}

/// Finds the place of one output after the other.
class Places {
public:
    explicit Places(std::vector<FileFault>& faults) : faults_(faults) {}

    void add(const FileUse& use) {
        try {
            placed_.push_back({&use, place_of(use)});
        } catch (const UsageError& fault) {
            faults_.push_back({fault.what(), use});
        }
    }

    const std::vector<Placed>& all() const { return placed_; }

private:
    fs::path place_of(const FileUse& use) {
        const bool in_new_folder = missing_.count(folder_of(use.path)) > 0;
        if (use.kind == FileUse::Kind::file && !in_new_folder) return place_of_file(use.path);
        if (use.kind != FileUse::Kind::file && (in_new_folder || folder_is_missing(use.path))) {
            missing_.insert(use.path);
        }
        return fs::weakly_canonical(fs::absolute(use.path));
    }

    std::vector<FileFault>& faults_;
    std::vector<Placed> placed_;
    std::set<fs::path> missing_;  ///< folders that are to be made
};

bool is_piece(const Placed& file, const Placed& pieces) {
    return pieces.use->kind == FileUse::Kind::pieces && file.at.extension() == ".vts" &&
           folder_of(file.at) == pieces.at;
}

bool collide(const Placed& one, const Placed& other) {
    if (is_piece(one, other) || is_piece(other, one)) return true;
    if (one.at != other.at) return exists_and_is(one.at, other.at);
    const auto may_be_shared = FileUse::Kind::folder;
    return one.use->kind != may_be_shared || other.use->kind != may_be_shared;
}

void find_collisions(const std::vector<Placed>& outputs, std::vector<FileFault>& faults) {
    for (auto later = outputs.begin(); later != outputs.end(); ++later) {
        const auto earlier = std::find_if(outputs.begin(), later,
                                          [&](const Placed& one) { return collide(one, *later); });
        if (earlier == later) continue;
        const FileUse& one = *earlier->use;
        const FileUse& other = *later->use;
        const std::string message =
            fmt::format("two outputs would be written to '{}': {} and {}", other.path.string(),
                        described(one), described(other));
        const bool later_is_placed = other.place.file != nullptr;
        faults.push_back({message, later_is_placed ? other : one, later_is_placed ? one : other});
    }
}

void find_overwritten(const Placed& output, const std::vector<FileUse>& read,
                      std::vector<FileFault>& faults) {
    const auto input = std::find_if(read.begin(), read.end(), [&](const FileUse& use) {
        return exists_and_is(output.at, use.path);
    });
    if (input == read.end()) return;
    const std::string named =
        input->place.file == nullptr
            ? ""
            : fmt::format(", which {}:{} names", input->place.file->name, input->place.line);
    faults.push_back(
        {fmt::format("{} would overwrite {}{}", described(*output.use), described(*input), named),
         *output.use, *input});
}

}  // namespace

std::vector<FileFault> file_faults(const FileUses& uses) {
    std::vector<FileFault> faults;
    Places places(faults);
    for (const FileUse& use : uses.written) places.add(use);
    find_collisions(places.all(), faults);
    for (const Placed& output : places.all()) find_overwritten(output, uses.read, faults);
    return faults;
}

void refuse(const std::vector<FileFault>& faults) {
    Diagnostics diagnostics;
    for (const FileFault& fault : faults) {
        if (fault.output.place.file == nullptr) continue;
        Diagnostic& told =
            diagnostics.error(fault.output.place, fault.message,
                              "paths of outputs are those of the folder in which hexweave runs");
        if (fault.other.place.file != nullptr) {
            told.notes.push_back({fault.other.place, "the other is named here"});
        }
    }
    if (diagnostics.has_errors()) throw InputError(std::move(diagnostics));
    if (!faults.empty()) throw UsageError(faults.front().message);
}

}  // namespace hexweave
