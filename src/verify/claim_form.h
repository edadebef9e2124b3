#pragma once

#include <vector>

#include "stepmill/feature/form_ground.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/plan/edge_breaks.h"
#include "stepmill/setup/setup.h"
#include "stepmill/verify/verify.h"

namespace stepmill::verify {

/// A failure for every band of the ground that does not cover the part, or a fixture, as the part's file and
/// the fixtures have them.
/// \param breaks  of a ground of edges what may go of the part; null: nothing
/// \param setup  derived, with its fixtures
/// \param layers  the setup's, derived
void compareForm(const FormGround& ground, const EdgeBreaks* breaks, const Setup& setup,
                 const LayerStack& layers, const Tolerances& tol, std::vector<ProofFailure>& failures);

}  // namespace stepmill::verify
