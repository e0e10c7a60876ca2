// SPDX-License-Identifier: Apache-2.0
#include "topology/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "topology/sample.h"

namespace hexweave {
namespace {

// A prime: symmetric sides do not cross just where both have a sample, which would be a touch.
constexpr int coarse = 97;
constexpr int fine = 24;
constexpr double resolved = 1e-5;     ///< of an edge: chords this short stand for it
constexpr double least_angle = 1e-3;  ///< radians
constexpr double at_end = 1e-5;       ///< of the shorter edge: what meets there touches
constexpr double in_plane = 1e-6;     ///< of the size of the sides

/// A part of an edge, between two fractions of it, and its chord in the plane's coordinates.
struct Piece {
    int edge = 0;
    double begin = 0;
    double end = 1;
    Vec3 from;
    Vec3 to;

    Vec3 chord() const { return to - from; }
};

/// Two pieces whose chords cross.
struct Candidate {
    Piece first;
    Piece second;

    double width() const { return std::max(first.end - first.begin, second.end - second.begin); }
    double sine() const {
        return std::abs(cross(first.chord(), second.chord()).z) /
               (norm(first.chord()) * norm(second.chord()));
    }
};

struct Plane {
    Vec3 origin;
    std::array<Vec3, 2> axes;  ///< of length 1, at right angles

    Vec3 coordinates(const Vec3& p) const {
        return {dot(p - origin, axes[0]), dot(p - origin, axes[1]), 0};
    }
};

/// The point for which a measure is greatest.
template <class Measure>
const Vec3& farthest(const std::vector<Vec3>& points, const Measure& measure) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

/// Nothing where the points lie on a line, or in no plane.
std::optional<Plane> plane_of(const std::vector<Vec3>& points) {
    if (points.empty()) return std::nullopt;
    const Vec3& origin = points.front();
    const Vec3 along =
        farthest(points, [&](const Vec3& p) { return distance(p, origin); }) - origin;
    const double size = norm(along);
    if (size == 0) return std::nullopt;
    const Vec3 first = along / size;
    const auto off_line = [&](const Vec3& p) {
        return (p - origin) - dot(p - origin, first) * first;
    };
    const Vec3 across =
        off_line(farthest(points, [&](const Vec3& p) { return norm(off_line(p)); }));
    if (norm(across) <= in_plane * size) return std::nullopt;
    const Plane plane{origin, {first, across / norm(across)}};
    const Vec3 normal = cross(plane.axes[0], plane.axes[1]);
    const bool flat = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
        return std::abs(dot(p - origin, normal)) <= in_plane * size;
    });
    return flat ? std::optional<Plane>(plane) : std::nullopt;
}

std::vector<Vec3> points_at(const Edge& edge, const std::vector<double>& fractions) {
    std::vector<Vec3> points;
    points.reserve(fractions.size());
    for (const double fraction : fractions) points.push_back(point_at(edge, fraction));
    return points;
}

/// The pieces of an edge between its points at some fractions.
void append_pieces(std::vector<Piece>& pieces, int edge, const std::vector<double>& fractions,
                   const std::vector<Vec3>& points, const Plane& plane) {
    for (std::size_t n = 1; n < points.size(); ++n) {
        pieces.push_back({edge, fractions[n - 1], fractions[n], plane.coordinates(points[n - 1]),
                          plane.coordinates(points[n])});
    }
}

std::vector<Vec3> joined(const std::map<int, std::vector<Vec3>>& points) {
    std::vector<Vec3> all;
    for (const auto& [edge, own] : points) all.insert(all.end(), own.begin(), own.end());
    return all;
}

/// Of a whole edge, closer at its ends, where its neighbours meet it.
std::vector<double> graded_fractions() {
    std::vector<double> fractions;
    for (int n = 0; n <= coarse; ++n) {
        fractions.push_back((1 - std::cos(std::numbers::pi * n / coarse)) / 2);
    }
    return fractions;
}

/// Of a piece and of as much of the edge on either side of it.
std::vector<double> finer_fractions(const Piece& piece) {
    const double width = piece.end - piece.begin;
    const double begin = std::max(0.0, piece.begin - width);
    const double end = std::min(1.0, piece.end + width);
    std::vector<double> fractions;
    for (int n = 0; n <= fine; ++n) fractions.push_back(begin + (end - begin) * n / fine);
    return fractions;
}

