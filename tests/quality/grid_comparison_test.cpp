// SPDX-License-Identifier: Apache-2.0
// Two grids: the same, whichever way they are turned; different, wherever they are touched.
#include "quality/grid_comparison.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "quality/turned_grids.h"

using namespace hexweave;
using namespace hexweave::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

GridComparison compare(const MultiblockGrid& candidate, const MultiblockGrid& golden,
                       const ComparisonOptions& options = {}, std::size_t piece_nodes = 60) {
    return compare_grids(source_of(candidate, piece_nodes), source_of(golden, piece_nodes),
                         options);
}

constexpr ComparisonOptions by_shape{1e-4, true};

/// Moves a point along x.
void nudge(MultiblockGrid& grid, std::size_t zone, const Node& n, double by) {
    PointField& points = grid.zones[zone].points;
    points.set(n[0], n[1], n[2], points(n[0], n[1], n[2]) + Vec3{by, 0, 0});
}

/// A row of three cubes of cells of sizes 1, 0.25 and 1 along i, size 1 otherwise.
MultiblockGrid bar() {
    MultiblockGrid grid;
    Zone zone{"bar", PointField({4, 3, 3})};
    const double x[] = {0, 1, 1.25, 2.25};
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 4; ++i) {
                zone.points.set(i, j, k, {x[i], static_cast<double>(j), static_cast<double>(k)});
            }
    grid.zones.push_back(zone);
    return grid;
}

std::vector<Turn> turns_of(const MultiblockGrid& grid, std::size_t first) {
    const std::vector<Turn> all = all_turns(grid.cell_dimension);
    std::vector<Turn> turns;
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
        turns.push_back(all[(first + 11 * z) % all.size()]);
    }
    return turns;
}

}  // namespace

TEST_CASE("a grid is the same as itself, by name and by shape") {
    for (const MultiblockGrid& grid : {three_blocks(), ring(), bar()}) {
        for (const ComparisonOptions& options : {ComparisonOptions{}, by_shape}) {
            const GridComparison found = compare(grid, grid, options);
            CHECK(found.same());
            CHECK(found.all().in_cells.size == 0);
            CHECK(found.zones.size() == grid.zones.size());
        }
    }
}

TEST_CASE("by shape a grid is the same however its zones are turned, ordered and called") {
    for (const MultiblockGrid& grid : {three_blocks(), ring()}) {
        const std::size_t all = all_turns(grid.cell_dimension).size();
        for (std::size_t first = 0; first < all; ++first) {
            const MultiblockGrid other = shuffled(turned(grid, turns_of(grid, first)));
            for (const bool back : {false, true}) {
                const GridComparison found =
                    back ? compare(grid, other, by_shape) : compare(other, grid, by_shape);
                INFO(first << " " << back);
                for (const Difference& d : found.differences) UNSCOPED_INFO(d.text);
                CHECK(found.same());
                CHECK(found.all().in_cells.size == 0);
                CHECK(found.zones.size() == grid.zones.size());
            }
            // By name nothing fits.
            CHECK(compare(other, grid).zones.empty());
            CHECK_FALSE(compare(other, grid).same());
        }
    }
}

TEST_CASE("a moved point is found at its node, however its zone is turned") {
    const MultiblockGrid golden = three_blocks();
    const Node moved{2, 0, 3};
    for (std::size_t first = 0; first < 48; ++first) {
        MultiblockGrid grid = golden;
        nudge(grid, 1, moved, 1e-3);
        const std::vector<Turn> turns = turns_of(grid, first);
        const GridComparison found = compare(turned(grid, turns), golden, by_shape);
        CHECK_FALSE(found.same());
        CHECK(found.all().beyond == 1);
        const ZoneDeviation& deviation = found.zones[1].deviation;
        CHECK(deviation.in_cells.node == turned(turns[1], moved, {7, 5, 6}));
        CHECK(deviation.in_length.size == Approx(1e-3));
        CHECK(deviation.in_length.place == golden.zones[1].points(2, 0, 3));
    }
}

