// SPDX-License-Identifier: Apache-2.0
// The JSON Schema of the format, judged by a validator that we did not write (python3-jsonschema).
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "tests/commands/program.h"
#include "topology/format_table.h"

using namespace hexweave::testing;
namespace fs = std::filesystem;

namespace {

/// Every config of a folder, quoted for the shell.
std::string configs_of(const std::string& folder) {
    std::string list;
    for (const auto& entry : fs::directory_iterator(HEXWEAVE_SOURCE_DIR "/" + folder)) {
        if (entry.path().extension() == ".yaml") list += " '" + entry.path().string() + "'";
    }
    return list;
}

/// The validator's lines about these files; nothing where it is not installed.
std::string verdicts(const Scratch& scratch, const std::string& files) {
    REQUIRE(scratch.shell("'" HEXWEAVE_PROGRAM "' schema >schema.json").exit_code == 0);
    const Finished check = scratch.shell("/usr/bin/python3 '" HEXWEAVE_SOURCE_DIR
                                         "/tests/tools/schema_check.py' schema.json " +
                                         files);
    if (check.exit_code == 77 || check.exit_code == 127) {
        WARN("skipped: python3-jsonschema and python3-yaml are not installed");
        return {};
    }
    INFO(check.err);
    REQUIRE(check.exit_code == 0);
    return check.out;
}

}  // namespace

TEST_CASE("every good config is valid by the schema") {
    for (const char* folder : {"configs", "tests/cases/good"}) {
        const Scratch scratch;
        std::istringstream lines(verdicts(scratch, configs_of(folder)));
        for (std::string line; std::getline(lines, line);) {
            INFO(line);
            CHECK(line.starts_with("valid "));
        }
    }
}

TEST_CASE("a config whose shape is wrong is not valid by the schema") {
    // What the reader says of a shape; references, values and files are no matter of a schema.
    const std::regex of_shape(
        "(unknown key|lacks the key|is not a valid [a-z]+ name|must be (a mapping|a list|a "
        "name|one "
        "of|true or false)|cannot be ')");
    const Scratch scratch;
    std::istringstream lines(verdicts(scratch, configs_of("tests/cases/bad")));
    int wrong = 0;
    for (std::string line; std::getline(lines, line);) {
        INFO(line);
        const std::size_t name = line.find(".yaml");
        const std::size_t begin = line.rfind(' ', name) + 1;
        const std::string stem = line.substr(begin, name - begin);
        std::istringstream told(slurp(HEXWEAVE_SOURCE_DIR "/tests/cases/bad/" + stem + ".txt"));
        bool shape_is_wrong = false;
        for (std::string message; std::getline(told, message);) {
            shape_is_wrong |=
                message.starts_with(stem + ".yaml:") && std::regex_search(message, of_shape);
        }
        if (!shape_is_wrong) continue;
        ++wrong;
        CHECK(!line.starts_with("valid "));
        CHECK(!line.starts_with("disagree"));
    }
    CHECK((lines.str().empty() || wrong > 20));
}

TEST_CASE("each structural fault alone makes a config invalid") {
    const Scratch scratch;
    std::string files;
    int count = 0;
    const auto add = [&](const std::string& yaml) {
        files += " " + scratch.write("f" + std::to_string(++count) + ".yaml",
                                     "hexweave: 1\n" + yaml + "\n");
    };
    add("vertices: {a: [0, 0], c: {curve: k, at: 1e-1}}");
    add("parameters: {wall: 1e-5, far: 20 * wall, m: \"max(wall, far)\"}");
    const int good = count;
    add("vertices: {a: [0, 0], b: [1]}");
    add("vertices: {a: [\"0,5\", 0]}");
    add("vertices: {2a: [0, 0]}");
    add("vertices: {y: [0, 0]}");
    add("edges: {e: {from: a, to: b, cells: 10.5}}");
    add("edges: {e: {from: a, to: b, cells: 0}}");
    add("edges: {e: {from: a, to: b, celss: 10}}");
    add("edges: {e: {from: a}}");
    add("edges: {e: {from: a, to: b, spacing: {start: -1}}}");
    add("faces: {f: {corners: [a, b, c]}}");
    add("vertices: {c: {surface: s, at: [0, 1], near: [0, 0]}}");
    add("curves: {c: {circle: {center: [0, 0], radius: 1}, line: [[0, 0], [1, 1]]}}");
    add("boundaries: {w: {type: BCWal, sides: e}}");
    add("solver: {start: yes}");
    std::istringstream lines(verdicts(scratch, files));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        INFO(line << "\n" << scratch.read("f" + std::to_string(number + 1) + ".yaml"));
        CHECK(line.starts_with(++number <= good ? "valid " : "invalid "));
    }
}

TEST_CASE("the schema has every key of the table, with its meaning and an example") {
    const Scratch scratch;
    const nlohmann::json schema = nlohmann::json::parse(scratch.hexweave("schema").out);
    CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
    for (const hexweave::MappingFormat& format : hexweave::format_table()) {
        const nlohmann::json& mapping =
            format.name == "case" ? schema : schema["$defs"][std::string(format.name)];
        INFO(format.name);
        CHECK(mapping["additionalProperties"] == false);
        for (const hexweave::KeyFormat& key : format.keys) {
            INFO(key.key);
            const nlohmann::json& property = mapping["properties"][std::string(key.key)];
            CHECK(!property["description"].get<std::string>().empty());
            CHECK(!property["examples"][0].is_null());
        }
    }
    CHECK(schema["$defs"]["held_height"]["properties"]["fade"]["default"] == 0.03);
    CHECK(schema["$defs"]["spacing"]["properties"]["law"]["default"] == "tanh");
}
