// SPDX-License-Identifier: Apache-2.0
// Cosine and sine of an angle, exact at multiples of a right angle, where those of the standard
// library leave 6e-17: what is turned by a quarter keeps its coordinates to the bit.
#pragma once

namespace hexweave {

struct Turn {
    double cosine = 1;
    double sine = 0;
};

/// Of an angle in quarter turns.
Turn turn_by_quarters(double quarters);

/// Of an angle in radians, which is a multiple of a right angle within some last places.
Turn turn_by(double angle);

}  // namespace hexweave
