#include "report/page/words.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/feature/hole_group.h"

namespace stepmill::report {
namespace {

/// Longer names may break within words [bytes].
constexpr std::size_t kMostUnbroken = 40;

/// Less than this shows as nothing in a table of volumes [mm3].
constexpr double kShowsMm3 = 0.5;

/// Where no tool is taken.
std::string noToolWords(const ToolSequence& sequence) {
    for (const Residual& residual : sequence.residual)
        if (!residual.taken_by.empty())
            return "left to " + residual.taken_by +
                   (residual.stays_mm3.value_or(0) > kShowsMm3 ? ", in part" : "");
    return "none fits";
}

}  // namespace

std::string fixed(double value, int decimals) {
    return fmt::format("{:.{}f}", value, decimals);
}

std::string sizeWords(const Vec3& size_mm) {
    return fmt::format("{:.2f} × {:.2f} × {:.2f} mm", size_mm.x(), size_mm.y(), size_mm.z());
}

std::string timesBound(double value_s, double bound_s) {
    return bound_s > 0 ? fixed(value_s / bound_s, 2) : std::string("-");
}

std::string gapWords(double share) {
    constexpr double kRounding = 1e-12;
    return share <= kRounding ? "0" : fmt::format("{:.1e}", share);
}

std::string axesWords(const SetupChoice& choice) {
    std::string words;
    for (const Vec3& axis : choice.axes)
        words += (words.empty() ? "" : ", ") + axisName(axis);
    return words;
}

std::string shortId(const std::string& id) {
    const std::size_t point = id.find('.');
    if (point == std::string::npos) return id;
    return id[point + 1] == 'O' ? id.substr(point + 2) : id.substr(point + 1);
}

std::string classWords(const WholeFeature<PlannedFeature>& feature, const Measures& in) {
    std::string words = toString(feature.featureClass());
    const Feature& lowest = feature.lowest();
    if (!isHole(lowest.feature_class) || !isFullCircles(lowest.target)) return words;
    if (const std::size_t count = lowest.target.loops.size(); count > 1)
        words = fmt::format("{} x {}", count, words);
    if (!isHole(feature.featureClass())) return words;
    return fmt::format("{}, {}", words, in.length(2 * holeRadiusMm(lowest)));
}

std::string groundWords(const Feature& feature) {
    const std::vector<std::string>& levels = feature.ground_of;
    if (levels.empty()) return {};
    if (levels.size() == 1) return "part of " + shortId(levels.front());
    return fmt::format("{} to {} together", shortId(levels.front()), shortId(levels.back()));
}

std::string placesOfHoles(const WholeFeature<PlannedFeature>& feature, const Measures& in) {
    const Feature& lowest = feature.lowest();
    if (!isHole(lowest.feature_class) || lowest.target.loops.size() < 2) return {};
    std::vector<std::string> places;
    for (const Vec2& centre : holeCentres(lowest))
        places.push_back(fmt::format("X {}, Y {}", in.number(centre.x(), 3), in.number(centre.y(), 3)));
    return fmt::format("{}", fmt::join(places, "; "));
}

Element breakable(const std::string& name) {
    return Element(name.size() > kMostUnbroken ? Tag("span.any") : Tag("span"), name);
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

std::string counted(int count, const std::string& what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string subjectWords(const Warning& warning) {
    if (warning.count == 1) return warning.subject;
    return fmt::format("{} and {} more", warning.subject, warning.count - 1);
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
    return words.empty() ? noToolWords(sequence) : words;
}

std::string toolWords(const WholeFeature<PlannedFeature>& feature) {
    if (feature.bands.size() == 1) return toolWords(feature.bands.front()->sequence);
    std::vector<std::string> tools;
    for (const PlannedFeature* band : feature.bands)
        for (const SequenceStep& step : band->sequence.steps)
            if (std::find(tools.begin(), tools.end(), step.tool_id) == tools.end())
                tools.push_back(step.tool_id);
    return fmt::format("{} in {} bands",
                       tools.empty() ? noToolWords(feature.bands.front()->sequence) : listed(tools),
                       feature.bands.size());
}

}  // namespace stepmill::report
