// SPDX-License-Identifier: Apache-2.0
// The house stays as drawn: dependencies run one way, third parties stay in their rooms.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file;  // relative to src
    std::string target;
    bool quoted = false;
};

std::vector<Include> all_includes() {
    const fs::path src = fs::path(HEXWEAVE_SOURCE_DIR) / "src";
    const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        std::ifstream stream(entry.path());
        std::string line;
        while (std::getline(stream, line)) {
            std::smatch match;
            if (!std::regex_search(line, match, pattern)) continue;
            found.push_back({fs::relative(entry.path(), src).string(), match[2], match[1] == "\""});
        }
    }
    return found;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.find('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
}

const std::map<std::string, std::set<std::string>> may_include{
    {"core", {}},
    {"geometry", {"core"}},
    {"elliptic", {"core"}},
    {"topology", {"core", "geometry"}},
    {"edges", {"core", "geometry", "topology"}},
    {"faces", {"core", "geometry", "topology", "edges", "elliptic"}},
    {"blocks", {"core", "topology", "edges", "faces", "elliptic"}},
    {"quality", {"core", "topology", "edges", "faces", "blocks", "elliptic"}},
    {"io", {"core", "geometry", "topology", "edges", "faces", "blocks", "quality", "elliptic"}},
};

// Third-party headers by prefix, and where they may stand.
const std::map<std::string, std::string> third_party_rooms{
    {"omp.h", "core/parallel.h"}, {"yaml-cpp/", "topology/"}, {"muParser", "topology/"},
    {"cgnslib.h", "io/cgns"},     {"hdf5.h", "io/cgns"},      {"H5", "io/cgns"},
    {"cairo", "io/picture"},      {"nlohmann/", "io/"},       {"CLI/", ""},
};

}  // namespace

TEST_CASE("a folder includes only what stands before it in the pipeline") {
    const std::vector<Include> includes = all_includes();
    REQUIRE(includes.size() > 100);
    for (const Include& include : includes) {
        const std::string folder = folder_of(include.file);
        if (!include.quoted || may_include.count(folder) == 0) continue;
        const std::string target = folder_of(include.target);
        INFO(include.file << " includes " << include.target);
        CHECK((target == folder || may_include.at(folder).count(target) == 1));
    }
}

TEST_CASE("third-party libraries stay in their rooms") {
    for (const Include& include : all_includes()) {
        if (include.quoted) continue;
        for (const auto& [prefix, room] : third_party_rooms) {
            if (include.target.rfind(prefix, 0) != 0) continue;
            INFO(include.file << " includes <" << include.target << ">");
            if (prefix == "CLI/") {
                const std::string folder = folder_of(include.file);
                CHECK((folder.empty() || folder == "commands"));
            } else {
                CHECK(include.file.rfind(room, 0) == 0);
            }
        }
    }
}

TEST_CASE("Open CASCADE stays in the module that reads CAD files") {
    std::size_t found = 0;
    for (const Include& include : all_includes()) {
        if (include.quoted || fs::path(include.target).extension() != ".hxx") continue;
        ++found;
        INFO(include.file << " includes <" << include.target << ">");
        CHECK(include.file.rfind("geometry/cad_", 0) == 0);
    }
    CHECK(found > 10);
    // Its own headers do not leave the module either.
    const std::set<std::string> inside{"geometry/cad_nurbs.h", "geometry/cad_readers.h",
                                       "geometry/cad_shapes.h"};
    for (const Include& include : all_includes()) {
        if (inside.count(include.target) == 0) continue;
        INFO(include.file << " includes " << include.target);
        CHECK(include.file.rfind("geometry/cad_", 0) == 0);
    }
}

TEST_CASE("main stays under a hundred lines") {
    std::ifstream stream(fs::path(HEXWEAVE_SOURCE_DIR) / "src" / "main.cpp");
    int lines = 0;
    for (std::string line; std::getline(stream, line);) ++lines;
    CHECK(lines > 10);
    CHECK(lines < 100);
}

// One namespace holds them all: two types of one name in it are one to the linker, which takes the
// functions of either for both, whatever they hold.
TEST_CASE("no two headers define a type of the same name") {
    const fs::path src = fs::path(HEXWEAVE_SOURCE_DIR) / "src";
    const std::regex pattern(R"(^(?:struct|class|enum class)\s+(\w+)\s*(?::[^:;]*)?\{)");
    std::map<std::string, std::string> defined;
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
        if (entry.path().extension() != ".h") continue;
        const std::string file = fs::relative(entry.path(), src).string();
        std::ifstream stream(entry.path());
        std::string line;
        while (std::getline(stream, line)) {
            std::smatch match;
            if (!std::regex_search(line, match, pattern)) continue;
            const auto [first, is_new] = defined.emplace(match[1], file);
            INFO(match[1] << " in " << first->second << " and " << file);
            CHECK(is_new);
        }
    }
    CHECK(defined.size() > 100);
}
