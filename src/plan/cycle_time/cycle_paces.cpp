// Paces that keep cycle times [Tripathi2005, 'Changes in cycle time', steps 1 to 3].

#include "plan/cycle_time/cycle_paces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill {
namespace {

/// Paces are multiples of this: as plan.json has them.
constexpr double kPaceStep = 1e-4;
/// The search ends with a time that is shorter than asked by no more than this share.
constexpr double kAimShare = 0.002;
/// Of the pace's bracket: no guess is nearer to an end.
constexpr double kLeastBracketShare = 0.1;

/// What a cycle time is of.
struct Scope {
    const PlannedSetup* setup = nullptr;  ///< null: all
    std::string feature;                  ///< whole; empty: all of the setup
};

std::string wholeFeature(const PlannedSetup& setup, const Operation& operation) {
    for (const PlannedFeature& planned : setup.features)
        if (planned.feature.id == operation.feature_id) return wholeOf(planned.feature);
    return operation.feature_id;
}

std::string knownWords(const std::vector<PlannedSetup>& setups) {
    std::string words;
    for (const PlannedSetup& setup : setups) {
        words += (words.empty() ? "" : ", ") + setup.setup.id;
        for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features))
            words += ", " + feature.id();
    }
    return words;
}

Scope scopeOf(const std::string& of, const std::vector<PlannedSetup>& setups) {
    if (of.empty()) return {};
    for (const PlannedSetup& setup : setups) {
        if (setup.setup.id == of) return {&setup, {}};
        for (const PlannedFeature& planned : setup.features)
            if (wholeOf(planned.feature) == of) return {&setup, of};
    }
    throw Error(ErrorCode::Usage, "--cycle-time " + of,
                "the plan has none of that name; it has " + knownWords(setups));
}

/// Features come before setups, and setups before the part.
int breadth(const Scope& scope) {
    return scope.setup == nullptr ? 2 : scope.feature.empty() ? 1 : 0;
}

template <typename Use>
void forEachOperation(const Scope& scope, const std::vector<PlannedSetup>& setups, const Use& use) {
    for (const PlannedSetup& setup : setups) {
        if (scope.setup != nullptr && scope.setup->setup.id != setup.setup.id) continue;
        for (const Operation& operation : setup.operations)
            if (scope.feature.empty() || wholeFeature(setup, operation) == scope.feature) use(operation);
    }
}

/// Without tool changes.
double operationsS(const Scope& scope, const std::vector<PlannedSetup>& setups) {
    double time_s = 0;
    forEachOperation(scope, setups, [&](const Operation& operation) { time_s += operation.motionS(); });
    return time_s;
}

/// With those of setups and the part.
double timeOf(const Scope& scope, const TimedSetups& timed) {
    if (scope.setup == nullptr) return timed.totals.motion_s;
    if (!scope.feature.empty()) return operationsS(scope, timed.setups);
    const auto found = std::find_if(timed.setups.begin(), timed.setups.end(), [&](const PlannedSetup& setup) {
        return setup.setup.id == scope.setup->setup.id;
    });
    return found->motion_s;
}

std::pair<TimeUse, std::optional<FeedLimit>> useOf(const Operation& operation) {
    if (operation.role == Role::Finish) return {TimeUse::Finishing, {}};
    if (operation.role == Role::Form) return {TimeUse::Forms, {}};
    if (isForHoles(operation.role)) return {TimeUse::Holes, {}};
    if (!operation.rating) return {TimeUse::LibraryFeed, {}};
    return {TimeUse::Cut, operation.cuts.limit};
}

std::vector<UsedTime> usesOf(const Scope& scope, const TimedSetups& timed) {
    std::map<std::pair<TimeUse, std::optional<FeedLimit>>, double> uses;
    forEachOperation(scope, timed.setups, [&](const Operation& operation) {
        const PathTotals& totals = operation.path.totals;
        uses[useOf(operation)] += totals.feed_time_s + operation.dwellOfAll_s();
        uses[{TimeUse::Rapids, {}}] += totals.rapid_time_s;
        uses[{TimeUse::Acceleration, {}}] += totals.motion_time_s - totals.time_s();
    });
    uses[{TimeUse::ToolChanges, {}}] = timeOf(scope, timed) - operationsS(scope, timed.setups);
    constexpr double kNothingS = 0.05;
    std::vector<UsedTime> longest;
    for (const auto& [use, time_s] : uses)
        if (time_s >= kNothingS) longest.push_back({use.first, use.second, time_s});
    std::stable_sort(longest.begin(), longest.end(),
                     [](const UsedTime& a, const UsedTime& b) { return a.time_s > b.time_s; });
    return longest;
}

double onGrid(double pace) {
    return std::round(pace / kPaceStep) * kPaceStep;
}

/// A pace and the time that is taken at it.
struct PacedTime {
    double pace = 1;
    double time_s = 0;
};

