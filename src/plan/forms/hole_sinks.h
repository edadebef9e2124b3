#pragma once

#include <vector>

#include "plan/forms/form_site.h"
#include "stepmill/access/form_centres.h"
#include "stepmill/toolpath/form_passes.h"

namespace stepmill {

/// Where a countersink goes straight down into the cones that are its flanks' and no wider than itself: a
/// level for each height of its tip, from above, with the places as passes without length. As deep as it
/// touches nothing that must stand.
std::vector<toolpath::FormLevel> sinkLevels(const FormSite& site, const ToolAssembly& tool,
                                            const FormCentres& centres, const Tolerances& tol);

}  // namespace stepmill
