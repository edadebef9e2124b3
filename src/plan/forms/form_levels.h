#pragma once

#include <vector>

#include "plan/forms/form_site.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// Levels are at least this far apart: flatter ground would take passes without end [mm].
inline constexpr double kLeastLevelStepMm = 0.1;

/// Heights of the tip at which a form cutter goes along the walls, the preferred ones first: where these take
/// all, later ones have nothing to do. They are so far apart that the ridges between its passes are no higher
/// than the scallop, and no more than its step-down.
///
/// A corner of radius r leaves on a wall that leans by a ridges of height s where passes are
/// 2 sqrt(2 r s - s^2) apart along the wall, and cos(a) of that in height. It touches the wall r (1 - sin a)
/// over its tip. A chamfer mill has two heights for each chamfer of its own angle: the tip, which hardly
/// cuts, below the chamfer, and at its foot where there is no room; on other walls it has none.
std::vector<double> formLevels(const FormSite& site, const ToolAssembly& tool, double step_down_mm,
                               double scallop_mm);

/// How far apart along a wall the passes of a corner may lie: 2 sqrt(2 r s - s^2).
double alongWallMm(double corner_mm, double scallop_mm);

}  // namespace stepmill
