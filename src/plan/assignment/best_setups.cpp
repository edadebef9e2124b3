// Which set of setups is taken, by whole plans.

#include "plan/assignment/best_setups.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "plan/assignment/setup_choice.h"
#include "plan/assignment/unreached_places.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/warning_order.h"

namespace stepmill {
namespace {

/// Another set of setups whose flat layers are not planned in this share of the time is given up, ...
constexpr double kOthersTimeShare = 0.25;
/// ... in this one where there is a plan already: then no choice of tools has to follow.
constexpr double kOthersTimeShareAtLast = 0.6;

/// Lots that keep the machine busy for so long are worth the time to weigh other sides and orders: a shift
/// [s].
constexpr double kLotWorthWeighingS = 8 * kSecondsPerHour;

/// A plan of no more operations is soon made: the order that leaves the least steps is tried beside it, ...
constexpr std::size_t kFewOperations = 100;
/// ... and where it takes so many times what its tools need at least, other sides and further orders, ...
constexpr double kFarFromBound = 4.5;
/// ... if there is so much to gain [s].
constexpr double kGainWorthWeighingS = 2 * kSecondsPerMinute;

/// Of the sides that are free to what stays so many are tried, those to most of it: each is a plan more.
constexpr std::size_t kSidesTried = 2;

/// What form cutters leave, skins and ridges, differs by no more than this share of all that is to be
/// removed, or than ridges as high as allowed on all that leans.
constexpr double kFormsLeaveShare = 0.002;
/// What is cut from one side or another by so much: slabs of a stock tell no less apart.
constexpr Alike kSidesAlike{SliceOptions{}.least_gain_share, 0};

class SetupSearch {
  public:
    SetupSearch(const PlanRequest& request, const Machine& machine, const PlanOfSetups& plan_of)
        : request_(request), weigher_(request, machine), plan_of_(plan_of) {}

    Plan best(const SetupSets& sets) {
        choose(sets);
        if (sets.more_may_follow) addSetups();
        return taken();
    }

  private:
    /// The best of the sets there are.
    void choose(const SetupSets& sets) {
        auto other = sets.others.further.begin();
        const Alike ridges{kFormsLeaveShare, sets.forms_leave_mm3};
        if (sets.with_forms.size() == 1)
            tryOut(sets.with_forms, ridges);
        else if (sets.with_forms.empty() && other != sets.others.further.end() &&
                 isSetUpQuicker(*other, sets.chosen))
            tryOut(*other++, kSidesAlike);
        if (best_ && weigher_.cannotBeat(*best_, sets.chosen, alike_)) {
            turned_down_.push_back(SetupWeigher::unplanned(sets.chosen, SetupVerdict::CannotTakeLess));
            return;
        }
        offer(plan_of_(sets.chosen, {}), sets.chosen, alike_);
        if (sets.with_forms.size() > 1 && mayBeBetter(sets.with_forms)) tryOut(sets.with_forms, ridges);
        const auto weigh = [&](const std::vector<Setup>& setups, bool worth_it) {
            const bool finishes_walls = leavesWalls(ridges) && isTurnedRound(setups, sets.chosen);
            if ((worth_it && mayPay(setups)) || finishes_walls) tryOut(setups, kSidesAlike);
        };
        const std::vector<Setup>& least_steps = sets.others.least_steps;
        if (!least_steps.empty()) weigh(least_steps, isWorthWeighing() || isSoonPlanned());
        const bool worth_it = isWorthWeighing() || isFarFromBest();
        for (; other != sets.others.further.end(); ++other)
            weigh(*other, worth_it);
    }

    /// Adds setups while plans with them are better: each is to take half of what its side is free to.
    void addSetups() {
        for (bool added = true; added;) {
            const Unreached unreached = unreachedIn(*best_);
            std::vector<AddedSetup> sides =
                withOneMore(best_->part, request_.setup, setups_, unreached.places);
            std::erase_if(sides, [&](const AddedSetup& side) { return side.free_mm3 < unreached.pays_mm3; });
            sides.resize(std::min(sides.size(), kSidesTried));
            added = false;
            for (auto side = sides.begin(); side != sides.end() && !added; ++side) {
                tryOut(side->setups, {0, side->free_mm3 / 2});
                added = setups_.size() == side->setups.size();
            }
        }
    }

