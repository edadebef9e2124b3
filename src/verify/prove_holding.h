#pragma once

#include "stepmill/verify/verify.h"

namespace stepmill::verify {

/// That the setup goes on holding what it says it holds: a vise that the shop has, with enough grip; jaws and
/// held stock among the fixtures, as high as the clamping says; no cutter of the programs in a jaw, in the
/// clearance over it or in held stock. Plans of older versions, which say nothing of the vise, are not looked
/// at.
void proveHolding(const PlanRecord& record, const RecordedSetup& setup,
                  const std::vector<ReadProgram>& programs, const Tolerances& tol, Verification& into);

}  // namespace stepmill::verify
