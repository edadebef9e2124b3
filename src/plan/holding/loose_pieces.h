#pragma once

#include <vector>

#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// Stock that a setup leaves and that hangs together with nothing that is held.
struct LoosePiece {
    double volume_mm3 = 0;
    Vec3 at = Vec3::Zero();  ///< in it, in setup coordinates
};

/// The pieces that the stage cuts loose, the largest first; crumbs are none, nor what hangs together with
/// nothing before: slices of stock seen aslant are wider than it is. On a plate all is held that touches it;
/// nothing is said of stages whose holding is not known or the shop's own.
/// \param stage    after holdStage()
/// \param removed  what the stage takes from its stock
std::vector<LoosePiece> loosePieces(const Stage& stage, const std::vector<Prism>& removed,
                                    const Tolerances& tol);

/// A warning of each of the largest, and one of the others.
std::vector<Warning> looseWarnings(const std::vector<LoosePiece>& pieces, const std::string& setup_id);

}  // namespace stepmill
