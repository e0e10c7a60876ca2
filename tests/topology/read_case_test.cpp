// SPDX-License-Identifier: Apache-2.0
#include "topology/read_case.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "geometry/cad.h"
#include "geometry/curve.h"

using namespace hexweave;

namespace {

const std::filesystem::path cases = std::filesystem::path(HEXWEAVE_SOURCE_DIR) / "tests/cases";

std::string contents(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    REQUIRE(stream);
    return text.str();
}

/// The text of one case: all that a case needs, and these lines.
std::string minimal(const std::string& lines) {
    return "hexweave: 1\n" + lines;
}

struct Read {
    Case c;
    Diagnostics diagnostics;
};

Read read_text(const std::string& text, const std::vector<Override>& overrides = {},
               const std::string& name = "case.yaml") {
    Read result;
    const auto source = std::make_shared<const SourceFile>(SourceFile{name, text});
    result.c = read_case(source, overrides, result.diagnostics);
    result.diagnostics.sort();
    return result;
}

/// In the folder of the cases while it lives, so that their data files are found by bare names.
class InFolder {
public:
    explicit InFolder(const std::filesystem::path& folder)
        : before_(std::filesystem::current_path()) {
        std::filesystem::current_path(folder);
    }
    InFolder(const InFolder&) = delete;
    InFolder& operator=(const InFolder&) = delete;
    InFolder(InFolder&&) = delete;
    InFolder& operator=(InFolder&&) = delete;
    ~InFolder() { std::filesystem::current_path(before_); }

private:
    std::filesystem::path before_;
};

Read read_good(const std::string& file, const std::vector<Override>& overrides = {}) {
    const InFolder here(cases / "good");
    Read result = read_text(contents(file), overrides, file);
    INFO(render(result.diagnostics));
    REQUIRE(result.diagnostics.all().empty());
    return result;
}

}  // namespace

TEST_CASE("a whole case is read") {
    const Case c = read_good("o_grid.yaml").c;
    CHECK(c.title == "NACA 0012, O-grid of two faces");
    CHECK(c.parameters.size() == 4);
    CHECK(c.parameters[1].value == 20);
    REQUIRE(c.curves.size() == 3);
    CHECK(evaluate(*c.curves[2].shape, 0).x == Approx(20.5).epsilon(1e-15));
    CHECK(std::get<Vec3>(c.vertices[0].where) == Vec3{1, 0, 0});
    CHECK(std::get<OnCurve>(c.vertices[3].where).at == 0.5);
    CHECK(c.edges[0].cells->value == 96);
    CHECK(std::get<TanhLaw>(c.edges[0].spacing->value).end == 2e-3);
    CHECK(std::get<LikeLaw>(c.edges[1].spacing->value).edge.value == "suction");
    CHECK_FALSE(c.edges[3].cells);
    CHECK(c.edges[4].through->value == Vec3{0.5, 20, 0});
    const auto& sides = std::get<0>(c.faces[1].shape);
    CHECK(sides[2][0].sign_given);
    CHECK_FALSE(sides[2][0].reversed);
    CHECK(c.faces[1].how.method == Method::algebraic);
    CHECK(c.boundaries[0].type.value == "BCWallViscous");
    CHECK(c.boundaries[1].sides[1].value == "out_low");
    CHECK(c.solver.tolerance == 1e-4);
    CHECK(c.solver.start_folded);
    REQUIRE(c.outputs.size() == 1);
    CHECK(c.outputs[0].path == "naca0012.cgns");
}

TEST_CASE("blocks by corners, laws and symmetry planes are read") {
    const Case c = read_good("box.yaml").c;
    CHECK(c.title == "A box, plainly\n");
    CHECK(c.units == "mm");
    CHECK(std::get<GeometricLaw>(c.edges[0].spacing->value).ratio == 1.2);
    CHECK(c.edges[1].cells->value == 6);
    CHECK(std::get<ExplicitLaw>(c.edges[1].spacing->value).formula(0.25) == Approx(0.125));
    CHECK(std::get<ExplicitLaw>(c.edges[2].spacing->value).values ==
          std::vector<double>{0, 0.25, 1});
    CHECK(std::get<1>(c.faces[0].shape)[3].value == "v3");
    CHECK(std::get<1>(c.blocks[0].shape)[7].value == "v7");
    CHECK(c.blocks[0].how.method == Method::algebraic);
    CHECK(c.boundaries[0].plane->value.axis == 2);
    CHECK(c.boundaries[0].plane->value.value == 0);
    CHECK(c.boundaries[1].sides[0].value == "v4-v5-v6-v7");
    CHECK(c.outputs.empty());
}

