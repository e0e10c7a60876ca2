// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of spacing laws.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>

#include "topology/law_equality.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("Equally near edges with different laws leave the edge undecided") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 1e-2}}
  mid: {from: a1, to: b1}
  right: {from: b2, to: a2, spacing: {start: 1e-2}}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, b0-b1, b1-b2]}
)";
    CHECK(
        faults(text) ==
        R"(5: error: the spacing of edge 'mid' is undecided: 'left' and 'right' are equally near and differ
  4: the spacing of 'left'
  6: the spacing of 'right'
  hint: say which: 'spacing: {like: left}', or give it a law of its own
)");
}

TEST_CASE("Equally near edges with the same law, seen along the edge, are no conflict") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 1e-2}}
  mid: {from: a1, to: b1}
  right: {from: b2, to: a2, spacing: {end: 1e-2}}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, b0-b1, b1-b2]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("The same sizes on edges of other lengths are different laws") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 2], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 1e-2}}
  mid: {from: a1, to: b1}
  right: {from: b2, to: a2, spacing: {end: 1e-2}}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, b0-b1, b1-b2]}
)";
    CHECK(
        faults(text) ==
        R"(5: error: the spacing of edge 'mid' is undecided: 'left' and 'right' are equally near and differ
  4: the spacing of 'left'
  6: the spacing of 'right'
  hint: say which: 'spacing: {like: left}', or give it a law of its own
)");
}

TEST_CASE("The same edge, reached twice, is no conflict") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 1e-2}}
  mid: {from: a1, to: b1}
  right: {from: b2, to: a2, spacing: {like: -left}}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, b0-b1, b1-b2]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("An undecided edge may say") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 1e-2}}
  mid: {from: a1, to: b1, spacing: {like: left}}
  right: {from: b2, to: a2, spacing: {start: 1e-2}}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, b0-b1, b1-b2]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("'like' goes to an edge of as many cells") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c}
  da: {from: d, to: a, spacing: {like: dc}}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) ==
          R"(8: error: edge 'da' has 3 cells and cannot be like edge 'dc', which has 16
  hint: 'like' takes the points of an edge of as many cells
)");
}

TEST_CASE("Spacings do not go round in a circle") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 3, spacing: {like: da}}
  dc: {from: d, to: c}
  da: {from: d, to: a, spacing: {like: bc}}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == R"(6: error: spacings go round in a circle: 'bc' -> 'da' -> 'bc'
  hint: give one of these edges a law of its own
)");
}

TEST_CASE("'like' names an edge") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c}
  da: {from: d, to: a, spacing: {like: bd}}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == R"(8: error: unknown edge 'bd'
  hint: known: 'am', 'bc', 'da', 'dc' and 'mb'
)");
}

TEST_CASE("A spacing that does not fit its edge is refused") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 3, spacing: {start: 2}}
  dc: {from: d, to: c}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(
        faults(text) ==
        R"(6: error: the spacing of edge 'bc' does not fit: the first cell, 2, is longer than the edge, 1
  hint: of 3 equal cells each would be 0.333333; first and last cells are lengths, in the units of the case
)");
}

namespace {

/// A row of four squares; the edges between them, v0 to v4, get the entries given.
Topology row(const std::array<std::string, 5>& entries) {
    std::string vertices = "\nvertices: {";
    std::string edges = "edges:\n  b: {from: a0, to: a1, cells: 4}\n";
    std::string faces = "faces:\n";
    for (std::size_t n = 0; n < 5; ++n) {
        vertices += fmt::format("a{0}: [{0}, 0], b{0}: [{0}, 1], ", n);
        edges += fmt::format("  v{}: {{{}}}\n", n, entries[n]);
        if (n == 4) continue;
        if (n > 0) edges += fmt::format("  b{0}: {{from: a{0}, to: a{1}, cells: 4}}\n", n, n + 1);
        faces += fmt::format("  f{0}: {{corners: [a{0}, a{1}, b{1}, b{0}]}}\n", n, n + 1);
    }
    return resolved(vertices + "}\n" + edges + faces);
}

}  // namespace

