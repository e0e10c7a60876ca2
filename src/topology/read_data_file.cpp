// SPDX-License-Identifier: Apache-2.0
#include "topology/read_data_file.h"

#include <fmt/format.h>

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
        if (stream) return std::make_shared<SourceFile>(SourceFile{*written, contents.str()});
        reason = std::strerror(errno);
    }
    reading.diagnostics.error(
        node.place, fmt::format("the file '{}' cannot be read: {}", shown(*written), reason),
        "files are looked for relative to the folder of the file that names them");
    return nullptr;
}

void tell_file_fault(Reading& reading, const YamlNode& node,
                     const std::shared_ptr<const SourceFile>& file, const std::string& fault,
                     int line) {
    Diagnostic& d = reading.diagnostics.error(
        node.place, fmt::format("in the file '{}': {}", shown(file->name), fault));
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
            tell_file_fault(reading, node, file, "a line must hold two or three numbers", number);
            return std::nullopt;
        }
        points.push_back({(*numbers)[0], (*numbers)[1], numbers->size() == 3 ? (*numbers)[2] : 0});
    }
    if (!points.empty()) return points;
    tell_file_fault(reading, node, file, "there are no points", 0);
    return std::nullopt;
}

}  // namespace hexweave
