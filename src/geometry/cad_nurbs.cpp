// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_nurbs.h"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>

namespace hexweave {

namespace {

/// A bound this near to that of the whole surface or curve is that bound, in shares of the range.
constexpr double same_bound = 1e-6;

template <class Kind>
bool is_a(const Handle(Standard_Transient) & shape) {
    return shape->IsKind(STANDARD_TYPE(Kind));
}

std::string surface_type(const Handle(Geom_Surface) & surface) {
    if (is_a<Geom_BSplineSurface>(surface)) return "B-spline surface";
    if (is_a<Geom_Plane>(surface)) return "plane";
    if (is_a<Geom_CylindricalSurface>(surface)) return "cylinder";
    if (is_a<Geom_ConicalSurface>(surface)) return "cone";
    if (is_a<Geom_SphericalSurface>(surface)) return "sphere";
    if (is_a<Geom_ToroidalSurface>(surface)) return "torus";
    if (is_a<Geom_SurfaceOfRevolution>(surface)) return "surface of revolution";
    if (is_a<Geom_SurfaceOfLinearExtrusion>(surface)) return "extruded surface";
    if (is_a<Geom_BezierSurface>(surface)) return "Bezier surface";
    if (is_a<Geom_OffsetSurface>(surface)) return "offset surface";
    return "surface";
}

std::string curve_type(const Handle(Geom_Curve) & curve) {
    if (is_a<Geom_BSplineCurve>(curve)) return "B-spline curve";
    if (is_a<Geom_Line>(curve)) return "line";
    if (is_a<Geom_Circle>(curve)) return "circle";
    if (is_a<Geom_Ellipse>(curve)) return "ellipse";
    if (is_a<Geom_Parabola>(curve)) return "parabola";
    if (is_a<Geom_Hyperbola>(curve)) return "hyperbola";
    if (is_a<Geom_BezierCurve>(curve)) return "Bezier curve";
    if (is_a<Geom_OffsetCurve>(curve)) return "offset curve";
    return "curve";
}

Handle(Geom_Surface) without_trimming(Handle(Geom_Surface) surface) {
    for (auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
         !trimmed.IsNull(); trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
        surface = trimmed->BasisSurface();
    }
    return surface;
}

Handle(Geom_Curve) without_trimming(Handle(Geom_Curve) curve) {
    for (auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull();
         trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
        curve = trimmed->BasisCurve();
    }
    return curve;
}

/// Whether it is a B-spline but for rounding: what is offset is not, and would be approximated.
bool is_exact(const Handle(Geom_Curve) & curve) {
    return !is_a<Geom_OffsetCurve>(without_trimming(curve));
}

bool is_exact(const Handle(Geom_Surface) & surface) {
    const Handle(Geom_Surface) whole = without_trimming(surface);
    if (is_a<Geom_OffsetSurface>(whole)) return false;
    const auto swept = Handle(Geom_SweptSurface)::DownCast(whole);
    return swept.IsNull() || is_exact(swept->BasisCurve());
}

std::vector<double> numbers(const TColStd_Array1OfReal& values) {
    return {values.begin(), values.end()};
}

NurbsNet net_of(const Handle(Geom_BSplineSurface) & surface) {
    NurbsNet net;
    net.degree_u = surface->UDegree();
    net.degree_v = surface->VDegree();
    net.count_u = surface->NbUPoles();
    net.count_v = surface->NbVPoles();
    net.knots_u = numbers(surface->UKnotSequence());
    net.knots_v = numbers(surface->VKnotSequence());
    const bool rational = surface->IsURational() || surface->IsVRational();
    for (int j = 1; j <= net.count_v; ++j) {
        for (int i = 1; i <= net.count_u; ++i) {
            const gp_Pnt& p = surface->Pole(i, j);
            net.control.push_back({p.X(), p.Y(), p.Z()});
            if (rational) net.weights.push_back(surface->Weight(i, j));
        }
    }
    return net;
}

NurbsPolygon polygon_of(const Handle(Geom_BSplineCurve) & curve) {
    NurbsPolygon polygon;
    polygon.degree = curve->Degree();
    polygon.knots = numbers(curve->KnotSequence());
    for (int i = 1; i <= curve->NbPoles(); ++i) {
        const gp_Pnt& p = curve->Pole(i);
        polygon.control.push_back({p.X(), p.Y(), p.Z()});
        if (curve->IsRational()) polygon.weights.push_back(curve->Weight(i));
    }
    return polygon;
}

/// The part of a range that lies in that of the whole, whose bounds it takes over where it is near
/// to them. All round a closed parameter it is that of the whole.
std::array<double, 2> within(std::array<double, 2> range, const std::array<double, 2>& whole,
                             bool periodic) {
    const double near = same_bound * (whole[1] - whole[0]);
    if (periodic) return range[1] - range[0] > whole[1] - whole[0] - near ? whole : range;
    if (range[0] < whole[0] + near) range[0] = whole[0];
    if (range[1] > whole[1] - near) range[1] = whole[1];
    return range;
}

bool is_bounded(const std::array<double, 2>& range) {
    return !Precision::IsInfinite(range[0]) && !Precision::IsInfinite(range[1]);
}

}  // namespace

void set_surface(CadFace& face, const Handle(Geom_Surface) & surface,
                 const std::array<std::array<double, 2>, 2>& box) {
    const Handle(Geom_Surface) whole = without_trimming(surface);
    face.type = surface_type(whole);
    face.range_u = box[0];
    face.range_v = box[1];
    if (!is_exact(whole)) {
        face.fault = "its shape (" + face.type + ") is not a NURBS, nor can it be made one exactly";
        return;
    }
    if (!is_bounded(box[0]) || !is_bounded(box[1])) {
        face.fault = "it has no bounds";
        return;
    }
    std::array<double, 2> whole_u{};
    std::array<double, 2> whole_v{};
    whole->Bounds(whole_u[0], whole_u[1], whole_v[0], whole_v[1]);
    face.range_u = within(box[0], whole_u, whole->IsUPeriodic());
    face.range_v = within(box[1], whole_v, whole->IsVPeriodic());
    auto spline = Handle(Geom_BSplineSurface)::DownCast(whole);
    if (spline.IsNull() || spline->IsUPeriodic() || spline->IsVPeriodic()) {
        const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(
            whole, face.range_u[0], face.range_u[1], face.range_v[0], face.range_v[1]);
        spline = GeomConvert::SurfaceToBSplineSurface(part);
        if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
        if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
        spline->Bounds(face.range_u[0], face.range_u[1], face.range_v[0], face.range_v[1]);
    }
    face.net = net_of(spline);
}

void set_curve(CadCurve& curve, const Handle(Geom_Curve) & shape, double begin, double end) {
    const Handle(Geom_Curve) whole = without_trimming(shape);
    curve.type = curve_type(whole);
    if (!is_exact(whole)) {
        curve.fault =
            "its shape (" + curve.type + ") is not a NURBS, nor can it be made one exactly";
        return;
    }
    if (!is_bounded({begin, end})) {
        curve.fault = "it has no bounds";
        return;
    }
    auto spline = Handle(Geom_BSplineCurve)::DownCast(whole);
    const bool all = !spline.IsNull() && !spline->IsPeriodic() &&
                     begin <= spline->FirstParameter() && end >= spline->LastParameter();
    if (!all) {
        spline = GeomConvert::CurveToBSplineCurve(
            Handle(Geom_Curve)(new Geom_TrimmedCurve(whole, begin, end)));
        if (spline->IsPeriodic()) spline->SetNotPeriodic();
    }
    curve.polygon = polygon_of(spline);
}

}  // namespace hexweave
