#include "stepmill/plan/warning_order.h"

#include <algorithm>
#include <string_view>

namespace stepmill {
namespace {

struct CodeConsequence {
    std::string_view code;
    Consequence consequence;
};
constexpr CodeConsequence kConsequences[] = {{"travel", Consequence::Danger},
                                             {"unit-doubt", Consequence::Danger},
                                             {"input-doubt", Consequence::Danger},
                                             {"books", Consequence::Danger},
                                             {"no-hold", Consequence::Danger},
                                             {"below-stock", Consequence::Danger},
                                             {"loose", Consequence::Danger},
                                             {"taped", Consequence::Danger},
                                             {"hollow-grip", Consequence::Danger},
                                             {"low-spindle", Consequence::Danger},
                                             {"proof", Consequence::Danger},
                                             {"not-2.5d", Consequence::MissingOnThePart},
                                             {"unreachable", Consequence::MissingOnThePart},
                                             {"feature-failed", Consequence::MissingOnThePart},
                                             {"planning-failed", Consequence::MissingOnThePart},
                                             {"time-limit", Consequence::MissingOnThePart},
                                             {"no-tool", Consequence::MissingOnThePart},
                                             {"residual", Consequence::MissingOnThePart},
                                             {"held-stock", Consequence::MissingOnThePart},
                                             {"no-allowance", Consequence::MissingOnThePart},
                                             {"thread", Consequence::MissingOnThePart},
                                             {"fit", Consequence::MissingOnThePart},
                                             {"sharp-edge", Consequence::MissingOnThePart},
                                             {"raw-edge", Consequence::MissingOnThePart},
                                             {"cycle-time", Consequence::Cost},
                                             {"magazine", Consequence::Cost},
                                             {"slow", Consequence::Cost},
                                             {"few-tools", Consequence::Cost},
                                             {"few-setups", Consequence::Cost},
                                             {"deflection", Consequence::Cost},
                                             {"tool-unusable", Consequence::Cost}};

bool staysAlone(const Warning& warning) {
    return warning.code == "proof" || warning.code == "loose";
}

}  // namespace

Consequence consequenceOf(const Warning& warning) {
    for (const CodeConsequence& known : kConsequences)
        if (known.code == warning.code) return known.consequence;
    return Consequence::Note;
}

std::string setupOf(const Warning& warning) {
    const std::string first = warning.subject.substr(0, warning.subject.find('.'));
    const bool is_setup =
        first.size() > 1 && first.front() == 'S' &&
        std::all_of(first.begin() + 1, first.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_setup ? first : std::string();
}

std::vector<Warning> byConsequence(std::vector<Warning> warnings) {
    std::vector<Warning> grouped;
    for (Warning& warning : warnings) {
        const auto alike = std::find_if(grouped.begin(), grouped.end(), [&](const Warning& known) {
            return !staysAlone(warning) && known.code == warning.code && known.text == warning.text &&
                   setupOf(known) == setupOf(warning);
        });
        if (alike != grouped.end())
            alike->count += warning.count;
        else
            grouped.push_back(std::move(warning));
    }
    std::stable_sort(grouped.begin(), grouped.end(),
                     [](const Warning& a, const Warning& b) { return consequenceOf(a) < consequenceOf(b); });
    return grouped;
}

bool isWithinTravel(const Plan& plan, const std::string& setup_id) {
    return std::none_of(plan.warnings.begin(), plan.warnings.end(), [&](const Warning& warning) {
        return warning.code == "travel" && warning.subject == setup_id;
    });
}

}  // namespace stepmill
