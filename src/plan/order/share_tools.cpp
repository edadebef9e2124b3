#include "plan/order/share_tools.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "plan/order/fewest_visits.h"
#include "plan/order/visit_problem.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill {
namespace {

/// So many combinations of choices are all tried; each takes an ordering of the plan's operations.
constexpr std::size_t kMostCombinations = 512;
/// Rounds of improvement; each makes the plan cheaper or is the last.
constexpr int kMostRounds = 20;
/// Orders that only compare two choices look ahead less far than the plan's own.
constexpr VisitSearch kTrialSearch{4, 0};
/// A plan has more visits than the least number that its chains of operations need. A change of a choice is
/// looked at closely where it would pay if it saved so many of these, beside what it saves of the least
/// number.
constexpr int kSavedBesideTheLeast = 1;
/// Orders of the choices that are compared at last.
constexpr VisitSearch kSharedSearch{16, 0};

struct Score {
    int too_many = 0;  ///< tools beyond the magazine's places
    double weight = 0;
    int visits = 0;
    int tools = 0;

    bool isBetterThan(const Score& other) const {
        if (too_many != other.too_many) return too_many < other.too_many;
        // Sums in another order differ by rounding.
        constexpr double kRounding = 1e-9;
        return weight < other.weight * (1 - kRounding);
    }
};

/// The features' choices as numbers, for scores that are asked for again and again.
class ChoiceVisits {
  public:
    ChoiceVisits(const std::vector<Precedence>& features,
                 const std::vector<std::vector<SequenceChoice>>& choices, const ToolLibrary& library) {
        std::map<std::string, int> number;
        const auto numbersOf = [&](const std::vector<std::string>& ids) {
            std::vector<int> numbers;
            numbers.reserve(ids.size());
            for (const std::string& id : ids)
                numbers.push_back(number.at(id));
            return numbers;
        };
        for (const Precedence& feature : features) {
            features_.push_back({feature.setup, numbersOf(feature.parents)});
            above_.push_back(numbersOf(feature.above));
            number.emplace(feature.feature_id, static_cast<int>(number.size()));
        }
        std::map<std::string, double> diameter_mm;
        for (const ToolAssembly& tool : library.tools)
            diameter_mm[tool.id] = tool.diameter_mm;
        std::map<std::string, int> tool_number;
        for (const std::vector<SequenceChoice>& of_feature : choices) {
            std::vector<std::vector<int>>& tools = tools_.emplace_back();
            for (const SequenceChoice& choice : of_feature) {
                std::vector<int>& of_choice = tools.emplace_back();
                for (const std::string& id : choice.tools) {
                    const auto [found, is_new] =
                        tool_number.emplace(id, static_cast<int>(tool_number.size()));
                    if (is_new) {
                        tool_ids_.push_back(id);
                        diameter_mm_.push_back(diameter_mm[id]);
                    }
                    of_choice.push_back(found->second);
                }
            }
        }
    }

    /// \param choice  of each feature
    VisitProblem problem(const std::vector<std::size_t>& choice) const {
        std::vector<VisitOperation> operations;
        for (std::size_t f = 0; f < tools_.size(); ++f)
            if (!tools_[f].empty())
                for (const int tool : tools_[f][choice[f]])
                    operations.push_back({tool, static_cast<int>(f), 0, likelyNeeds(choice, f, tool)});
        return visitProblem(std::move(operations), features_);
    }

    const std::string& toolId(int tool) const { return tool_ids_[tool]; }

  private:
    /// What earlyStarts() will say once there are paths: a tool may go down where none wider works any more.
    std::vector<Need> likelyNeeds(const std::vector<std::size_t>& choice, std::size_t feature,
                                  int tool) const {
        std::vector<Need> needs;
        for (const int above : above_[feature]) {
            if (tools_[above].empty()) continue;
            const std::vector<int>& visits = tools_[above][choice[above]];
            const auto as_narrow = std::find_if(visits.begin(), visits.end(), [&](int visit) {
                return diameter_mm_[visit] <= diameter_mm_[tool];
            });
            const auto all = static_cast<int>(visits.size());
            needs.push_back({above, std::min(static_cast<int>(as_narrow - visits.begin()) + 1, all)});
        }
        return needs;
    }

    std::vector<VisitFeature> features_;
    std::vector<std::vector<int>> above_;               ///< of each feature
    std::vector<std::vector<std::vector<int>>> tools_;  ///< of each feature, of each choice
    std::vector<std::string> tool_ids_;
    std::vector<double> diameter_mm_;  ///< of each tool
};

/// A visit of a tool with the features it works on.
struct ServingVisit {
    std::string tool;
    std::vector<std::size_t> features;
};

class Sharing {
  public:
    Sharing(const std::vector<Precedence>& features, const std::vector<std::vector<SequenceChoice>>& choices,
            double change_weight, const ToolLibrary& library, int magazine)
        : choices_(choices),
          visits_(features, choices, library),
          change_(change_weight),
          magazine_(magazine) {}

