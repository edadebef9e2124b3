#include "stepmill/plan/patience.h"

namespace stepmill {
namespace {

// Shares of the time a run has. Paths, proof and pages come after the choice of tools; on parts that need
// minutes they took up to a quarter of all.
constexpr double kAllToolsShare = 0.4;
constexpr double kFewToolsShare = 0.65;
/// One feature must leave time to the others.
constexpr double kFeatureShare = 0.15;

}  // namespace

Patience patienceFor(double seconds) {
    return {Deadline::in(kAllToolsShare * seconds), Deadline::in(kFewToolsShare * seconds),
            Deadline::in(seconds), kFeatureShare * seconds};
}

}  // namespace stepmill
