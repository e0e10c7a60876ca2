// SPDX-License-Identifier: Apache-2.0
#include "geometry/cad_shapes.h"

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
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

CadBox box_around(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    if (box.IsVoid() || box.IsOpen()) return {};
    box.SetGap(0);
    CadBox around;
    box.Get(around.low.x, around.low.y, around.low.z, around.high.x, around.high.y, around.high.z);
    // Open CASCADE leaves that much room around a shape.
    const double room = Precision::Confusion();
    around.low += {room, room, room};
    around.high -= {room, room, room};
    return around;
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
    result.box = box_around(face);
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
    if (result.fault.empty()) result.box = box_around(edge);
    return result;
}

}  // namespace hexweave