TEST_CASE("every family of curves and every transform is read") {
    Read read;
    {
        const InFolder here(cases / "good");
        read = read_text(contents("curves.yaml"), {{"section", "0.5"}}, "curves.yaml");
    }
    INFO(render(read.diagnostics));
    REQUIRE(read.diagnostics.all().empty());
    const auto end_of = [&](const std::string& name, bool last) {
        for (const CurveEntry& entry : read.c.curves) {
            if (entry.name.value != name) continue;
            REQUIRE(entry.shape);
            return evaluate(*entry.shape, last ? entry.shape->end : entry.shape->begin);
        }
        FAIL("no curve " << name);
        return Vec3{};
    };
    const auto near = [](const Vec3& a, const Vec3& b) { return distance(a, b) < 1e-14; };
    CHECK(near(end_of("line", true), {1, 2, 3}));
    CHECK(near(end_of("polyline", true), {1, 1, 0}));
    CHECK(near(end_of("spline", true), {2, 4, 0}));
    CHECK(near(end_of("circle", false), {3, 0, 0}));
    CHECK(near(end_of("arc", true), {0, 2, 0}));
    CHECK(near(end_of("through", true), {-1, 0, 0}));
    CHECK(near(end_of("ellipse", false), {0, 2, 0}));
    CHECK(near(end_of("naca", false), {0, 0, 0}));
    CHECK(near(end_of("airfoil", true), {1, 0, 0}));
    CHECK(near(end_of("parabola", true), {2, 4, -2}));
    CHECK(near(end_of("moved", true), {2, 2, 3}));
    CHECK(near(end_of("grown", true), {2, 6, 3}));
    CHECK(near(end_of("turned", true), {-2, 1, 3}));
    CHECK(near(end_of("mirrored", true), {3, 2, 3}));
    CHECK(near(end_of("backwards", true), {0, 0, 0}));
    CHECK(near(end_of("chain", true), {-0.5, 0.5, 1.5}));
    CHECK(read.c.curves[0].used_by_curve);
    CHECK_FALSE(read.c.curves[1].used_by_curve);
}

TEST_CASE("sides take one edge or several, signs, and axes") {
    const Read read = read_text(
        minimal("faces: {f: {imin: -e1, imax: [e2, -e3], jmin: +e4, jmax: \"-e5\"}}\n"
                "blocks: {b: {imin: f, imax: {face: f, axes: [-j, i]}, jmin: f, jmax: f, kmin: f, "
                "kmax: f}}\n"));
    REQUIRE(read.diagnostics.all().empty());
    const auto& sides = std::get<0>(read.c.faces[0].shape);
    CHECK(sides[0][0].reversed);
    CHECK(sides[1].size() == 2);
    CHECK(sides[1][1].reversed);
    CHECK_FALSE(sides[1][0].sign_given);
    CHECK(sides[2][0].sign_given);
    CHECK_FALSE(sides[2][0].reversed);
    CHECK(sides[3][0].value == "e5");
    CHECK(std::get<0>(read.c.blocks[0].shape)[1].faces[0].axes == std::array{-2, 1});
}

TEST_CASE("an override replaces a parameter before its dependents are computed") {
    const Case c = read_good("o_grid.yaml", {{"chord", "2*3"}, {"wall", "chord/4"}}).c;
    CHECK(c.parameters[0].value == 6);
    CHECK(c.parameters[0].overridden);
    CHECK(c.parameters[1].value == 120);
    CHECK(c.parameters[2].value == 1.5);
    CHECK_FALSE(c.parameters[1].overridden);
}

TEST_CASE("faulty overrides show the argument") {
    const std::string text = minimal("parameters: {chord: 1, far: 20 * chord}\n");
    const auto shown = [&](const Override& given) {
        return render(read_text(text, {given, {"far", "1"}}).diagnostics);
    };
    CHECK(shown({"chrod", "2"}) ==
          "--set:1:1: error: unknown parameter 'chrod'\n"
          "chrod=2\n"
          "^~~~~\n"
          "  hint: did you mean 'chord'?\n");
    CHECK(shown({"chord", "2 + far"}) ==
          "--set:1:11: error: the parameter 'far' is used before it is defined\n"
          "chord=2 + far\n"
          "          ^~~\n"
          "  hint: parameters may use only those that stand before them\n");
    CHECK(shown({"far", "2"}) ==
          "--set:1:1: error: the parameter 'far' is set twice\n"
          "far=1\n"
          "^~~\n"
          "  hint: leave one out\n");
    CHECK(shown({"chord", ""}) ==
          "--set:1:7: error: parameter 'chord' must be a number or an expression, not an empty "
          "text\n"
          "chord=\n"
          "      ^\n"
          "  hint: write a number or an expression here\n");
    CHECK(read_text(text, {{"chord", "2"}}).diagnostics.all().size() == 1);
    CHECK(render(read_text(minimal(""), {{"a", "1"}}).diagnostics) ==
          "--set:1:1: error: unknown parameter 'a'\n"
          "a=1\n"
          "^\n"
          "  hint: the file has no parameters\n");
}

