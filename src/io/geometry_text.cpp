// SPDX-License-Identifier: Apache-2.0
#include "io/geometry_text.h"

#include <fmt/format.h>

#include "topology/text.h"

namespace hexweave {
namespace {

std::string range_text(const std::array<double, 2>& range) {
    return fmt::format("{} to {}", number_text(range[0]), number_text(range[1]));
}

std::string box_text(const CadBox& box) {
    return fmt::format("box {} to {}", point_text(box.low), point_text(box.high));
}

std::string shape_text(const CadFace& face) {
    const NurbsNet& net = face.net;
    const bool converted = face.type != "B-spline surface";
    return fmt::format("{}{}, degree {} x {}, {} x {} points{}; u {}, v {}", face.type,
                       converted ? " as a NURBS" : "", net.degree_u, net.degree_v, net.count_u,
                       net.count_v, face.trimmed ? ", trimmed" : "", range_text(face.range_u),
                       range_text(face.range_v));
}

std::string face_text(const CadFace& face, const std::string& indent) {
    if (!face.fault.empty()) {
        return fmt::format("{}{}: cannot be used: {}\n", indent, face.type, face.fault);
    }
    return fmt::format("{}{}\n{}{}\n", indent, shape_text(face), indent, box_text(face.box));
}

std::string curve_text(const CadCurve& curve) {
    if (curve.is_point) return "a point, " + point_text(curve.box.low) + "\n";
    if (!curve.fault.empty()) {
        return fmt::format("{}: cannot be used: {}\n", curve.type, curve.fault);
    }
    const Curve shape = cad_curve(curve, 1);
    return fmt::format(
        "{}, degree {}, {} points; {}; from {} to {}\n", curve.type, curve.polygon.degree,
        curve.polygon.control.size(), range_text({shape.begin, shape.end}),
        point_text(evaluate(shape, shape.begin)), point_text(evaluate(shape, shape.end)));
}

std::string edges_text(const std::vector<CadCurve>& edges, const std::string& indent) {
    std::string text;
    for (std::size_t n = 0; n < edges.size(); ++n) {
        text += fmt::format("{}edge {}: {}", indent, n + 1, curve_text(edges[n]));
    }
    return text;
}

std::string heading(const CadEntity& entity) {
    std::string text = fmt::format("entity {}: {}", entity.number, entity.type);
    if (!entity.label.empty()) text += fmt::format(", label '{}'", entity.label);
    if (!entity.name.empty()) text += fmt::format(", name '{}'", entity.name);
    if (entity.faces.empty() && entity.curves.empty()) text += ", which cannot be read";
    return text + "\n";
}

std::string entity_text(const CadEntity& entity, bool with_edges) {
    std::string text = heading(entity);
    for (std::size_t n = 0; n < entity.faces.size(); ++n) {
        const bool several = entity.faces.size() > 1;
        const std::string indent = several ? "    " : "  ";
        if (several) text += fmt::format("  face {}:\n", n + 1);
        text += face_text(entity.faces[n], indent);
        if (with_edges) text += edges_text(entity.faces[n].edges, indent);
    }
    if (entity.curves.size() == 1) return text + "  " + curve_text(entity.curves.front());
    return text + edges_text(entity.curves, "  ");
}

}  // namespace

std::string to_text(const CadFile& file, const std::string& name, bool with_edges) {
    std::size_t faces = 0;
    std::size_t curves = 0;
    for (const CadEntity& entity : file.entities) {
        faces += entity.faces.size();
        curves += entity.curves.size();
    }
    std::string unit = file.unit.empty() ? "not said" : file.unit;
    if (file.several_units) unit += " (converted from several)";
    std::string text = fmt::format("{}: {}, unit of length: {}, {} surface{}, {} curve{}\n", name,
                                   file.format == CadFormat::iges ? "IGES" : "STEP", unit, faces,
                                   faces == 1 ? "" : "s", curves, curves == 1 ? "" : "s");
    for (const CadEntity& entity : file.entities) text += entity_text(entity, with_edges);
    return text;
}

}  // namespace hexweave
