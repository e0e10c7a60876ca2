// SPDX-License-Identifier: Apache-2.0
// `include:`, `set:` and `when:`. What can be wrong with them is in tests/cases/bad.
#include "topology/includes.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "topology/read_case.h"

using namespace hexweave;

namespace {

Case read_including(const std::vector<Override>& overrides) {
    const std::string name = HEXWEAVE_SOURCE_DIR "/tests/cases/included/including.yaml";
    std::ifstream stream(name);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    Diagnostics diagnostics;
    Case c = read_case(std::make_shared<const SourceFile>(SourceFile{name, text}), overrides,
                       diagnostics);
    INFO(render(diagnostics));
    REQUIRE(diagnostics.all().empty());
    return c;
}

std::vector<std::string> names_of(const std::vector<VertexEntry>& vertices) {
    std::vector<std::string> names;
    for (const VertexEntry& vertex : vertices) names.push_back(vertex.name.value);
    return names;
}

double parameter(const Case& c, const std::string& name) {
    for (const Parameter& p : c.parameters) {
        if (p.name.value == name) return p.value;
    }
    FAIL("no parameter " << name);
    return 0;
}

}  // namespace

TEST_CASE("included sections stand before those of the file that includes them") {
    const Case c = read_including({});
    CHECK(c.title == "A case of several files");
    CHECK(names_of(c.vertices) == std::vector<std::string>{"nose", "tail", "top"});
    CHECK(std::get<Vec3>(c.vertices[1].where).x == 6);
    CHECK(c.vertices[1].name.place.used_by->message == "included here");
    CHECK(c.vertices[2].name.place.used_by == nullptr);
}

TEST_CASE("a parameter set by the including file keeps its dependents computed") {
    const Case c = read_including({});
    CHECK(parameter(c, "chord") == 6);
    CHECK(parameter(c, "far") == 120);
    CHECK(c.edges[0].cells->value == 12);
}

TEST_CASE("an override reaches parameters of all files, and what an include is given") {
    CHECK(parameter(read_including({{"size", "4"}}), "far") == 160);
    const Case c = read_including({{"chord", "1"}});
    CHECK(parameter(c, "far") == 20);
    CHECK(c.edges[0].cells->value == 2);
}

TEST_CASE("an entry is there only where its condition holds") {
    const Case c = read_including({{"size", "1"}});
    CHECK(names_of(c.vertices) == std::vector<std::string>{"nose", "tail", "bottom"});
    CHECK(c.edges.size() == 1);
}

TEST_CASE("the provenance tells what was included") {
    const std::string provenance = read_including({}).provenance;
    CHECK(provenance.find("; include fnv1a64:") != std::string::npos);
    CHECK(provenance.find("shared") == std::string::npos);
}
