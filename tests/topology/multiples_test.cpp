// SPDX-License-Identifier: Apache-2.0
// Counts raised to multiples.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>

#include "topology/adjusted_counts.h"
#include "topology/explain.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// Two squares side by side, the upper side of the whole one edge: a channel with a step in it.
std::string channel(const std::string& keys, const std::string& low1, const std::string& low2,
                    const std::string& west) {
    return fmt::format(R"({}
vertices: {{a: [0, 0], m: [1, 0], b: [3, 0], c: [3, 1], d: [0, 1]}}
edges:
  low1: {{from: a, to: m, {}}}
  low2: {{from: m, to: b, {}}}
  high: {{from: d, to: c}}
  west: {{from: a, to: d, {}}}
  east: {{from: b, to: c}}
faces:
  f: {{imin: west, imax: east, jmin: [low1, low2], jmax: high}}
boundaries:
  all: {{type: BCWall, sides: [low1, low2, high, west, east]}}
)",
                       keys, low1, low2, west);
}

std::string counts_of(const Topology& t) {
    std::string text;
    for (const Edge& e : t.edges) text += fmt::format("{} {}, ", e.name, e.cells);
    return text;
}

std::string adjusted(const Topology& t) {
    std::string text;
    for (const AdjustedCount& a : t.adjusted_counts) {
        text += fmt::format("{} {} {} {}, ", a.edge, a.written, a.asked, a.got);
    }
    return text;
}

}  // namespace

TEST_CASE("counts are raised to the multiple asked for in the file, and listed") {
    const Topology t = resolved(channel("multiple_of: 8", "cells: 16", "cells: 17", "cells: 8"));
    CHECK(counts_of(t) == "low1 16, low2 24, high 40, west 8, east 8, ");
    CHECK(adjusted(t) == "low2 17 17 24, high 33 33 40, ");
    CHECK(t.faces[0].cells_i == 40);
}

TEST_CASE("counts that are multiples stay as they are") {
    const Topology t = resolved(channel("multiple_of: 8", "cells: 16", "cells: 8", "cells: 80"));
    CHECK(adjusted(t).empty());
}

TEST_CASE("multiples of several edges of a chain are met together") {
    const Topology t = resolved(R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  south: {from: a, to: b, cells: 13, multiple_of: 4}
  north: {from: d, to: c, multiple_of: 6}
  west: {from: a, to: d, cells: 5}
faces: {f: {corners: [a, b, c, d]}}
boundaries: {all: {type: BCWall, sides: [south, north, west, b-c]}}
)");
    CHECK(named(t.edges, "south").cells == 24);
    CHECK(named(t.edges, "north").cells == 24);
    CHECK(named(t.edges, "west").cells == 5);
    CHECK(adjusted(t) == "south 13 13 24, ");
}

TEST_CASE("where raised sums over sides differ, the lesser side is raised on") {
    // 3 + 3 = 6 become 8 + 8 and 8: the one edge of the other side follows.
    const Topology t = resolved(channel("multiple_of: 8", "cells: 3", "cells: 3", "cells: 8"));
    CHECK(counts_of(t) == "low1 8, low2 8, high 16, west 8, east 8, ");
    // A multiple that is asked for on the sum alone: the parts follow, the larger one first.
    const Topology sum = resolved(R"(
vertices: {a: [0, 0], m: [1, 0], b: [3, 0], c: [3, 1], d: [0, 1]}
edges:
  low1: {from: a, to: m, cells: 3}
  low2: {from: m, to: b, cells: 6}
  high: {from: d, to: c, multiple_of: 8}
  west: {from: a, to: d, cells: 2}
  east: {from: b, to: c}
faces: {f: {imin: west, imax: east, jmin: [low1, low2], jmax: high}}
boundaries: {all: {type: BCWall, sides: [low1, low2, high, west, east]}}
)");
    CHECK(counts_of(sum) == "low1 3, low2 13, high 16, west 2, east 2, ");
}

