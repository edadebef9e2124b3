#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <StepBasic_Product.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <Transfer_FinderProcess.hxx>
#include <Transfer_SimpleBinderOfTransient.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include "sample_parts.h"
#include "stepmill/core/file.h"
#include "stepmill/core/scratch_folder.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

Handle(TCollection_HAsciiString) text(const std::string& value) {
    return new TCollection_HAsciiString(value.c_str());
}

std::string number(double value) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.5g", std::abs(value) < 1e-9 ? 0.0 : value);
    return buffer.data();
}

/// "top", "side +x", "floor z 18", "wall", "round r 6": what a machinist would call the face.
std::string nameFace(const TopoDS_Face& face, const Box3& block) {
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() == GeomAbs_Cylinder) return "round r " + number(surface.Cylinder().Radius());
    if (surface.GetType() != GeomAbs_Plane) return "free form";
    const gp_Pnt at = surface.Plane().Location();
    const gp_Dir normal = surface.Plane().Axis().Direction();
    const std::array<const char*, 3> axes = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
        if (std::abs(normal.Coord(k + 1)) < 1 - 1e-9) continue;
        const double level = at.Coord(k + 1);
        const bool low = std::abs(level - block.min()[k]) < 1e-6;
        const bool high = std::abs(level - block.max()[k]) < 1e-6;
        if (k == 2) return low ? "bottom" : high ? "top" : "level z " + number(level);
        if (low || high) return std::string("side ") + (low ? "-" : "+") + axes[static_cast<std::size_t>(k)];
        return std::string("wall ") + axes[static_cast<std::size_t>(k)] + " " + number(level);
    }
    return "wall";
}

/// Entity a face was written as. The writer looks shapes up with their orientation, and may have turned the
/// shell that holds the face.
Handle(StepRepr_RepresentationItem)
    entityOf(const Handle(Transfer_FinderProcess) & process, const TopoDS_Shape& face) {
    for (const TopoDS_Shape& turned : {face, face.Reversed()}) {
        const Handle(TransferBRep_ShapeMapper) finder = TransferBRep::ShapeMapper(process, turned);
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(process->FindTransient(finder));
        if (!item.IsNull()) return item;
    }
    return {};
}

void nameFaces(STEPControl_Writer& writer, const SamplePart& part) {
    const Handle(Transfer_FinderProcess) process = writer.WS()->TransferWriter()->FinderProcess();
    const Box3 block = makePart(part.solid, part.name).bbox_mm;
    for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        const std::string name = nameFace(face, block);
        const Handle(StepRepr_RepresentationItem) item = entityOf(process, face);
        if (item.IsNull())
            throw Error(ErrorCode::GeometryKernel, part.name,
                        "the face \"" + name + "\" has no entity in the STEP model");
        item->SetName(text(name));
    }
}

/// The writer numbers products over the life of the program; the part's own name does not depend on that.
void nameProduct(const Handle(StepData_StepModel) & model, const std::string& name) {
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
        if (product.IsNull()) continue;
        product->SetId(text(name));
        product->SetName(text(name));
    }
}

void fixHeader(const Handle(StepData_StepModel) & model, const std::string& name) {
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text(name));
    header.SetTimeStamp(text("2000-01-01T00:00:00"));  // constant: the same part gives the same bytes
    header.SetAuthorValue(1, text("Stepmill"));
    header.SetOrganizationValue(1, text("Stepmill"));
    header.SetPreprocessorVersion(text("Open CASCADE STEP processor"));
    header.SetOriginatingSystem(text("stepmill-parts"));
    header.SetAuthorisation(text(""));
    header.SetDescriptionValue(1, text("Stepmill sample part"));
}

}  // namespace

std::string sampleStepText(const SamplePart& part) {
    std::string bytes;
    guardOcct(ErrorCode::GeometryKernel, part.name, [&] {
        Message::DefaultMessenger()->ChangePrinters().Clear();
        STEPControl_Controller::Init();
        Interface_Static::SetCVal("write.step.schema", "AP214IS");
        Interface_Static::SetCVal("write.step.unit", "MM");
        Interface_Static::SetCVal("write.step.product.name", part.name.c_str());
        Interface_Static::SetIVal("write.surfacecurve.mode",
                                  0);  // readers find curves on surfaces themselves
        STEPControl_Writer writer;
        if (writer.Transfer(part.solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
            throw Error(ErrorCode::GeometryKernel, part.name, "the solid cannot be turned into STEP");
        nameFaces(writer, part);
        nameProduct(writer.Model(), part.name);
        fixHeader(writer.Model(), part.name);
        const ScratchFolder scratch("parts");
        const std::filesystem::path file = scratch.path() / "part.step";
        if (writer.Write(file.c_str()) != IFSelect_RetDone)
            throw Error(ErrorCode::OutputUnwritable, part.name, "the STEP file cannot be written");
        bytes = readFile(file);
    });
    return bytes;
}

}  // namespace stepmill
