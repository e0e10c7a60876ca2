// SPDX-License-Identifier: Apache-2.0
#include "io/picture_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

constexpr Colour from_rgb(std::uint32_t rgb) {
    return {static_cast<double>(rgb >> 16U & 255U) / 255.0,
            static_cast<double>(rgb >> 8U & 255U) / 255.0, static_cast<double>(rgb & 255U) / 255.0};
}

constexpr std::array<Colour, 12> colours{
    from_rgb(0x0072B2),  // blue
    from_rgb(0xD55E00),  // vermilion
    from_rgb(0x009E73),  // bluish green
    from_rgb(0xCC79A7),  // reddish purple
    from_rgb(0xE69F00),  // orange
    from_rgb(0x56B4E9),  // sky blue
    from_rgb(0x882255),  // wine
    from_rgb(0x999933),  // olive
    from_rgb(0x5B4FB0),  // indigo
    from_rgb(0x44AA99),  // teal
    from_rgb(0x8C564B),  // brown
    from_rgb(0x6B7785),  // slate
};

}  // namespace

Colour palette(int index) {
    return colours[static_cast<std::size_t>(index) % colours.size()];
}

Colour mix(const Colour& from, const Colour& to, double fraction) {
    return {from.red + fraction * (to.red - from.red),
            from.green + fraction * (to.green - from.green),
            from.blue + fraction * (to.blue - from.blue)};
}

Colour tint_colour(const Colour& colour) {
    return mix(colour, white, 0.88);
}

Colour surface_colour(const Colour& colour) {
    return mix(colour, white, 0.45);
}

Colour line_shade(const Colour& colour) {
    return mix(colour, ink, 0.6);
}

std::uint32_t to_rgb(const Colour& colour) {
    const auto byte = [](double part) {
        return static_cast<std::uint32_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    };
    return byte(colour.red) << 16U | byte(colour.green) << 8U | byte(colour.blue);
}

}  // namespace hexweave
