#pragma once

#include <functional>

#include "stepmill/plan/plan.h"
#include "stepmill/record/plan_files.h"
#include "stepmill/verify/verify.h"

namespace stepmill {

/// A plan with its files, and what their proof said.
struct ProvenPlan {
    Plan plan;
    PlanFiles files;  ///< the very bytes that were proven
    Verification verification;

    /// Is all proven, and do the volume books close? Else there is a bug of ours, and no program leaves.
    bool mayRun() const;
};

/// Proves the files of a plan; verifyPlan() but in tests.
using Prover = std::function<Verification(const PlanFiles&, const Tolerances&)>;

/// Plans a part and proves the programs it would be written with (verify.h).
///
/// Small places that the paths are found to leave (no more of a feature than books may miss,
/// `tol.volume_share`) become residuals of the plan, "left between passes", with their volume in its books.
/// Where the proof fails otherwise, the part is planned again with more caution in the features that failed,
/// step by step until all is proven: plain rings and rapids, then without the tools that failed, at last with
/// the feature as a residual ("proof"). Where only material stays that the plan does not name, it is named.
/// The first setup that fails is mended first: those after it see another stock then. Each measure taken is a
/// warning "proof".
///
/// The result is unproven only where the failure belongs to no operation: a bug of ours. Costs one plan a
/// round; nearly all parts take one.
/// \throws what planPart() throws
ProvenPlan planProven(const Part& part, const PlanRequest& request, const ToolLibrary& library,
                      const Machine& machine, const Tolerances& tol, const Progress& progress = {},
                      const Prover& prover = verifyPlan);

}  // namespace stepmill