TEST_CASE("deviations are measured in the shortest edge at the point") {
    const MultiblockGrid golden = bar();
    struct Expected {
        Node node;
        double cell;
    };
    for (const Expected& e :
         {Expected{{0, 1, 1}, 1}, {{1, 1, 1}, 0.25}, {{2, 0, 2}, 0.25}, {{3, 2, 0}, 1}}) {
        for (const double part : {0.99, 1.01}) {
            MultiblockGrid grid = golden;
            nudge(grid, 0, e.node, part * 1e-4 * e.cell);
            const GridComparison found = compare(grid, golden);
            CHECK(found.all().in_cells.size == Approx(part * 1e-4));
            CHECK(found.all().in_length.size == Approx(part * 1e-4 * e.cell));
            CHECK(found.all().beyond == (part > 1 ? 1 : 0));
            CHECK(found.same() == (part < 1));
        }
    }
    MultiblockGrid grid = golden;
    nudge(grid, 0, {1, 1, 1}, 1e-3);
    CHECK_FALSE(compare(grid, golden).same());
    CHECK(compare(grid, golden, {5e-3, false}).same());
}

TEST_CASE("a lone axis of two nodes has an edge on one side only") {
    MultiblockGrid golden;
    golden.zones.push_back({"cell", PointField({2, 2, 2})});
    for (int n = 0; n < 8; ++n) {
        golden.zones[0].points.set(n & 1, n >> 1 & 1, n >> 2,
                                   {2.0 * (n & 1), 3.0 * (n >> 1 & 1), 4.0 * (n >> 2)});
    }
    MultiblockGrid grid = golden;
    nudge(grid, 0, {1, 1, 1}, 0.5);
    CHECK(compare(grid, golden).all().in_cells.size == Approx(0.25));
}

TEST_CASE("nothing below four epsilons of the box counts, nor do edges without length") {
    MultiblockGrid golden = bar();
    // A pole: the four nodes of k = 2 at i = 0 in one point, far from the origin of the box.
    for (int j = 0; j < 3; ++j) golden.zones[0].points.set(0, j, 2, {0, 1, 2});
    MultiblockGrid grid = golden;
    nudge(grid, 0, {0, 1, 2}, 0.5e-4);
    CHECK(compare(grid, golden).all().in_cells.size == Approx(0.5e-4));
    CHECK(compare(grid, golden).same());

    // A cell of the size of the last bits.
    const double diagonal = std::sqrt(2.25 * 2.25 + 4 + 4);
    const double floor = 4 * std::numeric_limits<double>::epsilon() * diagonal;
    golden = bar();
    golden.zones[0].points.set(2, 1, 1, {1 + 10 * floor, 1, 1});
    for (const double part : {0.9, 1.5}) {
        grid = golden;
        nudge(grid, 0, {2, 1, 1}, part * floor);
        const GridComparison found = compare(grid, golden);
        CHECK(found.floor == Approx(floor));
        CHECK(found.same() == (part < 1));
    }
}

TEST_CASE("however small the tolerance, round-off is allowed and a moved point is told in cells") {
    const MultiblockGrid golden = bar();
    MultiblockGrid grid = golden;
    nudge(grid, 0, {1, 1, 1}, 0.125);
    for (const double tolerance : {1e-16, 1e-150, 1e-170, 1e-300, 1e-320}) {
        INFO(tolerance);
        const GridComparison found = compare(grid, golden, {tolerance, false});
        CHECK(found.all().beyond == 1);
        CHECK(found.all().in_cells.size == Approx(0.5));
        MultiblockGrid near = golden;
        nudge(near, 0, {1, 1, 1}, 0.5 * found.floor);
        const GridComparison rounded = compare(near, golden, {tolerance, false});
        CHECK(rounded.same());
        CHECK(rounded.all().in_cells.size == Approx(2 * found.floor).epsilon(0.5));
    }
    CHECK(compare(grid, golden, {1e200, false}).same());
    grid.zones[0].points.x(0, 0, 0) = not_a_number;
    for (const double tolerance : {1e-170, 1.0, 1e200, 1e308}) {
        CHECK(compare(grid, golden, {tolerance, false}).all().not_finite == 1);
        CHECK_FALSE(compare(grid, golden, {tolerance, false}).same());
    }
}

TEST_CASE("scales far from one change nothing") {
    for (const double scale : {1e-290, 1e-160, 1e-9, 1e12, 1e160, 1e290}) {
        MultiblockGrid golden = three_blocks();
        for (Zone& zone : golden.zones) {
            for (std::size_t n = 0; n < zone.points.extent().nodes(); ++n) {
                zone.points.set(n, scale * zone.points[n]);
            }
        }
        MultiblockGrid grid = golden;
        nudge(grid, 1, {2, 2, 2}, 1e-3 * scale);
        INFO(scale);
        CHECK(compare(golden, golden, by_shape).same());
        CHECK(compare(grid, golden).all().beyond == 1);
        CHECK(compare(grid, golden).all().in_length.size == Approx(1e-3 * scale));
    }
}

