#pragma once

#include "stepmill/feature/form_ground.h"
#include "stepmill/toolpath/standing_stairs.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {

/// A form cutter, as the stack of discs that it is, against what must stand at every height it passes;
/// rapids, shank and holder against all that stands when form operations begin; everything within the window
/// that the ground tells of.
void proveFormMoves(const ReadOperation& operation, const RecordedOperation& planned,
                    const FormGround& ground, const Tolerances& tol, const Findings& findings);

/// Takes off the stairs what the operation sweeps, and fails where that is less than the plan counts on.
void proveFormCut(const ReadOperation& operation, const RecordedOperation& planned, const Tolerances& tol,
                  StandingStairs& stairs, const Findings& findings);

}  // namespace stepmill::verify
