#include "stepmill/core/enum_words.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

constexpr EnumWord<Objective> kObjectives[] = {{Objective::Time, "time"}, {Objective::Cost, "cost"}};

constexpr EnumWord<SurrogateRule> kSurrogateRules[] = {{SurrogateRule::Single, "single"},
                                                       {SurrogateRule::SingleOrLater, "single or later"},
                                                       {SurrogateRule::Sequence, "sequence"}};

}  // namespace

std::string toString(Objective objective) {
    return wordOf(kObjectives, objective);
}

std::optional<Objective> objectiveFrom(std::string_view word) {
    return valueOf(kObjectives, word);
}

std::string toString(SurrogateRule rule) {
    return wordOf(kSurrogateRules, rule);
}

std::optional<SurrogateRule> surrogateRuleFrom(std::string_view word) {
    return valueOf(kSurrogateRules, word);
}

}  // namespace stepmill
