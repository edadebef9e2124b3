#pragma once

#include <vector>

#include "stepmill/access/form_centres.h"
#include "stepmill/toolpath/standing_stairs.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// The passes of a form cutter with its tip at one height.
struct FormLevel {
    double tip_z_mm = 0;
    Region free_centres;
    std::vector<Path> passes;  ///< in climb direction, farthest from the walls first
};

/// Passes along the boundary of the free centres at one height, wherever the cutter meets stairs thicker than
/// `least_mm` there, and beside them at the step-over where the stairs are wider. No passes where it meets
/// none.
FormLevel formLevel(const FormCentres& centres, const StandingStairs& stairs, const CutterForm& form,
                    double tip_z_mm, double step_over_mm, double least_mm, const Tolerances& tol);

/// What a form cutter's moves need to know beside its passes.
struct FormTask {
    const FormGround& ground;
    double retract_z_mm = 0;
    bool plain_ways = false;  ///< no way between passes but over the retract height
};

/// A form cutter's whole path, and the ways at depth between its passes, which may cut too.
struct FormPath {
    Toolpath path;
    std::vector<LevelWays> between;
};

/// The passes of all levels, from above, as one path: rapids come down over what stands when form operations
/// begin, ways at depth stay in the free centres, all else goes over the retract height. No moves without
/// passes.
FormPath formPath(const FormTask& task, const std::vector<FormLevel>& levels, const ToolAssembly& tool,
                  const CuttingData& cutting, const Machine& machine, const Tolerances& tol);

}  // namespace stepmill::toolpath