    bool isSetUpQuicker(const std::vector<Setup>& setups, const std::vector<Setup>& than) const {
        return weigher_.settingUpS(setups) < weigher_.settingUpS(than);
    }
    /// Setups of the best plan in which nothing was left to cut need not be set up.
    bool mayBeBetter(const std::vector<Setup>& with_forms) const {
        const VolumeBalance& books = best_->balance;
        return with_forms.size() <= best_->setups.size() ||
               books.leftMm3() > kFormsLeaveShare * books.stock_minus_part_mm3;
    }
    bool isWorthWeighing() const { return best_->totals.motion_s * request_.quantity >= kLotWorthWeighingS; }
    bool isSoonPlanned() const {
        std::size_t operations = 0;
        for (const PlannedSetup& setup : best_->setups)
            operations += setup.operations.size();
        return operations <= kFewOperations;
    }
    bool isFarFromBest() const {
        const double bound_s = best_->totals.lower_bound_s;
        return isSoonPlanned() && bound_s > 0 && best_->totals.motion_s > kFarFromBound * bound_s &&
               mayGainS() * request_.quantity > kGainWorthWeighingS;
    }
    /// About, a piece: other setups have other features.
    double mayGainS() const { return best_->totals.motion_s - best_->totals.lower_bound_s; }
    /// May their cutting give back what they take longer to set up?
    bool mayPay(const std::vector<Setup>& setups) const {
        return weigher_.settingUpS(setups) < weigher_.settingUpS(*best_) + mayGainS();
    }
    /// More than form cutters leave; without any of them that is so of every wall.
    bool leavesWalls(const Alike& ridges) const {
        return request_.scallop_mm > 0 && best_->balance.unreachable_mm3 > alikeMm3(*best_, ridges);
    }
    /// Two setups the other way round may finish walls that the second one cuts away the room for.
    static bool isTurnedRound(const std::vector<Setup>& setups, const std::vector<Setup>& chosen) {
        return chosen.size() == 2 && setups.size() == 2 && isSameAxis(setups[0].axis, chosen[1].axis) &&
               isSameAxis(setups[1].axis, chosen[0].axis);
    }

    /// A set that cannot be planned in its time must not lose the plan of another.
    void tryOut(const std::vector<Setup>& setups, const Alike& alike) {
        if (request_.patience.all_tools.passed()) {
            turned_down_.push_back(SetupWeigher::unplanned(setups, SetupVerdict::NoTime));
            return;
        }
        std::optional<Plan> plan;
        try {
            const double share = best_ ? kOthersTimeShareAtLast : kOthersTimeShare;
            plan = plan_of_(setups, Deadline::in(share * request_.patience.all_tools.secondsLeft()));
        } catch (const std::exception& error) {
            const auto* known = dynamic_cast<const Error*>(&error);
            const bool late = known != nullptr && known->code() == ErrorCode::TimedOut;
            turned_down_.push_back(
                SetupWeigher::unplanned(setups, late ? SetupVerdict::NoTime : SetupVerdict::CannotBePlanned));
            return;
        }
        offer(std::move(*plan), setups, alike);
    }

    void offer(Plan plan, const std::vector<Setup>& setups, const Alike& alike) {
        alike_ = alike;
        const auto no = best_ ? weigher_.against(*best_, plan, alike) : std::nullopt;
        if (no) {
            turned_down_.push_back(weigher_.choiceOf(plan, setups, *no));
            return;
        }
        if (best_)
            turned_down_.push_back(weigher_.choiceOf(*best_, setups_, weigher_.whyNot(*best_, plan, alike)));
        best_ = std::move(plan);
        setups_ = setups;
    }

    Plan taken() {
        if (!turned_down_.empty()) {
            std::vector<SetupChoice>& choices = best_->assignment.choices;
            choices = {weigher_.choiceOf(*best_, setups_, SetupVerdict::Taken)};
            choices.insert(choices.end(), turned_down_.begin(), turned_down_.end());
            warnOfHaste(best_->warnings);
            best_->warnings = byConsequence(std::move(best_->warnings));
        }
        return std::move(*best_);
    }

    /// On a faster machine, or with more time, the plan might be another.
    void warnOfHaste(std::vector<Warning>& warnings) const {
        const auto late =
            std::count_if(turned_down_.begin(), turned_down_.end(),
                          [](const SetupChoice& choice) { return choice.verdict == SetupVerdict::NoTime; });
        if (late == 0) return;
        warnings.push_back({"few-setups", "part",
                            fmt::format("{} other {} of setups {} not weighed: that takes longer than "
                                        "--timeout allows here",
                                        late, late == 1 ? "choice" : "choices", late == 1 ? "was" : "were")});
    }

    const PlanRequest& request_;
    const SetupWeigher weigher_;
    const PlanOfSetups& plan_of_;
    std::optional<Plan> best_;
    std::vector<Setup> setups_;  ///< of the best plan, those along which nothing is cut among them
    Alike alike_ = kSidesAlike;  ///< by which the last two were compared
    std::vector<SetupChoice> turned_down_;
};

}  // namespace

Plan bestPlan(const SetupSets& sets, const PlanRequest& request, const Machine& machine,
              const PlanOfSetups& plan_of) {
    return SetupSearch(request, machine, plan_of).best(sets);
}

}  // namespace stepmill
