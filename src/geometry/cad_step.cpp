// SPDX-License-Identifier: Apache-2.0
#include <IFSelect_ReturnStatus.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "geometry/cad_readers.h"
#include "geometry/cad_shapes.h"

namespace hexweave {

namespace {

Handle(StepRepr_GlobalUnitAssignedContext) units_of(const Handle(Standard_Transient) & entity) {
    using Plain = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;
    using WithUncertainty = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
    const auto plain = Handle(Plain)::DownCast(entity);
    if (!plain.IsNull()) return plain->GlobalUnitAssignedContext();
    const auto uncertain = Handle(WithUncertainty)::DownCast(entity);
    if (!uncertain.IsNull()) return uncertain->GlobalUnitAssignedContext();
    return {};
}

/// The units of length of all parts of the file, in millimetres.
std::set<double> length_factors(const Handle(StepData_StepModel) & model) {
    std::set<double> factors;
    for (int n = 1; n <= model->NbEntities(); ++n) {
        const auto units = units_of(model->Entity(n));
        if (units.IsNull()) continue;
        STEPConstruct_UnitContext context;
        context.ComputeFactors(units);
        if (context.LengthDone()) factors.insert(context.LengthFactor());
    }
    return factors;
}

void convert_to(const LengthUnit& unit, const Handle(StepData_StepModel) & model) {
    convert_lengths_to(unit);
    model->SetLocalLengthUnit(1e3 * unit.metres);
}

void set_units(CadFile& file, const Handle(StepData_StepModel) & model) {
    const LengthUnit* unit = find_length_unit("mm");
    convert_to(*unit, model);
    const std::set<double> factors = length_factors(model);
    if (factors.empty()) return;
    file.several_units = factors.size() > 1;
    const LengthUnit* common = find_length_unit(1e-3 * *factors.begin());
    if (!file.several_units && common != nullptr) unit = common;
    convert_to(*unit, model);
    file.unit = unit->name;
    file.unit_in_metres = unit->metres;
}

/// Which entity of the file a face or edge is made from: the last one, where it is several.
class Origins {
public:
    explicit Origins(const STEPControl_Reader& reader) : model_(reader.StepModel()) {
        const Handle(Transfer_TransientProcess) transfer =
            reader.WS()->TransferReader()->TransientProcess();
        for (int n = 1; n <= model_->NbEntities(); ++n) {
            const auto item = Handle(StepRepr_RepresentationItem)::DownCast(model_->Entity(n));
            if (item.IsNull()) continue;
            const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer, item);
            if (shape.IsNull()) continue;
            if (shape.ShapeType() == TopAbs_FACE || shape.ShapeType() == TopAbs_EDGE) {
                items_[shape.TShape().get()] = item;
            }
        }
    }

    /// The entity that the shape is made from, or the one that its whole is.
    Handle(Standard_Transient)
        of(const TopoDS_Shape& shape, const Handle(Standard_Transient) & root) const {
        const auto found = items_.find(shape.TShape().get());
        return found == items_.end() ? root : Handle(Standard_Transient)(found->second);
    }

private:
    Handle(StepData_StepModel) model_;
    std::map<const TopoDS_TShape*, Handle(StepRepr_RepresentationItem)> items_;
};

/// The entities so far, by number.
class Entities {
public:
    explicit Entities(Handle(StepData_StepModel) model) : model_(std::move(model)) {}

    CadEntity& at(const Handle(Standard_Transient) & origin) {
        const int number = model_->IdentLabel(origin);
        CadEntity& entity = entities_[number];
        entity.number = number;
        entity.type = model_->TypeName(origin, false);
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(origin);
        const bool named = !item.IsNull() && !item->Name().IsNull();
        if (named) entity.name = item->Name()->ToCString();
        return entity;
    }

    std::vector<CadEntity> take() {
        std::vector<CadEntity> list;
        list.reserve(entities_.size());
        for (auto& [number, entity] : entities_) list.push_back(std::move(entity));
        return list;
    }

private:
    Handle(StepData_StepModel) model_;
    std::map<int, CadEntity> entities_;
};

}  // namespace

CadFile read_step(const CadText& text) {
    STEPControl_Controller::Init();
    STEPControl_Reader reader;
    std::istringstream stream(text.text);
    const IFSelect_ReturnStatus status = reader.ReadStream("cad", stream);
    const Handle(StepData_StepModel) model = reader.StepModel();
    if (status != IFSelect_RetDone || model.IsNull() || model->NbEntities() == 0) {
        throw CadFault("the STEP file holds nothing that can be read");
    }
    CadFile file;
    set_units(file, model);
    std::vector<std::pair<Handle(Standard_Transient), TopoDS_Shape>> roots;
    for (int n = 1; n <= reader.NbRootsForTransfer(); ++n) {
        const Handle(Standard_Transient) root = reader.RootForTransfer(n);
        reader.TransferRoot(n);
        const TopoDS_Shape shape = reader.WS()->TransferReader()->ShapeResult(root);
        if (!shape.IsNull()) roots.emplace_back(root, shape);
    }
    const Origins origins(reader);
    Entities entities(model);
    for (const auto& [root, shape] : roots) {
        for (const TopoDS_Face& face : faces_of(shape)) {
            entities.at(origins.of(face, root)).faces.push_back(cad_face(face));
        }
        for (const TopoDS_Edge& edge : free_edges_of(shape)) {
            entities.at(origins.of(edge, root)).curves.push_back(cad_edge(edge));
        }
    }
    file.entities = entities.take();
    return file;
}

}  // namespace hexweave
