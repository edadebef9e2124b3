#include "drawing/spline_points.h"

#include <Geom_BezierCurve.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "stepmill/drawing/drawing.h"

namespace stepmill::drawing {

opencascade::handle<Geom_BSplineCurve> kernelSpline(const Spline& spline) {
    std::vector<double> knots;
    std::vector<int> repeats;
    for (const double knot : spline.knots) {
        if (!knots.empty() && knot == knots.back()) {
            ++repeats.back();
        } else {
            knots.push_back(knot);
            repeats.push_back(1);
        }
    }
    const int poles = static_cast<int>(spline.poles.size());
    TColgp_Array1OfPnt pole_array(1, poles);
    TColStd_Array1OfReal weight_array(1, poles);
    for (int i = 0; i < poles; ++i) {
        const Vec2& pole = spline.poles[static_cast<std::size_t>(i)];
        pole_array.SetValue(i + 1, gp_Pnt(pole.x(), pole.y(), 0));
        weight_array.SetValue(i + 1, spline.weights[static_cast<std::size_t>(i)]);
    }
    const int spans = static_cast<int>(knots.size());
    TColStd_Array1OfReal knot_array(1, spans);
    TColStd_Array1OfInteger repeat_array(1, spans);
    for (int i = 0; i < spans; ++i) {
        knot_array.SetValue(i + 1, knots[static_cast<std::size_t>(i)]);
        repeat_array.SetValue(i + 1, repeats[static_cast<std::size_t>(i)]);
    }
    return new Geom_BSplineCurve(pole_array, weight_array, knot_array, repeat_array, spline.degree);
}

std::vector<Stroke> spansOf(const Stroke& stroke) {
    if (!stroke.spline) return {stroke};
    const auto whole = kernelSpline(*stroke.spline);
    GeomConvert_BSplineCurveToBezierCurve spans(whole, whole->FirstParameter(), whole->LastParameter(),
                                                Precision::PConfusion());
    std::vector<Stroke> strokes;
    Vec2 reached = stroke.from;
    double skipped_mm = 0;
    for (int i = 1; i <= spans.NbArcs(); ++i) {
        const Handle(Geom_BezierCurve) arc = spans.Arc(i);
        std::vector<Vec2> poles;
        std::vector<double> weights;
        double length_mm = 0;
        for (int pole = 1; pole <= arc->NbPoles(); ++pole) {
            poles.emplace_back(arc->Pole(pole).X(), arc->Pole(pole).Y());
            weights.push_back(arc->Weight(pole));
            if (pole > 1) length_mm += (poles.back() - poles[poles.size() - 2]).norm();
        }
        skipped_mm += length_mm;
        if (skipped_mm <= kHealedGapMm) continue;
        skipped_mm = 0;
        poles.front() = reached;
        reached = poles.back();
        Stroke span = bezier(poles);
        if (poles.size() == 2) {
            span.spline = nullptr;
        } else {
            auto spline = std::make_shared<Spline>(*span.spline);
            spline->weights = weights;
            span.spline = std::move(spline);
        }
        span.layer = stroke.layer;
        span.colour = stroke.colour;
        span.place = stroke.place;
        strokes.push_back(std::move(span));
    }
    return strokes;
}

std::vector<Vec2> splinePoints(const Spline& spline) {
    constexpr int kPointsASpan = 24;
    const auto curve = kernelSpline(spline);
    std::vector<Vec2> points;
    for (int span = 1; span < curve->NbKnots(); ++span) {
        const double first = curve->Knot(span);
        const double step = (curve->Knot(span + 1) - first) / kPointsASpan;
        for (int i = span == 1 ? 1 : 0; i < kPointsASpan; ++i) {
            const gp_Pnt p = curve->Value(first + i * step);
            points.emplace_back(p.X(), p.Y());
        }
    }
    return points;
}

}  // namespace stepmill::drawing
