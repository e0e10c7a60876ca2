// SPDX-License-Identifier: Apache-2.0
#include "topology/read_data_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

namespace hexweave {

namespace {

constexpr std::uintmax_t largest_file = 256U << 20U;

/// Why a path cannot be read as a data file; empty when it can.
std::string unreadable(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return error ? error.message() : "there is no such file";
    if (!std::filesystem::is_regular_file(status)) return "it is not a file";
    if (std::filesystem::file_size(path, error) > largest_file) return "it is too large";
    return {};
}

constexpr const char* points_hint =
    "each line holds the x, y and, where wanted, z of a point; what follows a '#' is skipped";

/// The file of a folder whose name is most like another; empty where none is.
std::string nearest_file(const std::filesystem::path& folder, const std::string& name) {
    constexpr std::size_t most_looked_at = 10'000;
    std::vector<std::string> names;
    std::error_code error;
    std::filesystem::directory_iterator file(folder.empty() ? "." : folder, error);
    for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
        if (file->is_regular_file(error)) names.push_back(file->path().filename().string());
        if (names.size() >= most_looked_at) break;
    }
    std::sort(names.begin(), names.end());
    return nearest_name(name, names);
}

/// What may be meant by a path that cannot be read, or where it was looked for.
std::string hint_for_path(const std::string& written, const std::filesystem::path& path) {
    const std::string nearest = nearest_file(path.parent_path(), path.filename().string());
    if (!nearest.empty() && nearest != path.filename().string()) {
        const std::filesystem::path meant = std::filesystem::path(written).parent_path() / nearest;
        return fmt::format("did you mean '{}'?", shown(meant.string()));
    }
    const std::string tried =
        path.string() == written ? "" : fmt::format("; this one would be '{}'", path.string());
    return "files are looked for relative to the folder of the file that names them" + tried;
}

/// The numbers of one line; nothing where something else stands in it.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
    std::vector<double> numbers;
    line = line.substr(0, line.find('#'));
    while (true) {
        const std::size_t first = line.find_first_not_of(" \t\r,;");
        if (first == std::string_view::npos) return numbers;
        line.remove_prefix(first + (line[first] == '+' ? 1 : 0));
        double value = 0;
        const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
        if (!line.empty() &&
            std::string_view(" \t\r,;").find(line.front()) == std::string_view::npos) {
            return std::nullopt;
        }
        numbers.push_back(value);
    }
}

}  // namespace

std::filesystem::path path_of_file(const YamlNode& node) {
    std::filesystem::path path(node.text);
    if (path.is_absolute() || !node.place.file || node.place.file->name == "<stdin>") return path;
    return std::filesystem::path(node.place.file->name).parent_path() / path;
}

std::shared_ptr<const SourceFile> read_data_file(Reading& reading, const YamlNode& node,
                                                 const std::string& what) {
    const std::optional<std::string> written = read_text(reading, node, what);
    if (!written) return nullptr;
    const std::filesystem::path path = path_of_file(node);
    std::string reason = unreadable(path);
    if (reason.empty()) {
        std::ifstream stream(path, std::ios::binary);
        std::ostringstream contents;
        contents << stream.rdbuf();
        if (stream) {
            reading.files.push_back({path.string(), node.place});
            return std::make_shared<SourceFile>(SourceFile{*written, contents.str()});
        }
        reason = std::strerror(errno);
    }
    reading.diagnostics.error(
        node.place, fmt::format("the file '{}' cannot be read: {}", shown(*written), reason),
        hint_for_path(*written, path));
    return nullptr;
}

void tell_file_fault(Reading& reading, const YamlNode& node,
                     const std::shared_ptr<const SourceFile>& file, const std::string& fault,
                     int line, const std::string& hint) {
    Diagnostic& d = reading.diagnostics.error(
        node.place, fmt::format("in the file '{}': {}", shown(file->name), fault), hint);
    if (line > 0) d.notes.push_back({{file, line, 0, 1}, "here"});
}

std::optional<std::vector<Vec3>> read_point_file(Reading& reading, const YamlNode& node,
                                                 const std::string& what) {
    const std::shared_ptr<const SourceFile> file = read_data_file(reading, node, what);
    if (!file) return std::nullopt;
    std::vector<Vec3> points;
    std::istringstream lines(file->text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const std::optional<std::vector<double>> numbers = numbers_of(line);
        if (numbers && numbers->empty()) continue;
        if (!numbers || numbers->size() < 2 || numbers->size() > 3) {
            tell_file_fault(reading, node, file, "a line must hold two or three numbers", number,
                            points_hint);
            return std::nullopt;
        }
        points.push_back({(*numbers)[0], (*numbers)[1], numbers->size() == 3 ? (*numbers)[2] : 0});
    }
    if (!points.empty()) return points;
    tell_file_fault(reading, node, file, "there are no points", 0, points_hint);
    return std::nullopt;
}

}  // namespace hexweave
