#pragma once

#include <vector>

#include <Geom_BSplineCurve.hxx>

#include "drawing/sketch.h"

namespace stepmill::drawing {

/// The kernel's form of a spline, in the plane z 0.
opencascade::handle<Geom_BSplineCurve> kernelSpline(const Spline& spline);

/// Points along it between its ends, near enough for a look at what crosses what.
std::vector<Vec2> splinePoints(const Spline& spline);

}  // namespace stepmill::drawing
