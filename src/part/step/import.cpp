#include "part/step/import.h"

#include <cmath>
#include <sstream>

#include <gp_Vec.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <Transfer_TransientProcess.hxx>
#include <TransferBRep.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "part/measure.h"
#include "part/occt_values.h"

namespace stepmill {
namespace {

/// Takes OCCT's printers off its messenger for a while.
class SilentMessenger {
  public:
    SilentMessenger() : saved_(Message::DefaultMessenger()->Printers()) {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
    SilentMessenger(const SilentMessenger&) = delete;
    SilentMessenger& operator=(const SilentMessenger&) = delete;
    ~SilentMessenger() { Message::DefaultMessenger()->ChangePrinters() = saved_; }

  private:
    Message_SequenceOfPrinters saved_;
};

std::string textOf(const Handle(TCollection_HAsciiString) & text) {
    return text.IsNull() ? std::string() : std::string(text->ToCString());
}

/// Refuses shape entities whose values are of the wrong kind or number. The reader notes them, leaves
/// their members null and then runs into those. Representations and their contexts are left alone: real
/// files name odd items and missing units there, and the shape is whole.
void checkEntities(const Handle(Interface_InterfaceModel) & model, const std::string& file) {
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (!model->IsReportEntity(i) || !model->Check(i, Standard_True)->HasFailed()) continue;
        const Handle(Standard_Transient)& entity = model->Value(i);
        if (entity.IsNull() || !entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem))) continue;
        const std::string kind = entity->DynamicType()->Name();
        if (!kind.starts_with("StepGeom_") && !kind.starts_with("StepShape_")) continue;
        throw Error(ErrorCode::StepDamaged, file,
                    entityName(model, entity) + " has values of the wrong kind or number (" +
                        model->Check(i, Standard_True)->CFail(1) + ")");
    }
}

std::vector<std::string> lengthUnits(STEPControl_Reader& reader) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    std::vector<std::string> units;
    for (int i = 1; i <= lengths.Length(); ++i) {
        const std::string unit = lengths.Value(i).ToCString();
        if (!unit.empty() && std::find(units.begin(), units.end(), unit) == units.end())
            units.push_back(unit);
    }
    return units;
}

/// A product's name, empty where Open CASCADE made one up: its version and a count, or a label of its
/// document. The file's name tells a reader more.
std::string nameOf(const StepBasic_Product& product) {
    const std::string given = textOf(product.Name());
    const std::string name = given.empty() ? textOf(product.Id()) : given;
    const bool made_up = name.starts_with("Open CASCADE STEP translator ") || name.starts_with("=>[");
    return made_up ? std::string() : name;
}

/// Product of a shape representation, through its definition.
std::string productOf(const Handle(Standard_Transient) & representation, const Interface_Graph& graph) {
    for (Interface_EntityIterator it = graph.Sharings(representation); it.More(); it.Next()) {
        const auto link = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(it.Value());
        if (link.IsNull()) continue;
        const auto shape =
            Handle(StepRepr_ProductDefinitionShape)::DownCast(link->Definition().PropertyDefinition());
        if (shape.IsNull()) continue;
        const Handle(StepBasic_ProductDefinition) definition = shape->Definition().ProductDefinition();
        if (definition.IsNull() || definition->Formation().IsNull()) continue;
        const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
        if (!product.IsNull()) return nameOf(*product);
    }
    return {};
}

/// The product a solid's representation belongs to, directly or through an equivalent representation.
std::string productOfSolid(const Handle(Standard_Transient) & solid, const Interface_Graph& graph) {
    for (Interface_EntityIterator it = graph.Sharings(solid); it.More(); it.Next()) {
        const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(it.Value());
        if (representation.IsNull()) continue;
        if (const std::string name = productOf(representation, graph); !name.empty()) return name;
        for (Interface_EntityIterator up = graph.Sharings(representation); up.More(); up.Next()) {
            const auto relation = Handle(StepRepr_ShapeRepresentationRelationship)::DownCast(up.Value());
            if (relation.IsNull()) continue;
            for (const Handle(StepRepr_Representation) & other : {relation->Rep1(), relation->Rep2()}) {
                if (other == representation || other.IsNull()) continue;
                if (const std::string name = productOf(other, graph); !name.empty()) return name;
            }
        }
    }
    return {};
}