namespace {

/// Two boxes of one component beside each other.
const std::string two_boxes = R"(hexweave: 1
parameters: {many: 4, shown: 0}
components:
  box:
    parameters: {length: required, cells: 4, base: 2, spare: 3 * base, lip: 0}
    vertices: {a: [0, 0], b: [length, 0], c: [length, 1], d: [0, 1]}
    edges: {south: {from: a, to: b, cells: cells}, west: {from: a, to: d, cells: 4}}
    faces: {f: {corners: [a, b, c, d]}}
    boundaries:
      walls: {type: BCWall, sides: [south, west, b-c, c-d]}
      extra: {type: BCWall, sides: south, when: 0 * lip}
  pair:
    parameters: {cells: 5}
    instances: {inner: {of: box, set: {length: 1, cells: 2 * cells}}}
instances:
  low: {of: box, set: {length: 1, cells: many}}
  high: {of: pair, translate: [0, 3]}
boundaries:
  more: {type: BCWall, sides: low.south, when: shown}
)";

}  // namespace

TEST_CASE("the command line has the last word on the parameters of instances") {
    const auto cells = [](const std::vector<Override>& overrides) {
        const Read read = read_text(two_boxes, overrides);
        REQUIRE(!read.diagnostics.has_errors());
        return std::array{read.c.edges[0].cells->value, read.c.edges[2].cells->value};
    };
    CHECK(cells({}) == std::array{4, 10});
    CHECK(cells({{"low.cells", "2 * many"}}) == std::array{8, 10});
    CHECK(cells({{"high.cells", "3"}}) == std::array{4, 6});
    CHECK(cells({{"high.inner.cells", "3"}, {"many", "7"}}) == std::array{7, 3});

    const Case c = read_text(two_boxes, {{"high.inner.length", "2"}}).c;
    CHECK(c.parameters.size() == 2 + 5 + 5 + 1);
    const auto named = [&](const std::string& name) {
        return *std::find_if(c.parameters.begin(), c.parameters.end(),
                             [&](const Parameter& p) { return p.name.value == name; });
    };
    CHECK(named("high.inner.length").value == 2);
    CHECK(named("high.inner.length").overridden);
    CHECK(named("low.cells").value == 4);
    CHECK_FALSE(named("low.cells").overridden);
    CHECK(c.provenance.find("; set high.inner.length=2") != std::string::npos);
}

TEST_CASE("overrides of parameters that no instance has are told") {
    const auto fault = [](const std::string& name, const std::string& value = "1") {
        const Diagnostics all = read_text(two_boxes, {{name, value}}).diagnostics;
        std::string text;
        for (const Diagnostic& d : all.all()) {
            if (d.severity == Severity::error) text += d.message + "; " + d.hint;
        }
        return text;
    };
    CHECK(fault("low.cels") == "unknown parameter 'cels' of instance 'low'; did you mean 'cells'?");
    CHECK(fault("high.inner.x") ==
          "unknown parameter 'x' of instance 'high.inner'; its parameters are base, cells, length, "
          "lip, spare");
    CHECK(fault("hihg.cells") ==
          "'hihg.cells' is a parameter of no instance: there is no instance 'hihg'; did you mean "
          "'high'?");
    CHECK(fault("cells") ==
          "unknown parameter 'cells'; did you mean 'low.cells'? parameters of instances are set by "
          "their full names");
    CHECK(fault("low.cells", "length") ==
          "unknown parameter 'length'; known parameters are many, shown");
    CHECK(fault("low.cells", "2.5").find("must be a whole number") != std::string::npos);
}

TEST_CASE("a parameter of a component that no instance uses is told once") {
    // 'base' is used by another, 'lip' and 'shown' in what is left out.
    CHECK(render(read_text(two_boxes).diagnostics) ==
          "case.yaml:5:55: warning: parameter 'spare' of component 'box' is never used\n"
          "    parameters: {length: required, cells: 4, base: 2, spare: 3 * base, lip: 0}\n"
          "                                                      ^~~~~\n");
    CHECK(read_text(two_boxes, {{"low.spare", "1"}}).diagnostics.all().empty());
}

