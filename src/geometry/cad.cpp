// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad.h"

#include <utility>

#include "core/assert.h"
#include "geometry/cad_module.h"

#ifdef HEXWEAVE_CAD
#include <dlfcn.h>

#include "core/errors.h"
#include "geometry/cad_archive.h"
#include "geometry/child_process.h"
#endif

namespace hexweave {

namespace {

#ifdef HEXWEAVE_CAD
/// The module, which stays loaded. It is looked for in the folders that the program was linked to
/// look for libraries in.
ReadPreparedCad* load_module() {
    void* module = dlopen(HEXWEAVE_CAD, RTLD_NOW | RTLD_LOCAL);
    void* found = module == nullptr ? nullptr : dlsym(module, read_prepared_cad_name);
    if (found != nullptr) return reinterpret_cast<ReadPreparedCad*>(found);
    throw MachineError(std::string("cannot load the reader of CAD files: ") + dlerror());
}

/// In a process of its own: of damaged files Open CASCADE is known to crash, or not to end.
CadResult read_prepared(const CadText& text) {
    const int most_seconds = 30 + 5 * static_cast<int>(text.text.size() >> 20U);
    static ReadPreparedCad* const read = load_module();
    const ChildResult child = run_in_child(
        [&text] {
            CadResult result;
            read(text, result);
            return pack(result);
        },
        most_seconds);
    if (child.fault.empty()) return unpack(child.bytes);
    return {{}, "Open CASCADE cannot read it, it seems damaged (" + child.fault + ")"};
}
#else
CadResult read_prepared(const CadText& text) {
    HEXWEAVE_ASSERT(can_read_cad());
    return {{}, text.error};
}
#endif

/// What Open CASCADE made of the file is checked as what a user writes is.
void find_faults(CadEntity& entity) {
    const auto check_curve = [](CadCurve& curve) {
        if (curve.fault.empty() && !curve.is_point) curve.fault = fault_of(curve.polygon);
    };
    for (CadCurve& curve : entity.curves) check_curve(curve);
    for (CadFace& face : entity.faces) {
        if (face.fault.empty()) face.fault = fault_of(face.net);
        for (CadCurve& edge : face.edges) check_curve(edge);
    }
}

void scale_points(std::vector<Vec3>& points, double scale) {
    for (Vec3& p : points) p = scale * p;
}

void limit(std::array<double, 2>& range, bool& closed, const std::array<double, 2>& to) {
    closed = closed && to == range;
    range = to;
}

}  // namespace

bool can_read_cad() {
#ifdef HEXWEAVE_CAD
    return true;
#else
    return false;
#endif
}

CadResult read_cad(const std::string& text) {
    const CadText prepared = prepare_cad_text(text);
    if (!prepared.error.empty()) return {{}, prepared.error};
    CadResult result = read_prepared(prepared);
    if (!result.file) return result;
    for (CadEntity& entity : result.file->entities) find_faults(entity);
    return result;
}

Surface cad_surface(const CadFace& face, double scale) {
    NurbsNet net = face.net;
    scale_points(net.control, scale);
    Surface surface = nurbs_surface(std::move(net));
    limit(surface.range_u, surface.closed_u, face.range_u);
    limit(surface.range_v, surface.closed_v, face.range_v);
    return surface;
}

Curve cad_curve(const CadCurve& curve, double scale) {
    NurbsPolygon polygon = curve.polygon;
    scale_points(polygon.control, scale);
    return nurbs_curve(std::move(polygon));
}

}  // namespace hexweave
