#pragma once

#include <string>
#include <vector>

#include "drawing/sketch.h"

namespace stepmill::drawing {

/// What the data of an SVG path draw, in its own coordinates.
/// \throws std::invalid_argument saying what was expected
std::vector<Stroke> svgPath(const std::string& data);

/// An elliptic arc between two points [SVG 1.1, F.6]: an arc of a circle where both radii are equal, else
/// splines; a line where a radius is 0.
std::vector<Stroke> svgArc(const Vec2& from, double rx, double ry, double turned_rad, bool large,
                           bool positive, const Vec2& to);

}  // namespace stepmill::drawing
