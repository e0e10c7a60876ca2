// SPDX-License-Identifier: Apache-2.0
#include "io/picture_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hexweave {

namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr int shades = 40;  ///< of one colour: more than the eye tells apart

double cross_of(const Sight& a, const Sight& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

Sight between(const std::array<Sight, 4>& cell, double s, double t) {
    const auto mean = [&](double a, double b, double c, double d) {
        return (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c);
    };
    return {mean(cell[0].x, cell[1].x, cell[2].x, cell[3].x),
            mean(cell[0].y, cell[1].y, cell[2].y, cell[3].y),
            mean(cell[0].depth, cell[1].depth, cell[2].depth, cell[3].depth)};
}

std::array<Sight, 4> corners(const SightSheet& sheet, int i0, int i1, int j0, int j1) {
    return {sheet(i0, j0), sheet(i1, j0), sheet(i1, j1), sheet(i0, j1)};
}

bool all_finite(const std::array<Sight, 4>& cell) {
    return std::all_of(cell.begin(), cell.end(), [](const Sight& s) { return is_finite(s); });
}

bool outside(const Frame& frame, const std::array<Sight, 4>& cell) {
    const auto all = [&](auto&& beyond) { return std::all_of(cell.begin(), cell.end(), beyond); };
    return all([&](const Sight& s) { return s.x < frame.left; }) ||
           all([&](const Sight& s) { return s.x > frame.right; }) ||
           all([&](const Sight& s) { return s.y < frame.top; }) ||
           all([&](const Sight& s) { return s.y > frame.bottom; });
}

/// Where a triangle crosses a height of the page: from the left, to the right.
std::array<double, 2> crossing(const std::array<Sight, 3>& triangle, double y) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t n = 0; n < 3; ++n) {
        const Sight& p = triangle[n];
        const Sight& q = triangle[(n + 1) % 3];
        if (std::min(p.y, q.y) > y || std::max(p.y, q.y) < y) continue;
        const double f = p.y == q.y ? 0 : (y - p.y) / (q.y - p.y);
        const double x = p.x + f * (q.x - p.x);
        left = std::min(left, x);
        right = std::max(right, x);
    }
    return {left, right};
}

double spatial_distance(const Sight& a, const Sight& b) {
    return std::hypot(b.x - a.x, b.y - a.y, b.depth - a.depth);
}

}  // namespace

Raster::Raster(int width, int height, const Frame& frame)
    : frame_(frame),
      factor_(static_cast<double>(width) * height <= 5e6 ? 2 : 1),
      width_(width * factor_),
      height_(height * factor_),
      depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), nothing),
      colour_(depth_.size(), to_rgb(white)) {}

void Raster::draw(const SightSheet& sheet, const Colour& colour) {
    for (int j = 0; j + 1 < sheet.nj; ++j) {
        for (int i = 0; i + 1 < sheet.ni; ++i) {
            const auto cell = corners(sheet, i, i + 1, j, j + 1);
            if (!all_finite(cell) || outside(frame_, cell)) continue;
            const std::uint32_t rgb = to_rgb(shaded(colour, cell));
            const bool first_diagonal =
                spatial_distance(cell[0], cell[2]) <= spatial_distance(cell[1], cell[3]);
            const int turn = first_diagonal ? 0 : 1;
            const auto corner = [&](int n) {
                return cell[static_cast<std::size_t>((n + turn) % 4)];
            };
            draw_triangle(corner(0), corner(1), corner(2), rgb);
            draw_triangle(corner(0), corner(2), corner(3), rgb);
        }
    }
}

// Samples on an edge belong to both triangles: no gaps, and the nearer or first one stays.
void Raster::draw_triangle(const Sight& a, const Sight& b, const Sight& c, std::uint32_t colour) {
    const double area = cross_of(a, b, c.x, c.y);
    if (area == 0) return;
    const auto samples = [&](double from, double to, double low, double high) {
        return std::array{static_cast<int>(std::ceil(std::clamp(from, low, high) * factor_ - 0.5)),
                          static_cast<int>(std::floor(std::clamp(to, low, high) * factor_ - 0.5))};
    };
    const auto rows =
        samples(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), frame_.top, frame_.bottom);
    constexpr double slack = -1e-9;
    for (int row = rows[0]; row <= rows[1]; ++row) {
        const double y = (row + 0.5) / factor_;
        const auto [from, to] = crossing({a, b, c}, y);
        const auto columns = samples(from - 0.01, to + 0.01, frame_.left, frame_.right);
        for (int column = columns[0]; column <= columns[1]; ++column) {
            const double x = (column + 0.5) / factor_;
            const double of_a = cross_of(b, c, x, y) / area;
            const double of_b = cross_of(c, a, x, y) / area;
            const double of_c = 1 - of_a - of_b;
            if (of_a < slack || of_b < slack || of_c < slack) continue;
            const double depth = of_a * a.depth + of_b * b.depth + of_c * c.depth;
            const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(column);
            if (depth <= depth_[at]) continue;
            depth_[at] = depth;
            colour_[at] = colour;
            covered_ = true;
        }
    }
}

