// Profiles of a STEP file: curves without faces, in one plane.

#include <cmath>

#include <fmt/format.h>
#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <Precision.hxx>

#include "drawing/sketch.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/part/step_curves.h"

namespace stepmill::drawing {
namespace {

/// Profiles lie in one plane across z, but for rounding [mm].
constexpr double kFlatMm = 1e-3;
/// Axes of circles and ellipses that lean less stand upright.
constexpr double kUprightCos = 1 - 1e-10;
/// A turn that lacks less is whole [rad].
constexpr double kWholeTurn = 2 * kPi - 1e-9;

class CurveReader {
  public:
    CurveReader(const StepCurves& from, const std::string& file)
        : from_(from), file_(file), mm_per_unit_(from.mm_per_unit > 0 ? from.mm_per_unit : 1) {
        const BRepAdaptor_Curve first(from.curves.front().edge);
        z_mm_ = first.Value(first.FirstParameter()).Z();
    }

    Sketch read() {
        for (const StepCurve& curve : from_.curves) {
            ++number_;
            for (Stroke& stroke : strokesOf(curve.edge)) {
                stroke.layer = curve.layer.empty() ? "curves" : plainLine(curve.layer);
                stroke.place = place();
                sketch_.strokes.push_back(std::move(stroke));
            }
            if (sketch_.strokes.size() > kMostStrokes)
                refuse(file_, place(), fmt::format("expected at most {} lines and arcs", kMostStrokes));
        }
        sketch_.mm_per_unit = from_.mm_per_unit;
        return std::move(sketch_);
    }

  private:
    std::string place() const { return fmt::format("curve {}", number_); }

    /// In the drawing's unit.
    Vec2 flat(const gp_Pnt& p) const {
        if (std::abs(p.Z() - z_mm_) > kFlatMm)
            refuse(file_, place(),
                   fmt::format("expected profiles in one plane across z, found z {:g} mm and z {:g} mm",
                               z_mm_, p.Z()));
        return Vec2(p.X(), p.Y()) / mm_per_unit_;
    }
    static Vec2 flat(const gp_Dir& d) { return {d.X(), d.Y()}; }

    static bool isUpright(const gp_Dir& axis) { return std::abs(axis.Z()) > kUprightCos; }

    std::vector<Stroke> strokesOf(const TopoDS_Edge& edge) const {
        const BRepAdaptor_Curve curve(edge);
        const double first = curve.FirstParameter();
        if (Precision::IsInfinite(first) || Precision::IsInfinite(curve.LastParameter()))
            refuse(file_, place(), "expected a curve with two ends, found one without end");
        const double sweep = curve.LastParameter() - first;
        Stroke stroke;
        stroke.from = flat(curve.Value(first));
        stroke.to = flat(curve.Value(curve.LastParameter()));
        switch (curve.GetType()) {
            case GeomAbs_Line:
                return {stroke};
            case GeomAbs_Circle: {
                const gp_Circ circle = curve.Circle();
                if (!isUpright(circle.Axis().Direction())) break;
                if (sweep < kWholeTurn) {
                    stroke.bulge = std::copysign(std::tan(sweep / 4), circle.Axis().Direction().Z());
                } else {
                    stroke.from = stroke.to = flat(circle.Location());
                    stroke.circle_radius = circle.Radius() / mm_per_unit_;
                }
                return {stroke};
            }
            case GeomAbs_Ellipse: {
                const gp_Elips ellipse = curve.Ellipse();
                if (!isUpright(ellipse.Axis().Direction())) break;
                return ellipseArc(flat(ellipse.Location()),
                                  ellipse.MajorRadius() / mm_per_unit_ * flat(ellipse.XAxis().Direction()),
                                  ellipse.MinorRadius() / mm_per_unit_ * flat(ellipse.YAxis().Direction()),
                                  first, sweep);
            }
            default:
                break;
        }
        stroke.spline = splineOf(edge);
        return {stroke};
    }

    std::shared_ptr<const Spline> splineOf(const TopoDS_Edge& edge) const {
        double first = 0;
        double last = 0;
        const Handle(Geom_Curve) whole = BRep_Tool::Curve(edge, first, last);
        const Handle(Geom_BSplineCurve) curve =
            GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(whole, first, last));
        if (curve->IsPeriodic()) curve->SetNotPeriodic();
        Spline spline;
        spline.degree = curve->Degree();
        for (int i = 1; i <= curve->NbPoles(); ++i) {
            spline.poles.push_back(flat(curve->Pole(i)));
            spline.weights.push_back(curve->Weight(i));
        }
        for (int i = 1; i <= curve->NbKnots(); ++i)
            spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(curve->Multiplicity(i)),
                                curve->Knot(i));
        return std::make_shared<const Spline>(std::move(spline));
    }

    const StepCurves& from_;
    const std::string& file_;
    double mm_per_unit_;
    double z_mm_ = 0;
    int number_ = 0;
    Sketch sketch_;
};

}  // namespace

Sketch readStepCurves(std::string_view text, const std::string& file) {
    const StepCurves curves = stepCurvesFromText(text, file);
    Sketch sketch;
    guardOcct(ErrorCode::StepDamaged, file, [&] { sketch = CurveReader(curves, file).read(); });
    return sketch;
}

}  // namespace stepmill::drawing
