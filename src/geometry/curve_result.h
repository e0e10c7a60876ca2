// SPDX-License-Identifier: Apache-2.0
// What a maker of curves returns where its data may be faulty: a curve, or the fault in words.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "geometry/curve.h"

namespace hexweave {

/// Either `curve` holds a value, or `error` says what is wrong (a fact, no full stop). `line`
/// counts from 1 where the fault stands in a text that was read, else it is 0.
struct CurveResult {
    std::optional<Curve> curve;
    std::string error;
    int line = 0;

    CurveResult(Curve made) : curve(std::move(made)) {}
    CurveResult(std::string what, int where = 0) : error(std::move(what)), line(where) {}
};

}  // namespace hexweave
