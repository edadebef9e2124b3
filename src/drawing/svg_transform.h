#pragma once

#include <Eigen/Geometry>

#include <string>

namespace stepmill::drawing {

/// What an SVG attribute `transform` does: matrix, translate, scale, rotate, skewX, skewY one after another.
/// \throws std::invalid_argument saying what was expected
Eigen::Affine2d svgTransform(const std::string& text);

}  // namespace stepmill::drawing
