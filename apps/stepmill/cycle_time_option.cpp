#include "cycle_time_option.h"

#include <algorithm>
#include <optional>
#include <regex>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {

namespace {

/// "4:30", "1:04:30", "0:45.5"; nothing for other words.
std::optional<double> secondsOf(const std::string& word) {
    static const std::regex kClock(R"((?:(\d{1,3}):([0-5]\d)|(\d{1,4})):([0-5]\d(?:\.\d{1,3})?))");
    std::smatch found;
    if (!std::regex_match(word, found, kClock)) return std::nullopt;
    const double minutes =
        found[3].matched ? std::stod(found[3]) : 60 * std::stod(found[1]) + std::stod(found[2]);
    return minutes * kSecondsPerMinute + std::stod(found[4]);
}

CycleTarget cycleTarget(const std::string& word) {
    const std::size_t equals = word.find('=');
    const bool named = equals != std::string::npos;
    const std::optional<double> time_s = secondsOf(named ? word.substr(equals + 1) : word);
    if (!time_s || equals == 0)
        throw Error(
            ErrorCode::Usage, "--cycle-time " + word,
            "expected minutes and seconds (4:30) or hours too (1:04:30), of a setup S1=4:30, of a feature "
            "S1.F3=4:30");
    if (*time_s <= 0 || *time_s > kLongestCycleTimeS)
        throw Error(ErrorCode::Usage, "--cycle-time " + word,
                    "expected more than 0 s and no more than 100 hours");
    return {named ? word.substr(0, equals) : std::string(), *time_s};
}

}  // namespace

std::vector<CycleTarget> cycleTargets(const std::vector<std::string>& words) {
    if (words == std::vector<std::string>{"off"}) return {};
    std::vector<CycleTarget> targets;
    for (const std::string& word : words) {
        CycleTarget target = cycleTarget(word);
        const bool again = std::any_of(targets.begin(), targets.end(),
                                       [&](const CycleTarget& other) { return other.of == target.of; });
        if (again) throw Error(ErrorCode::Usage, "--cycle-time " + word, "expected one time for each");
        targets.push_back(std::move(target));
    }
    return targets;
}

}  // namespace stepmill
