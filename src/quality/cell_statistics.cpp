// SPDX-License-Identifier: Apache-2.0
#include "quality/cell_statistics.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/parallel.h"
#include "quality/cell_corners.h"
#include "quality/cell_measures.h"
#include "quality/jacobian_bound.h"

namespace hexweave {

namespace {

Vec3 centre_of(const CellNodes& nodes, int count) {
    Vec3 sum;
    for (int c = 0; c < count; ++c) sum += nodes[static_cast<std::size_t>(c)];
    return sum / count;
}

class Collector {
public:
    Collector(const Zone& zone, const Vec3& plane, int worst_count)
        : zone_(zone),
          plane_(plane),
          worst_count_(static_cast<std::size_t>(worst_count)),
          axes_(zone.points.extent().nk == 1 ? 2 : 3) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        statistics.quality.least_volume.value = infinity;
        statistics.quality.greatest_volume.value = -infinity;
        statistics.quality.least_jacobian.value = infinity;
    }

    void include(const Node& cell);
    void include(const Collector& later);

    CellStatistics statistics;

private:
    double include_corners(const Node& cell, const Vec3& centre, const CellCorners& corners);
    void include_volume(WorstCell& cell, const CellNodes& nodes, const CellCorners& corners);
    double include_angles(const CellNodes& nodes);
    void keep_worst(const WorstCell& cell);

    const Zone& zone_;
    Vec3 plane_;
    std::size_t worst_count_;
    std::size_t axes_;
};

void keep_least(CellExtreme& kept, const CellExtreme& found) {
    if (!(found.value >= kept.value)) kept = found;
}
void keep_greatest(CellExtreme& kept, const CellExtreme& found) {
    if (!(found.value <= kept.value)) kept = found;
}

/// Returns the least scaled Jacobian of the cell.
double Collector::include_corners(const Node& cell, const Vec3& centre,
                                  const CellCorners& corners) {
    double least_scaled = 1;
    for (const CellCorner& corner : corners) {
        if (corner.counted_apart()) continue;
        keep_least(statistics.quality.least_jacobian, {corner.jacobian, cell, centre});
        if (!(corner.scaled_jacobian >= least_scaled)) least_scaled = corner.scaled_jacobian;
    }
    statistics.scaled_jacobian.include(least_scaled);
    return least_scaled;
}

/// Finds the volume of the cell, and whether its Jacobian is positive.
void Collector::include_volume(WorstCell& cell, const CellNodes& nodes,
                               const CellCorners& corners) {
    ZoneQuality& q = statistics.quality;
    double& volume = cell.volume;
    JacobianVerdict& verdict = cell.verdict;
    if (axes_ == 3) {
        const JacobianCoefficients coefficients = jacobian_coefficients(nodes);
        FlatCorners flat{};
        for (std::size_t c = 0; c < 8; ++c) flat[c] = corners.corners[c].counted_apart();
        volume = cell_volume(coefficients);
        verdict = judge_jacobian(coefficients, flat);
    } else {
        // The Jacobian of a bilinear map is linear along every side: its corners bound it.
        volume = surface_cell_area(nodes, plane_);
        for (const CellCorner& corner : corners) {
            if (corner.folds()) verdict = JacobianVerdict::not_positive;
        }
    }
    q.volume += volume;
    keep_least(q.least_volume, {volume, cell.cell, cell.place});
    keep_greatest(q.greatest_volume, {volume, cell.cell, cell.place});
    q.positive += verdict == JacobianVerdict::positive;
    q.not_positive += verdict == JacobianVerdict::not_positive;
    q.undecided += verdict == JacobianVerdict::undecided;
}

/// Returns the skewness of the cell.
double Collector::include_angles(const CellNodes& nodes) {
    double greatest = 0;
    visit_deviations(nodes, axes_, [&](double off) {
        statistics.deviation.include(off);
        if (!(off <= greatest)) greatest = off;
    });
    return greatest / 90;
}

void Collector::keep_worst(const WorstCell& cell) {
    auto& worst = statistics.worst;
    if (worst.size() == worst_count_ && (worst.empty() || !is_worse(cell, worst.back()))) {
        return;
    }
    const auto at = std::upper_bound(worst.begin(), worst.end(), cell, is_worse);
    worst.insert(at, cell);
    if (worst.size() > worst_count_) worst.pop_back();
}

void Collector::include(const Node& cell) {
    const CellNodes nodes = cell_nodes(zone_.points, cell);
    const Vec3 centre = centre_of(nodes, axes_ == 3 ? 8 : 4);
    const CellCorners corners = cell_corners(zone_.points, cell, plane_);
    WorstCell judged{zone_.name, cell, centre};
    judged.scaled_jacobian = include_corners(cell, centre, corners);
    include_volume(judged, nodes, corners);
    judged.skewness = include_angles(nodes);
    statistics.skewness.include(judged.skewness);
    statistics.quality.mean_skewness += judged.skewness;
    keep_greatest(statistics.quality.greatest_skewness, {judged.skewness, cell, centre});
    const double aspect = cell_aspect_ratio(nodes, axes_);
    statistics.aspect_ratio.include(aspect);
    keep_greatest(statistics.quality.greatest_aspect_ratio, {aspect, cell, centre});
    keep_worst(judged);
}

void Collector::include(const Collector& later) {
    ZoneQuality& q = statistics.quality;
    const ZoneQuality& o = later.statistics.quality;
    q.volume += o.volume;
    keep_least(q.least_volume, o.least_volume);
    keep_greatest(q.greatest_volume, o.greatest_volume);
    keep_least(q.least_jacobian, o.least_jacobian);
    q.positive += o.positive;
    q.not_positive += o.not_positive;
    q.undecided += o.undecided;
    q.mean_skewness += o.mean_skewness;
    keep_greatest(q.greatest_skewness, o.greatest_skewness);
    keep_greatest(q.greatest_aspect_ratio, o.greatest_aspect_ratio);
    statistics.scaled_jacobian.include(later.statistics.scaled_jacobian);
    statistics.skewness.include(later.statistics.skewness);
    statistics.aspect_ratio.include(later.statistics.aspect_ratio);
    statistics.deviation.include(later.statistics.deviation);
    for (const WorstCell& cell : later.statistics.worst) keep_worst(cell);
}

}  // namespace

