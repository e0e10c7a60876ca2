// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_shapes.h"

#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>

#include "geometry/cad_nurbs.h"

namespace hexweave {

namespace {

using Rectangle = std::array<std::array<double, 2>, 2>;

/// Around samples: Open CASCADE's own boxes are either far too large or take it longer than all
/// the rest.
class Box {
public:
    void add(const gp_Pnt& p) {
        box_.low = {std::min(box_.low.x, p.X()), std::min(box_.low.y, p.Y()),
                    std::min(box_.low.z, p.Z())};
        box_.high = {std::max(box_.high.x, p.X()), std::max(box_.high.y, p.Y()),
                     std::max(box_.high.z, p.Z())};
    }
    const CadBox& value() const { return box_; }

private:
    CadBox box_{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
};

constexpr int box_samples = 32;

double sample(double begin, double end, int n) {
    return n == box_samples ? end : begin + (end - begin) * n / box_samples;
}

/// Around the part of a surface in the rectangle of a face.
CadBox box_around(const CadFace& face, const Handle(Geom_Surface) & surface) {
    Box box;
    for (int j = 0; j <= box_samples; ++j) {
        const double v = sample(face.range_v[0], face.range_v[1], j);
        for (int i = 0; i <= box_samples; ++i) {
            box.add(surface->Value(sample(face.range_u[0], face.range_u[1], i), v));
        }
    }
    return box.value();
}

CadBox box_around(const Handle(Geom_Curve) & curve, double begin, double end) {
    Box box;
    for (int n = 0; n <= box_samples; ++n) box.add(curve->Value(sample(begin, end, n)));
    return box.value();
}

/// The edges of a wire one behind the other, those that hang together with no other at the end.
std::vector<TopoDS_Edge> edges_in_a_row(const TopoDS_Wire& wire, const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> edges;
    for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next()) edges.push_back(at.Current());
    for (TopoDS_Iterator at(wire); at.More(); at.Next()) {
        const bool known = std::any_of(edges.begin(), edges.end(), [&](const TopoDS_Edge& edge) {
            return edge.IsEqual(at.Value());
        });
        if (!known) edges.push_back(TopoDS::Edge(at.Value()));
    }
    return edges;
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Face& face) {
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    if (outer.IsNull()) return {};
    std::vector<TopoDS_Edge> edges = edges_in_a_row(outer, face);
    for (TopExp_Explorer at(face, TopAbs_WIRE); at.More(); at.Next()) {
        if (at.Current().IsSame(outer)) continue;
        const std::vector<TopoDS_Edge> hole = edges_in_a_row(TopoDS::Wire(at.Current()), face);
        edges.insert(edges.end(), hole.begin(), hole.end());
    }
    return edges;
}

/// A net of points, in parameters, on the edges of a face.
std::vector<gp_Pnt2d> boundary_parameters(const TopoDS_Face& face,
                                          const std::vector<TopoDS_Edge>& edges) {
    constexpr int samples = 32;
    std::vector<gp_Pnt2d> points;
    for (const TopoDS_Edge& edge : edges) {
        double begin = 0;
        double end = 0;
        const Handle(Geom2d_Curve) line = BRep_Tool::CurveOnSurface(edge, face, begin, end);
        if (line.IsNull()) continue;
        for (int n = 0; n <= samples; ++n) {
            points.push_back(line->Value(begin + (end - begin) * n / samples));
        }
    }
    return points;
}

Rectangle parameter_box(const TopoDS_Face& face, const Handle(Geom_Surface) & surface) {
    Rectangle box{};
    if (BRep_Tool::NaturalRestriction(face)) {
        surface->Bounds(box[0][0], box[0][1], box[1][0], box[1][1]);
    } else {
        BRepTools::UVBounds(face, box[0][0], box[0][1], box[1][0], box[1][1]);
    }
    return box;
}

/// Whether some of the points on the boundary of a face do not lie on that of its rectangle.
bool is_trimmed(const CadFace& face, const std::vector<gp_Pnt2d>& boundary) {
    constexpr double near = 1e-6;  // of the range
    const auto at_an_end = [](double t, const std::array<double, 2>& range) {
        const double width = near * (range[1] - range[0]);
        return t < range[0] + width || t > range[1] - width;
    };
    return std::any_of(boundary.begin(), boundary.end(), [&](const gp_Pnt2d& p) {
        return !at_an_end(p.X(), face.range_u) && !at_an_end(p.Y(), face.range_v);
    });
}

}  // namespace

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
        faces.push_back(TopoDS::Face(at.Current()));
    }
    return faces;
}

CadFace cad_face(const TopoDS_Face& face) {
    CadFace result;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) {
        result.type = "face";
        result.fault = "it has no surface";
        return result;
    }
    set_surface(result, surface, parameter_box(face, surface));
    if (!result.fault.empty()) return result;
    const std::vector<TopoDS_Edge> edges = edges_of(face);
    for (const TopoDS_Edge& edge : edges) result.edges.push_back(cad_edge(edge));
    result.trimmed = is_trimmed(result, boundary_parameters(face, edges));
    result.box = box_around(result, surface);
    return result;
}

std::vector<TopoDS_Edge> free_edges_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Edge> edges;
    for (TopExp_Explorer at(shape, TopAbs_EDGE, TopAbs_FACE); at.More(); at.Next()) {
        edges.push_back(TopoDS::Edge(at.Current()));
    }
    return edges;
}

CadCurve cad_edge(const TopoDS_Edge& edge) {
    CadCurve result;
    double begin = 0;
    double end = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
    if (BRep_Tool::Degenerated(edge) || curve.IsNull()) {
        result.is_point = BRep_Tool::Degenerated(edge);
        result.type = result.is_point ? "point" : "edge";
        result.fault = result.is_point ? "it is shrunk to a point" : "it has no curve in space";
        const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
        if (vertex.IsNull()) return result;
        const gp_Pnt p = BRep_Tool::Pnt(vertex);
        result.box = {{p.X(), p.Y(), p.Z()}, {p.X(), p.Y(), p.Z()}};
        return result;
    }
    set_curve(result, curve, begin, end);
    if (result.fault.empty()) result.box = box_around(curve, begin, end);
    return result;
}

}  // namespace hexweave