    SharedChoice best() const {
        const Choice own(choices_.size(), 0);
        Choice found = combinations() <= kMostCombinations ? bestOfAll() : improved(own);
        const Score alone = score(own, kSharedSearch);
        Score together = score(found, kSharedSearch);
        if (!together.isBetterThan(alone)) {
            found = own;
            together = alone;
        }
        SharedChoice result;
        result.gain.visits_alone = alone.visits;
        result.gain.visits = together.visits;
        result.gain.tools_alone = alone.tools;
        result.gain.tools = together.tools;
        result.gain.saved = alone.weight - together.weight;
        result.choice = std::move(found);
        return result;
    }

  private:
    using Choice = std::vector<std::size_t>;

    std::size_t combinations() const {
        std::size_t count = 1;
        for (const auto& of_feature : choices_)
            if (count <= kMostCombinations) count *= std::max<std::size_t>(1, of_feature.size());
        return count;
    }

    const std::vector<std::string>& toolsOf(const Choice& choice, std::size_t feature) const {
        return choices_[feature][choice[feature]].tools;
    }

    std::set<std::string> toolsOf(const Choice& choice) const {
        std::set<std::string> tools;
        for (std::size_t f = 0; f < choices_.size(); ++f)
            if (!choices_[f].empty()) tools.insert(toolsOf(choice, f).begin(), toolsOf(choice, f).end());
        return tools;
    }

    Score score(const Choice& choice, int visits) const {
        Score score;
        for (std::size_t f = 0; f < choices_.size(); ++f)
            if (!choices_[f].empty()) score.weight += choices_[f][choice[f]].paths;
        score.tools = static_cast<int>(toolsOf(choice).size());
        score.visits = visits;
        score.weight += score.visits * change_;
        if (magazine_ > 0) score.too_many = std::max(0, score.tools - magazine_);
        return score;
    }

    Score score(const Choice& choice, const VisitSearch& search) const {
        return score(choice, static_cast<int>(fewestVisits(visits_.problem(choice), search).tools.size()));
    }

    /// The score where it is better than the best.
    /// \param spare_visits  even the least number of visits there can be, and so many more, must be better
    std::optional<Score> scoreIfBetter(const Choice& choice, const VisitSearch& search, int spare_visits,
                                       const Score& best) const {
        const std::optional<int> visits = visitsWithin(
            visits_.problem(choice), mostVisits(score(choice, 0), best), spare_visits, search.width);
        if (!visits) return std::nullopt;
        const Score found = score(choice, *visits);
        return found.isBetterThan(best) ? std::optional(found) : std::nullopt;
    }

    /// With how many visits a choice is better than the best; -1: with no number.
    /// \param without  the choice's score without visits
    int mostVisits(const Score& without, const Score& best) const {
        if (without.too_many != best.too_many)
            return without.too_many < best.too_many ? kAnyNumberOfVisits : -1;
        if (change_ <= 0) return without.isBetterThan(best) ? kAnyNumberOfVisits : -1;
        const double most = std::floor((best.weight - without.weight) / change_);
        return static_cast<int>(std::clamp<double>(most, -1, kAnyNumberOfVisits));
    }

    /// The visits of a choice in their order.
    std::vector<ServingVisit> visitsOf(const Choice& choice) const {
        const VisitProblem problem = visits_.problem(choice);
        std::vector<ServingVisit> visits;
        std::vector<int> done(problem.queue.size(), 0);
        for (const int tool : fewestVisits(problem, kTrialSearch).tools) {
            std::set<std::size_t> features;
            for (const int operation : takeAll(problem, tool, done))
                features.insert(problem.operations[operation].feature);
            visits.push_back({visits_.toolId(tool), {features.begin(), features.end()}});
        }
        return visits;
    }

    Choice bestOfAll() const {
        Choice best(choices_.size(), 0);
        Score best_score = score(best, kSharedSearch);
        for (Choice choice = best; next(choice);) {
            const std::optional<Score> found = scoreIfBetter(choice, kSharedSearch, 0, best_score);
            if (!found) continue;
            best = choice;
            best_score = *found;
        }
        return best;
    }

    /// Counts up; false after the last combination.
    bool next(Choice& choice) const {
        for (std::size_t f = 0; f < choice.size(); ++f) {
            if (++choice[f] < choices_[f].size()) return true;
            choice[f] = 0;
        }
        return false;
    }

    Choice improved(Choice choice) const {
        Score best = score(choice, kTrialSearch);
        const auto spareVisits = [&] {
            return std::max(0, best.visits - leastVisits(visits_.problem(choice)) - kSavedBesideTheLeast);
        };
        int spare_visits = spareVisits();
        for (int round = 0; round < kMostRounds; ++round) {
            bool any = false;
            const auto tryOut = [&](const Choice& other) {
                const std::optional<Score> found = scoreIfBetter(other, kTrialSearch, spare_visits, best);
                if (!found) return;
                choice = other;
                best = *found;
                spare_visits = spareVisits();
                any = true;
            };
            for (const std::string& tool : toolsOf(choice))
                if (const auto other = without(choice, tool, allFeatures())) tryOut(*other);
            giveUpVisits(choice, tryOut);
            for (std::size_t f = 0; f < choices_.size(); ++f)
                for (std::size_t i = 0; i < choices_[f].size(); ++i)
                    if (mayPay(choice, f, i)) tryOut(changed(choice, f, i));
            if (!any) break;
        }
        return choice;
    }

