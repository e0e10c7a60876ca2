// SPDX-License-Identifier: Apache-2.0
// CAD files read, against Open CASCADE's own evaluation of what it reads itself.
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <UnitsMethods.hxx>
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "geometry/cad.h"
#include "geometry/cad_archive.h"
#include "geometry/child_process.h"
#include "geometry/surface_projection.h"

using namespace hexweave;

namespace {

const std::string wings = HEXWEAVE_SOURCE_DIR "/data/wings/";

std::string slurp(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

CadFile read_text(const std::string& text) {
    const CadResult result = read_cad(text);
    INFO(result.error);
    REQUIRE(result.file);
    return *result.file;
}

std::vector<CadFace> faces_of(const CadFile& file) {
    std::vector<CadFace> faces;
    for (const CadEntity& e : file.entities) {
        faces.insert(faces.end(), e.faces.begin(), e.faces.end());
    }
    return faces;
}

/// Open CASCADE keeps what it last converted lengths to.
void want_millimetres() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    UnitsMethods::SetCasCadeLengthUnit(2);
    StepData_StepModel().SetLocalLengthUnit(1);
}

template <class Reader>
std::vector<TopoDS_Face> faces_by_open_cascade(const std::string& path) {
    want_millimetres();
    Reader reader;
    REQUIRE(reader.ReadFile(path.c_str()) == IFSelect_RetDone);
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
        faces.push_back(TopoDS::Face(at.Current()));
    }
    return faces;
}

Vec3 vec(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

double share(const std::array<double, 2>& range, int n, int intervals) {
    return n == intervals ? range[1] : range[0] + (range[1] - range[0]) * n / intervals;
}

/// The greatest distance from points of their face to the nearest of ours.
double farthest(const TopoDS_Face& face, const std::vector<CadFace>& ours) {
    constexpr int intervals = 6;
    std::vector<SurfaceProjection> surfaces;
    for (const CadFace& one : ours) surfaces.emplace_back(cad_surface(one, 1));
    const Handle(Geom_Surface) theirs = BRep_Tool::Surface(face);
    std::array<double, 2> u{};
    std::array<double, 2> v{};
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    double worst = 0;
    for (int j = 0; j <= intervals; ++j) {
        for (int i = 0; i <= intervals; ++i) {
            const Vec3 p = vec(theirs->Value(share(u, i, intervals), share(v, j, intervals)));
            double nearest = 1e300;
            for (const SurfaceProjection& surface : surfaces) {
                nearest = std::min(nearest, surface.nearest(p).distance);
            }
            worst = std::max(worst, nearest);
        }
    }
    return worst;
}

std::vector<TopoDS_Shape> solids() {
    const gp_Ax2 skew(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2));
    return {
        BRepPrimAPI_MakeSphere(skew, 2.5).Shape(), BRepPrimAPI_MakeCylinder(skew, 1.5, 4).Shape(),
        BRepPrimAPI_MakeCone(skew, 2, 0.5, 3).Shape(), BRepPrimAPI_MakeTorus(skew, 3, 1).Shape(),
        BRepPrimAPI_MakeCylinder(skew, 1.5, 4, 1.0).Shape()};
}

/// A file that is gone after the test.
struct Written {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hexweave_cad_" + std::to_string(getpid()));
    Written() = default;
    Written(const Written&) = delete;
    Written& operator=(const Written&) = delete;
    ~Written() { std::filesystem::remove(path); }
};

void write_step(const TopoDS_Shape& shape, const std::string& path) {
    want_millimetres();
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(path.c_str());
}

void write_iges(const TopoDS_Shape& shape, const std::string& path, const char* unit) {
    want_millimetres();
    IGESControl_Writer writer(unit, 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    writer.Write(path.c_str());
}

}  // namespace

TEST_CASE("B-spline surfaces keep their parameters", "[cad]") {
    const CadFile file = read_text(slurp(wings + "AileM6_with_sharp_TE.igs"));
    const auto theirs =
        faces_by_open_cascade<IGESControl_Reader>(wings + "AileM6_with_sharp_TE.igs");
    const std::vector<CadFace> ours = faces_of(file);
    REQUIRE(ours.size() == 10);
    REQUIRE(theirs.size() == 10);
    constexpr int intervals = 11;
    for (std::size_t n = 0; n < ours.size(); ++n) {
        CHECK(ours[n].fault.empty());
        const Surface surface = cad_surface(ours[n], 1);
        const Handle(Geom_Surface) oracle = BRep_Tool::Surface(theirs[n]);
        for (int j = 0; j <= intervals; ++j) {
            for (int i = 0; i <= intervals; ++i) {
                const double u = share(surface.range_u, i, intervals);
                const double v = share(surface.range_v, j, intervals);
                gp_Pnt p;
                gp_Vec along_u;
                gp_Vec along_v;
                oracle->D1(u, v, p, along_u, along_v);
                const double size = 1200;
                CHECK(distance(evaluate(surface, {u, v}), vec(p)) < 1e-12 * size);
                const Vec3 du = evaluate_derivative_u(surface, {u, v});
                CHECK(norm(du - Vec3{along_u.X(), along_u.Y(), along_u.Z()}) < 1e-9 * norm(du));
            }
        }
    }
}

