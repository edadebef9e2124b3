#include "stepmill/plan/patience.h"

namespace stepmill {
namespace {

// Shares of the time a run has. Paths, proof and pages come after the choice of tools: of ctc_02, planned
// with few tools, they take a third as long as all before. On a machine half as fast that must still fit in.
constexpr double kAllToolsShare = 0.38;
constexpr double kFewToolsShare = 0.58;
/// Of the time that is left after a proof: another proof must fit in, and what to do after it.
constexpr double kAllToolsAgainShare = 0.2;
constexpr double kFewToolsAgainShare = 0.35;
/// One feature must leave time to the others.
constexpr double kFeatureShare = 0.15;
/// One setup must leave time to the others, of which the first has most to cut.
constexpr double kSetupShare = 0.6;

}  // namespace

Patience Patience::ofOneSetup(std::size_t followers) const {
    if (followers == 0 || setup_share >= 1) return *this;
    Patience one = *this;
    one.all_tools = Deadline::in(setup_share * all_tools.secondsLeft());
    one.few_tools = Deadline::in(setup_share * few_tools.secondsLeft());
    return one;
}

Patience patienceFor(double seconds) {
    return {Deadline::in(kAllToolsShare * seconds), Deadline::in(kFewToolsShare * seconds),
            Deadline::in(seconds), kFeatureShare * seconds, kSetupShare};
}

Patience patienceAfter(const Patience& before) {
    const double left_s = before.end.secondsLeft();
    const bool no_more = before.all_tools.passed();
    return {no_more ? before.all_tools : Deadline::in(kAllToolsAgainShare * left_s),
            Deadline::in(kFewToolsAgainShare * left_s), before.end, kFeatureShare * left_s,
            before.setup_share};
}

}  // namespace stepmill
