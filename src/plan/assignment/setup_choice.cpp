// Which of two sets of setups makes the better plan.

#include "plan/assignment/setup_choice.h"

#include <algorithm>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

constexpr EnumWord<SetupVerdict> kSetupVerdicts[] = {{SetupVerdict::Taken, "taken"},
                                                     {SetupVerdict::LeavesMore, "leaves more"},
                                                     {SetupVerdict::TakesLonger, "takes longer"},
                                                     {SetupVerdict::HeldWorse, "held worse"},
                                                     {SetupVerdict::CannotTakeLess, "can take no less"},
                                                     {SetupVerdict::NoTime, "no time"},
                                                     {SetupVerdict::CannotBePlanned, "cannot be planned"}};

/// Setups that nothing is known to hold while something is cut.
auto unheld(const Plan& plan) {
    return std::count_if(plan.setups.begin(), plan.setups.end(), [](const PlannedSetup& setup) {
        return setup.clamping.kind == HoldKind::None && !setup.operations.empty();
    });
}

bool leavesMore(const Plan& plan, const Plan& than, const Alike& alike) {
    return plan.balance.leftMm3() > than.balance.leftMm3() + alikeMm3(plan, alike);
}

std::vector<Setup> setupsOf(const Plan& plan) {
    std::vector<Setup> setups;
    for (const PlannedSetup& planned : plan.setups)
        if (!planned.operations.empty()) setups.push_back(planned.setup);
    return setups;
}

}  // namespace

double alikeMm3(const Plan& plan, const Alike& alike) {
    return std::max(alike.mm3, alike.share * plan.balance.stock_minus_part_mm3);
}

std::string toString(SetupVerdict verdict) {
    return wordOf(kSetupVerdicts, verdict);
}

std::optional<SetupVerdict> setupVerdictFrom(std::string_view word) {
    return valueOf(kSetupVerdicts, word);
}

double SetupWeigher::settingUpS(const std::vector<Setup>& setups) const {
    double once_min = 0;
    for (const Setup& setup : setups)
        once_min += machine_.settingUpMin(setup.indexed);
    return once_min * kSecondsPerMinute / request_.quantity +
           static_cast<double>(setups.size()) * machine_.load_time_s;
}

double SetupWeigher::settingUpS(const Plan& plan) const {
    return settingUpS(setupsOf(plan));
}

double SetupWeigher::weightOfS(double setting_up_s) const {
    return request_.sequence.objective == Objective::Time ? setting_up_s : machine_.costOf(setting_up_s);
}

double SetupWeigher::weight(const Plan& plan) const {
    const double run =
        request_.sequence.objective == Objective::Time ? plan.totals.motion_s : plan.totals.cost;
    return run + weightOfS(settingUpS(plan));
}

bool SetupWeigher::cannotBeat(const Plan& plan, const std::vector<Setup>& others, const Alike& alike) const {
    return plan.balance.leftMm3() <= alikeMm3(plan, alike) && unheld(plan) == 0 &&
           weight(plan) <= weightOfS(settingUpS(others));
}

std::optional<SetupVerdict> SetupWeigher::against(const Plan& plan, const Plan& other,
                                                  const Alike& alike) const {
    if (leavesMore(plan, other, alike)) return std::nullopt;
    if (leavesMore(other, plan, alike)) return SetupVerdict::LeavesMore;
    if (unheld(other) < unheld(plan)) return std::nullopt;
    if (unheld(other) > unheld(plan)) return SetupVerdict::HeldWorse;
    return weight(other) < weight(plan) ? std::nullopt : std::optional(SetupVerdict::TakesLonger);
}

SetupVerdict SetupWeigher::whyNot(const Plan& plan, const Plan& better, const Alike& alike) const {
    if (leavesMore(plan, better, alike)) return SetupVerdict::LeavesMore;
    return unheld(plan) > unheld(better) ? SetupVerdict::HeldWorse : SetupVerdict::TakesLonger;
}

SetupChoice SetupWeigher::choiceOf(const Plan& plan, const std::vector<Setup>& setups,
                                   SetupVerdict verdict) const {
    SetupChoice choice = unplanned(setups, verdict);
    choice.planned = SetupChoice::Planned{plan.totals.motion_s, settingUpS(plan), plan.balance.leftMm3()};
    return choice;
}

SetupChoice SetupWeigher::unplanned(const std::vector<Setup>& setups, SetupVerdict verdict) {
    SetupChoice choice;
    for (const Setup& setup : setups)
        choice.axes.push_back(setup.axis);
    choice.verdict = verdict;
    return choice;
}

}  // namespace stepmill