Histogram skewness_in_thousandths() {
    std::vector<double> limits;
    for (int n = 1; n <= 1000; ++n) limits.push_back(n / 1000.0);
    return {"equiangle skewness", std::move(limits)};
}

CellStatistics cell_statistics(const Zone& zone, int physical_dimension, int worst_count) {
    const Vec3 plane = zone_plane(zone.points, physical_dimension);
    const Extent e = zone.points.extent();
    // Rows of cells are parts of their own, put together in their order: sums do not depend on the
    // number of threads.
    const auto layers = static_cast<std::size_t>(e.nk == 1 ? e.nj - 1 : e.nk - 1);
    std::vector<Collector> parts(layers, Collector(zone, plane, worst_count));
    parallel_for(layers, [&](std::size_t layer) {
        const int n = static_cast<int>(layer);
        const int first_j = e.nk == 1 ? n : 0;
        const int last_j = e.nk == 1 ? n : e.nj - 2;
        for (int j = first_j; j <= last_j; ++j) {
            for (int i = 0; i + 1 < e.ni; ++i) parts[layer].include({i, j, e.nk == 1 ? 0 : n});
        }
    });
    Collector all(zone, plane, worst_count);
    for (const Collector& part : parts) all.include(part);
    all.statistics.quality.mean_skewness /=
        static_cast<double>(std::max<std::size_t>(e.cells(), 1));
    all.statistics.quality.skewness_99 = all.statistics.skewness.quantile(0.99);
    return all.statistics;
}

}  // namespace hexweave
