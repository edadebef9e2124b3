#include "report/page/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/sequence/sequence.h"

namespace stepmill::report {

std::string fixed(double value, int decimals) {
    return fmt::format("{:.{}f}", value, decimals);
}

std::string sizeWords(const Vec3& size_mm) {
    return fmt::format("{:.2f} × {:.2f} × {:.2f} mm", size_mm.x(), size_mm.y(), size_mm.z());
}

std::string timesBound(double value_s, double bound_s) {
    return bound_s > 0 ? fixed(value_s / bound_s, 2) : std::string("-");
}

std::string listed(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string clockTime(double seconds) {
    constexpr double kRoundsToAMinuteS = 59.95;
    if (seconds < kRoundsToAMinuteS) return fmt::format("{:.1f} s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string toolWords(const ToolSequence& sequence) {
    std::string words;
    bool in_brackets = false;
    std::string last;
    for (const SequenceStep& step : sequence.steps) {
        const bool surrogate = step.role == Role::Surrogate;
        if (step.tool_id == last && (step.role == Role::Finish || (surrogate && in_brackets))) continue;
        if (in_brackets && !surrogate) words += ")";
        if (surrogate)
            words += in_brackets ? ", " : " (+ ";
        else if (!words.empty())
            words += " > ";
        words += step.tool_id;
        in_brackets = surrogate;
        last = step.tool_id;
    }
    if (in_brackets) words += ")";
    return words.empty() ? "none fits" : words;
}

}  // namespace stepmill::report
