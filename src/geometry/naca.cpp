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

/// One end of a camber line: z (constant + linear z + square z^2), z the distance from that end, so
/// that it is exactly 0 there.
struct CamberEnd {
    double constant = 0;
    double linear = 0;
    double square = 0;
};

/// A camber line in two pieces that meet at `joint` (0: no camber).
struct CamberLine {
    double joint = 0;
    CamberEnd front;  ///< z = x
    CamberEnd rear;   ///< z = 1 - x
};

/// The section for unit chord.
struct Section {
    CamberLine camber;
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
Camber camber_at(const CamberLine& line, double x) {
    const bool front = x < line.joint;
    const CamberEnd& end = front ? line.front : line.rear;
    const double z = front ? x : 1 - x;
    const double slope = end.constant + z * (2 * end.linear + z * 3 * end.square);
    return {z * (end.constant + z * (end.linear + z * end.square)), front ? slope : -slope,
            2 * end.linear + z * 6 * end.square};
}

/// Two parabolas that are level where they meet, m high at p.
CamberLine four_digit_camber(double m, double p) {
    const double front = m / (p * p);
    const double rear = m / ((1 - p) * (1 - p));
    return {p, {front * 2 * p, -front, 0}, {rear * 2 * (1 - p), -rear, 0}};
}

/// What the tables of Report 537 give for a design lift of 0.3.
struct FiveDigitLine {
    char place;
    char reflexed;
    double m;      ///< where the curvature's slope changes
    double k1;     ///< that slope in front of m
    double ratio;  ///< that slope behind m, relative to k1: k2 / k1
};

constexpr std::array five_digit_lines{FiveDigitLine{'1', '0', 0.0580, 361.400, 0},
                                      FiveDigitLine{'2', '0', 0.1260, 51.640, 0},
                                      FiveDigitLine{'3', '0', 0.2025, 15.957, 0},
                                      FiveDigitLine{'4', '0', 0.2900, 6.643, 0},
                                      FiveDigitLine{'5', '0', 0.3910, 3.230, 0},
                                      FiveDigitLine{'2', '1', 0.1300, 51.990, 0.000764},
                                      FiveDigitLine{'3', '1', 0.2170, 15.793, 0.00677},
                                      FiveDigitLine{'4', '1', 0.3180, 6.520, 0.0303},
                                      FiveDigitLine{'5', '1', 0.4410, 3.191, 0.1355}};

/// A cubic whose second derivative falls to 0 at m, and a cubic (a straight line where not
/// reflexed) behind it. Both ends have been divided by their distance from that end.
CamberLine five_digit_camber(const FiveDigitLine& line, double lift) {
    const double m = line.m;
    const double behind = 1 - m;
    const double f = line.k1 / 6 * (lift / 0.3);
    const double tilt = line.ratio * behind * behind * behind + m * m * m;
    const double r = f * line.ratio;
    return {m,
            {f * (3 * m * m - tilt), -3 * f * m, f},
            {f * tilt - 3 * r * behind * behind, 3 * r * behind, -r}};
}

/// Position and derivative at s = sqrt(x), on the upper (sign 1) or lower (-1) side.
struct SectionPoint {
    Vec3 position;
    Vec3 derivative;
};

SectionPoint section_point(const Section& section, double s, double sign) {
    const double x = s * s;
    const Rated y = half_thickness(section, s);
    const Camber camber = camber_at(section.camber, x);
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
    if (section.camber.joint > 0) curve.breaks = {std::sqrt(section.camber.joint)};
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
    if (section.camber.joint > 0) {
        const double s = std::sqrt(section.camber.joint);
        curve.breaks = {-s, 0, s};
    }
    return curve;
}

/// The camber line of a code, or what is wrong with it.
struct MaybeCamber {
    CamberLine line;
    std::string fault;
};

MaybeCamber camber_of(std::string_view code, const std::string& airfoil) {
    const bool cambered = code[0] != '0';
    const bool placed = code[1] != '0';
    if (cambered && !placed) {
        return {{}, airfoil + " has camber (first digit) without a place (second)"};
    }
    if (!cambered && placed) {
        return {{}, airfoil + " has a place of camber (second digit) without camber"};
    }
    const int first = code[0] - '0';
    if (code.size() == 4) {
        if (!cambered) return {};
        return {four_digit_camber(first / 100.0, (code[1] - '0') / 10.0), ""};
    }
    for (const FiveDigitLine& line : five_digit_lines) {
        if (line.place == code[1] && line.reflexed == code[2]) {
            return {five_digit_camber(line, 0.15 * first), ""};
        }
    }
    return {{},
            airfoil + " has no camber line '" + std::string(code.substr(1, 2)) +
                "' (second and third digit): the five-digit ones are 10, 20, 30, 40, 50, and "
                "reflexed 21, 31, 41, 51"};
}

}  // namespace

CurveResult naca_airfoil(std::string_view code, double chord, AirfoilSide side, TrailingEdge edge) {
    const std::string quoted = std::string("'").append(code).append("'");
    const bool digits = code.find_first_not_of("0123456789") == std::string_view::npos;
    if (!digits || (code.size() != 4 && code.size() != 5)) {
        return "a NACA code has four or five digits, not " + quoted;
    }
    const std::string airfoil = "the NACA airfoil " + quoted;
    const int thickness = 10 * (code[code.size() - 2] - '0') + (code.back() - '0');
    if (thickness == 0) return airfoil + " has no thickness";
    const MaybeCamber camber = camber_of(code, airfoil);
    if (!camber.fault.empty()) return camber.fault;
    const Section section{camber.line, thickness / 100.0, edge == TrailingEdge::sharp};
    const Curve unit = side == AirfoilSide::whole   ? whole_curve(section)
                       : side == AirfoilSide::upper ? side_curve(section, 1)
                                                    : side_curve(section, -1);
    return transformed(unit, scaling({chord, chord, chord}));
}

}  // namespace hexweave
