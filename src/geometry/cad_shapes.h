// SPDX-License-Identifier: Apache-2.0
// Open CASCADE's faces and edges as ours. Inside the module of CAD files only.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "geometry/cad.h"

namespace hexweave {

/// The faces of a shape, each with the edges of its outer boundary in a row, then those of holes.
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);
CadFace cad_face(const TopoDS_Face& face);

/// The edges of a shape that bound no face.
std::vector<TopoDS_Edge> free_edges_of(const TopoDS_Shape& shape);
CadCurve cad_edge(const TopoDS_Edge& edge);

}  // namespace hexweave