/// Reads names off the entities that became faces and solids.
void readNames(STEPControl_Reader& reader, StepImport& result) {
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    const Interface_Graph& graph = reader.WS()->Graph();
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(process->Mapped(i));
        if (item.IsNull()) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
        if (shape.IsNull()) continue;
        if (shape.ShapeType() == TopAbs_FACE) {
            result.face_names.set(shape, textOf(item->Name()));
        } else if (shape.ShapeType() == TopAbs_SOLID) {
            for (ImportedSolid& solid : result.solids) {
                if (!solid.name.empty() || !solid.shape.IsPartner(shape)) continue;
                solid.name = productOfSolid(item, graph);
                if (solid.name.empty()) solid.name = textOf(item->Name());
            }
        }
    }
}

gp_Vec vectorOf(const Handle(StepGeom_Direction) & direction, const gp_Vec& otherwise) {
    if (direction.IsNull() || direction->NbDirectionRatios() != 3) return otherwise;
    return {direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
            direction->DirectionRatiosValue(3)};
}

/// Refuses placements that scale or mirror: the reader turns and moves only, and makes another shape.
void checkPlacements(const Handle(Interface_InterfaceModel) & model, const std::string& file) {
    constexpr double kScaleRounding = 1e-9;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto placement = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(model->Value(i));
        if (placement.IsNull()) continue;
        const bool scales = placement->HasScale() && std::abs(placement->Scale() - 1) > kScaleRounding;
        const gp_Vec x = vectorOf(placement->Axis1(), gp_Vec(1, 0, 0));
        const gp_Vec y = vectorOf(placement->Axis2(), gp_Vec(0, 1, 0));
        const gp_Vec z = vectorOf(placement->Axis3(), gp_Vec(0, 0, 1));
        if (!scales && x.Crossed(y).Dot(z) >= 0) continue;
        throw Error(
            ErrorCode::StepDamaged, file,
            entityName(model, placement) +
                " scales or mirrors what it places, which the geometry reader cannot; export it as it "
                "stands");
    }
}

/// Refuses curves of sets and representations that the reader makes no edge of.
void checkCurves(const Handle(Interface_InterfaceModel) & model, const Interface_Graph& graph,
                 const Handle(Transfer_TransientProcess) & process, const std::string& file) {
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto curve = Handle(StepGeom_Curve)::DownCast(model->Value(i));
        if (curve.IsNull() || !TransferBRep::ShapeResult(process, curve).IsNull()) continue;
        for (Interface_EntityIterator it = graph.Sharings(curve); it.More(); it.Next())
            if (it.Value()->IsKind(STANDARD_TYPE(StepShape_GeometricSet)) ||
                it.Value()->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation)))
                throw Error(ErrorCode::StepDamaged, file,
                            entityName(model, curve) + " is a curve that the geometry reader cannot build");
    }
}

/// The layer that an entity of the file lies on; empty for none.
std::string layerOf(const Handle(Standard_Transient) & item, const Interface_Graph& graph) {
    for (Interface_EntityIterator it = graph.Sharings(item); it.More(); it.Next()) {
        const auto layer = Handle(StepVisual_PresentationLayerAssignment)::DownCast(it.Value());
        if (!layer.IsNull()) return textOf(layer->Name());
    }
    return {};
}

