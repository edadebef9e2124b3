#include "part/step/elementary_solid.h"

#include <cmath>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <NCollection_DataMap.hxx>
#include <Precision.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>

#include <fmt/format.h>

#include "part/measure.h"
#include "part/step/elementary_curve.h"
#include "part/step/elementary_surface.h"

namespace stepmill {
namespace {

TopoDS_Shape forward(const TopoDS_Shape& shape) {
    return shape.Oriented(TopAbs_FORWARD);
}

/// Draws a solid's faces and edges anew. Vertices stay, and so do faces that neither they nor their edges
/// have another form. What is drawn anew has no curves on its surfaces yet.
class Redrawing {
  public:
    explicit Redrawing(const TopoDS_Shape& solid) {
        for (const TopoDS_Face& face : facesOf(solid))
            if (const auto form = elementarySurface(face)) forms_.Bind(face, *form);
        if (forms_.IsEmpty()) return;
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(solid, TopAbs_EDGE, edges);
        for (int i = 1; i <= edges.Extent(); ++i) {
            const TopoDS_Edge edge = TopoDS::Edge(forward(edges(i)));
            if (const auto form = elementaryCurve(edge)) edges_.Bind(edge, redrawn(edge, *form));
        }
    }

    int surfaces() const { return forms_.Extent(); }

    TopoDS_Shape solid(const TopoDS_Shape& drawn) {
        TopoDS_Solid solid;
        builder_.MakeSolid(solid);
        for (TopoDS_Iterator shells(forward(drawn)); shells.More(); shells.Next()) {
            TopoDS_Shell shell;
            builder_.MakeShell(shell);
            for (TopoDS_Iterator faces(forward(shells.Value())); faces.More(); faces.Next())
                builder_.Add(shell, face(TopoDS::Face(faces.Value())));
            shell.Closed(true);
            builder_.Add(solid, shell.Oriented(shells.Value().Orientation()));
        }
        return solid.Oriented(drawn.Orientation());
    }

    /// The face as solid() has it.
    TopoDS_Shape face(const TopoDS_Face& drawn) {
        if (!faces_.IsBound(drawn)) faces_.Bind(drawn, isRedrawn(drawn) ? redrawn(drawn) : forward(drawn));
        const TopoDS_Shape& face = faces_(drawn);
        return drawn.Orientation() == TopAbs_REVERSED ? face.Reversed() : face;
    }

  private:
    TopoDS_Edge redrawn(const TopoDS_Edge& drawn, const ElementaryCurve& form) {
        TopoDS_Edge edge;
        builder_.MakeEdge(edge, form.curve, std::max(BRep_Tool::Tolerance(drawn), kSameForm_mm));
        builder_.Range(edge, form.first, form.last);
        for (TopoDS_Iterator vertices(drawn); vertices.More(); vertices.Next())
            builder_.Add(edge, vertices.Value());
        return edge;
    }

    bool isRedrawn(const TopoDS_Face& drawn) const {
        if (forms_.IsBound(drawn)) return true;
        for (TopExp_Explorer edges(drawn, TopAbs_EDGE); edges.More(); edges.Next())
            if (edges_.IsBound(edges.Current())) return true;
        return false;
    }

    /// \returns it as it is where `drawn` looks forward
    TopoDS_Shape redrawn(const TopoDS_Face& drawn) {
        const ElementarySurface* form = forms_.Seek(drawn);
        const bool turned = form != nullptr && form->turned;
        TopoDS_Face face;
        builder_.MakeFace(face,
                          form != nullptr ? Handle(Geom_Surface)(form->surface) : BRep_Tool::Surface(drawn),
                          std::max(BRep_Tool::Tolerance(drawn), Precision::Confusion()));
        // A loop runs anticlockwise about the normal of its surface.
        for (TopoDS_Iterator wires(forward(drawn)); wires.More(); wires.Next()) {
            const TopoDS_Shape wire = redrawnWire(wires.Value());
            if (TopoDS_Iterator(wire).More()) builder_.Add(face, turned ? wire.Reversed() : wire);
        }
        return turned ? face.Reversed() : TopoDS_Shape(face);
    }

    TopoDS_Shape redrawnWire(const TopoDS_Shape& drawn) {
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (TopoDS_Iterator edges(forward(drawn)); edges.More(); edges.Next()) {
            const TopoDS_Shape& edge = edges.Value();
            // Those at poles have no curve but on the surface; fixing puts them where they belong.
            if (BRep_Tool::Degenerated(TopoDS::Edge(edge))) continue;
            const bool redrawn = edges_.IsBound(edge);
            builder_.Add(wire, redrawn ? edges_(edge).Oriented(edge.Orientation()) : edge);
        }
        wire.Closed(true);
        return wire.Oriented(drawn.Orientation());
    }

    BRep_Builder builder_;
    /// By face.
    NCollection_DataMap<TopoDS_Shape, ElementarySurface, TopTools_ShapeMapHasher> forms_;
    TopTools_DataMapOfShapeShape edges_;  ///< drawn anew, by the edges they stand for
    TopTools_DataMapOfShapeShape faces_;  ///< as they are where the drawn ones look forward
};

/// To how much of itself a volume is measured, with room.
constexpr double kMeasuredShare = 1e-5;

/// Is it the solid it was?
bool isSame(const TopoDS_Shape& redrawn, const HealedSolid& drawn) {
    if (redrawn.IsNull() || countShapes(redrawn, TopAbs_SOLID) != 1) return false;
    if (countShapes(redrawn, TopAbs_FACE) != countShapes(drawn.shape, TopAbs_FACE)) return false;
    if (countFreeEdges(redrawn) > 0 || !BRepCheck_Analyzer(redrawn).IsValid()) return false;
    return std::abs(volumeOf(redrawn) - drawn.volume_mm3) <
           kSameForm_mm * areaOf(redrawn) + kMeasuredShare * drawn.volume_mm3;
}

TopoDS_Shape redrawnSolid(const HealedSolid& solid, ShapeNames& names, std::vector<Remark>& remarks) {
    Redrawing redrawing(solid.shape);
    if (redrawing.surfaces() == 0) return solid.shape;
    ShapeFix_Shape fixer(redrawing.solid(solid.shape));
    fixer.Perform();
    const TopoDS_Shape redrawn = fixer.Shape();
    if (!isSame(redrawn, solid)) return solid.shape;
    for (const TopoDS_Face& face : facesOf(solid.shape))
        if (const std::string name = names.of(face); !name.empty())
            names.set(fixer.Context()->Apply(redrawing.face(face)), name);
    remarks.push_back(
        {kForTheRecord,
         fmt::format("{} of {} faces, drawn as splines or swept, are planes, cylinders, cones, "
                     "spheres or tori to {:g} mm and taken as these",
                     redrawing.surfaces(), countShapes(solid.shape, TopAbs_FACE), kSameForm_mm)});
    return TopExp_Explorer(redrawn, TopAbs_SOLID).Current();
}

}  // namespace

TopoDS_Shape withElementarySurfaces(const HealedSolid& solid, ShapeNames& names,
                                    std::vector<Remark>& remarks) {
    try {
        return redrawnSolid(solid, names, remarks);
    } catch (const Standard_OutOfMemory&) {
        throw;
    } catch (const Standard_Failure&) {
        return solid.shape;  // as good as it was drawn
    }
}

}  // namespace stepmill
