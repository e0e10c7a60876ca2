// SPDX-License-Identifier: Apache-2.0
#include <IFSelect_ReturnStatus.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>

#include <sys/mman.h>
#include <unistd.h>

#include "geometry/cad_readers.h"
#include "geometry/cad_shapes.h"

namespace hexweave {

namespace {

/// A text as a file in memory: IGES can be read from files only.
class MemoryFile {
public:
    explicit MemoryFile(const std::string& text) : descriptor_(memfd_create("cad", MFD_CLOEXEC)) {
        std::size_t written = 0;
        while (descriptor_ >= 0 && written < text.size()) {
            const ssize_t count = write(descriptor_, text.data() + written, text.size() - written);
            if (count <= 0) break;
            written += static_cast<std::size_t>(count);
        }
        if (written < text.size()) throw CadFault("there is no memory for a copy of it");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

/// The entities that are shapes by themselves or, where no other shape is made of them, may be.
const std::map<int, const char*>& shape_types() {
    static const std::map<int, const char*> types{{100, "circular arc"},
                                                  {102, "composite curve"},
                                                  {104, "conic arc"},
                                                  {106, "copious data"},
                                                  {108, "plane"},
                                                  {110, "line"},
                                                  {112, "parametric spline curve"},
                                                  {114, "parametric spline surface"},
                                                  {118, "ruled surface"},
                                                  {120, "surface of revolution"},
                                                  {122, "tabulated cylinder"},
                                                  {126, "B-spline curve"},
                                                  {128, "B-spline surface"},
                                                  {130, "offset curve"},
                                                  {140, "offset surface"},
                                                  {143, "bounded surface"},
                                                  {144, "trimmed surface"},
                                                  {186, "solid"},
                                                  {190, "plane surface"},
                                                  {192, "cylindrical surface"},
                                                  {194, "conical surface"},
                                                  {196, "spherical surface"},
                                                  {198, "toroidal surface"},
                                                  {308, "subfigure"},
                                                  {408, "subfigure instance"},
                                                  {514, "shell"}};
    return types;
}

/// Entities that others are made of, and not shapes: curves on surfaces, boundaries, faces.
bool is_part(int type) {
    return type == 141 || type == 142 || type == 508 || type == 510;
}

bool belongs_to_another(const Interface_Graph& graph, const Handle(IGESData_IGESEntity) & entity) {
    for (Interface_EntityIterator at = graph.Sharings(entity); at.More(); at.Next()) {
        const auto owner = Handle(IGESData_IGESEntity)::DownCast(at.Value());
        if (owner.IsNull()) continue;
        const int type = owner->TypeNumber();
        if (is_part(type) || shape_types().count(type) == 1) return true;
    }
    return false;
}

std::string trimmed_text(const Handle(TCollection_HAsciiString) & text) {
    if (text.IsNull()) return {};
    const std::string all = text->ToCString();
    const std::size_t begin = all.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    return all.substr(begin, all.find_last_not_of(' ') - begin + 1);
}

std::string label_of(const Handle(IGESData_IGESEntity) & entity) {
    if (!entity->HasShortLabel()) return {};
    std::string label = trimmed_text(entity->ShortLabel());
    if (entity->HasSubScriptNumber() && entity->SubScriptNumber() > 0) {
        label += "(" + std::to_string(entity->SubScriptNumber()) + ")";
    }
    return label;
}

/// Whatever unit they are in, lengths stay as they stand in the file.
void keep_lengths(const Handle(IGESData_IGESModel) & model) {
    IGESData_GlobalSection global = model->GlobalSection();
    global.SetUnitFlag(6);
    global.SetCascadeUnit(1e3);
    model->SetGlobalSection(global);
    convert_lengths_to(*find_length_unit("m"));
}

std::string name_of(const Handle(IGESData_IGESEntity) & entity) {
    if (entity->NbTypedProperties(STANDARD_TYPE(IGESBasic_Name)) == 0) return {};
    return trimmed_text(entity->NameValue());
}

CadEntity read_entity(IGESControl_Reader& reader, const Handle(IGESData_IGESModel) & model,
                      const Handle(IGESData_IGESEntity) & entity) {
    CadEntity result;
    result.number = model->DNum(entity);
    result.type = shape_types().at(entity->TypeNumber());
    result.label = label_of(entity);
    result.name = name_of(entity);
    reader.TransferEntity(entity);
    const TopoDS_Shape shape = reader.WS()->TransferReader()->ShapeResult(entity);
    if (shape.IsNull()) return result;
    for (const TopoDS_Face& face : faces_of(shape)) result.faces.push_back(cad_face(face));
    for (const TopoDS_Edge& edge : free_edges_of(shape)) result.curves.push_back(cad_edge(edge));
    return result;
}

}  // namespace

CadFile read_iges(const CadText& text) {
    IGESControl_Controller::Init();
    // Surfaces with creases stay in one piece.
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
    const MemoryFile in_memory(text.text);
    IGESControl_Reader reader;
    const IFSelect_ReturnStatus status = reader.ReadFile(in_memory.path().c_str());
    const Handle(IGESData_IGESModel) model = reader.IGESModel();
    if (status != IFSelect_RetDone || model.IsNull() || model->NbEntities() == 0) {
        throw CadFault("the IGES file holds nothing that can be read");
    }
    CadFile file;
    file.unit = text.unit;
    if (!file.unit.empty()) file.unit_in_metres = find_length_unit(file.unit)->metres;
    keep_lengths(model);
    const Interface_Graph& graph = reader.WS()->Graph();
    for (int n = 1; n <= model->NbEntities(); ++n) {
        const Handle(IGESData_IGESEntity) entity = model->Entity(n);
        constexpr int definition = 2;
        constexpr int parametric = 5;
        if (shape_types().count(entity->TypeNumber()) == 0 || entity->TypeNumber() == 308 ||
            entity->UseFlag() == definition || entity->UseFlag() == parametric ||
            belongs_to_another(graph, entity)) {
            continue;
        }
        file.entities.push_back(read_entity(reader, model, entity));
    }
    return file;
}

}  // namespace hexweave
