// SPDX-License-Identifier: Apache-2.0
#include "quality/offenders.h"

#include <catch2/catch.hpp>

using namespace hexweave;

namespace {

/// Unit squares (cubes), node (i, j, k) at (i, j, k).
PointField lattice(Extent e) {
    PointField points(e);
    for (int k = 0; k < e.nk; ++k)
        for (int j = 0; j < e.nj; ++j)
            for (int i = 0; i < e.ni; ++i) points.set(i, j, k, {1.0 * i, 1.0 * j, 1.0 * k});
    return points;
}

int count(const std::vector<double>& values, double value) {
    int found = 0;
    for (const double v : values) found += v == value;
    return found;
}

}  // namespace

TEST_CASE("folded cells are marked, the worst one first") {
    for (const bool in_space : {false, true}) {
        // Node (1, 1) goes beyond the diagonal of the cell to its right above.
        PointField points = lattice({4, 4, 1});
        points.set(1, 1, 0, {1.8, 1.7, 0});
        if (in_space) {  // the same, standing on end
            for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
                points.set(n, {points.x[n], 0, points.y[n]});
            }
        }
        const CellMarks marks = mark_cells(points);
        REQUIRE(marks.folded.size() == 9);
        CHECK(count(marks.folded, 1) == 1);
        CHECK(marks.folded[4] == 1);  // cell (1, 1)
        CHECK(marks.worst[4] == 1);
        CHECK(marks.scaled_jacobian[4] < 0);
        CHECK(count(marks.worst, 0) == 0);
        for (int rank = 1; rank <= 9; ++rank) CHECK(count(marks.worst, rank) == 1);
        CHECK(marks.scaled_jacobian[8] == 1);
    }
}

TEST_CASE("a cell of a plane that lies the wrong way round has a negative scaled Jacobian") {
    // Columns 1 and 2 have changed places: the middle column of cells is inside out, all squares.
    for (const bool in_space : {false, true}) {
        PointField points = lattice({4, 3, 1});
        for (int j = 0; j < 3; ++j) {
            points.set(1, j, 0, {2, 1.0 * j, 0});
            points.set(2, j, 0, {1, 1.0 * j, 0});
        }
        if (in_space) {
            for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
                points.set(n, {points.x[n], 0, points.y[n]});
            }
        }
        const CellMarks marks = mark_cells(points);
        const std::vector<double> expected{1, -1, 1, 1, -1, 1};
        CHECK(marks.scaled_jacobian == expected);
        CHECK(marks.folded == std::vector<double>{0, 1, 0, 0, 1, 0});
        CHECK(marks.worst == std::vector<double>{3, 1, 4, 5, 2, 6});
    }
}

TEST_CASE("of a block ten cells are marked, by their scaled Jacobians where none is folded") {
    PointField points = lattice({6, 5, 4});
    points.set(3, 2, 1, {3.3, 2, 1});  // the eight cells round it lean
    points.set(1, 1, 1, {1.1, 1, 1});
    const CellMarks marks = mark_cells(points);
    REQUIRE(marks.worst.size() == 60);
    CHECK(count(marks.folded, 1) == 0);
    CHECK(count(marks.worst, 0) == 50);
    const auto cell = [](int i, int j, int k) {
        return static_cast<std::size_t>(i + 5 * (j + 4 * k));
    };
    for (int c = 0; c < 8; ++c) {
        const std::size_t n = cell(2 + (c & 1), 1 + ((c >> 1) & 1), c >> 2);
        CHECK(marks.worst[n] >= 1);
        CHECK(marks.worst[n] <= 8);
        CHECK(marks.scaled_jacobian[n] < 0.97);
    }
    CHECK(marks.scaled_jacobian[cell(4, 3, 2)] == 1);
}

TEST_CASE("offenders are what is folded or did not converge, faces and blocks alike") {
    std::vector<FaceGrid> faces(2);
    faces[0].points = lattice({3, 4, 1});
    faces[1].points = lattice({2, 2, 1});
    std::vector<BlockGrid> blocks(1);
    blocks[0].points = lattice({2, 3, 4});
    Report report;
    for (const char* name : {"first", "second", "block"}) {
        SolveMeasure solve;
        solve.name = name;
        solve.is_block = report.solves.size() == 2;
        solve.result.status = SolveStatus::converged;
        report.solves.push_back(solve);
    }
    CHECK(find_offenders(report, faces, blocks).empty());
    report.solves[1].result.folded_after = 1;
    report.solves[2].result.status = SolveStatus::not_converged;
    const std::vector<Offender> found = find_offenders(report, faces, blocks);
    REQUIRE(found.size() == 2);
    CHECK(found[0].name == "second");
    CHECK_FALSE(found[0].is_block);
    CHECK(found[0].points.extent() == Extent{2, 2, 1});
    CHECK(found[1].name == "block");
    CHECK(found[1].is_block);
    CHECK(found[1].points.extent() == Extent{2, 3, 4});
    CHECK(found[1].marks.folded.size() == 6);
}
