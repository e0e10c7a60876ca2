// SPDX-License-Identifier: Apache-2.0
// The reference that the program prints, and its copy in docs/. That every example in it is read
// without a fault is held by tests/topology/format_table_test.cpp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "tests/commands/program.h"
#include "topology/format_table.h"

using namespace hexweave::testing;

TEST_CASE("docs/reference.md is what the program prints") {
    const Scratch scratch;
    const Finished docs = scratch.hexweave("docs");
    CHECK(docs.exit_code == 0);
    INFO("to renew it: hexweave docs > docs/reference.md");
    CHECK((docs.out == slurp(HEXWEAVE_SOURCE_DIR "/docs/reference.md")));
}

TEST_CASE("the reference has every key of every mapping, with its example") {
    const Scratch scratch;
    const std::string reference = scratch.hexweave("docs").out;
    for (const hexweave::MappingFormat& format : hexweave::format_table()) {
        std::string title(format.name);
        for (char& c : title) c = c == '_' ? ' ' : c;
        INFO(format.name);
        const std::size_t begin = reference.find("\n## " + title + "\n");
        REQUIRE(begin != std::string::npos);
        const std::size_t end = std::min(reference.find("\n## ", begin + 1), reference.size());
        const std::string section = reference.substr(begin, end - begin);
        CHECK(!contains(reference.substr(end), "\n## " + title + "\n"));
        for (const hexweave::KeyFormat& key : format.keys) {
            INFO(key.key);
            CHECK(contains(section, "- **`" + std::string(key.key) + "`**: "));
            CHECK(contains(section, "  Example: `" + std::string(key.example) + "`\n"));
        }
    }
}

TEST_CASE("docs prints a part of the reference") {
    const Scratch scratch;
    const Finished spacing = scratch.hexweave("docs spacing");
    CHECK(spacing.exit_code == 0);
    CHECK(spacing.out.starts_with("## spacing\n\n"));
    CHECK(contains(spacing.out, "\nIn edge:\n\n- **`spacing`**: "));
    CHECK(contains(spacing.out, "\n## spacing like\n"));
    CHECK(!contains(spacing.out, "](#"));
    CHECK(!contains(spacing.out, "## edge"));
    CHECK(scratch.hexweave("docs 'curve circle'").out == scratch.hexweave("docs curve_circle").out);

    CHECK(scratch.hexweave("docs curve circle").out == scratch.hexweave("docs curve_circle").out);

    const Finished words = scratch.hexweave("docs first cell");
    CHECK(words.exit_code == 0);
    CHECK(words.out.starts_with("No key is called 'first cell'; of that speak: "));
    CHECK(contains(words.out, "held height"));
    const Finished cells = scratch.hexweave("docs cells");
    CHECK(contains(cells.out, "In edge:\n"));
    CHECK(contains(cells.out, "In pole:\n"));

    const Finished near = scratch.hexweave("docs spacng");
    CHECK(near.exit_code == 2);
    CHECK(near.out.empty());
    CHECK(near.err ==
          "hexweave: error: docs spacng: the format has no such key; did you mean 'spacing'?\n");
    const Finished far = scratch.hexweave("docs xyzzyplugh");
    CHECK(far.exit_code == 2);
    CHECK(contains(far.err, "`hexweave docs case` lists where to begin"));
}
