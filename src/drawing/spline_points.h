#pragma once

#include <vector>

#include <Geom_BSplineCurve.hxx>

#include "drawing/sketch.h"

namespace stepmill::drawing {

/// The kernel's form of a spline, in the plane z 0.
opencascade::handle<Geom_BSplineCurve> kernelSpline(const Spline& spline);

/// A stroke of a spline cut at its knots, in mm, since it may have corners there; spans of degree 1 are
/// lines. Spans are left out as long as they are together no longer than kHealedGapMm, as of doubled points:
/// the next begins where they do. Other strokes stay as they are.
std::vector<Stroke> spansOf(const Stroke& stroke);

/// Points along it between its ends, near enough for a look at what crosses what.
std::vector<Vec2> splinePoints(const Spline& spline);

}  // namespace stepmill::drawing
