#pragma once

#include <array>
#include <set>
#include <vector>

#include "stepmill/planar/svg_path.h"

namespace stepmill::report {

/// A straight line of a picture, its ends in order, so that one drawn twice is one.
using Stroke = std::array<SvgDot, 2>;

/// Nothing where both ends are one dot.
void addStroke(const SvgDot& from, const SvgDot& to, std::set<Stroke>& strokes);

/// The strokes as few long lines: each begins where the one before ends while there is any.
std::vector<std::vector<SvgDot>> joined(const std::set<Stroke>& strokes);

}  // namespace stepmill::report