TEST_CASE("listed points that are no multiple are told") {
    CHECK(faults(channel("multiple_of: 4", "cells: 4", "cells: 4",
                         "spacing: {positions: [0, 0.2, 0.5, 1]}")) ==
          "7: error: edge 'west' lists the points of 3 cells, which is not a multiple of 4\n"
          "  hint: list as many as that takes, or give a formula in t, which fits any count\n");
    const Topology formula = resolved(
        channel("multiple_of: 4", "cells: 4", "cells: 4", "cells: 3, spacing: {positions: t^2}"));
    CHECK(named(formula.edges, "west").cells == 4);
}

TEST_CASE("listed points are those of the level medium") {
    const std::string list = "spacing: {positions: [0, 0.2, 0.4, 0.7, 1]}";
    CHECK(faults(channel("level: fine", "cells: 4", "cells: 4", list)) ==
          "7: error: edge 'west' lists its points, which are those of the level 'medium' only\n"
          "  hint: give a formula in t, which fits any count\n");
    CHECK(faults(channel("levels: {factor: 1.5}\nlevel: coarse", "cells: 6", "cells: 6", list))
              .find("level 'medium' only") != std::string::npos);
    // The finest being medium, nothing is to be continued.
    const Topology t =
        resolved(channel("levels: {names: [coarse, medium]}", "cells: 4", "cells: 6", list));
    CHECK(named(t.edges, "west").cells == 4);
}

TEST_CASE("sides that no multiples make equal are told") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [3, 0], c: [3, 1], d: [0, 1]}
edges:
  low1: {from: a, to: m, spacing: {positions: [0, 0.5, 1]}}
  low2: {from: m, to: b, spacing: {positions: [0, 0.5, 1]}}
  high: {from: d, to: c, multiple_of: 8}
  west: {from: a, to: d, cells: 2}
  east: {from: b, to: c}
faces: {f: {imin: west, imax: east, jmin: [low1, low2], jmax: high}}
boundaries: {all: {type: BCWall, sides: [low1, low2, high, west, east]}}
)";
    CHECK(faults(text) ==
          "9: error: no multiples were found that make jmin and jmax of face 'f' equal\n"
          "  hint: write counts on its edges that are multiples and add up\n");
}

TEST_CASE("a multiple beyond any grid is a count beyond any grid") {
    const std::string text = channel("multiple_of: 9999991", "cells: 9, multiple_of: 9999973",
                                     "cells: 9, multiple_of: 9999971", "cells: 8");
    CHECK(faults(text).find("more than a CGNS zone can hold") != std::string::npos);
}

TEST_CASE("raising balances whole networks of sums") {
    // a + b = c and c + d = e + f, with multiples of their own.
    const std::vector<SumEquation> equations{{0, 0, {{0, 1}, {1, 1}, {2, -1}}},
                                             {1, 0, {{2, 1}, {3, 1}, {4, -1}, {5, -1}}}};
    const std::vector<WantedCount> wanted{{5, 4}, {7, 4}, {12, 8}, {3, 2}, {10, 8}, {5, 2}};
    const RaisedCounts raised = raise_counts(wanted, equations);
    REQUIRE(!raised.unequal);
    const std::vector<std::int64_t>& x = raised.cells;
    CHECK(x[0] + x[1] == x[2]);
    CHECK(x[2] + x[3] == x[4] + x[5]);
    for (std::size_t g = 0; g < wanted.size(); ++g) {
        CHECK(x[g] % wanted[g].multiple == 0);
        CHECK(static_cast<double>(x[g]) >= wanted[g].asked);
        CHECK(static_cast<double>(x[g]) <= 2 * wanted[g].asked + 8);
    }
    CHECK(raise_counts({{4.0000000001, 4}, {0, 4}, {2.5, 1}}, {}).cells ==
          std::vector<std::int64_t>{4, 0, 3});
}

TEST_CASE("it is explained why a count was raised") {
    const std::string text = channel("multiple_of: 8", "cells: 16", "cells: 17", "cells: 8");
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    const Case c = read_case(source, {}, diagnostics);
    const Topology t = resolve(c, diagnostics);
    std::string all;
    const std::vector<Explanation> explanations = explain(c, t, "low2");
    for (const ExplanationStep& step : explanations.front().steps) {
        all += fmt::format("{}: {}\n", step.place.line, step.text);
    }
    INFO(all);
    CHECK(all.find("6: 17 cells: said here\n"
                   "6:   raised from 17 to 24\n"
                   "2:   a multiple of 8 is asked for here\n") != std::string::npos);
}