TEST_CASE("IGES and STEP of one wing are the same surfaces", "[cad]") {
    const CadFile iges = read_text(slurp(wings + "AileM6_with_sharp_TE.igs"));
    const CadFile step = read_text(slurp(wings + "AileM6_with_sharp_TE.stp"));
    CHECK(step.entities.size() == 11);  // it has the plane of the root as well
    int compared = 0;
    for (const CadFace& one : faces_of(iges)) {
        for (const CadFace& other : faces_of(step)) {
            if (one.net.count_u != other.net.count_u || one.net.count_v != other.net.count_v ||
                distance(one.net.control.front(), other.net.control.front()) > 1e-3 ||
                distance(one.net.control.back(), other.net.control.back()) > 1e-3) {
                continue;
            }
            ++compared;
            // The STEP file was written with parameters from 0 to 1.
            const auto place = [](const std::vector<double>& knots, double share) {
                return knots.front() + share * (knots.back() - knots.front());
            };
            Surface whole = nurbs_surface(one.net);
            Surface unit = nurbs_surface(other.net);
            for (double u = 0; u <= 1; u += 0.125) {
                for (double v = 0; v <= 1; v += 0.125) {
                    const Vec3 p =
                        evaluate(whole, {place(one.net.knots_u, u), place(one.net.knots_v, v)});
                    const Vec3 q =
                        evaluate(unit, {place(other.net.knots_u, u), place(other.net.knots_v, v)});
                    CHECK(distance(p, q) < 1e-9 * 1200);
                }
            }
        }
    }
    CHECK(compared == 8);
}

TEST_CASE("planes, cylinders, cones, spheres and tori become rational surfaces", "[cad]") {
    constexpr double size = 10;
    for (const TopoDS_Shape& solid : solids()) {
        const Written file;
        write_step(solid, file.path);
        const CadFile step = read_text(slurp(file.path));
        const auto in_step = faces_by_open_cascade<STEPControl_Reader>(file.path);
        write_iges(solid, file.path, "MM");
        const CadFile iges = read_text(slurp(file.path));
        const auto in_iges = faces_by_open_cascade<IGESControl_Reader>(file.path);
        for (const CadFile* read : {&step, &iges}) {
            CHECK(read->unit == "mm");
            const auto& oracle = read == &step ? in_step : in_iges;
            const std::vector<CadFace> ours = faces_of(*read);
            CHECK(ours.size() == oracle.size());
            for (const CadFace& face : ours) {
                INFO(face.type << ": " << face.fault);
                REQUIRE(face.fault.empty());
            }
            for (const TopoDS_Face& face : oracle) CHECK(farthest(face, ours) < 1e-12 * size);
        }
    }
}

TEST_CASE("what was read comes back from bytes as it was", "[cad]") {
    const CadResult read = read_cad(slurp(wings + "AileM6_with_sharp_TE.stp"));
    const std::string bytes = pack(read);
    const CadResult again = unpack(bytes);
    REQUIRE(again.file);
    CHECK(again.file->entities.size() == read.file->entities.size());
    CHECK(faces_of(*again.file).front().net.control == faces_of(*read.file).front().net.control);
    CHECK(pack(again) == bytes);
    CHECK(unpack(pack({{}, "a fault"})).error == "a fault");
}

TEST_CASE("a crash of other people's code is not ours", "[cad]") {
    CHECK(run_in_child([] { return std::string(1000000, 'a'); }, 10).bytes ==
          std::string(1000000, 'a'));
    CHECK(run_in_child([] { return std::string(); }, 10).fault.empty());
    CHECK(run_in_child([] { return raise(SIGKILL), std::string(); }, 10).fault == "Killed");
    const auto fails = []() -> std::string { throw std::runtime_error("no"); };
    CHECK(run_in_child(fails, 10).fault == "it failed");
    const auto never_ends = [] {
        volatile int n = 0;
        while (n < 1) {
        }
        return std::string();
    };
    CHECK(run_in_child(never_ends, 1).fault == "it took too long");
}

TEST_CASE("damaged files are read in part or refused", "[cad]") {
    for (const char* name : {"taper_wing.igs", "AileM6_with_sharp_TE.stp"}) {
        const std::string text = slurp(wings + name);
        std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same files every time
        for (int n = 0; n < 6; ++n) {
            std::string damaged = text;
            for (int k = 0; k < 20; ++k) {
                char& c = damaged[random() % damaged.size()];
                if (c != '\n' && c != '\r') c = "0123456789.,-;( "[random() % 16];
            }
            const CadResult result = read_cad(damaged);
            CHECK(result.file.has_value() == result.error.empty());
        }
    }
}

TEST_CASE("units other than millimetres leave the numbers of the file", "[cad]") {
    const Written file;
    write_iges(BRepPrimAPI_MakeSphere(25.4).Shape(), file.path, "INCH");
    const CadFile inches = read_text(slurp(file.path));
    CHECK(inches.unit == "in");
    const CadBox box = faces_of(inches).front().box;
    CHECK(box.high.z == Approx(1).epsilon(1e-6));
    CHECK(box.low.z == Approx(-1).epsilon(1e-6));
}
