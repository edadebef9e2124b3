#include "part/step/elementary_curve.h"

#include <algorithm>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <gce_MakeCirc.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>

#include "part/measure.h"
#include "part/step/elementary_surface.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

constexpr int kFewestOnCurve = 17;
constexpr int kOnCurveSpan = 5;

std::vector<gp_Pnt> pointsOn(const BRepAdaptor_Curve& curve) {
    const int steps = std::max(kFewestOnCurve, kOnCurveSpan * curve.NbIntervals(GeomAbs_CN));
    std::vector<gp_Pnt> points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i)
        points.push_back(curve.Value(curve.FirstParameter() +
                                     (curve.LastParameter() - curve.FirstParameter()) * i / steps));
    return points;
}

std::optional<ElementaryCurve> lineThrough(const std::vector<gp_Pnt>& points) {
    const gp_Vec along(points.front(), points.back());
    if (along.Magnitude() < kSameForm_mm) return std::nullopt;
    const gp_Lin line(points.front(), gp_Dir(along));
    for (const gp_Pnt& p : points)
        if (line.Distance(p) > kSameForm_mm) return std::nullopt;
    return ElementaryCurve{new Geom_Line(line), 0, along.Magnitude()};
}

std::optional<ElementaryCurve> circleThrough(const std::vector<gp_Pnt>& points) {
    const std::size_t third = points.size() / 3;
    const gce_MakeCirc made(points.front(), points[third], points[2 * third]);
    if (!made.IsDone()) return std::nullopt;
    const gp_Circ& through = made.Value();
    const gp_Dir axis = through.Axis().Direction();
    // The sense of three points in their order is anticlockwise about the axis.
    const gp_Circ circle(gp_Ax2(through.Location(), axis, gp_Vec(through.Location(), points.front())),
                         through.Radius());
    for (const gp_Pnt& p : points)
        if (circle.Distance(p) > kSameForm_mm) return std::nullopt;
    const bool closed = points.front().Distance(points.back()) < kSameForm_mm;
    const gp_Vec end(circle.Location(), points.back());
    double angle = circle.XAxis().Direction().AngleWithRef(gp_Dir(end), axis);
    if (closed)
        angle = 2 * kPi;
    else if (angle < 0)
        angle += 2 * kPi;
    return ElementaryCurve{new Geom_Circle(circle), 0, angle};
}

}  // namespace

std::optional<ElementaryCurve> elementaryCurve(const TopoDS_Edge& edge) {
    if (!isFreeForm(edge)) return std::nullopt;
    const std::vector<gp_Pnt> points = pointsOn(BRepAdaptor_Curve(edge));
    if (auto line = lineThrough(points)) return line;
    return circleThrough(points);
}

}  // namespace stepmill