/// Edges that bound no face. Each has the layer of its curve, else that of the set the curve is in, else the
/// name of that set or of its product.
void collectCurves(STEPControl_Reader& reader, StepImport& result) {
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    const Interface_Graph& graph = reader.WS()->Graph();
    ShapeNames layers, layers_of_sets, names_of_sets;
    const auto name = [](ShapeNames& names, const TopoDS_Shape& shape, const std::string& text) {
        for (TopExp_Explorer it(shape, TopAbs_EDGE); !text.empty() && it.More(); it.Next())
            if (names.of(it.Current()).empty()) names.set(it.Current(), text);
    };
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const Handle(Standard_Transient)& item = process->Mapped(i);
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
        if (shape.IsNull()) continue;
        const bool is_edge = shape.ShapeType() == TopAbs_EDGE;
        name(is_edge ? layers : layers_of_sets, shape, layerOf(item, graph));
        if (is_edge) continue;
        const auto set = Handle(StepRepr_RepresentationItem)::DownCast(item);
        std::string called = set.IsNull() ? std::string() : textOf(set->Name());
        if (called.empty()) called = productOfSolid(item, graph);
        if (called.empty()) called = productOf(item, graph);
        name(names_of_sets, shape, called);
    }
    for (int i = 1; i <= reader.NbShapes(); ++i)
        for (TopExp_Explorer it(reader.Shape(i), TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next()) {
            std::string layer;
            for (const ShapeNames* names : {&layers, &layers_of_sets, &names_of_sets})
                if (layer.empty()) layer = names->of(it.Current());
            result.curves.push_back({TopoDS::Edge(it.Current()), layer});
        }
}

void collectSolids(const TopoDS_Shape& root, StepImport& result) {
    for (TopExp_Explorer it(root, TopAbs_SOLID); it.More(); it.Next()) {
        const auto known =
            std::find_if(result.solids.begin(), result.solids.end(),
                         [&](const ImportedSolid& s) { return s.shape.IsPartner(it.Current()); });
        if (known == result.solids.end())
            result.solids.push_back({it.Current(), 1, {}});
        else
            ++known->count;
    }
}

int countOutside(const TopoDS_Shape& root, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outside) {
    int count = 0;
    for (TopExp_Explorer it(root, kind, outside); it.More(); it.Next())
        ++count;
    return count;
}

void collectStrays(const TopoDS_Shape& root, Strays& strays) {
    for (TopExp_Explorer it(root, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
        ++strays.shells;
        strays.shell_free_edges += countFreeEdges(it.Current());
        strays.shell_faces += countShapes(it.Current(), TopAbs_FACE);
    }
    strays.faces += countOutside(root, TopAbs_FACE, TopAbs_SHELL);
    strays.edges += countOutside(root, TopAbs_EDGE, TopAbs_FACE);
    strays.points += countOutside(root, TopAbs_VERTEX, TopAbs_EDGE);
}

}  // namespace

void ShapeNames::set(const TopoDS_Shape& shape, const std::string& name) {
    names_.Bind(unplaced(shape), name);
}

std::string ShapeNames::of(const TopoDS_Shape& shape) const {
    const std::string* name = names_.Seek(unplaced(shape));
    return name ? *name : std::string();
}

StepImport importStep(std::string_view text, const std::string& file) {
    StepImport result;
    guardOcct(ErrorCode::StepDamaged, file, [&] {
        const SilentMessenger silence;
        STEPControl_Controller::Init();
        Interface_Static::SetCVal("xstep.cascade.unit", "MM");
        STEPControl_Reader reader;
        std::istringstream stream{std::string(text)};
        if (reader.ReadStream(file.c_str(), stream) != IFSelect_RetDone)
            throw Error(ErrorCode::StepDamaged, file, "the STEP reader cannot make sense of the entities");
        checkEntities(reader.Model(), file);
        checkPlacements(reader.Model(), file);
        reader.TransferRoots();
        result.units = lengthUnits(reader);
        for (int i = 1; i <= reader.NbShapes(); ++i) {
            const TopoDS_Shape root = reader.Shape(i);
            if (root.IsNull()) continue;
            collectSolids(root, result);
            collectStrays(root, result.strays);
        }
        if (result.solids.empty() && result.strays.faces + result.strays.shell_faces == 0) {
            checkCurves(reader.Model(), reader.WS()->Graph(),
                        reader.WS()->TransferReader()->TransientProcess(), file);
            collectCurves(reader, result);
        }
        readNames(reader, result);
        result.bodies = accountBodies(reader);
    });
    return result;
}

}  // namespace stepmill