/// The slowest pace found that keeps the time, between one that does and one that does not. Times are nearly
/// a sum of what stays and what goes with 1 / pace.
/// \pre fast.time_s <= target_s < slow.time_s
PacedTime paceFor(double target_s, PacedTime slow, PacedTime fast,
                  const std::function<double(double)>& timeAt) {
    while (fast.time_s < target_s * (1 - kAimShare) && fast.pace - slow.pace > 1.5 * kPaceStep) {
        const double aim_s = target_s * (1 - kAimShare / 2);
        const double share = std::clamp((slow.time_s - aim_s) / (slow.time_s - fast.time_s),
                                        kLeastBracketShare, 1 - kLeastBracketShare);
        const double guess = 1 / (1 / slow.pace + share * (1 / fast.pace - 1 / slow.pace));
        const double pace = std::clamp(onGrid(guess), slow.pace + kPaceStep, fast.pace - kPaceStep);
        const PacedTime found{pace, timeAt(pace)};
        (found.time_s <= target_s ? fast : slow) = found;
    }
    return fast;
}

/// Finds the paces of one plan.
class PaceSearch {
  public:
    PaceSearch(const std::vector<PlannedSetup>& setups, const CuttingFeedSettings& settings)
        : setups_(setups), settings_(settings), planned_(timed()) {}

    PacedSetups paced() {
        const std::vector<CycleTarget>& targets = settings_.request.cycle_times;
        std::vector<Scope> scopes;
        scopes.reserve(targets.size());
        for (const CycleTarget& target : targets)
            scopes.push_back(scopeOf(target.of, setups_));
        std::vector<CycleOutcome> outcomes(targets.size());
        for (int width = 0; width <= breadth({}); ++width)
            for (std::size_t i = 0; i < targets.size(); ++i)
                if (breadth(scopes[i]) == width) outcomes[i] = outcomeOf(targets[i], scopes[i]);
        TimedSetups kept = timed();
        for (std::size_t i = 0; i < targets.size(); ++i) {
            outcomes[i].time_s = timeOf(scopes[i], kept);
            outcomes[i].uses = usesOf(scopes[i], kept);
        }
        return {std::move(kept), std::move(outcomes)};
    }

  private:
    TimedSetups timed() const {
        return withTimes(withCuttingFeeds(setups_, settings_, paces_), settings_.library, settings_.machine);
    }

    CycleOutcome outcomeOf(const CycleTarget& target, const Scope& scope) {
        CycleOutcome outcome;
        outcome.target = target;
        outcome.planned_s = timeOf(scope, planned_);
        const double changes_s = outcome.planned_s - operationsS(scope, planned_.setups);
        const auto timeAt = [&](double pace) { return changes_s + operationsAt(scope, target.of, pace); };
        // What narrower times made of it already.
        const PacedTime usual{1, timeAt(1)};
        const bool is_kept = usual.time_s <= target.time_s && usual.time_s >= target.time_s * (1 - kAimShare);
        const double last = usual.time_s > target.time_s ? kFastestPace : kSlowestPace;
        const PacedTime bound{last, timeAt(last)};
        outcome.bound_s = bound.time_s;
        outcome.pace = is_kept ? 1 : paceTo(target.time_s, usual, bound, timeAt);
        paces_.set(target.of, outcome.pace);
        return outcome;
    }

    static double paceTo(double target_s, const PacedTime& usual, const PacedTime& bound,
                         const std::function<double(double)>& timeAt) {
        const bool shorter = usual.time_s > target_s;
        const bool out_of_reach = shorter ? bound.time_s > target_s : bound.time_s <= target_s;
        if (out_of_reach) return bound.time_s == usual.time_s ? 1 : bound.pace;
        const PacedTime& slow = shorter ? usual : bound;
        const PacedTime& fast = shorter ? bound : usual;
        return paceFor(target_s, slow, fast, timeAt).pace;
    }

    double operationsAt(const Scope& scope, const std::string& of, double pace) const {
        Paces paces = paces_;
        paces.set(of, pace);
        std::vector<PlannedSetup> own;
        for (const PlannedSetup& setup : setups_)
            if (scope.setup == nullptr || scope.setup->setup.id == setup.setup.id) own.push_back(setup);
        return operationsS(scope, withCuttingFeeds(std::move(own), settings_, paces));
    }

    const std::vector<PlannedSetup>& setups_;
    const CuttingFeedSettings& settings_;
    Paces paces_;
    const TimedSetups planned_;
};

}  // namespace

PacedSetups withCycleTimes(std::vector<PlannedSetup> setups, const CuttingFeedSettings& settings) {
    if (settings.request.cycle_times.empty())
        return {
            withTimes(withCuttingFeeds(std::move(setups), settings, {}), settings.library, settings.machine),
            {}};
    return PaceSearch(setups, settings).paced();
}

}  // namespace stepmill
