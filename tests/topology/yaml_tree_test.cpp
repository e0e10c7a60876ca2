// SPDX-License-Identifier: Apache-2.0
#include "topology/yaml_tree.h"

#include <catch2/catch.hpp>

using namespace hexweave;

namespace {

struct Parsed {
    std::optional<YamlNode> root;
    Diagnostics diagnostics;
};

Parsed parse(const std::string& text) {
    Parsed result;
    result.root = read_yaml(std::make_shared<const SourceFile>(SourceFile{"f.yaml", text}),
                            result.diagnostics);
    return result;
}

YamlNode parse_good(const std::string& text) {
    Parsed parsed = parse(text);
    INFO(render(parsed.diagnostics));
    REQUIRE(parsed.diagnostics.all().empty());
    REQUIRE(parsed.root);
    return *parsed.root;
}

const YamlNode& at(const YamlNode& node, const std::string& key) {
    const YamlNode* found = node.find(key);
    REQUIRE(found != nullptr);
    return *found;
}

/// line:column+length
std::string where(const Place& place) {
    return std::to_string(place.line) + ":" + std::to_string(place.column) + "+" +
           std::to_string(place.length);
}

/// line:column: message, of the only diagnostic.
std::string fault(const std::string& text) {
    const Parsed parsed = parse(text);
    REQUIRE(parsed.diagnostics.all().size() == 1);
    const Diagnostic& d = parsed.diagnostics.all().front();
    return std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message;
}

}  // namespace

TEST_CASE("every node knows its kind, its text and its place") {
    const YamlNode root = parse_good("a: 1\nbc: \"x y\"\nd: [u, {v: 'w'}]\ne:\nf: ~\n");
    CHECK(root.is_mapping());
    CHECK(where(at(root, "a").place) == "1:4+1");
    CHECK(where(at(root, "bc").key_place) == "2:1+2");
    CHECK(where(at(root, "bc").place) == "2:5+5");
    CHECK(at(root, "bc").text == "x y");
    CHECK(at(root, "bc").quoted);
    CHECK(at(root, "bc").text_column == 6);
    const YamlNode& list = at(root, "d");
    REQUIRE(list.is_sequence());
    CHECK(where(list.place) == "3:4+1");
    CHECK(where(list.children[0].place) == "3:5+1");
    CHECK(where(at(list.children[1], "v").place) == "3:12+3");
    CHECK(at(root, "e").is_null());
    CHECK(where(at(root, "e").place) == "4:1+1");
    CHECK(where(at(root, "f").place) == "5:4+1");
    CHECK(root.find("g") == nullptr);
}

TEST_CASE("columns count characters behind multibyte ones, in every kind of line end") {
    const YamlNode root = parse_good("\xEF\xBB\xBFgröße: ä\r\nb: [é, ü]\r\n");
    CHECK(where(at(root, "größe").key_place) == "1:1+5");
    CHECK(where(at(root, "größe").place) == "1:8+1");
    CHECK(where(at(root, "b").children[1].place) == "2:8+1");
}

TEST_CASE("a text that does not stand in the file as it is has no column of its own") {
    const YamlNode root = parse_good("a: 'it''s'\nb: \"\\x41\"\nc: |\n  1 +\n  2\nd: 1 +\n  2\n");
    CHECK(at(root, "a").text == "it's");
    CHECK(at(root, "a").text_column == 0);
    CHECK(where(at(root, "a").place) == "1:4+7");
    CHECK(at(root, "b").text == "A");
    CHECK(at(root, "b").text_column == 0);
    CHECK(at(root, "c").text == "1 +\n2\n");
    CHECK(at(root, "d").text == "1 + 2");
    CHECK(at(root, "d").text_column == 0);
}

TEST_CASE("an alias stands where it is used, what is inside of it where it was written") {
    const YamlNode root = parse_good("a: &x [1, 2]\nb: *x\nc: &y 3\nd: *y\n");
    CHECK(where(at(root, "b").place) == "2:4+2");
    CHECK(where(at(root, "b").children[1].place) == "1:11+1");
    CHECK(where(at(root, "c").place) == "3:7+1");
    CHECK(at(root, "d").text == "3");
    CHECK(where(at(root, "d").place) == "4:4+2");
}

TEST_CASE("keys given twice are all told and the first value is kept") {
    const Parsed parsed = parse("a: 1\nb: {x: 1, x: 2}\na: 3\n");
    REQUIRE(parsed.diagnostics.all().size() == 2);
    REQUIRE(parsed.root);
    CHECK(at(*parsed.root, "a").text == "1");
    const Diagnostic& d = parsed.diagnostics.all()[1];
    CHECK(d.message == "the key 'a' is given twice");
    CHECK(where(d.place) == "3:1+1");
    CHECK(where(d.notes.at(0).place) == "1:1+1");
}

