// SPDX-License-Identifier: Apache-2.0
// Inputs that no user means: each is refused with one message, in bounded time and memory.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;

namespace {

std::string repeated(const std::string& part, std::size_t times) {
    std::string text;
    text.reserve(part.size() * times);
    for (std::size_t n = 0; n < times; ++n) text += part;
    return text;
}

std::size_t count_of(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

/// AddressSanitizer reserves more addresses than any limit allows.
#ifdef __SANITIZE_ADDRESS__
constexpr const char* limits = "";
#else
constexpr const char* limits = "ulimit -v 1000000; ";
#endif

Finished check(const Scratch& scratch, const std::string& config) {
    return scratch.shell(std::string(limits) + "timeout 100 '" HEXWEAVE_PROGRAM "' check " +
                         config);
}

void is_one_message(const Finished& run, const std::string& message) {
    INFO(run.err.substr(0, 4000));
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(count_of("error: ", run.err) == 1);
    CHECK(count_of(message, run.err) == 1);
    CHECK(run.err.size() < 4000);
}

/// A case is refused with one message that holds this text.
void refused(const std::string& text, const std::string& message) {
    const Scratch scratch;
    scratch.write("c.yaml", "hexweave: 1\n" + text);
    is_one_message(check(scratch, "c.yaml"), message);
}

const std::string square = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges: {south: {from: a, to: b, cells: 4}, west: {from: a, to: d, cells: 3}}
faces: {f: {corners: [a, b, c, d]}}
boundaries: {rim: {type: BCWall, sides: [south, west, b-c, c-d]}}
)";

}  // namespace