TEST_CASE("provenance names the version, the config's hash and the overrides") {
    // FNV-1a of the empty text and of "a" are in the authors' test vectors.
    CHECK(read_text("").c.provenance.find("; config fnv1a64:cbf29ce484222325") !=
          std::string::npos);
    CHECK(read_text("a").c.provenance.find("; config fnv1a64:af63dc4c8601ec8c") !=
          std::string::npos);
    const std::string provenance = read_text("a", {{"n", "2*m"}}, "/home/me/a.yaml").c.provenance;
    const std::string end = "; config fnv1a64:af63dc4c8601ec8c; set n=2*m";
    CHECK(provenance.substr(0, 9) == "hexweave ");
    REQUIRE(provenance.size() > end.size());
    CHECK(provenance.substr(provenance.size() - end.size()) == end);
    CHECK(provenance.find("home") == std::string::npos);
}

TEST_CASE("cell counts are whole within rounding") {
    const auto cells = [](const std::string& text) {
        const Read read =
            read_text(minimal("edges: {ab: {from: a, to: b, cells: " + text + "}}\n"));
        return read.c.edges.at(0).cells ? read.c.edges[0].cells->value : 0;
    };
    CHECK(cells("7") == 7);
    CHECK(cells("0.1*3*10") == 3);  // 3.0000000000000004
    CHECK(cells("10^7") == 10000000);
    CHECK(cells("10^7 + 1") == 0);
    CHECK(cells("3 + 1e-8") == 0);
    CHECK(cells("0") == 0);
    CHECK(cells("-4") == 0);
}

TEST_CASE("a faulty entry still defines its name and takes nothing else down") {
    const Read read =
        read_text(minimal("curves: {c: {circle: {radius: 1}}}\n"
                          "vertices: {a: [1, oops], b: [1, 0]}\n"
                          "edges: {ab: {from: a, to: b, cells: oops}, ba: {from: b, to: a}}\n"
                          "faces: {f: {corners: 3}}\n"));
    CHECK(read.diagnostics.errors() == 4);
    REQUIRE(read.c.curves.size() == 1);
    CHECK(read.c.curves[0].shape == nullptr);
    REQUIRE(read.c.vertices.size() == 2);
    CHECK(std::get<OnCurve>(read.c.vertices[0].where).curve.value.empty());
    CHECK(std::get<Vec3>(read.c.vertices[1].where) == Vec3{1, 0, 0});
    REQUIRE(read.c.edges.size() == 2);
    CHECK(read.c.edges[0].from.value.empty());
    CHECK(read.c.edges[1].from.value == "b");
    CHECK(read.c.faces.size() == 1);
}

TEST_CASE("curves made of one another come to an end") {
    std::string text = "curves:\n  c0: {line: [[0, 0], [1, 0]]}\n";
    for (int i = 1; i <= 101; ++i) {
        text += "  c" + std::to_string(i) + ": {of: c" + std::to_string(i - 1) + ", scale: 1}\n";
    }
    const Read read = read_text(minimal(text));
    REQUIRE(read.diagnostics.errors() == 1);
    CHECK(read.diagnostics.all()[0].message == "more than 100 shapes are made of one another");
}

TEST_CASE("every bad case gives exactly the text beside it") {
    const InFolder here(cases / "bad");
    int pairs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
        if (entry.path().extension() != ".yaml") continue;
        if (!can_read_cad() && entry.path().stem() == "cad") continue;
        const std::string name = entry.path().filename().string();
        std::filesystem::path expected = entry.path();
        expected.replace_extension(".txt");
        INFO(name);
        CHECK(render(read_text(contents(entry.path()), {}, name).diagnostics) ==
              contents(expected));
        ++pairs;
    }
    CHECK(pairs >= 25);
}

TEST_CASE("no truncation or mutation of a case does more than give diagnostics") {
    const InFolder here(cases / "good");
    // Fixed seed: the same texts in every run.
    std::mt19937 random(20220601);
    const auto below = [&](std::size_t limit) { return random() % limit; };
    constexpr char alphabet[] =
        "\0\t\n\r !\"#%&'()*+,-.0123456789:<=>?@[]^_`abtz{|}~\x7F\x80\xC3\xFF";
    const std::string bytes(alphabet, sizeof(alphabet) - 1);
    for (const std::string file : {"o_grid.yaml", "box.yaml", "curves.yaml"}) {
        const std::string good = contents(file);
        for (std::size_t end = 0; end < good.size(); end += 1 + below(5)) {
            CHECK_NOTHROW(render(read_text(good.substr(0, end)).diagnostics));
        }
        for (int n = 0; n < 1000; ++n) {
            std::string text = good;
            for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
                const std::size_t at = below(text.size());
                const std::size_t kind = below(4);
                if (kind == 0) text[at] = bytes[below(bytes.size())];
                if (kind == 1) text.insert(at, 1, bytes[below(bytes.size())]);
                if (kind == 2) text.erase(at, 1 + below(8));
                if (kind == 3) text.insert(at, text.substr(below(text.size()), below(20)));
            }
            INFO(text);
            CHECK_NOTHROW(render(read_text(text).diagnostics));
        }
    }
}