TEST_CASE("what YAML parsers pass silently is an error with a place") {
    CHECK(fault("y: \"open\n") == "1:4: the quote that opens here is never closed");
    CHECK(fault("y: 'it''s\n\n") == "1:4: the quote that opens here is never closed");
    CHECK(fault("{a: 1} more\n") == "1:8: this does not belong to what stands before it");
    CHECK(fault("- 1\nb: 2\n") == "2:1: this does not belong to what stands before it");
    CHECK(fault("a: 1\n---\nb: 1\n") == "2:1: this does not belong to what stands before it");
    CHECK(fault("a:\n \tb: 1\n") == "2:2: a tab in the indentation");
    CHECK(fault("a: \xC3\n") == "1:4: byte 0xC3 is not valid UTF-8");
    CHECK(fault("ab: \xED\xA0\x80\n") == "1:5: byte 0xED is not valid UTF-8");
    CHECK(fault("a: \xC0\x80\n") == "1:4: byte 0xC0 is not valid UTF-8");
    CHECK(fault(std::string("a: 1\n\0b: 2\n", 11)) == "2:1: control character 0x00 in the text");
    CHECK(fault("a: 1\n\x04"
                "b: 2\n") == "2:1: control character 0x04 in the text");
    CHECK(fault("a: 1\rb: 2\n") == "1:5: control character 0x0D in the text");
    CHECK(fault("") == "0:0: the file is empty");
    CHECK(fault("\xEF\xBB\xBF") == "0:0: the file is empty");
    CHECK(fault("# nothing\n---\n") == "0:0: the file is empty");
    CHECK(fault("a: !!float 1\n") ==
          "1:4: YAML tags such as 'tag:yaml.org,2002:float' have no meaning here");
    CHECK(fault("? {a: 1}\n: 2\n") == "1:3: a key must be a name");
}

TEST_CASE("tabs between tokens, in comments and in blank lines are no fault") {
    const YamlNode root = parse_good("a:\t1\n#\tcomment\n\t\nb: 2\t# two\n");
    CHECK(at(root, "a").text == "1");
    CHECK(at(root, "b").text == "2");
}

TEST_CASE("an alias or anchor that was meant as text is told to be quoted") {
    CHECK(fault("cells: *n\n") == "1:8: '*n' is a YAML alias, but no anchor '&n' stands before it");
    CHECK(fault("cells: &n\n") == "1:8: '&' begins a YAML anchor, and nothing follows it");
    CHECK(fault("cells: * 2\n") == "1:8: '*' begins no text in YAML");
    CHECK(parse("cells: *n\n").diagnostics.all()[0].hint ==
          "a text that begins with '*' must be quoted");
    CHECK(at(parse_good("cells: \"*n\"\n"), "cells").text == "*n");
    CHECK(at(parse_good("cells: 2 * n & m\n"), "cells").text == "2 * n & m");
}

TEST_CASE("keys that are longer than YAML allows are told as such") {
    const std::string longest(1024, 'k');
    const std::string message = "this key has 1025 characters; YAML allows 1024";
    CHECK(at(parse_good("{" + longest + ": 1}\n"), longest).text == "1");
    CHECK(fault("a:\n  " + longest + "k: 1\n") == "2:3: " + message);
    CHECK(fault("- " + longest + "k: 1\n") == "1:3: " + message);
    CHECK(fault("{a: 1, " + longest + "k: 1}\n") == "1:8: " + message);
    CHECK(fault("a: b: c\n") == "1:5: not valid YAML: a ':' where no key can stand");
    CHECK(fault("{: 1}\n") == "1:2: a key must be a name");
}

TEST_CASE("anchors within anchors are copies, too") {
    std::string nested;
    for (int n = 0; n < 50; ++n) nested += "&a" + std::to_string(n) + " [";
    std::string list;
    for (int n = 0; n < 5000; ++n) list += "1, ";
    const std::string end(50, ']');
    CHECK(parse("a: " + nested + "1" + end + "\n").diagnostics.all().empty());
    CHECK(parse("a: " + nested + list + end + "\n").diagnostics.all().at(0).message ==
          "anchors and their aliases make this file too large");
    const std::string text = "a: &a " + std::string(100'000, 'x') + "\nb: [";
    CHECK(parse(text + "*a, *a]\n").diagnostics.all().empty());
    std::string many;
    for (int n = 0; n < 300; ++n) many += "*a, ";
    CHECK(parse(text + many + "1]\n").diagnostics.errors() == 1);
}

TEST_CASE("depth and the size of nested aliases have limits") {
    const std::string deep = "a: " + std::string(99, '[') + std::string(99, ']') + "\n";
    const std::string deeper = "a: " + std::string(100, '[') + std::string(100, ']') + "\n";
    parse_good(deep);
    CHECK(fault(deeper) == "1:103: nested more than 100 deep");

    std::string laughs = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (const char digit : std::string("123456789")) {
        const char before = static_cast<char>(digit - 1);
        laughs.append("a").append(1, digit).append(": &a").append(1, digit).append(" [");
        for (int n = 0; n < 10; ++n) laughs.append(n > 0 ? ", *a" : "*a").append(1, before);
        laughs.append("]\n");
    }
    CHECK(fault(laughs) == "5:9: anchors and their aliases make this file too large");
}
