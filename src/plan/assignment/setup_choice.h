#pragma once

#include <optional>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Minutes that the machine's file gives to set a part up along these axes, shared among the pieces of the
/// lot [s].
double settingUpS(const std::vector<Setup>& setups, const Machine& machine, int quantity);

/// The plan of few setups against that of more, of which some finish what the few leave in steps or to form
/// cutters. Each is weighed with the time to set it up, or what that costs.
class SetupWeigher {
  public:
    /// Keeps `request` and `machine`.
    SetupWeigher(const PlanRequest& request, const Machine& machine) : request_(request), machine_(machine) {}

    /// Can no plan of those setups be better: would setting up alone take as long as this plan does, which
    /// leaves next to nothing?
    bool cannotBeat(const Plan& few, const std::vector<Setup>& more) const;
    /// Why the plan of more setups is not taken; nothing: it is better.
    std::optional<SetupVerdict> against(const Plan& few, const Plan& more) const;
    /// Why that of few is not, where it is not.
    SetupVerdict whyNotFew(const Plan& few, const Plan& more) const;
    /// \param axes  asked for; those along which nothing is cut among them
    SetupChoice choiceOf(const Plan& plan, const std::vector<Setup>& setups, SetupVerdict verdict) const;
    /// Setups of which no plan was made.
    static SetupChoice unplanned(const std::vector<Setup>& setups, SetupVerdict verdict);

  private:
    double weight(const Plan& plan) const;
    double weightOfS(double setting_up_s) const;
    bool leavesMore(const Plan& plan, const Plan& than) const;

    const PlanRequest& request_;
    const Machine& machine_;
};

}  // namespace stepmill
