// SPDX-License-Identifier: Apache-2.0
// Surfaces and curves of CAD files (IGES, STEP), in our own data. Open CASCADE reads the files; it
// lives in a module that is loaded when the first file is read, so that nobody else waits for it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/vec3.h"
#include "geometry/cad_text.h"
#include "geometry/curve.h"
#include "geometry/nurbs.h"
#include "geometry/surface.h"

namespace hexweave {

/// Around samples of a surface, in the rectangle of parameters of its face, or of a curve.
struct CadBox {
    Vec3 low;
    Vec3 high;
};

/// A curve, or an edge of a face. Lengths here and below are in the unit of the file.
struct CadCurve {
    std::string type;      ///< as the file has it: "line", "circle", "B-spline curve", ...
    NurbsPolygon polygon;  ///< over the file's own parameters where that is a B-spline curve
    CadBox box;
    std::string fault;      ///< why there is no polygon; empty where there is one
    bool is_point = false;  ///< an edge that is shrunk to one
};

/// A face: a surface, and the curves that bound a part of it.
struct CadFace {
    std::string type;  ///< as the file has it: "plane", "B-spline surface", ...
    NurbsNet net;      ///< over the file's own parameters where that is a B-spline surface
    /// The rectangle of parameters around the face.
    std::array<double, 2> range_u{};
    std::array<double, 2> range_v{};
    bool trimmed = false;  ///< the face is not all of that rectangle
    std::vector<CadCurve> edges;
    CadBox box;
    std::string fault;  ///< why there is no net; empty where there is one
};

/// What users can name: a surface, a curve, or a body of several faces.
struct CadEntity {
    int number = 0;     ///< IGES: of the first line of its directory entry; STEP: n of #n
    std::string type;   ///< "trimmed surface", "ADVANCED_FACE", ...
    std::string label;  ///< IGES, with its subscript where it has one: "WING(2)"
    std::string name;
    std::vector<CadFace> faces;
    std::vector<CadCurve> curves;
};

struct CadFile {
    CadFormat format = CadFormat::iges;
    std::string unit;           ///< "mm", "inch", ...; empty where the file does not say
    double unit_in_metres = 0;  ///< of `unit`
    /// Where parts of the file are in different units: all are converted to `unit`.
    bool several_units = false;
    std::vector<CadEntity> entities;  ///< ascending numbers
};

/// Either `file` holds a value, or `error` says what is wrong (a fact, no full stop).
struct CadResult {
    std::optional<CadFile> file;
    std::string error;
};

/// Whether this program was built with the module.
bool can_read_cad();

/// Reads the contents of an IGES or STEP file, whichever it is. Throws MachineError when the module
/// cannot be loaded. Not to be called from two threads at once. Precondition: can_read_cad().
CadResult read_cad(const std::string& text);

/// The surface of a face over the rectangle of parameters around it, its lengths multiplied with
/// `scale`. Precondition: the face has no fault.
Surface cad_surface(const CadFace& face, double scale);

/// The same for a curve.
Curve cad_curve(const CadCurve& curve, double scale);

}  // namespace hexweave
