#include "stepmill/plan/patience.h"

namespace stepmill {
namespace {

// Shares of the time a run has. Paths, proof and pages come after the choice of tools: of ctc_02, planned
// with few tools, they take nearly half of all.
constexpr double kAllToolsShare = 0.33;
constexpr double kFewToolsShare = 0.5;
/// One feature must leave time to the others.
constexpr double kFeatureShare = 0.15;

}  // namespace

Patience patienceFor(double seconds) {
    return {Deadline::in(kAllToolsShare * seconds), Deadline::in(kFewToolsShare * seconds),
            Deadline::in(seconds), kFeatureShare * seconds};
}

Patience patienceAfter(const Patience& before) {
    Patience next = patienceFor(before.end.secondsLeft());
    if (before.all_tools.passed()) next.all_tools = before.all_tools;
    return next;
}

}  // namespace stepmill
