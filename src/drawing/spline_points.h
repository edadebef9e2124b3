#pragma once

#include <vector>

#include <Geom_BSplineCurve.hxx>

#include "drawing/sketch.h"

namespace stepmill::drawing {

/// The kernel's form of a spline, in the plane z 0.
opencascade::handle<Geom_BSplineCurve> kernelSpline(const Spline& spline);

/// A stroke of a spline cut at its knots, in mm: faces on one span each, for volumes over several are
/// integrated wrong. Spans of degree 1 are lines; spans no longer than kHealedGapMm, as of doubled points,
/// are left out. Other strokes stay as they are.
std::vector<Stroke> spansOf(const Stroke& stroke);

/// Points along it between its ends, near enough for a look at what crosses what.
std::vector<Vec2> splinePoints(const Spline& spline);

}  // namespace stepmill::drawing
