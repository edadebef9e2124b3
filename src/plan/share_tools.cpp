#include "plan/share_tools.h"

#include <map>
#include <set>

#include "stepmill/core/units.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill {
namespace {

/// So many combinations of choices are all tried; each takes an ordering of the plan's operations.
constexpr std::size_t kMostCombinations = 512;
/// Rounds of improvement; each makes the plan cheaper or is the last.
constexpr int kMostRounds = 20;
/// Orders that only compare two choices look ahead less far than the plan's own.
constexpr std::size_t kTrialBeamWidth = 4;

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

class Sharing {
  public:
    Sharing(const std::vector<Precedence>& features, const std::vector<std::vector<SequenceChoice>>& choices,
            double change_weight, const ToolLibrary& library, int magazine)
        : features_(features), choices_(choices), change_(change_weight), magazine_(magazine) {
        for (const ToolAssembly& tool : library.tools)
            diameter_mm_[tool.id] = tool.diameter_mm;
        for (std::size_t f = 0; f < features.size(); ++f)
            number_[features[f].feature_id] = f;
    }

    SharedChoice best() const {
        const Choice own(choices_.size(), 0);
        Choice found = combinations() <= kMostCombinations ? bestOfAll() : improved(own);
        const Score alone = score(own, kBeamWidth);
        Score together = score(found, kBeamWidth);
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

    Score score(const Choice& choice, std::size_t beam_width) const {
        Score score;
        std::vector<Operation> operations;
        for (std::size_t f = 0; f < choices_.size(); ++f) {
            if (choices_[f].empty()) continue;
            score.weight += choices_[f][choice[f]].paths;
            for (const std::string& tool : toolsOf(choice, f)) {
                Operation operation;
                operation.feature_id = features_[f].feature_id;
                operation.tool_id = tool;
                operation.waits = likelyWaits(choice, f, tool);
                operations.push_back(std::move(operation));
            }
        }
        score.tools = static_cast<int>(toolsOf(choice).size());
        score.visits = static_cast<int>(toolVisits(operations, features_, beam_width).size());
        score.weight += score.visits * change_;
        if (magazine_ > 0) score.too_many = std::max(0, score.tools - magazine_);
        return score;
    }

    /// What earlyStarts() will say once there are paths: a tool may go down where none wider works any more.
    std::vector<Wait> likelyWaits(const Choice& choice, std::size_t feature, const std::string& tool) const {
        std::vector<Wait> waits;
        for (const std::string& band : features_[feature].bands_above) {
            const std::size_t above = number_.at(band);
            if (choices_[above].empty()) return {};
            const std::vector<std::string>& visits = toolsOf(choice, above);
            const auto as_narrow = std::find_if(visits.begin(), visits.end(), [&](const std::string& visit) {
                return diameter_mm_.at(visit) <= diameter_mm_.at(tool);
            });
            const auto all = static_cast<int>(visits.size());
            waits.push_back({band, std::min(static_cast<int>(as_narrow - visits.begin()) + 1, all)});
        }
        return waits;
    }

    Choice bestOfAll() const {
        Choice best(choices_.size(), 0);
        Score best_score = score(best, kBeamWidth);
        for (Choice choice = best; next(choice);) {
            const Score found = score(choice, kBeamWidth);
            if (!found.isBetterThan(best_score)) continue;
            best = choice;
            best_score = found;
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
        Score best = score(choice, kTrialBeamWidth);
        for (int round = 0; round < kMostRounds; ++round) {
            bool any = false;
            const auto tryOut = [&](const Choice& other) {
                const Score found = score(other, kTrialBeamWidth);
                if (!found.isBetterThan(best)) return;
                choice = other;
                best = found;
                any = true;
            };
            for (const std::string& tool : toolsOf(choice))
                if (const auto other = without(choice, tool)) tryOut(*other);
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

    /// Every feature that calls `tool` takes the cheapest choice without it, beside the tools that are called
    /// anyway; nothing when one of them has none.
    std::optional<Choice> without(const Choice& choice, const std::string& tool) const {
        std::set<std::string> called = toolsOf(choice);
        called.erase(tool);
        Choice other = choice;
        for (std::size_t f = 0; f < choices_.size(); ++f) {
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

    const std::vector<Precedence>& features_;
    const std::vector<std::vector<SequenceChoice>>& choices_;
    double change_;
    int magazine_;
    std::map<std::string, double> diameter_mm_;  ///< by tool id
    std::map<std::string, std::size_t> number_;  ///< of each feature
};

}  // namespace

SharedChoice shareTools(const std::vector<Precedence>& features,
                        const std::vector<std::vector<SequenceChoice>>& choices, double change_weight,
                        const ToolLibrary& library, int magazine) {
    return Sharing(features, choices, change_weight, library, magazine).best();
}

SharedSetups withSharedTools(std::vector<PlannedSetup> setups, const ToolLibrary& library,
                             const Machine& machine, Objective objective) {
    std::vector<std::vector<SequenceChoice>> choices;
    for (const PlannedSetup& setup : setups)
        for (const PlannedFeature& planned : setup.features)
            choices.push_back(choicesOf(planned.sequence));
    const double hours = machine.tool_change_s / (60 * kSecondsPerMinute);
    const double change_weight =
        objective == Objective::Time ? machine.tool_change_s : hours * machine.hourly_rate;
    SharedChoice shared =
        shareTools(inSetupOrder(setups), choices, change_weight, library, machine.magazine_size);
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
