// SPDX-License-Identifier: Apache-2.0
// CAD files read: what they hold, against the numbers that stand in them.
#include "geometry/cad.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/surface_projection.h"

using namespace hexweave;

namespace {

std::string wing_text(const std::string& name) {
    std::ifstream stream(std::string(HEXWEAVE_SOURCE_DIR "/data/wings/") + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

CadFile read_wing(const std::string& name) {
    const CadResult result = read_cad(wing_text(name));
    INFO(result.error);
    REQUIRE(result.file);
    return *result.file;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), by);
}

/// The numbers of an IGES file's parameter lines from the first to the last (counted from 1), up to
/// column 65, as a person would read them.
std::vector<double> numbers_in(const std::string& text, int first, int last) {
    std::istringstream lines(text);
    std::vector<double> numbers;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 73 || line[72] != 'P' || ++number < first || number > last) continue;
        std::istringstream data(line.substr(0, 65));
        for (std::string word; std::getline(data, word, ',');) {
            if (word.find_first_not_of(" ;") != std::string::npos) {
                numbers.push_back(std::strtod(word.c_str(), nullptr));
            }
        }
    }
    return numbers;
}

}  // namespace

TEST_CASE("a text that is no CAD file is told from one that is cut short") {
    const std::string iges = wing_text("taper_wing.igs");
    const std::string step = wing_text("AileM6_with_sharp_TE.stp");
    CHECK(prepare_cad_text(iges).error.empty());
    CHECK(prepare_cad_text(iges).format == CadFormat::iges);
    CHECK(prepare_cad_text(step).error.empty());
    CHECK(prepare_cad_text(step).format == CadFormat::step);
    CHECK(prepare_cad_text("").error == "it is empty");
    CHECK(prepare_cad_text(" \n\n").error == "it is empty");
    CHECK(prepare_cad_text("hexweave: 1\n").error == "it is neither an IGES nor a STEP file");
    CHECK(prepare_cad_text(std::string(100, 'x')).error == "it is neither an IGES nor a STEP file");
    CHECK(prepare_cad_text(std::string(500, '\0')).error ==
          "it is neither an IGES nor a STEP file");
    CHECK(prepare_cad_text(iges.substr(0, iges.size() / 2 + 9)).error.find("line 325 ") == 0);
    CHECK(prepare_cad_text(iges.substr(0, 81 * 100)).error ==
          "the IGES file is cut short: it has no terminate section");
    CHECK(prepare_cad_text(step.substr(0, step.size() / 2)).error ==
          "the STEP file is cut short: it does not end with END-ISO-10303-21;");
    CHECK(prepare_cad_text(replaced(iges, "D      3", "P      3")).error ==
          "line 9 is of an earlier section");
}

TEST_CASE("data in column 65 of an IGES file moves to column 64") {
    const std::string iges = wing_text("taper_wing.igs");
    const CadText prepared = prepare_cad_text(iges);
    std::istringstream lines(prepared.text);
    for (std::string line; std::getline(lines, line);) {
        if (line[72] == 'P') CHECK(line[64] == ' ');
    }
    CHECK(numbers_in(prepared.text, 1, 1000) == numbers_in(iges, 1, 1000));
    const std::string full = "         128,          12,           5,           3,           3,";
    const std::string no_blank =
        "128,12345678901,12345678901,12345678901,12345678901,1234567890123";
    CHECK(prepare_cad_text(replaced(iges, full, no_blank)).error ==
          "line 18 holds data in column 65, which must be blank");
    const std::string crlf = replaced(iges, "4HINCH", "4HINCH");
    std::string windows;
    for (const char c : crlf) windows += c == '\n' ? "\r\n" : std::string(1, c);
    CHECK(prepare_cad_text(windows).text == prepared.text);
}

TEST_CASE("the unit of an IGES file is a number or, for number 3, a name") {
    const std::string iges = wing_text("taper_wing.igs");
    const auto unit = [&](const std::string& header) {
        return prepare_cad_text(replaced(iges, "1.,1,4HINCH", header)).unit;
    };
    CHECK(unit("1.,1,4HINCH") == "in");
    CHECK(unit("1.,2,4HINCH") == "mm");
    CHECK(unit("1.,3,4HINCH") == "in");
    CHECK(unit("01.,3,2HUM,") == "um");
    CHECK(unit("1.,3,4HELLE").empty());
    CHECK(unit("1.,,04HINCH").empty());
    CHECK(unit("1.,0,4HINCH").empty());
    CHECK(unit("1,,10,2HCM,") == "");
    // A string may run over the end of a line, and other delimiters may be in use.
    const auto global = [](const std::string& data) {
        std::string text = std::string(72, ' ') + "S      1\n";
        for (std::size_t at = 0; at < data.size(); at += 72) {
            std::string line = data.substr(at, 72);
            line.resize(72, ' ');
            text += line + "G      1\n";
        }
        return prepare_cad_text(text + std::string(72, ' ') + "T      1\n").unit;
    };
    const std::string filled(60, 'a');
    CHECK(global("1H,,1H;,60H" + filled + ",,,,,,,,,,,3,2HCM;") == "cm");
    CHECK(global("1H/,1H;/60H" + filled + "///////////3/4HFOOT;").empty());
    CHECK(global("1H/,1H;/60H" + filled + "///////////4/2HFT;").empty());
    CHECK(global(",,60H" + filled + ",,,,,,,,,,,6;") == "m");
}

