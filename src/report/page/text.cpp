#include "report/page/text.h"

#include <fmt/format.h>

#include "stepmill/core/plain_text.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

std::string escapeHtml(const std::string& text) {
    std::string safe;
    for (const char c : plainText(text))
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                safe += c;
        }
    return safe;
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

}  // namespace stepmill