bool chords_cross(const Piece& a, const Piece& b) {
    const auto divides = [](const Piece& line, const Piece& other) {
        return cross(line.chord(), other.from - line.from).z *
                   cross(line.chord(), other.to - line.from).z <
               0;
    };
    return divides(a, b) && divides(b, a);
}

/// Whether two pieces are the same part of an edge, or neighbours.
bool belong_together(const Piece& a, const Piece& b) {
    return a.edge == b.edge && a.begin <= b.end && b.begin <= a.end;
}

/// All pairs of pieces whose chords cross. The pieces are sorted, so that each is compared with
/// those alone that begin before it ends.
std::vector<Candidate> candidates(std::vector<Piece> pieces) {
    const auto low = [](const Piece& p) { return std::min(p.from.x, p.to.x); };
    const auto high = [](const Piece& p) { return std::max(p.from.x, p.to.x); };
    std::stable_sort(pieces.begin(), pieces.end(),
                     [&](const Piece& a, const Piece& b) { return low(a) < low(b); });
    std::vector<Candidate> found;
    for (std::size_t a = 0; a < pieces.size(); ++a) {
        const double end = high(pieces[a]);
        for (std::size_t b = a + 1; b < pieces.size() && low(pieces[b]) <= end; ++b) {
            if (belong_together(pieces[a], pieces[b]) || !chords_cross(pieces[a], pieces[b])) {
                continue;
            }
            found.push_back({pieces[a], pieces[b]});
        }
    }
    return found;
}

/// Follows a crossing of chords down to chords that stand for their edges; nothing where they turn
/// out not to cross.
std::optional<Candidate> refined(Candidate candidate, const Plane& plane, const EdgeLookup& edge) {
    while (candidate.width() > resolved) {
        std::vector<Piece> pieces;
        for (const Piece& piece : {candidate.first, candidate.second}) {
            const std::vector<double> fractions = finer_fractions(piece);
            append_pieces(pieces, piece.edge, fractions, points_at(edge(piece.edge), fractions),
                          plane);
        }
        const std::vector<Candidate> finer = candidates(std::move(pieces));
        if (finer.empty()) return std::nullopt;
        candidate = *std::max_element(
            finer.begin(), finer.end(),
            [](const Candidate& a, const Candidate& b) { return a.sine() < b.sine(); });
    }
    return candidate;
}

/// Where two chords cross, without what round-off leaves of a coordinate that is zero.
Vec3 place_of(const Candidate& candidate, const EdgeLookup& edge) {
    const Piece& a = candidate.first;
    const Piece& b = candidate.second;
    const double part = cross(b.from - a.from, b.chord()).z / cross(a.chord(), b.chord()).z;
    const Edge& first = edge(a.edge);
    const Vec3 place = point_at(first, a.begin + (a.end - a.begin) * part);
    const double noise = 1e-9 * first.length;
    const auto cleared = [&](double value) { return std::abs(value) <= noise ? 0.0 : value; };
    return {cleared(place.x), cleared(place.y), cleared(place.z)};
}

bool is_at_an_end(const Vec3& place, const Edge& first, const Edge& second) {
    const double near = at_end * std::min(first.length, second.length);
    for (const Edge* edge : {&first, &second}) {
        for (const double end : {0.0, 1.0}) {
            if (distance(place, point_at(*edge, end)) <= near) return true;
        }
    }
    return false;
}

}  // namespace

std::optional<EdgeCrossing> find_crossing(const FrameSides& sides, const EdgeLookup& edge) {
    const std::vector<double> fractions = graded_fractions();
    std::map<int, std::vector<Vec3>> points;
    for (const auto& side : sides) {
        for (const EdgeUse& use : side) {
            if (use.pole || points.count(use.edge) != 0) continue;
            points[use.edge] = points_at(edge(use.edge), fractions);
        }
    }
    const std::optional<Plane> plane = plane_of(joined(points));
    if (!plane) return std::nullopt;
    std::vector<Piece> pieces;
    for (const auto& [index, own] : points) append_pieces(pieces, index, fractions, own, *plane);
    for (const Candidate& rough : candidates(std::move(pieces))) {
        const std::optional<Candidate> found = refined(rough, *plane, edge);
        if (!found || found->sine() < least_angle) continue;
        const Vec3 place = place_of(*found, edge);
        const auto [first, second] = std::minmax(found->first.edge, found->second.edge);
        if (is_at_an_end(place, edge(first), edge(second))) continue;
        return EdgeCrossing{first, second, place};
    }
    return std::nullopt;
}

}  // namespace hexweave
