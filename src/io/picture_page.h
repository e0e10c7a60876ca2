// SPDX-License-Identifier: Apache-2.0
// How space comes onto the page: a camera in parallel projection, the frame that the grid is drawn
// in, and what of a line lies in it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/vec3.h"
#include "io/picture_drawing.h"

namespace hexweave {

/// A right-handed set of unit vectors: to the right of the picture, to its top, to the eye.
struct Camera {
    Vec3 right{1, 0, 0};
    Vec3 up{0, 1, 0};
    Vec3 eye{0, 0, 1};
};

/// The camera in direction `eye`, which must not be zero. What points up is z, or y for a view
/// along z, unless said; an `up` along the view is an error of the user (UsageError).
Camera look_from(const Vec3& eye, const std::optional<Vec3>& up);

/// A rectangle of the page.
struct Frame {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// A point on the page with its depth: pixels towards the eye. Not finite when the node is not.
struct Sight {
    double x = 0;
    double y = 0;
    double depth = 0;

    friend bool operator==(const Sight&, const Sight&) = default;
};

bool is_finite(const Sight& sight);
inline double page_distance(const Sight& a, const Sight& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// The camera, and the place and scale (pixels per unit of length) of its plane on the page.
struct View {
    Camera camera;
    Frame frame;
    double scale = 1;
    Vec3 centre;  ///< what is seen at the frame's centre, as (right, up, depth)

    /// (right, up, depth) in units of length.
    Vec3 plane_coordinates(const Vec3& point) const;
    Sight place(const Vec3& point) const;
    /// xmin, ymin, xmax, ymax of the plane inside the frame.
    std::array<double, 4> window() const;
};

/// The nodes of a rectangle of a grid on the page, i fastest.
struct SightSheet {
    int ni = 0;
    int nj = 0;
    std::vector<Sight> nodes;

    const Sight& operator()(int i, int j) const {
        return nodes[static_cast<std::size_t>(i) +
                     static_cast<std::size_t>(ni) * static_cast<std::size_t>(j)];
    }
};

/// The part of the segment inside the frame, or nothing. An end that lies inside is kept as it is.
std::optional<std::array<Sight, 2>> clip(const Frame& frame, const Sight& a, const Sight& b);

/// The part of a polygon inside the frame [Sutherland & Hodgman 1974].
Polyline clip_polygon(const Frame& frame, const Polyline& ring);

/// The line with points closer than 0.3 px merged, and without those nearer than `tolerance` to the
/// line through their neighbours [Douglas & Peucker 1973]. First and last points stay.
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace hexweave