    static Choice changed(Choice choice, std::size_t feature, std::size_t index) {
        choice[feature] = index;
        return choice;
    }

    std::vector<std::size_t> allFeatures() const {
        std::vector<std::size_t> all(choices_.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }

    /// Tools that are called again: without one of their visits, or without all from one on.
    template <typename TryOut>
    void giveUpVisits(const Choice& choice, const TryOut& tryOut) const {
        std::vector<ServingVisit> visits = visitsOf(choice);
        std::reverse(visits.begin(), visits.end());
        std::map<std::string, std::vector<std::size_t>> from_here_on;
        std::map<std::string, int> times;
        for (const ServingVisit& visit : visits)
            ++times[visit.tool];
        for (const ServingVisit& visit : visits) {
            if (times[visit.tool] < 2) continue;
            if (const auto other = without(choice, visit.tool, visit.features)) tryOut(*other);
            std::vector<std::size_t>& later = from_here_on[visit.tool];
            const bool first_asked = later.empty();
            later.insert(later.end(), visit.features.begin(), visit.features.end());
            if (first_asked) continue;
            if (const auto other = without(choice, visit.tool, later)) tryOut(*other);
        }
    }

    /// Those of the features that call `tool` take the cheapest choice without it, beside the tools that are
    /// called anyway; nothing when one of them has none.
    std::optional<Choice> without(const Choice& choice, const std::string& tool,
                                  const std::vector<std::size_t>& features) const {
        std::set<std::string> called = toolsOf(choice);
        called.erase(tool);
        Choice other = choice;
        for (const std::size_t f : features) {
            if (choices_[f].empty() || !uses(choices_[f][choice[f]], tool)) continue;
            std::optional<std::size_t> best;
            for (std::size_t i = 0; i < choices_[f].size(); ++i) {
                if (uses(choices_[f][i], tool)) continue;
                if (!best || beside(called, f, i) < beside(called, f, *best)) best = i;
            }
            if (!best) return std::nullopt;
            other[f] = *best;
        }
        return other;
    }

    static bool uses(const SequenceChoice& choice, const std::string& tool) {
        return std::find(choice.tools.begin(), choice.tools.end(), tool) != choice.tools.end();
    }

    double beside(const std::set<std::string>& called, std::size_t feature, std::size_t index) const {
        const SequenceChoice& choice = choices_[feature][index];
        double weight = choice.paths;
        for (const std::string& tool : choice.tools)
            if (called.count(tool) == 0) weight += change_;
        return weight;
    }

    /// A change of one feature saves at most the visits of the tools it no longer calls, and one visit for
    /// each of its own that the new order of its tools may join to another's.
    bool mayPay(const Choice& choice, std::size_t feature, std::size_t index) const {
        const SequenceChoice& now = choices_[feature][choice[feature]];
        const SequenceChoice& then = choices_[feature][index];
        if (index == choice[feature]) return false;
        return then.paths < now.paths + change_ * static_cast<double>(now.tools.size());
    }

    const std::vector<std::vector<SequenceChoice>>& choices_;
    ChoiceVisits visits_;
    double change_;
    int magazine_;
};

}  // namespace

SharedChoice shareTools(const std::vector<Precedence>& features,
                        const std::vector<std::vector<SequenceChoice>>& choices, double change_weight,
                        const ToolLibrary& library, int magazine) {
    SharedChoice shared = Sharing(features, choices, change_weight, library, magazine).best();
    if (magazine <= 0 || shared.gain.tools <= magazine) return shared;
    return Sharing(features, choices, change_weight, library, 0).best();
}

SharedSetups withSharedTools(std::vector<PlannedSetup> setups, const ToolLibrary& library,
                             const Machine& machine, Objective objective) {
    std::vector<std::vector<SequenceChoice>> choices;
    for (const PlannedSetup& setup : setups)
        for (const PlannedFeature& planned : setup.features)
            choices.push_back(choicesOf(planned.sequence));
    SharedChoice shared = shareTools(inSetupOrder(setups), choices, changeWeight(machine, objective), library,
                                     machine.magazine_size);
    std::size_t feature = 0;
    std::set<std::string> changed;
    for (PlannedSetup& setup : setups) {
        for (PlannedFeature& planned : setup.features) {
            ToolSequence& sequence = planned.sequence;
            const std::size_t choice = shared.choice[feature++];
            if (choice > 0) {
                sequence = withChoice(sequence, choice);
                changed.insert(wholeOf(planned.feature));
            }
            // The DAG and all it was made from are not needed any more.
            sequence.choices.reset();
        }
    }
    shared.gain.features_changed = static_cast<int>(changed.size());
    return {std::move(setups), shared.gain};
}

}  // namespace stepmill