// The nine samples around the point: on a steep surface its own sample may lie nearer.
bool Raster::sees(const Sight& point) const {
    const auto range = [&](double at, double low, double high) {
        const double first = std::ceil(low * factor_ - 0.5);
        const double last = std::floor(high * factor_ - 0.5);
        const double sample = std::floor(std::clamp(at * factor_, first, last));
        return std::array{static_cast<int>(std::max(sample - 1, first)),
                          static_cast<int>(std::min(sample + 1, last))};
    };
    const auto columns = range(point.x, frame_.left, frame_.right);
    const auto rows = range(point.y, frame_.top, frame_.bottom);
    double farthest = std::numeric_limits<double>::infinity();
    for (int row = rows[0]; row <= rows[1]; ++row) {
        for (int column = columns[0]; column <= columns[1]; ++column) {
            farthest = std::min(
                farthest, depth_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(column)]);
        }
    }
    return point.depth >= farthest - 1;
}

std::vector<std::uint32_t> Raster::pixels() const {
    const int columns = width_ / factor_;
    const int rows = height_ / factor_;
    const auto samples = static_cast<std::uint32_t>(factor_ * factor_);
    std::vector<std::uint32_t> result;
    result.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            std::array<std::uint32_t, 3> sum{samples / 2, samples / 2, samples / 2};
            for (int n = 0; n < factor_ * factor_; ++n) {
                const int x = column * factor_ + n % factor_;
                const int y = row * factor_ + n / factor_;
                const std::uint32_t rgb =
                    colour_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(x)];
                sum[0] += rgb >> 16U & 255U;
                sum[1] += rgb >> 8U & 255U;
                sum[2] += rgb & 255U;
            }
            result.push_back(sum[0] / samples << 16U | sum[1] / samples << 8U | sum[2] / samples);
        }
    }
    return result;
}

Colour shaded(const Colour& colour, const std::array<Sight, 4>& cell) {
    const auto diagonal = [&](std::size_t from, std::size_t to) {
        return Vec3{cell[to].x - cell[from].x, cell[from].y - cell[to].y,
                    cell[to].depth - cell[from].depth};
    };
    const Vec3 normal = cross(diagonal(0, 2), diagonal(1, 3));
    const double length = norm(normal);
    if (!(length > 0)) return colour;
    constexpr Vec3 light{-0.34, 0.48, 0.809};
    const Vec3 facing = (normal.z < 0 ? -1 : 1) * normal / length;
    const double lit = std::max(0.0, dot(facing, light));
    const double brightness = std::round(shades * (0.6 + 0.4 * lit)) / shades;
    return mix({0.09, 0.10, 0.14}, colour, brightness);
}

namespace {

/// Cuts a sheet into tiles: a rectangle of cells is halved while it is large on the page, and a
/// single large cell is cut into parts, so that the order of the tiles' depths is that of the
/// surfaces.
class Tiler {
public:
    Tiler(const SightSheet& sheet, const Colour& colour, const Frame& frame, const Raster& raster,
          double size, std::vector<DeepTile>& tiles)
        : sheet_(sheet),
          colour_(colour),
          frame_(frame),
          raster_(raster),
          size_(size),
          tiles_(tiles) {}

    void cut(int i0, int i1, int j0, int j1) {
        if (i1 - i0 == 1 && j1 - j0 == 1) {
            cut_cell(corners(sheet_, i0, i1, j0, j1));
            return;
        }
        const int im = (i0 + i1) / 2;
        const int jm = (j0 + j1) / 2;
        const double along_i = length({sheet_(i0, j0), sheet_(im, j0), sheet_(i1, j0)},
                                      {sheet_(i0, j1), sheet_(im, j1), sheet_(i1, j1)});
        const double along_j = length({sheet_(i0, j0), sheet_(i0, jm), sheet_(i0, j1)},
                                      {sheet_(i1, j0), sheet_(i1, jm), sheet_(i1, j1)});
        const bool small =
            std::max(along_i, along_j) <= size_ && std::max(i1 - i0, j1 - j0) <= widest;
        if (small || (std::max(along_i, along_j) <= 3 * size_ && is_even(i0, i1, j0, j1))) {
            append(corners(sheet_, i0, i1, j0, j1));
        } else if (i1 - i0 > 1 && (along_i >= along_j || j1 - j0 == 1)) {
            cut(i0, im, j0, j1);
            cut(im, i1, j0, j1);
        } else {
            cut(i0, i1, j0, jm);
            cut(i0, i1, jm, j1);
        }
    }

private:
    static constexpr int widest = 64;   ///< cells in a tile: it shows what lies between its corners
    static constexpr double part = 12;  ///< pixels: parts of a large cell

