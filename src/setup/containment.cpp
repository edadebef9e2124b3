// Is the part inside its stock?

#include "setup/containment.h"

#include <fmt/format.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill::setup {

namespace {

/// Where both skins coincide, rounding must not call the part outside.
constexpr double kSlackMm = 1e-3;

void checkBoxes(const Box3& part, const Box3& stock) {
    for (int i = 0; i < 3; ++i) {
        const double below = stock.min()[i] - part.min()[i];
        const double above = part.max()[i] - stock.max()[i];
        if (std::max(below, above) <= kSlackMm) continue;
        throw Error(ErrorCode::Usage, "stock",
                    fmt::format("does not contain the part: it sticks out {:.3f} mm on the {}{} side",
                                std::max(below, above), above >= below ? '+' : '-', "xyz"[i]));
    }
}

double distanceTo(const TopoDS_Shape& solid, const gp_Pnt& p) {
    BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(p).Vertex(), solid);
    return distance.IsDone() ? distance.Value() : 0;
}

/// What points on the part's skin cannot tell: hollows of the stock inside the part.
void checkHollows(const TopoDS_Shape& part, const TopoDS_Shape& stock) {
    const TopoDS_Shape part_copy = BRepBuilderAPI_Copy(part).Shape();
    const TopoDS_Shape stock_copy = BRepBuilderAPI_Copy(stock).Shape();
    BRepAlgoAPI_Cut outside(part_copy, stock_copy);
    if (!outside.IsDone()) return;
    GProp_GProps volume;
    BRepGProp::VolumeProperties(outside.Shape(), volume);
    GProp_GProps skin;
    BRepGProp::SurfaceProperties(part_copy, skin);
    // A film of the slack all over the part is rounding.
    if (volume.Mass() <= kSlackMm * skin.Mass()) return;
    const gp_Pnt at = volume.CentreOfMass();
    throw Error(
        ErrorCode::Usage, "stock",
        fmt::format("does not contain the part: {:.3f} mm3 of it about ({:.3f}, {:.3f}, {:.3f}) lie outside",
                    volume.Mass(), at.X(), at.Y(), at.Z()));
}

}  // namespace

void checkContained(const Part& part, const Facets& part_facets, const Part& stock) {
    checkBoxes(part.bbox_mm, stock.bbox_mm);
    constexpr std::size_t kMostProbes = 2000;
    const std::size_t step = std::max<std::size_t>(1, part_facets.size() / kMostProbes);
    gp_Pnt worst;
    double worst_mm = kSlackMm;
    guardOcct(ErrorCode::GeometryKernel, "stock", [&] {
        BRepClass3d_SolidClassifier in_stock(stock.shape->solid);
        BRepClass3d_SolidClassifier in_part(part.shape->solid);
        // The middle of a facet on a bore is in its air, where the part has nothing.
        const auto sticksOut = [&](const gp_Pnt& p) {
            in_stock.Perform(p, kSlackMm);
            if (in_stock.State() != TopAbs_OUT) return false;
            in_part.Perform(p, kSlackMm);
            return in_part.State() != TopAbs_OUT;
        };
        for (std::size_t i = 0; i < part_facets.size(); i += step) {
            const Vec3 middle = (part_facets[i][0] + part_facets[i][1] + part_facets[i][2]) / 3;
            for (const Vec3& probe : {part_facets[i][0], middle}) {
                const gp_Pnt p(probe.x(), probe.y(), probe.z());
                if (!sticksOut(p)) continue;
                const double out_mm = distanceTo(stock.shape->solid, p);
                if (out_mm <= worst_mm) continue;
                worst_mm = out_mm;
                worst = p;
            }
        }
    });
    if (worst_mm > kSlackMm)
        throw Error(
            ErrorCode::Usage, "stock",
            fmt::format("does not contain the part: at ({:.3f}, {:.3f}, {:.3f}) the part sticks out by "
                        "{:.3f} mm",
                        worst.X(), worst.Y(), worst.Z(), worst_mm));
    guardOcct(ErrorCode::GeometryKernel, "stock",
              [&] { checkHollows(part.shape->solid, stock.shape->solid); });
}

}  // namespace stepmill::setup