TEST_CASE("what is no finite number differs from everything") {
    const MultiblockGrid golden = three_blocks();
    for (const double bad : {not_a_number, std::numeric_limits<double>::infinity()}) {
        MultiblockGrid grid = golden;
        grid.zones[2].points.y(1, 4, 2) = bad;
        const GridComparison found = compare(grid, golden);
        CHECK_FALSE(found.same());
        CHECK(found.all().beyond == 1);
        CHECK(found.all().not_finite == 1);
        CHECK(found.zones[2].deviation.in_cells.node == Node{1, 4, 2});
        // A golden grid with one is none.
        CHECK_THROWS_AS(compare(golden, grid), UsageError);
        CHECK_THROWS_WITH(compare(grid, grid), Contains("node (2, 5, 3) of zone 'top'"));
    }
    // By shape as well, where a zone is looked at to be recognised.
    MultiblockGrid corner = golden;
    for (const int i : {0, 3}) corner.zones[0].points.z(i, 0, 0) = not_a_number;
    const GridComparison recognised = compare(corner, golden, by_shape);
    CHECK(recognised.differences.empty());
    CHECK(recognised.all().not_finite == 2);

    MultiblockGrid far = golden;
    far.zones[0].points.x(0, 0, 0) = 1e308;
    CHECK(compare(far, golden).all().beyond == 1);
    CHECK(compare(far, golden).all().not_finite == 0);
}

TEST_CASE("the size of the pieces changes nothing") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    for (int n = 0; n < 5; ++n) nudge(grid, 1, {n, n % 3, 5 - n}, 1e-3 * (n + 1));
    nudge(grid, 2, {1, 3, 2}, 1e-6);
    const GridComparison whole = compare(grid, golden, {}, 100000);
    CHECK(whole.all().beyond == 5);
    for (const std::size_t nodes : {27U, 28U, 36U, 45U, 50U, 80U, 120U, 180U, 210U}) {
        const GridComparison found = compare(grid, golden, {}, nodes);
        for (std::size_t z = 0; z < whole.zones.size(); ++z) {
            const ZoneDeviation& a = found.zones[z].deviation;
            const ZoneDeviation& b = whole.zones[z].deviation;
            INFO(nodes << " " << z);
            CHECK(a.points == b.points);
            CHECK(a.beyond == b.beyond);
            CHECK(a.in_cells.size == b.in_cells.size);
            CHECK(a.in_cells.node == b.in_cells.node);
            CHECK(a.in_length.size == b.in_length.size);
        }
    }
}

TEST_CASE("portions cover every node once and keep to their size") {
    for (const Extent& extent : {Extent{7, 5, 6}, {41, 7, 1}, {2, 2, 2}, {1, 9, 9}, {100, 1, 1}}) {
        for (const std::size_t most : {27U, 40U, 100U, 1000U}) {
            std::vector<int> seen(extent.nodes());
            for (const Portion& portion : cut(extent, most)) {
                const IndexBox& outer = portion.with_neighbours;
                std::size_t nodes = 1;
                for (std::size_t a = 0; a < 3; ++a) {
                    nodes *= static_cast<std::size_t>(outer.end[a] - outer.begin[a] + 1);
                }
                CHECK(nodes <= most);
                const IndexBox& core = portion.core;
                for (int k = core.begin[2]; k <= core.end[2]; ++k)
                    for (int j = core.begin[1]; j <= core.end[1]; ++j)
                        for (int i = core.begin[0]; i <= core.end[0]; ++i) {
                            ++seen[extent.offset(i, j, k)];
                        }
            }
            CHECK(std::count(seen.begin(), seen.end(), 1) ==
                  static_cast<std::ptrdiff_t>(extent.nodes()));
        }
    }
}

namespace {

/// The one difference of two grids whose points are the same.
Difference only_difference(const MultiblockGrid& candidate, const MultiblockGrid& golden) {
    const GridComparison found = compare(candidate, golden);
    CHECK_FALSE(found.same());
    CHECK(found.all().beyond == 0);
    for (const Difference& d : found.differences) UNSCOPED_INFO(d.text);
    REQUIRE(found.differences.size() == 1);
    return found.differences[0];
}

}  // namespace

