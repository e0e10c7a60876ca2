// SPDX-License-Identifier: Apache-2.0
#include "core/diagnostics.h"

#include <catch2/catch.hpp>

using namespace hexweave;

namespace {

Place place(const std::string& text, int line, int column, int length = 1) {
    return {std::make_shared<const SourceFile>(SourceFile{"wing.yaml", text}), line, column,
            length};
}

std::string shown(const Place& where) {
    Diagnostics diagnostics;
    diagnostics.error(where, "wrong");
    return render(diagnostics);
}

}  // namespace

TEST_CASE("an error shows its place, its line, a caret and a hint") {
    Diagnostics diagnostics;
    diagnostics.error(place("edges:\n  wake: {from: te, celss: 3}\n", 2, 20, 5),
                      "unknown key 'celss'", "did you mean 'cells'?");
    CHECK(render(diagnostics) ==
          "wing.yaml:2:20: error: unknown key 'celss'\n"
          "  wake: {from: te, celss: 3}\n"
          "                   ^~~~~\n"
          "  hint: did you mean 'cells'?\n");
}

TEST_CASE("a message on a text that is used from elsewhere says from where") {
    const std::string text = "components:\n  section: {c: 0}\ninstances:\n  slat: {}\n  flap: {}\n";
    const auto inside = [&](int user_line) {
        Place where = place(text, 2, 13, 4);
        where.used_by = std::make_shared<const Note>(
            Note{place(text, user_line, 3, 4), "in instance, written here"});
        return where;
    };
    Diagnostics diagnostics;
    Diagnostic& d = diagnostics.error(inside(4), "wrong");
    d.notes.push_back({inside(5), "differs from"});
    CHECK(render(diagnostics) ==
          "wing.yaml:2:13: error: wrong\n"
          "  section: {c: 0}\n"
          "            ^~~~\n"
          "wing.yaml:4:3: note: in instance, written here\n"
          "  slat: {}\n"
          "  ^~~~\n"
          "wing.yaml:2:13: note: differs from\n"
          "  section: {c: 0}\n"
          "            ^~~~\n"
          "wing.yaml:5:3: note: in instance, written here\n"
          "  flap: {}\n"
          "  ^~~~\n");
}

TEST_CASE("what is wrong in a text that is used several times is told once") {
    const std::string text =
        "components:\n  section: {c: 0}\ninstances:\n  slat: {}\n  flap: {}\n  tab: {}\n";
    const auto tell = [&](Diagnostics& diagnostics, int user_line, const std::string& user) {
        Place where = place(text, 2, 13, 4);
        where.used_by = std::make_shared<const Note>(
            Note{place(text, user_line, 3, 4), "in '" + user + "', written here", user + "."});
        diagnostics.error(where, "unknown curve '" + user + ".c', no " + user + "x.c",
                          "did you mean '" + user + ".d'?");
    };
    Diagnostics diagnostics;
    tell(diagnostics, 4, "slat");
    tell(diagnostics, 5, "flap");
    diagnostics.sort();
    CHECK(diagnostics.errors() == 2);  // slatx.c and flapx.c are other names
    CHECK(diagnostics.all().front().hint == "did you mean 'd'?");

    Diagnostics same;
    for (const auto& [line, user] :
         {std::pair(4, "slat"), std::pair(5, "flap"), std::pair(6, "tab")}) {
        Place where = place(text, 2, 13, 4);
        where.used_by = std::make_shared<const Note>(
            Note{place(text, line, 3, 4), std::string("in '") + user + "', written here",
                 std::string(user) + "."});
        same.error(where, std::string("edge '") + user + ".a-" + user + ".b' is lost");
    }
    same.sort();
    CHECK(render(same) ==
          "wing.yaml:2:13: error: edge 'slat.a-slat.b' is lost\n"
          "  section: {c: 0}\n"
          "            ^~~~\n"
          "wing.yaml:4:3: note: in 'slat', written here\n"
          "  slat: {}\n"
          "  ^~~~\n"
          "wing.yaml:5:3: note: and in 'flap' and 1 more\n"
          "  flap: {}\n"
          "  ^~~~\n");
}

TEST_CASE("of very many warnings the first are kept, and very many errors end the work") {
    Diagnostics diagnostics;
    for (int n = 1; n <= 1000; ++n) {
        diagnostics.warning(place("a\n", 1, n), "warned " + std::to_string(n))
            .notes.push_back({place("a\n", 1, 1), "seen"});
    }
    CHECK(diagnostics.warnings() == 1000);
    CHECK(diagnostics.all().size() == Diagnostics::most_kept);
    CHECK_FALSE(diagnostics.has_errors());
    for (int n = 200; n >= 1; --n) diagnostics.error(place("a\n", 1, n), "wrong");
    CHECK(diagnostics.errors() == 200);
    CHECK(diagnostics.left_out() == 800);
    try {
        diagnostics.error(place("a\n", 1, 999), "wrong");
        FAIL("no end of errors");
    } catch (const InputError& error) {
        CHECK(error.diagnostics.errors() == 201);
        CHECK(error.diagnostics.all().size() == 2 * Diagnostics::most_kept);
        CHECK(error.diagnostics.all().front().place.column == 1);
        const std::string text = render(error.diagnostics);
        CHECK(text.find("warned 200\n") != std::string::npos);
        CHECK(text.find("warned 201\n") == std::string::npos);
        CHECK(text.find(":999:") == std::string::npos);
        CHECK(text.find("\nand 800 more warnings\n") != std::string::npos);
    }
}