TEST_CASE("An edge keeps its own law, or takes that of the edge it is like") {
    const Topology t =
        row({"from: a0, to: b0, cells: 9, spacing: {start: 0.01}",
             "from: b1, to: a1, spacing: {like: v0}", "from: a2, to: b2, spacing: {like: v4}",
             "from: a3, to: b3, spacing: uniform",
             "from: b4, to: a4, spacing: {law: geometric, ratio: 1.2}"});
    CHECK(broken_promise(t) == "");
    CHECK(law_text(t, named(t.edges, "v0")) == "own");
    CHECK(law_text(t, named(t.edges, "v2")) == "same as v4");  // no vertex shared: start to start
    CHECK(std::holds_alternative<UniformLaw>(named(t.edges, "v3").law));
    CHECK(named(t.edges, "v0").asked_start == 0.01);
    CHECK_FALSE(named(t.edges, "v1").asked_start);
    CHECK(law_text(t, named(t.edges, "v1")) == "same as v0");
}

TEST_CASE("A law passes over edges without one, and none at all is uniform") {
    const Topology t =
        row({"from: a0, to: b0, cells: 9, spacing: {start: 0.01}", "from: b1, to: a1",
             "from: a2, to: b2", "from: b3, to: a3", "from: b4, to: a4"});
    CHECK(law_text(t, named(t.edges, "v1")) == "same as -v0");
    CHECK(law_text(t, named(t.edges, "v2")) == "same as v0");
    CHECK(law_text(t, named(t.edges, "v3")) == "same as -v0");
    CHECK(law_text(t, named(t.edges, "v4")) == "same as -v0");
    CHECK(std::holds_alternative<UniformLaw>(named(t.edges, "b").law));
    CHECK(std::holds_alternative<UniformLaw>(named(t.edges, "b0-b1").law));
}

TEST_CASE("'like' of an edge that itself inherits leads to the edge with the law") {
    const Topology t =
        row({"from: a0, to: b0, cells: 9, spacing: {start: 0.01}", "from: b1, to: a1",
             "from: a2, to: b2, spacing: {like: -v1}", "from: b3, to: a3", "from: b4, to: a4"});
    CHECK(broken_promise(t) == "");
    CHECK(law_text(t, named(t.edges, "v2")) == "same as v0");
    CHECK(law_text(t, named(t.edges, "v4")) == "same as -v0");
}

TEST_CASE("Laws are compared by their values, seen in one direction") {
    const SpacingLaw tanh = TanhLaw{0.1, std::nullopt};
    CHECK(same_distribution(tanh, 1, turned(TanhLaw{std::nullopt, 0.1}, true), 1));
    CHECK_FALSE(same_distribution(tanh, 1, TanhLaw{std::nullopt, 0.1}, 1));
    CHECK_FALSE(same_distribution(tanh, 1, tanh, 1 + 1e-8));
    CHECK(same_distribution(tanh, 1, tanh, 1 + 1e-10));
    const SpacingLaw ratio = GeometricLaw{1.25, std::nullopt, std::nullopt};
    CHECK(same_distribution(ratio, 1, ratio, 7));
    CHECK(same_distribution(turned(ratio, true), 1, GeometricLaw{0.8, std::nullopt, std::nullopt},
                            1));
    const SpacingLaw list = ExplicitLaw{{0, 0.1, 0.4, 1}, {}, false};
    CHECK(same_distribution(turned(list, true), 1, ExplicitLaw{{0, 0.6, 0.9, 1}, {}, false}, 1));
    CHECK_FALSE(same_distribution(list, 1, ExplicitLaw{{0, 0.1, 1}, {}, false}, 1));
    CHECK(same_distribution(UniformLaw{}, 1, UniformLaw{}, 2));
    CHECK_FALSE(same_distribution(UniformLaw{}, 1, tanh, 1));
}