TEST_CASE("one interface range off by one is one difference") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    grid.interfaces[2].box.end[1] = 3;
    grid.interfaces[2].donor_box.end[2] = 3;
    const Difference found = only_difference(grid, golden);
    CHECK(found.kind == "interface");
    CHECK_THAT(found.text, Contains("zone 'right', nodes [1, 1, 6] to [7, 4, 6]"));
    CHECK_THAT(found.text, Contains("golden: zone 'right', nodes [1, 1, 6] to [7, 5, 6]"));
}

TEST_CASE("interfaces that are missing, added, turned or carried elsewhere are told") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    grid.interfaces.erase(grid.interfaces.begin());
    CHECK_THAT(only_difference(grid, golden).text, Contains("missing"));
    CHECK_THAT(only_difference(golden, grid).text, Contains("not in the golden grid"));
    grid = golden;
    std::swap(grid.interfaces[1].donor_box.begin[2], grid.interfaces[1].donor_box.end[2]);
    grid.interfaces[1].orientation.axes[1] = -3;
    CHECK(only_difference(grid, golden).kind == "interface");
    grid = golden;
    grid.interfaces[3].periodic->translation.y = 4.001;
    CHECK_THAT(only_difference(grid, golden).text, Contains("4.001"));
    grid.interfaces[3].periodic.reset();
    CHECK_THAT(only_difference(grid, golden).text, Contains("not periodic, golden periodic"));
}

TEST_CASE("what is small beside the grid makes no periodicity another one") {
    MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    Periodicity& map = *grid.interfaces[3].periodic;
    map = {{1e-30, 0, 0}, {0, 0, 1e-12}, {1e-17, 4 + 1e-9, 0}};
    CHECK(compare(grid, golden).same());
    map.angle.z = 1e-4;
    CHECK(only_difference(grid, golden).kind == "interface");
    map = {{}, {}, {1e-3, 4, 0}};
    CHECK(only_difference(grid, golden).kind == "interface");
    // A turn about x is the same about any point of x.
    golden.interfaces[3].periodic = Periodicity{{0, 1, 2}, {0.5, 0, 0}, {}};
    map = {{100, 1, 2}, {0.5, 0, 0}, {}};
    CHECK(compare(grid, golden).same());
    map.center.y = 1.001;
    CHECK_THAT(only_difference(grid, golden).text, Contains("about (100, 1.001, 2)"));
    // One that moves nothing is still one.
    map = {};
    golden.interfaces[3].periodic.reset();
    CHECK_FALSE(compare(grid, golden).same());
}

TEST_CASE("ends of an interface that contradict each other are told") {
    const MultiblockGrid golden = three_blocks();
    PointSource candidate = source_of(golden, 60);
    const Interface& first = golden.interfaces[3];
    Interface second = other_side(first);
    const auto differences = [&] {
        candidate.outline.ends_apart = {{first, second}};
        return compare_grids(candidate, source_of(golden, 60), {}).differences;
    };
    CHECK(differences().empty());
    second.periodic->translation.y = -4 - 1e-7;
    CHECK(differences().empty());
    for (const auto& wrong :
         {std::optional<Periodicity>{}, std::optional<Periodicity>{{{}, {}, {0, -4.01, 0}}},
          std::optional<Periodicity>{{{}, {0.01, 0, 0}, {0, -4, 0}}},
          std::optional<Periodicity>{{{}, {}, {0, not_a_number, 0}}}}) {
        second.periodic = wrong;
        REQUIRE(differences().size() == 1);
        CHECK(differences()[0].kind == "interface");
        CHECK_THAT(differences()[0].text, Contains("'d' of zone 'left' is periodic by"));
        CHECK_THAT(differences()[0].text, Contains("contradict each other"));
        // As a golden grid it is none.
        CHECK_THROWS_WITH(compare_grids(source_of(golden, 60), candidate, {}),
                          Contains("in the golden grid the two ends"));
    }
    // Turns about several axes: the way back runs through them in the other order.
    Interface turned_first = first;
    turned_first.periodic = Periodicity{{1, 2, 3}, {0.3, 0, 0.7}, {}};
    Interface turned_back = second;
    const auto contradict = [&](const Vec3& angle) {
        turned_back.periodic = Periodicity{{1, 2, 3}, angle, {}};
        candidate.outline.ends_apart = {{turned_first, turned_back}};
        return !compare_grids(candidate, source_of(golden, 60), {}).differences.empty();
    };
    CHECK(contradict({-0.3, 0, -0.7}));
    CHECK_FALSE(contradict({-0.2323214, -0.1915485, -0.6775813}));
}

