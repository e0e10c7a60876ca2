// SPDX-License-Identifier: Apache-2.0
// Labels that keep clear of each other and of lines as far as there is room: each takes the best of
// the places that it could stand at, in the order in which they are placed.
#pragma once

#include <string>
#include <vector>

#include "io/picture_drawing.h"
#include "io/picture_page.h"

namespace hexweave {

/// What a label says and looks like.
struct LabelText {
    std::string text;
    double size = 12;
    Colour colour = ink;
    bool bold = false;
};

class LabelPlacement {
public:
    /// `frame`: nothing of a label should stand outside.
    explicit LabelPlacement(const Frame& frame) : frame_(frame) {}

    /// Points that labels should not cover: those of lines, a few pixels apart.
    void avoid(const Polyline& line);
    /// Places the label with its centre at one of `centres`, the first ones preferred.
    void place(const LabelText& label, const std::vector<PagePoint>& centres);
    /// The labels, each on a white ground.
    void append_to(Drawing& drawing) const;

private:
    struct Placed {
        LabelText label;
        Frame box;
    };
    double cost_at(const Frame& box) const;

    Frame frame_;
    Polyline points_;
    std::vector<Placed> placed_;
};

/// Around a point: to the right, left, above, below, and between, with room for the text.
std::vector<PagePoint> places_around(const PagePoint& point, const LabelText& label);
/// Beside a line, at its middle or nearer to its ends, on either side.
std::vector<PagePoint> places_beside(const Polyline& line, const LabelText& label);

}  // namespace hexweave
