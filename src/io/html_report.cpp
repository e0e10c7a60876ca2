// SPDX-License-Identifier: Apache-2.0
#include "io/html_report.h"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

#include "core/errors.h"
#include "core/orientation.h"
#include "io/base64.h"
#include "io/json_values.h"
#include "io/picture_colours.h"
#include "io/quality_json.h"
#include "io/report_graph.h"
#include "io/report_page.h"

namespace hexweave {

namespace {

/// JSON to stand in a <script>: no '<' in it, which could end the script or begin a comment.
std::string script_text(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

std::string css_colour(const Colour& colour) {
    return fmt::format("#{:06x}", to_rgb(colour));
}

Json family_json(const MultiblockGrid& grid, std::size_t index) {
    return {{"name", grid.families[index].name},
            {"type", grid.families[index].type},
            {"colour", css_colour(palette(static_cast<int>(index)))}};
}

Json zone_json(const Zone& zone, std::size_t index) {
    return {{"name", zone.name},
            {"nodes", json_of(zone.points.extent())},
            {"colour", css_colour(palette(static_cast<int>(index)))}};
}

Json sheet_json(const MultiblockGrid& grid, const ReportSheet& sheet) {
    return {{"zone", sheet.zone},
            {"axis", sheet.axis},
            {"index", sheet.index + 1},
            {"family", sheet.family},
            {"worst", sheet.worst},
            {"stride", sheet.stride},
            {"nodes", {sheet.lines[0].size(), sheet.lines[1].size()}},
            {"points", to_base64(sheet_coordinates(grid, sheet))},
            {"measures", to_base64(sheet_measures(grid, sheet))}};
}

/// The nodes of a cell, in the order of its corners.
Json cell_json(const MultiblockGrid& grid, const WorstCell& worst) {
    Json nodes = Json::array();
    for (const Zone& zone : grid.zones) {
        if (zone.name != worst.zone) continue;
        const int corners = zone.points.extent().nk == 1 ? 4 : 8;
        for (int c = 0; c < corners; ++c) {
            nodes.push_back(
                json_of(zone.points(worst.cell[0] + (c & 1), worst.cell[1] + ((c >> 1) & 1),
                                    worst.cell[2] + (c >> 2))));
        }
    }
    return nodes;
}

/// Sides of a planar or surface grid that a family covers: rows of nodes.
Json boundary_lines(const MultiblockGrid& grid) {
    Json lines = Json::array();
    if (grid.cell_dimension != 2) return lines;
    for (const BoundaryPatch& patch : grid.patches) {
        const PointField& points = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        Json nodes = Json::array();
        Node n = patch.box.begin;
        const int along = patch.box.begin[0] != patch.box.end[0] ? 0 : 1;
        const auto a = static_cast<std::size_t>(along);
        const int step = patch.box.begin[a] <= patch.box.end[a] ? 1 : -1;
        for (n[a] = patch.box.begin[a];; n[a] += step) {
            const Vec3 p = points(n[0], n[1], n[2]);
            for (const double value : {p.x, p.y, p.z}) {
                nodes.push_back(json_of(static_cast<double>(static_cast<float>(value))));
            }
            if (n[a] == patch.box.end[a]) break;
        }
        lines.push_back({{"family", patch.family}, {"nodes", std::move(nodes)}});
    }
    return lines;
}

Json page_data(const MultiblockGrid& grid, const GridQuality& quality,
               const HtmlReportOptions& options) {
    Json data{{"quality", Json::parse(to_json(quality, options.grid_file))},
              {"planar", grid.cell_dimension == 2 && grid.physical_dimension == 2},
              {"provenance", grid.provenance},
              {"run", Json::parse(options.run)}};
    Json families = Json::array();
    for (std::size_t n = 0; n < grid.families.size(); ++n) {
        families.push_back(family_json(grid, n));
    }
    Json zones = Json::array();
    for (std::size_t n = 0; n < grid.zones.size(); ++n) {
        zones.push_back(zone_json(grid.zones[n], n));
    }
    data["families"] = std::move(families);
    data["zones"] = std::move(zones);
    data["sheets"] =
        json_list(report_sheets(grid, options.planes, quality.worst, options.budget),
                  [&grid](const ReportSheet& sheet) { return sheet_json(grid, sheet); });
    data["lines"] = boundary_lines(grid);
    data["worst_cells"] = json_list(
        quality.worst, [&grid](const WorstCell& worst) { return cell_json(grid, worst); });
    return data;
}

}  // namespace

std::string html_report(const MultiblockGrid& grid, const GridQuality& quality,
                        const HtmlReportOptions& options) {
    const std::map<std::string_view, std::string> parts{
        {"TITLE", escape_html(grid.title.empty() ? options.grid_file : grid.title)},
        {"STYLE", std::string(report_page::style_css)},
        {"GRAPH", topology_graph(grid)},
        {"DATA", script_text(page_data(grid, quality, options))},
        {"VIEWER", std::string(report_page::viewer_js)}};
    std::string page;
    std::string_view rest = report_page::page_html;
    for (std::size_t open = rest.find("{{"); open != std::string_view::npos;
         open = rest.find("{{")) {
        const std::size_t close = rest.find("}}", open);
        page += rest.substr(0, open);
        page += parts.at(rest.substr(open + 2, close - open - 2));
        rest.remove_prefix(close + 2);
    }
    page += rest;
    return page;
}

}  // namespace hexweave