TEST_CASE("nesting without end is refused at the hundredth step") {
    const std::string message = "error: nested more than 100 deep";
    refused("a: " + std::string(20'000, '[') + std::string(20'000, ']') + "\n", message);
    refused("a: " + std::string(20'000, '[') + "\n", message);
    refused("a: " + repeated("{a: ", 20'000) + "1" + std::string(20'000, '}') + "\n", message);
    refused("a:\n" + repeated("- ", 20'000) + "1\n", message);
    refused(repeated("? ", 20'000) + "1\n", message);
    std::string blocks;
    for (std::size_t n = 0; n < 3'000; ++n) blocks += std::string(n, ' ') + "a:\n";
    refused(blocks, message);
}

TEST_CASE("what is too long for a case is told to be put into files of its own") {
    const std::string hint = "hint: put lists of points into files of their own";
    refused("# " + std::string(100'000'000, 'x') + "\n", hint);
    refused("a: [" + repeated("1,", 5'000'000) + "1]\n", hint);
    refused("a:\n" + repeated("- 1\n", 3'000'000), hint);
    refused("curves: {c: {spline: [" + repeated("[0,1],", 2'500'000) + "[1,1]]}}\n", hint);
}

TEST_CASE("what holds a long text but no case is read in a while") {
    refused(repeated("\n", 16'000'000), "the file describes no grid");
    refused(repeated("# a comment\n", 1'000'000), "the file describes no grid");
    refused("title: |\n" + repeated("  x\n", 3'000'000), "the file describes no grid");
}

TEST_CASE("aliases of aliases, and of long texts, are refused before they take memory") {
    std::string laughs = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (const char digit : std::string("123456789")) {
        const std::string before(1, static_cast<char>(digit - 1));
        laughs +=
            std::string("a") + digit + ": &a" + digit + " [" + repeated("*a" + before + ", ", 9);
        laughs += "*a" + before + "]\n";
    }
    const std::string message = "error: anchors and their aliases make this file too large";
    refused(laughs, message);
    refused("a: &a " + std::string(1'000'000, 'x') + "\nb: [" + repeated("*a, ", 100'000) + "*a]\n",
            message);
    std::string nested;
    for (int n = 0; n < 90; ++n) nested += "&a" + std::to_string(n) + " [";
    refused("a: " + nested + repeated("1,", 100'000) + std::string(90, ']') + "\n", message);
}

TEST_CASE("a name of ten thousand characters is told with its beginning") {
    const std::string name(10'000, 'n');
    const std::string key = "this key has 10000 characters; YAML allows 1024";
    refused("vertices:\n  " + name + ": [0, 0]\n", key);
    refused("vertices: {" + name + ": [0, 0]}\n", key);
    refused(name + ": 1\n", key);
    refused("vertices: {'" + name + "': [0, 0]}\n", "characters; YAML allows 1024");
    const std::string shown = "'" + std::string(57, 'n') + "...'";
    std::string use = square;
    refused(use.replace(use.find("from: a"), 7, "from: " + name), "unknown vertex " + shown);
    std::string parameter = square;
    refused(parameter.replace(parameter.find("[1, 1]"), 6, "[1, " + name + "]"),
            "unknown parameter " + shown);
}

TEST_CASE("expressions without end are refused") {
    const auto with = [](const std::string& expression) {
        std::string text = square;
        return text.replace(text.find("[1, 1]"), 6, "[1, '" + expression + "']");
    };
    const std::string message = "error: the expression is too long";
    refused(with(repeated("1+", 10'000) + "1"), message);
    refused(with(std::string(20'000, '(') + "1" + std::string(20'000, ')')), message);
    refused(with(std::string(20'000, '-') + "1"), message);
}

TEST_CASE("of a fault in every line the first two hundred are told") {
    const std::string end = "\nmore than 200 errors: what follows is not looked at\n";
    const Scratch scratch;
    scratch.write("c.yaml", "hexweave: 1\n" + repeated("a: 1\n", 200'000));
    const Finished twice = check(scratch, "c.yaml");
    CHECK(twice.exit_code == 2);
    CHECK(count_of("error: ", twice.err) == 200);
    CHECK(count_of(end, twice.err) == 1);

    std::string unknown = "hexweave: 1\nedges:\n";
    for (int n = 0; n < 40'000; ++n) unknown += "  e" + std::to_string(n) + ": {form: a, too: b}\n";
    scratch.write("c.yaml", unknown);
    const Finished misspelled = check(scratch, "c.yaml");
    CHECK(misspelled.exit_code == 2);
    CHECK(count_of("did you mean 'from'?", misspelled.err) > 50);
    CHECK(count_of("error: ", misspelled.err) == 200);
    CHECK(count_of(end, misspelled.err) == 1);

    std::string lost = "hexweave: 1\nvertices:\n";
    for (int n = 0; n < 15'000; ++n) lost += "  a" + std::to_string(n) + ": [0, 0]\n";
    lost += "edges:\n";
    for (int n = 0; n < 15'000; ++n) {
        lost += "  e" + std::to_string(n) + ": {from: b" + std::to_string(n) + ", to: c}\n";
    }
    scratch.write("c.yaml", lost);
    CHECK(count_of(end, check(scratch, "c.yaml").err) == 1);
}

TEST_CASE("components within components have an end") {
    std::string chain = "components:\n";
    std::string tree = "components:\n";
    for (int n = 0; n < 1'000; ++n) {
        const std::string next = std::to_string(n + 1);
        const std::string head = "  c" + std::to_string(n) + ": {instances: {a: {of: c" + next;
        chain += head + "}}}\n";
        if (n < 19) tree += head + "}, b: {of: c" + next + "}, c: {of: c" + next + "}}}\n";
    }
    refused(chain + "  c1000: {vertices: {v: [0, 0]}}\ninstances: {top: {of: c0}}\n" + square,
            "instances within instances are more than 20 deep");
    refused(tree + "  c19: {vertices: {v: [0, 0]}}\ninstances: {top: {of: c0}}\n" + square,
            "with this instance the case is too large");
}

TEST_CASE("what is no text is no case") {
    const Scratch scratch;
    const auto told = [&](const std::string& text, const std::string& message) {
        scratch.write("c.yaml", text);
        is_one_message(check(scratch, "c.yaml"), message);
    };
    told(std::string(1'000'000, '\0'), "c.yaml:1:1: error: control character 0x00 in the text");
    told(
        "\x7F"
        "ELF\x02\x01\x01",
        "c.yaml:1:1: error: control character 0x7F in the text");
    told("\xFF\xFEh\0e\0x\0", "c.yaml:1:1: error: byte 0xFF is not valid UTF-8");
    told(std::string(1'000'000, '\t'), "c.yaml: error: the file is empty");
    is_one_message(check(scratch, "/dev/zero"), "a case may have");
    is_one_message(check(scratch, "/dev/null"), "the file is empty");
    is_one_message(check(scratch, "."), "cannot read '.': it is a folder");
}

TEST_CASE("a case may come through a pipe, but not what it names") {
    const Scratch scratch;
    scratch.write("c.yaml", "hexweave: 1" + square);
    const Finished good =
        scratch.shell("mkfifo pipe && (cat c.yaml >pipe &) && '" HEXWEAVE_PROGRAM "' check pipe");
    INFO(good.err);
    CHECK(good.exit_code == 0);
    scratch.write("c.yaml", "hexweave: 1\ninclude: pipe\n" + square);
    is_one_message(check(scratch, "c.yaml"), "the file 'pipe' cannot be read: it is not a file");
}

TEST_CASE("names of files that are not UTF-8 are shown as they can be") {
    const Scratch scratch;
    const Finished run = scratch.hexweave("check \"$(printf 'no\\377.yaml')\" --json out.json");
    CHECK(run.exit_code == 2);
    const auto json = nlohmann::json::parse(scratch.read("out.json"));
    CHECK(json["exit_code"] == 2);
}
