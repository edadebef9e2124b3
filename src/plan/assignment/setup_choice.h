#pragma once

#include <optional>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Plans leave as much that differ by no more than the larger of these.
struct Alike {
    double share = 0;  ///< of all there is to remove
    double mm3 = 0;
};
/// As a volume, the larger of both [mm3].
double alikeMm3(const Plan& plan, const Alike& alike);

/// Plans of two sets of setups against each other, each weighed with the time to set it up, or what that
/// costs.
class SetupWeigher {
  public:
    /// Keeps `request` and `machine`.
    SetupWeigher(const PlanRequest& request, const Machine& machine) : request_(request), machine_(machine) {}

    /// What the machine's file gives to set a part up along these axes, shared among the pieces of the lot,
    /// and to load each piece in each of the setups [s].
    double settingUpS(const std::vector<Setup>& setups) const;
    /// In the setups of a plan in which something is cut.
    double settingUpS(const Plan& plan) const;
    /// Can no plan of those setups be better: would setting up alone take as long as this plan does, which
    /// leaves next to nothing?
    bool cannotBeat(const Plan& plan, const std::vector<Setup>& others, const Alike& alike) const;
    /// Why the other plan is not taken in its place; nothing: it is better.
    std::optional<SetupVerdict> against(const Plan& plan, const Plan& other, const Alike& alike) const;
    /// Why the plan is not taken, where it is not.
    SetupVerdict whyNot(const Plan& plan, const Plan& better, const Alike& alike) const;
    /// \param setups  asked for; those along which nothing is cut among them
    SetupChoice choiceOf(const Plan& plan, const std::vector<Setup>& setups, SetupVerdict verdict) const;
    /// Setups of which no plan was made.
    static SetupChoice unplanned(const std::vector<Setup>& setups, SetupVerdict verdict);

  private:
    double weight(const Plan& plan) const;
    double weightOfS(double setting_up_s) const;

    const PlanRequest& request_;
    const Machine& machine_;
};

}  // namespace stepmill
