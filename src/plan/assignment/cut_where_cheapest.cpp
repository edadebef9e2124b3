// Which setup cuts what.

#include "plan/assignment/cut_where_cheapest.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plan/assignment/propose_reserve.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// Two plans' books differ by so much of stock minus part where cuts are seen from the side, whatever stays.
constexpr double kBooksNoiseShare = 1e-6;
/// Where something stays anyway, so much more of it may: other tools reach a little less of a corner or more.
constexpr double kMoreMayStayShare = 0.005;
/// A plan must be shorter by so much to be taken: feeds and leaning walls, which come later, are not in it.
constexpr double kWorthChanging = 0.99;

/// How many setups nothing is known that would hold them.
auto unheld(const CutSetups& cut) {
    return std::count_if(cut.setups.begin(), cut.setups.end(),
                         [](const PlannedSetup& setup) { return setup.clamping.kind == HoldKind::None; });
}

/// Is it clearly shorter, or cheaper if plans are made by cost, with no more setups, held as well, and no
/// more that stays?
bool isBetter(const CutSetups& cut, const CutSetups& than, Objective objective) {
    const auto weight = [&](const PlanTotals& totals) {
        return objective == Objective::Time ? totals.motion_s : totals.cost;
    };
    const double noise_mm3 =
        std::max(kVolumeRoundingMm3, kBooksNoiseShare * than.balance.stock_minus_part_mm3);
    const double may_stay_mm3 = than.leftMm3() + std::max(noise_mm3, kMoreMayStayShare * than.leftMm3());
    return cut.setups.size() <= than.setups.size() && unheld(cut) <= unheld(than) &&
           weight(cut.totals) < kWorthChanging * weight(than.totals) && cut.leftMm3() <= may_stay_mm3 &&
           std::abs(cut.balance.gapMm3()) <= std::abs(than.balance.gapMm3()) + noise_mm3;
}

/// The setups as they would be cut if one of them left stock.
struct Trial {
    ReserveProposal proposal;
    std::vector<CutPrisms> reserves;
    CutSetups cut;
};

class Trials {
  public:
    Trials(const std::vector<Setup>& setups, double stock_minus_part_mm3, const PlanningShop& shop,
           const Progress& progress)
        : setups_(setups), stock_minus_part_mm3_(stock_minus_part_mm3), shop_(shop), progress_(progress) {}

    CutSetups cut(const std::vector<CutPrisms>& reserves) const {
        return cutSetups(setups_, reserves, stock_minus_part_mm3_, shop_, progress_);
    }

    /// What the i-th of the setups that cut might leave; nothing where it is not worth a trial. A trial that
    /// cannot be planned must not lose the plan there is.
    std::optional<Trial> leaving(const CutSetups& best, std::size_t i,
                                 std::vector<CutPrisms> reserves) const {
        const std::size_t place = best.stages[i].place;
        if (progress_) progress_("what " + best.setups[i].setup.id + " might leave for later setups", 1);
        try {
            auto proposal = proposeReserve(best.setups[i], best.stages[i].layers, setups_, place, shop_);
            if (!proposal) return std::nullopt;
            reserves[place] = proposal->reserve;
            CutSetups made = cut(reserves);
            return Trial{std::move(*proposal), std::move(reserves), std::move(made)};
        } catch (const Error&) {
            return std::nullopt;
        }
    }

  private:
    const std::vector<Setup>& setups_;
    double stock_minus_part_mm3_;
    const PlanningShop& shop_;
    const Progress& progress_;
};

}  // namespace

CutSetups cutWhereCheapest(const std::vector<Setup>& setups, double stock_minus_part_mm3,
                           const PlanningShop& shop, const Progress& progress, Assignment& assignment) {
    const PlanRequest& request = shop.request;
    const Trials trials(setups, stock_minus_part_mm3, shop, progress);
    assignment.reserves.resize(setups.size());
    CutSetups best = trials.cut(assignment.reserves);
    if (request.assignment || !request.assign || request.roughing) return best;
    for (std::size_t i = 0; i < best.stages.size() && !request.patience.all_tools.passed(); ++i) {
        std::optional<Trial> trial = trials.leaving(best, i, assignment.reserves);
        if (!trial) continue;
        const bool taken = isBetter(trial->cut, best, request.sequence.objective);
        assignment.tried.push_back({best.setups[i].setup.id, std::move(trial->proposal), best.totals.motion_s,
                                    trial->cut.totals.motion_s, trial->cut.leftMm3() - best.leftMm3(),
                                    taken});
        if (!taken) continue;
        best = std::move(trial->cut);
        assignment.reserves = std::move(trial->reserves);
    }
    return best;
}

}  // namespace stepmill
