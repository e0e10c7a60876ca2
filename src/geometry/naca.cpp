// SPDX-License-Identifier: Apache-2.0
#include "geometry/naca.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "geometry/transform.h"

namespace hexweave {

namespace {

/// A value and its derivative by the curve's parameter.
struct Rated {
    double value;
    double rate;
};

/// The section for unit chord.
struct Section {
    double camber = 0;     ///< greatest camber m
    double place = 0;      ///< of the greatest camber, p; 0 without camber
    double thickness = 0;  ///< greatest thickness t
    bool sharp = true;
};

/// Half the thickness at x = s^2. The sharp form is written with the factor (1 - s) taken out, so
/// that it is exactly 0 at the trailing edge.
Rated half_thickness(const Section& section, double s) {
    // Coefficients of s, s^2, ..., s^8.
    constexpr std::array blunt{0.2969, -0.1260, 0.0, -0.3516, 0.0, 0.2843, 0.0, -0.1015};
    constexpr std::array factored{0.2969, 0.1709, 0.1709, -0.1807, -0.1807, 0.1036, 0.1036, 0.0};
    const auto& coefficients = section.sharp ? factored : blunt;
    Rated sum{0, 0};
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        sum.rate = sum.rate * s + sum.value;
        sum.value = sum.value * s + coefficients[k];
    }
    Rated half{sum.value * s, sum.rate * s + sum.value};
    if (section.sharp) half = {half.value * (1 - s), half.rate * (1 - s) - half.value};
    return {5 * section.thickness * half.value, 5 * section.thickness * half.rate};
}

struct Camber {
    double height;
    double slope;
    double curvature;  ///< second derivative
};

/// The camber line at x; exactly 0 at both ends.
Camber camber_line(const Section& section, double x) {
    const double m = section.camber;
    const double p = section.place;
    if (m == 0) return {0, 0, 0};
    if (x < p) {
        const double f = m / (p * p);
        return {f * x * (2 * p - x), 2 * f * (p - x), -2 * f};
    }
    const double f = m / ((1 - p) * (1 - p));
    return {f * (1 - x) * (1 - 2 * p + x), 2 * f * (p - x), -2 * f};
}

/// Position and derivative at s = sqrt(x), on the upper (sign 1) or lower (-1) side.
struct SectionPoint {
    Vec3 position;
    Vec3 derivative;
};

SectionPoint section_point(const Section& section, double s, double sign) {
    const double x = s * s;
    const Rated y = half_thickness(section, s);
    const Camber camber = camber_line(section, x);
    // The normal of the camber line is (-sine, cosine) of its angle.
    const double cosine = 1 / std::sqrt(1 + camber.slope * camber.slope);
    const double sine = camber.slope * cosine;
    const double dx = 2 * s;
    const double angle_rate = camber.curvature * dx * cosine * cosine;
    return {{x - sign * y.value * sine, camber.height + sign * y.value * cosine, 0},
            {dx - sign * (y.rate * sine + y.value * cosine * angle_rate),
             camber.slope * dx + sign * (y.rate * cosine - y.value * sine * angle_rate), 0}};
}

/// One side, s from 0 to 1.
Curve side_curve(const Section& section, double sign) {
    Curve curve;
    curve.position = [=](double s) { return section_point(section, s, sign).position; };
    curve.derivative = [=](double s) { return section_point(section, s, sign).derivative; };
    if (section.camber > 0) curve.breaks = {std::sqrt(section.place)};
    return curve;
}

/// Both sides: s = -parameter on the upper one, s = parameter on the lower one.
Curve whole_curve(const Section& section) {
    Curve curve;
    curve.position = [=](double w) {
        return section_point(section, std::abs(w), w < 0 ? 1 : -1).position;
    };
    curve.derivative = [=](double w) {
        return w < 0 ? -section_point(section, -w, 1).derivative
                     : section_point(section, w, -1).derivative;
    };
    curve.begin = -1;
    curve.end = 1;
    curve.closed = section.sharp;
    curve.breaks = {0};
    if (section.camber > 0) {
        const double s = std::sqrt(section.place);
        curve.breaks = {-s, 0, s};
    }
    return curve;
}

}  // namespace

CurveResult naca4(std::string_view code, double chord, AirfoilSide side, TrailingEdge edge) {
    const std::string quoted = std::string("'").append(code).append("'");
    if (code.size() != 4) return "a NACA code has four digits, not " + quoted;
    std::array<int, 4> digits{};
    for (std::size_t k = 0; k < 4; ++k) {
        if (code[k] < '0' || code[k] > '9') return "a NACA code has four digits, not " + quoted;
        digits[k] = code[k] - '0';
    }
    const Section section{digits[0] / 100.0, digits[1] / 10.0, (10 * digits[2] + digits[3]) / 100.0,
                          edge == TrailingEdge::sharp};
    if (section.thickness == 0) return "the NACA airfoil " + quoted + " has no thickness";
    if (section.camber > 0 && section.place == 0) {
        return "the NACA airfoil " + quoted + " has camber (first digit) without a place (second)";
    }
    if (section.camber == 0 && section.place > 0) {
        return "the NACA airfoil " + quoted +
               " has a place of camber (second digit) without camber";
    }
    const Curve unit = side == AirfoilSide::whole   ? whole_curve(section)
                       : side == AirfoilSide::upper ? side_curve(section, 1)
                                                    : side_curve(section, -1);
    return transformed(unit, scaling({chord, chord, chord}));
}

}  // namespace hexweave
