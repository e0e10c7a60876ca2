// SPDX-License-Identifier: Apache-2.0
// The colours of pictures: twelve that remain distinguishable with the common kinds of colour
// blindness (after Okabe & Ito, "Color Universal Design", and Tol, "Colour schemes"), and their
// shades.
#pragma once

#include <cstdint>

namespace hexweave {

/// Red, green and blue from 0 to 1.
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;

    friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour white{1, 1, 1};
inline constexpr Colour ink{0.13, 0.15, 0.18};      ///< block boundaries, text
inline constexpr Colour pencil{0.45, 0.48, 0.52};   ///< axes, grid lines without a colour
inline constexpr Colour plaster{0.80, 0.81, 0.83};  ///< surfaces without a colour

/// The colour of the zone or family of that index; repeats after twelve.
Colour palette(int index);
/// A fraction of the way from one colour to the other.
Colour mix(const Colour& from, const Colour& to, double fraction);
/// The colour of a planar zone of that colour: a breath of it.
Colour tint_colour(const Colour& colour);
/// The colour of a lit surface of the zone or family of that colour: lighter.
Colour surface_colour(const Colour& colour);
/// The colour of grid lines on a surface of that colour: darker.
Colour line_shade(const Colour& colour);
/// 0xRRGGBB.
std::uint32_t to_rgb(const Colour& colour);

}  // namespace hexweave