    static double length(const std::array<Sight, 3>& a, const std::array<Sight, 3>& b) {
        return std::max(page_distance(a[0], a[1]) + page_distance(a[1], a[2]),
                        page_distance(b[0], b[1]) + page_distance(b[1], b[2]));
    }

    /// Whether the quarters of a tile are as bright as the whole and lie where it shows them.
    bool is_even(int i0, int i1, int j0, int j1) const {
        const int im = (i0 + i1) / 2;
        const int jm = (j0 + j1) / 2;
        const auto tile = corners(sheet_, i0, i1, j0, j1);
        const Colour colour = shaded(colour_, tile);
        const auto like = [&](int a, int b, int c, int d) {
            return shaded(colour_, corners(sheet_, a, b, c, d)) == colour;
        };
        const auto off = [&](int i, int j, std::size_t a, std::size_t b) {
            const double along = page_distance(tile[a], tile[b]);
            return along > 0
                       ? std::abs(cross_of(tile[a], tile[b], sheet_(i, j).x, sheet_(i, j).y)) /
                             along
                       : 0;
        };
        constexpr double straight = 0.3;  // pixels
        return i1 - i0 > 1 && j1 - j0 > 1 && like(i0, im, j0, jm) && like(im, i1, j0, jm) &&
               like(i0, im, jm, j1) && like(im, i1, jm, j1) && off(im, j0, 0, 1) < straight &&
               off(i1, jm, 1, 2) < straight && off(im, j1, 3, 2) < straight &&
               off(i0, jm, 0, 3) < straight;
    }

    void cut_cell(const std::array<Sight, 4>& cell) {
        if (!all_finite(cell) || outside(frame_, cell)) return;
        const auto parts = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
            const double longest =
                std::max(page_distance(cell[a], cell[b]), page_distance(cell[c], cell[d]));
            return static_cast<int>(std::clamp(std::ceil(longest / part), 1.0, 400.0));
        };
        const int ni = parts(0, 1, 3, 2);
        const int nj = parts(0, 3, 1, 2);
        const Colour colour = shaded(colour_, cell);
        for (int j = 0; j < nj; ++j) {
            for (int i = 0; i < ni; ++i) {
                const auto at = [&](int m, int n) {
                    return between(cell, static_cast<double>(m) / ni, static_cast<double>(n) / nj);
                };
                append({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, colour);
            }
        }
    }

    void append(const std::array<Sight, 4>& tile) {
        if (all_finite(tile)) append(tile, shaded(colour_, tile));
    }

    void append(const std::array<Sight, 4>& tile, const Colour& colour) {
        if (outside(frame_, tile) || !seen(tile)) return;
        Polyline ring;
        for (const Sight& corner : tile) ring.push_back({corner.x, corner.y});
        if (cross_of(tile[0], tile[1], tile[2].x, tile[2].y) < 0) {
            std::reverse(ring.begin(), ring.end());
        }
        ring = clip_polygon(frame_, ring);
        if (ring.size() < 3) return;
        const double depth = between(tile, 0.5, 0.5).depth;
        tiles_.push_back({{std::move(ring), colour}, depth});
    }

    bool seen(const std::array<Sight, 4>& tile) const {
        for (const double t : {0.5, 0.02, 0.98, 0.25, 0.75}) {
            for (const double s : {0.5, 0.02, 0.98, 0.25, 0.75}) {
                if (raster_.sees(between(tile, s, t))) return true;
            }
        }
        return false;
    }

    const SightSheet& sheet_;
    const Colour& colour_;
    const Frame& frame_;
    const Raster& raster_;
    double size_;
    std::vector<DeepTile>& tiles_;
};

}  // namespace

void append_tiles(const SightSheet& sheet, const Colour& colour, const Frame& frame,
                  const Raster& raster, double size, std::vector<DeepTile>& tiles) {
    if (sheet.ni < 2 || sheet.nj < 2) return;
    Tiler(sheet, colour, frame, raster, size, tiles).cut(0, sheet.ni - 1, 0, sheet.nj - 1);
}

Mosaic mosaic(std::vector<DeepTile> tiles) {
    std::stable_sort(tiles.begin(), tiles.end(),
                     [](const DeepTile& a, const DeepTile& b) { return a.depth < b.depth; });
    Mosaic result;
    for (DeepTile& tile : tiles) result.tiles.push_back(std::move(tile.tile));
    return result;
}

}  // namespace hexweave
