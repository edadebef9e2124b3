#include "part/step/import_account.h"

#include <BRep_Tool.hxx>
#include <Interface_InterfaceModel.hxx>
#include <NCollection_DataMap.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_BrepWithVoids.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedFace.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <Transfer_TransientProcess.hxx>
#include <TransferBRep.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <fmt/format.h>

#include "part/measure.h"
#include "part/occt_values.h"

namespace stepmill {
namespace {

int idOf(const Handle(Interface_InterfaceModel) & model, const Handle(Standard_Transient) & entity) {
    return Handle(StepData_StepModel)::DownCast(model)->IdentLabel(entity);
}

struct ShellUse {
    Handle(StepShape_ConnectedFaceSet) shell;
    bool forward = true;
};

ShellUse useOf(const Handle(StepShape_ConnectedFaceSet) & shell) {
    const auto oriented = Handle(StepShape_OrientedClosedShell)::DownCast(shell);
    if (oriented.IsNull()) return {shell, true};
    return {oriented->ClosedShellElement(), oriented->Orientation()};
}

std::vector<ShellUse> shellsOf(const Handle(StepShape_ManifoldSolidBrep) & body) {
    std::vector<ShellUse> shells;
    if (!body->Outer().IsNull()) shells.push_back(useOf(body->Outer()));
    const auto with_voids = Handle(StepShape_BrepWithVoids)::DownCast(body);
    for (int i = 1; !with_voids.IsNull() && i <= with_voids->NbVoids(); ++i)
        shells.push_back(useOf(with_voids->VoidsValue(i)));
    return shells;
}

/// Edges the file lists around a face, a seam twice; nothing where a bound is not made of edges.
std::optional<int> edgesAround(const Handle(StepShape_Face) & face) {
    int count = 0;
    for (int i = 1; i <= face->NbBounds(); ++i) {
        const auto loop = Handle(StepShape_EdgeLoop)::DownCast(face->BoundsValue(i)->Bound());
        if (loop.IsNull()) return std::nullopt;
        count += loop->NbEdgeList();
    }
    return count;
}

int edgesAround(const TopoDS_Face& face) {
    int count = 0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        count += BRep_Tool::Degenerated(TopoDS::Edge(it.Current())) ? 0 : 1;
    return count;
}

class Accountant {
  public:
    explicit Accountant(STEPControl_Reader& reader)
        : model_(reader.Model()), process_(reader.WS()->TransferReader()->TransientProcess()) {}

    BodyAccount account(const Handle(StepShape_ManifoldSolidBrep) & body) {
        BodyAccount result;
        result.id = idOf(model_, body);
        result.shape = TransferBRep::ShapeResult(process_, body);
        if (result.shape.IsNull() || result.shape.ShapeType() != TopAbs_SOLID) {
            result.losses.push_back(nameOf(body) + " came out as no single solid");
        } else {
            gatherFaces(result);
        }
        int in_file = 0;
        for (const ShellUse& use : shellsOf(body))
            in_file += accountShell(use, result);
        if (result.losses.empty() && result.faces != in_file)
            result.losses.push_back(
                fmt::format("{} has {} faces, {} were made of it", nameOf(body), in_file, result.faces));
        return result;
    }

  private:
    std::string nameOf(const Handle(Standard_Transient) & entity) const { return entityName(model_, entity); }

    void gatherFaces(BodyAccount& result) {
        orientations_.Clear();
        for (TopExp_Explorer it(result.shape, TopAbs_FACE); it.More(); it.Next()) {
            orientations_.Bind(unplaced(it.Current()), it.Current().Orientation());
            ++result.faces;
        }
    }

    int accountShell(const ShellUse& use, BodyAccount& result) {
        for (int i = 1; i <= use.shell->NbCfsFaces(); ++i)
            accountFace(use.shell->CfsFacesValue(i), use.forward, result);
        return use.shell->NbCfsFaces();
    }

    void accountFace(Handle(StepShape_Face) face, bool forward, BodyAccount& result) {
        if (const auto oriented = Handle(StepShape_OrientedFace)::DownCast(face); !oriented.IsNull()) {
            forward = oriented->Orientation() == forward;
            face = oriented->FaceElement();
        }
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, face);
        if (shape.IsNull()) {
            result.losses.push_back(nameOf(face) + " was dropped");
        } else if (shape.ShapeType() != TopAbs_FACE) {
            result.losses.push_back(nameOf(face) + " was split");
        } else {
            compareFace(face, TopoDS::Face(shape), forward, result);
        }
    }

    void compareFace(const Handle(StepShape_Face) & face, const TopoDS_Face& made, bool forward,
                     BodyAccount& result) {
        // More are no loss: a closed face gets a seam where the file has none, and edges are cut where the
        // seam of a face beside them ends.
        const std::optional<int> in_file = edgesAround(face);
        const int edges = edgesAround(made);
        if (in_file && edges < *in_file)
            result.losses.push_back(
                fmt::format("{} has {} edges, {} were made of them", nameOf(face), *in_file, edges));
        const TopAbs_Orientation* orientation = orientations_.Seek(unplaced(made));
        if (!orientation) {
            if (!result.shape.IsNull()) result.losses.push_back(nameOf(face) + " is not in the solid");
            return;
        }
        const auto surface_face = Handle(StepShape_FaceSurface)::DownCast(face);
        if (surface_face.IsNull()) return;
        const bool looks_along = *orientation == TopAbs_FORWARD;
        if (looks_along != (surface_face->SameSense() == forward)) result.turned.push_back(nameOf(face));
    }

    Handle(Interface_InterfaceModel) model_;
    Handle(Transfer_TransientProcess) process_;
    NCollection_DataMap<TopoDS_Shape, TopAbs_Orientation, TopTools_ShapeMapHasher> orientations_;
};

}  // namespace

std::string entityName(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Standard_Transient) & entity) {
    // StepShape_AdvancedFace is OCCT's name of ADVANCED_FACE.
    const std::string type = entity->DynamicType()->Name();
    std::string keyword;
    for (const char c : type.substr(type.find('_') + 1)) {
        const bool capital = std::isupper(static_cast<unsigned char>(c)) != 0;
        if (capital && !keyword.empty()) keyword += '_';
        keyword += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return fmt::format("#{} {}", idOf(model, entity), keyword);
}

std::vector<BodyAccount> accountBodies(STEPControl_Reader& reader) {
    std::vector<BodyAccount> bodies;
    const Handle(Interface_InterfaceModel) model = reader.Model();
    Accountant accountant(reader);
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto body = Handle(StepShape_ManifoldSolidBrep)::DownCast(model->Value(i));
        if (!body.IsNull()) bodies.push_back(accountant.account(body));
    }
    return bodies;
}

}  // namespace stepmill
