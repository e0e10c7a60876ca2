// SPDX-License-Identifier: Apache-2.0
#include "elliptic/level.h"

#include "core/parallel.h"

namespace hexweave {

namespace {

void inject(const Level& finer, const RowArray<double>& from, const Level& coarse,
            RowArray<double>& to, int components) {
    const Extent& f = finer.extent;
    const Extent& c = coarse.extent;
    parallel_blocks(c.nj * c.nk, 6 * c.ni, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const int j = n % c.nj;
            const int k = n / c.nj;
            const double* read = from.row(finer_index(j, f.nj, coarse.halved[1]),
                                          finer_index(k, f.nk, coarse.halved[2]));
            double* write = to.row(j, k);
            for (int component = 0; component < components; ++component) {
                for_coarse_nodes(
                    finer.shape, coarse.shape, coarse.halved[0],
                    [=](std::ptrdiff_t fine, std::ptrdiff_t here) { write[here] = read[fine]; });
                read += finer.shape.length();
                write += coarse.shape.length();
            }
        }
    });
}

}  // namespace

void store(const Field& field, int component, RowArray<double>& rows) {
    const Extent& e = field.extent();
    const RowShape shape(e.ni);
    parallel_blocks(e.nj * e.nk, 2 * e.ni, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const double* const value = field.data() + e.offset(0, n % e.nj, n / e.nj);
            double* const row = rows.row(n % e.nj, n / e.nj) + component * shape.length();
            for (int i = 0; i < e.ni; ++i) row[shape.at(i)] = value[i];
        }
    });
}

void restore(const RowArray<double>& rows, int component, Field& field) {
    const Extent& e = field.extent();
    const RowShape shape(e.ni);
    for (int n = 0; n < e.nj * e.nk; ++n) {
        double* const value = field.data() + e.offset(0, n % e.nj, n / e.nj);
        const double* const row = rows.row(n % e.nj, n / e.nj) + component * shape.length();
        for (int i = 0; i < e.ni; ++i) value[i] = row[shape.at(i)];
    }
}

void restore_interior(const RowArray<double>& rows, int component, Field& field) {
    const Extent& e = field.extent();
    const RowShape shape(e.ni);
    parallel_blocks(e.nj * e.nk, 2 * e.ni, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const int j = n % e.nj;
            const int k = n / e.nj;
            if (j == 0 || j == e.nj - 1 || (e.nk > 1 && (k == 0 || k == e.nk - 1))) continue;
            double* const value = field.data() + e.offset(0, j, k);
            const double* const row = rows.row(j, k) + component * shape.length();
            for (int i = 1; i < e.ni - 1; ++i) value[i] = row[shape.at(i)];
        }
    });
}

Level coarser_level(const Level& finer, const std::array<bool, 3>& halved) {
    Level coarse;
    const Extent& f = finer.extent;
    coarse.extent = {halved[0] ? halved_count(f.ni) : f.ni, halved[1] ? halved_count(f.nj) : f.nj,
                     halved[2] ? halved_count(f.nk) : f.nk};
    coarse.shape = RowShape(coarse.extent.ni);
    coarse.axes = finer.axes;
    coarse.components = finer.components;
    coarse.halved = halved;
    coarse.points = RowArray<double>(coarse.extent, coarse.components);
    coarse.parameters = RowArray<double>(coarse.extent, coarse.axes);
    inject(finer, finer.parameters, coarse, coarse.parameters, coarse.axes);
    return coarse;
}

void inject_points(const Level& finer, Level& coarse) {
    inject(finer, finer.points, coarse, coarse.points, coarse.components);
}

}  // namespace hexweave