TEST_CASE("of a message without end the middle is left out, between characters") {
    Diagnostics diagnostics;
    std::string name;
    for (int n = 0; n < 5000; ++n) name += "é";
    const Diagnostic& d = diagnostics.error({}, "unknown '" + name + "'!", name);
    CHECK(d.message.size() < 1010);
    CHECK(d.message.substr(0, 13) == "unknown 'éé");
    CHECK(d.message.substr(d.message.size() - 6) == "éé'!");
    CHECK(d.message.find("é ... é") != std::string::npos);
    CHECK(d.hint.size() < 1010);
}

TEST_CASE("a warning says so and notes stand before the hint") {
    const Place first = place("a: 1\nb: 2\na: 3\n", 1, 1);
    const Place again = place("a: 1\nb: 2\na: 3\n", 3, 1);
    Diagnostics diagnostics;
    Diagnostic& d = diagnostics.warning(again, "'a' is given twice", "remove one");
    d.notes.push_back({first, "first given here"});
    CHECK(render(diagnostics) ==
          "wing.yaml:3:1: warning: 'a' is given twice\n"
          "a: 3\n"
          "^\n"
          "wing.yaml:1:1: note: first given here\n"
          "a: 1\n"
          "^\n"
          "  hint: remove one\n");
    CHECK_FALSE(diagnostics.has_errors());
    CHECK(diagnostics.warnings() == 1);
}

TEST_CASE("a place without a line is the file, one without a column the line") {
    CHECK(shown(place("a\n", 0, 0)) == "wing.yaml: error: wrong\n");
    CHECK(shown(place("a\nb\n", 2, 0)) == "wing.yaml:2: error: wrong\nb\n");
    CHECK(shown({}) == "error: wrong\n");
}

TEST_CASE("the caret stands under its character after tabs and multibyte characters") {
    CHECK(shown(place("\tab\tc", 1, 5)) == "wing.yaml:1:5: error: wrong\n\tab\tc\n\t  \t^\n");
    CHECK(shown(place("größe: x", 1, 8)) == "wing.yaml:1:8: error: wrong\ngröße: x\n       ^\n");
    // Two columns for a wide character, none for a combining accent.
    CHECK(shown(place("翼: x", 1, 4)) == "wing.yaml:1:4: error: wrong\n翼: x\n    ^\n");
    CHECK(shown(place("e\xCC\x81: x", 1, 5)) ==
          "wing.yaml:1:5: error: wrong\ne\xCC\x81: x\n   ^\n");
}

TEST_CASE("the underline ends with the line and may stand just behind it") {
    CHECK(shown(place("abc\n", 1, 2, 9)) == "wing.yaml:1:2: error: wrong\nabc\n ^~\n");
    CHECK(shown(place("abc\n", 1, 4)) == "wing.yaml:1:4: error: wrong\nabc\n   ^\n");
    CHECK(shown(place("abc\n", 7, 1)) == "wing.yaml:7:1: error: wrong\n\n^\n");
}

TEST_CASE("line breaks, byte order marks, control characters and broken UTF-8 are not shown") {
    CHECK(shown(place("\xEF\xBB\xBF"
                      "ab\r\ncd\r\n",
                      1, 2)) == "wing.yaml:1:2: error: wrong\nab\n ^\n");
    CHECK(shown(place("a\x1B[31mb\xFF"
                      "c\n",
                      1, 8)) == "wing.yaml:1:8: error: wrong\na?[31mb?c\n       ^\n");
}

TEST_CASE("of a very long line only the surroundings of the caret are shown") {
    const std::string text = std::string(500, 'a') + "X" + std::string(500, 'b');
    CHECK(shown(place(text, 1, 501)) == "wing.yaml:1:501: error: wrong\n..." +
                                            std::string(59, 'a') + "X" + std::string(60, 'b') +
                                            "...\n" + std::string(62, ' ') + "^\n");
    CHECK(shown(place(text, 1, 1)) ==
          "wing.yaml:1:1: error: wrong\n" + std::string(120, 'a') + "...\n^\n");
}

TEST_CASE("sorting goes file by file, then by place, and drops repetitions") {
    const std::string text = "one\ntwo\nthree\n";
    const Place set{std::make_shared<const SourceFile>(SourceFile{"--set", "n=1"}), 1, 1, 1};
    Diagnostics diagnostics;
    diagnostics.error(place(text, 3, 1), "c");
    diagnostics.error(set, "set");
    diagnostics.error(place(text, 1, 2), "b");
    diagnostics.warning(place(text, 1, 1), "a");
    diagnostics.error(place(text, 3, 1), "c");
    diagnostics.error(place(text, 3, 1), "d");
    diagnostics.sort();
    std::string order;
    for (const Diagnostic& d : diagnostics.all()) order += d.message + ' ';
    CHECK(order == "a b c d set ");
    CHECK(diagnostics.errors() == 4);
    CHECK(diagnostics.warnings() == 1);
}

TEST_CASE("the nearest name is near: within a third of the length and three edits") {
    const std::vector<std::string> known{"cells", "spacing", "along", "through"};
    CHECK(nearest_name("celss", known) == "cells");
    CHECK(nearest_name("Spacing", known) == "spacing");
    CHECK(nearest_name("trough", known) == "through");
    CHECK(nearest_name("a", known).empty());
    CHECK(nearest_name("cxyls", known).empty());
    CHECK(nearest_name("", known).empty());
    CHECK(nearest_name("spacnig", known) == "spacing");
    CHECK(nearest_name(std::string(100'000, 's'), known).empty());
    CHECK(nearest_name("celss", std::vector<std::string>(30'000, "cells")).empty());
    CHECK(nearest_name("bcwallviscous", {"BCWall", "BCWallViscous"}) == "BCWallViscous");
    CHECK(nearest_name("orthogonality_of_all", {"orthxgxnxlxty_of_all"}).empty());
}
