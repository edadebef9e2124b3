// What cycle times are said in, and the rule for wider tools.

#include "stepmill/plan/cycle_time.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

constexpr EnumWord<TimeUse> kUses[] = {{TimeUse::Cut, "cut"},
                                       {TimeUse::LibraryFeed, "library feed"},
                                       {TimeUse::Holes, "holes"},
                                       {TimeUse::Finishing, "finishing"},
                                       {TimeUse::Forms, "forms"},
                                       {TimeUse::Rapids, "rapids"},
                                       {TimeUse::Acceleration, "acceleration"},
                                       {TimeUse::ToolChanges, "tool changes"}};

constexpr EnumWord<CycleWay> kWays[] = {{CycleWay::Feeds, "feeds"},
                                        {CycleWay::Diameter, "diameter"},
                                        {CycleWay::Objective, "objective"},
                                        {CycleWay::Sequence, "sequence"}};

/// Passes over a whole number by more are one more; by less they ask for a wider cutter.
constexpr double kHalfAPass = 0.5;
/// Whole numbers of passes are whole to this.
constexpr double kWholePasses = 1e-9;

}  // namespace

std::string toString(TimeUse use) {
    return wordOf(kUses, use);
}

std::optional<TimeUse> timeUseFrom(std::string_view word) {
    return valueOf(kUses, word);
}

std::string toString(CycleWay way) {
    return wordOf(kWays, way);
}

std::optional<CycleWay> cycleWayFrom(std::string_view word) {
    return valueOf(kWays, word);
}

bool CycleOutcome::isMet() const {
    return std::abs(time_s - target.time_s) <= kCycleTimeShare * target.time_s;
}

std::string missedWords(const CycleOutcome& outcome) {
    return fmt::format("takes {:.1f} s at the {}, {:.1f} s were asked for", outcome.time_s,
                       outcome.isTooLong() ? "least" : "most", outcome.target.time_s);
}

bool CycleTimes::areMet() const {
    return std::all_of(outcomes.begin(), outcomes.end(),
                       [](const CycleOutcome& outcome) { return outcome.isMet(); });
}

double wantedDiameterMm(const WiderCut& cut) {
    STEPMILL_CHECK(cut.area_mm2 > 0 && cut.time_s > 0 && cut.feed_mm_per_min > 0 && cut.width_mm > 0,
                   "a cut has ground, a time and a feed");
    return cut.area_mm2 / (cut.time_s * cut.feed_mm_per_min / kSecondsPerMinute);
}

std::optional<WiderChoice> widerCutter(const WiderCut& cut, std::vector<AvailableCutter> cutters) {
    const double wanted_mm = wantedDiameterMm(cut);
    std::erase_if(cutters, [&](const AvailableCutter& one) { return one.diameter_mm < wanted_mm; });
    std::stable_sort(cutters.begin(), cutters.end(), [](const AvailableCutter& a, const AvailableCutter& b) {
        return a.diameter_mm < b.diameter_mm;
    });
    if (cutters.empty()) return std::nullopt;
    const auto passesOf = [&](const AvailableCutter& one) { return cut.width_mm / one.step_over_mm; };
    const auto choice = [&](const AvailableCutter& one) {
        const double passes = std::max(1.0, std::ceil(passesOf(one) - kWholePasses));
        return WiderChoice{wanted_mm, one.diameter_mm, static_cast<int>(passes)};
    };
    for (const AvailableCutter& one : cutters) {
        const double over = passesOf(one) - std::floor(passesOf(one) + kWholePasses);
        if (passesOf(one) <= 1 || over <= kWholePasses || over > kHalfAPass) return choice(one);
    }
    return choice(cutters.front());
}

}  // namespace stepmill