TEST_CASE("the surfaces of an IGES file are the numbers in it", "[cad]") {
    if (!can_read_cad()) return;
    const std::string text = wing_text("taper_wing.igs");
    const CadFile file = read_wing("taper_wing.igs");
    CHECK(file.format == CadFormat::iges);
    CHECK(file.unit == "in");
    CHECK(file.unit_in_metres == 0.0254);
    CHECK_FALSE(file.several_units);
    REQUIRE(file.entities.size() == 6);
    const std::vector<int> lines{1, 118, 235, 352, 469, 550, 631};
    for (std::size_t n = 0; n < 6; ++n) {
        const CadEntity& entity = file.entities[n];
        CHECK(entity.number == static_cast<int>(2 * n + 1));
        CHECK(entity.type == "B-spline surface");
        REQUIRE(entity.faces.size() == 1);
        const CadFace& face = entity.faces.front();
        CHECK(face.fault.empty());
        CHECK_FALSE(face.trimmed);
        const std::vector<double> all = numbers_in(text, lines[n], lines[n + 1] - 1);
        // type, K1, K2, M1, M2, five properties, knots, weights, control points, four bounds
        const NurbsNet& net = face.net;
        CHECK(net.count_u == static_cast<int>(all[1]) + 1);
        CHECK(net.count_v == static_cast<int>(all[2]) + 1);
        CHECK(net.degree_u == static_cast<int>(all[3]));
        CHECK(net.degree_v == static_cast<int>(all[4]));
        auto at = all.begin() + 10;
        CHECK(std::equal(net.knots_u.begin(), net.knots_u.end(), at));
        at += static_cast<std::ptrdiff_t>(net.knots_u.size());
        CHECK(std::equal(net.knots_v.begin(), net.knots_v.end(), at));
        at += static_cast<std::ptrdiff_t>(net.knots_v.size() + net.control.size());
        for (const Vec3& p : net.control) {
            CHECK(p == Vec3{at[0], at[1], at[2]});
            at += 3;
        }
        CHECK(net.weights.empty());
        CHECK(face.range_u == std::array{at[0], at[1]});
        CHECK(face.range_v == std::array{at[2], at[3]});
    }
}

TEST_CASE("lengths are those of the file, whatever its unit", "[cad]") {
    if (!can_read_cad()) return;
    const std::string text = wing_text("taper_wing.igs");
    const std::vector<Vec3> control = read_wing("taper_wing.igs").entities[0].faces[0].net.control;
    const std::vector<std::pair<std::string, std::string>> units{
        {"1.,2,4HINCH", "mm"}, {"1.,6,4HINCH", "m"}, {"1.,3,4HINCH", "in"}, {"01.,10,2HCM", "cm"}};
    for (const auto& [header, unit] : units) {
        const CadResult result = read_cad(replaced(text, "1.,1,4HINCH", header));
        REQUIRE(result.file);
        CHECK(result.file->unit == unit);
        CHECK(result.file->entities[0].faces[0].net.control == control);
    }
    const CadResult unknown = read_cad(replaced(text, "1.,1,4HINCH", "1.,3,4HELLE"));
    REQUIRE(unknown.file);
    CHECK(unknown.file->unit.empty());
    CHECK(unknown.file->entities[0].faces[0].net.control == control);

    CHECK(read_wing("AileM6_with_sharp_TE.stp").unit == "mm");
    const std::string step = wing_text("AileM6_with_sharp_TE.stp");
    const CadResult metres = read_cad(replaced(step, ".MILLI.,.METRE.", "$,.METRE."));
    REQUIRE(metres.file);
    CHECK(metres.file->unit == "m");
    const CadFile millimetres = read_wing("AileM6_with_sharp_TE.stp");
    CHECK(millimetres.unit == "mm");
    CHECK(metres.file->entities[0].faces[0].net.control ==
          millimetres.entities[0].faces[0].net.control);
}

TEST_CASE("a surface is scaled, and limited to the rectangle around its face", "[cad]") {
    if (!can_read_cad()) return;
    const CadFile file = read_wing("AileM6_with_sharp_TE.igs");
    const auto cap = std::find_if(file.entities.begin(), file.entities.end(),
                                  [](const CadEntity& e) { return e.number == 79; });
    REQUIRE(cap != file.entities.end());
    CHECK(cap->type == "trimmed surface");
    CHECK(cap->name == "Assembler.10");
    const CadFace& face = cap->faces.front();
    const Surface millimetres = cad_surface(face, 1);
    const Surface metres = cad_surface(face, 1e-3);
    CHECK(metres.range_v == std::array{15.8033937, 31.6067874});
    const SurfaceParameters at{100, 20};
    CHECK(distance(1e-3 * evaluate(millimetres, at), evaluate(metres, at)) < 1e-14);
    CHECK(distance(evaluate(metres, {0, 15.8033937}), {0.7030898938, 1.205648661, 0}) < 1e-8);
}

TEST_CASE("files that Open CASCADE finds nothing in are told", "[cad]") {
    if (!can_read_cad()) return;
    std::string blank = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";
    CHECK(read_cad(blank).error == "the STEP file holds nothing that can be read");
    CHECK_FALSE(read_cad("ISO-10303-21;\n)(&%$;END-ISO-10303-21;").error.empty());
    const std::string start(72, ' ');
    CHECK(read_cad(start + "S      1\n" + start + "T      1\n").error ==
          "the IGES file holds nothing that can be read");
}