TEST_CASE("boundaries differ by family, by range, or by being there") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    grid.patches[2].family = 0;
    CHECK(only_difference(grid, golden).text ==
          "zone 'left', nodes [1, 1, 1] to [1, 5, 6]: the boundary is of family 'floor', golden "
          "'ends'");
    grid = golden;
    grid.patches[3].box.end[1] = 1;
    CHECK(only_difference(grid, golden).text ==
          "zone 'right', nodes [7, 1, 1] to [7, 2, 6]: boundary 'ends', golden nodes [7, 1, 1] to "
          "[7, 3, 6]");
    grid = golden;
    grid.patches.pop_back();
    CHECK_THAT(only_difference(grid, golden).text, Contains("missing"));
    grid = golden;
    grid.patches.push_back(grid.patches[0]);
    CHECK_THAT(only_difference(grid, golden).text, Contains("not in the golden grid"));
    grid = golden;
    grid.patches[0].name = "another name";
    CHECK(compare(grid, golden).same());
}

TEST_CASE("a boundary of another type than its family's differs") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    grid.patches[2].type = "BCOutflow";
    CHECK(only_difference(grid, golden).text ==
          "zone 'left', nodes [1, 1, 1] to [1, 5, 6]: boundary 'ends' is of type BCOutflow, golden "
          "BCInflow");
    CHECK_THAT(only_difference(golden, grid).text, EndsWith("of type BCInflow, golden BCOutflow"));
    CHECK(compare(grid, grid).same());
    // Its own type or its family's: what counts is which it is.
    MultiblockGrid said = golden;
    said.patches[2].type = "BCInflow";
    CHECK(compare(said, golden).same());
    // A family that no file declares has as many types as its patches.
    for (MultiblockGrid* side : {&grid, &said}) side->families[1].undeclared = true;
    CHECK_THAT(only_difference(grid, said).text, EndsWith("of type BCOutflow, golden BCInflow"));
    said.families[1].type = "BCOutflow";
    said.patches[2].type = "BCOutflow";
    said.patches[3].type = "BCInflow";
    CHECK(compare(grid, said).same());
}

TEST_CASE("a renamed family, another type, another unit and another size differ") {
    const MultiblockGrid golden = three_blocks();
    MultiblockGrid grid = golden;
    grid.families[0].name = "ground";
    CHECK_FALSE(compare(grid, golden).same());
    CHECK(compare(grid, golden).differences.size() == 4);  // gone, new, two boundaries
    grid = golden;
    grid.families[0].type = "BCWall";
    CHECK_THAT(only_difference(grid, golden).text, Contains("BCWall, golden BCWallViscous"));
    grid = golden;
    grid.units = "mm";
    CHECK(only_difference(grid, golden).text == "the length unit is mm, golden m");
    grid = golden;
    grid.title = "another title";
    grid.provenance = "another day";
    CHECK(compare(grid, golden).same());

    MultiblockGrid longer = bar();
    longer.zones[0].points = PointField({4, 3, 4});
    CHECK(only_difference(longer, bar()).text ==
          "zone 'bar' has 4 x 3 x 4 nodes, golden 4 x 3 x 3");
    longer = golden;
    longer.zones.push_back({"more", PointField({2, 2, 2})});
    CHECK(only_difference(longer, golden).text ==
          "zone 'more' (2 x 2 x 2) has no counterpart in the golden grid");
    CHECK(only_difference(golden, longer).text ==
          "zone 'more' (2 x 2 x 2) of the golden grid is missing");
}

TEST_CASE("zones that were exchanged differ by name and are found by shape") {
    MultiblockGrid golden = ring();
    golden.zones.push_back(golden.zones[0]);
    golden.zones[1].name = "small";
    PointField& small = golden.zones[1].points;
    for (std::size_t n = 0; n < small.extent().nodes(); ++n) small.set(n, 0.4 * small[n]);
    MultiblockGrid grid = golden;
    std::swap(grid.zones[0].points, grid.zones[1].points);
    grid.interfaces[0].zone = grid.interfaces[0].donor = 1;
    grid.patches[0].zone = 1;
    CHECK_FALSE(compare(grid, golden).same());
    const GridComparison found = compare(grid, golden, by_shape);
    CHECK(found.same());
    CHECK(found.zones[0].golden_name == "small");
}
