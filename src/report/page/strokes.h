#pragma once

#include <array>
#include <functional>
#include <set>
#include <vector>

#include "stepmill/planar/svg_path.h"

namespace stepmill::report {

/// A straight line of a picture, its ends in order, so that one drawn twice is one.
using Stroke = std::array<SvgDot, 2>;

/// The lines' pieces whose ends are two dots.
std::set<Stroke> strokesOf(const std::vector<std::vector<Vec2>>& lines,
                           const std::function<SvgDot(const Vec2&)>& dot_of);

/// The strokes as few long lines: each begins where the one before ends while there is any.
std::vector<std::vector<SvgDot>> joined(const std::set<Stroke>& strokes);

}  // namespace stepmill::report
