#include "report/replan/replan_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/page/words.h"

namespace stepmill::report {
namespace {

/// Less ground is not told: from above it may be the same.
constexpr double kShownMm2 = 0.005;

std::string causeWords(ChangeCause cause, const FeatureChange& change) {
    const FeatureThen& before = *change.before;
    const FeatureThen& after = *change.after;
    switch (cause) {
        case ChangeCause::Ground:
            if (std::max(change.more_mm2, change.less_mm2) < kShownMm2) return "other ground at some depth";
            return fmt::format("{:.2f} mm2 more and {:.2f} mm2 less ground", change.more_mm2,
                               change.less_mm2);
        case ChangeCause::Depth:
            return fmt::format("from Z{:.3f} to Z{:.3f} instead of Z{:.3f} to Z{:.3f}", after.top_z_mm,
                               after.floor_z_mm, before.top_z_mm, before.floor_z_mm);
        case ChangeCause::Kind:
            return fmt::format("a {} that was a {}", toString(after.feature_class),
                               toString(before.feature_class));
        case ChangeCause::Surroundings:
            return "other material stands around it";
        case ChangeCause::Tools:
            return fmt::format("{} instead of {}", listed(after.tools), listed(before.tools));
        case ChangeCause::Path:
            return "other moves or feeds";
    }
    return {};
}

std::string targetName(const std::string& of) {
    return of.empty() ? "part" : of;
}

std::string usedWords(const UsedTime& used) {
    const std::string what = used.use == TimeUse::Cut           ? "cuts held by " + toString(*used.limit)
                             : used.use == TimeUse::LibraryFeed ? "cuts at the library's feeds"
                             : used.use == TimeUse::Holes       ? "tools for holes"
                             : used.use == TimeUse::Finishing   ? "finishing passes"
                             : used.use == TimeUse::Forms       ? "form cutters"
                                                                : toString(used.use);
    return clockTime(used.time_s) + " " + what;
}

/// What its time goes to.
std::string usesWords(const CycleOutcome& outcome) {
    std::vector<std::string> words;
    for (const UsedTime& used : outcome.uses)
        words.push_back(usedWords(used));
    return listed(words);
}

/// Of the library's.
std::string paceWords(double pace) {
    if (pace == 1) return "the usual feeds";
    if (pace < 1) return fmt::format("{:.2f} times the usual speeds and feeds", pace);
    return fmt::format("cuts fed up to {:.2f} times as fast", pace);
}

std::string outcomeWords(const CycleOutcome& outcome) {
    const std::string head =
        fmt::format("{}: {} asked for", targetName(outcome.target.of), clockTime(outcome.target.time_s));
    const std::string pace = paceWords(outcome.pace);
    if (outcome.isMet()) return fmt::format("{}, takes {}: {}", head, clockTime(outcome.time_s), pace);
    if (!outcome.isTooLong())
        return fmt::format("{}; takes {} at the most ({}): the machine waits {}", head,
                           clockTime(outcome.time_s), pace,
                           clockTime(outcome.target.time_s - outcome.time_s));
    return fmt::format("{}, not met; takes {} at the least ({}): {}", head, clockTime(outcome.time_s), pace,
                       usesWords(outcome));
}

std::string wayWords(const CycleStep& step) {
    switch (step.way) {
        case CycleWay::Feeds:
            return paceWords(step.pace);
        case CycleWay::Diameter: {
            const std::string passes =
                step.passes > 0 ? fmt::format("{} pass{}", step.passes, step.passes == 1 ? "" : "es")
                                : std::string("none is as wide");
            return fmt::format("{} begun {:g} mm wide, not by {} ({:.1f} mm by area / (time x feed), {})",
                               step.feature, step.diameter_mm, step.tool, step.wanted_mm, passes);
        }
        case CycleWay::Objective:
            return "tools by time, not by money";
        case CycleWay::Sequence:
            return "without " + step.tool;
    }
    return {};
}

std::string stepWords(const CycleStep& step) {
    const std::string verdict = step.taken         ? ""
                                : step.leaves_more ? ", not taken: leaves more"
                                                   : ", not taken: no gain";
    return fmt::format("{}: {} -> {} ({}){}", wayWords(step), clockTime(step.before_s),
                       clockTime(step.after_s), differenceWords(step.before_s, step.after_s, 1, "s"),
                       verdict);
}

}  // namespace

std::vector<std::string> cycleWords(const CycleTimes& times) {
    std::vector<std::string> words;
    for (const CycleOutcome& outcome : times.outcomes) {
        words.push_back(outcomeWords(outcome));
        for (const CycleStep& step : times.steps)
            if (step.of == outcome.target.of) words.push_back("  " + stepWords(step));
    }
    return words;
}

std::vector<std::string> inputWords(const PlanChange& change) {
    std::vector<std::string> words;
    if (change.part_before.sha256 != change.part_after.sha256)
        words.push_back(
            fmt::format("part: {} instead of {}{}", change.part_after.file, change.part_before.file,
                        change.part_after.file == change.part_before.file ? ", with other contents" : ""));
    for (const InputChange& input : change.inputs)
        words.push_back(fmt::format("{}: {} instead of {}", input.what,
                                    input.after.empty() ? "nothing" : input.after,
                                    input.before.empty() ? "nothing" : input.before));
    return words;
}

std::string changeWords(const FeatureChange& change) {
    std::vector<std::string> words;
    for (const ChangeCause cause : change.causes)
        words.push_back(causeWords(cause, change));
    return listed(words);
}

std::string featureWords(const std::optional<FeatureThen>& feature) {
    if (!feature) return "-";
    return fmt::format("{} {} by {}", clockTime(feature->time_s), toString(feature->feature_class),
                       feature->tools.empty() ? "none" : listed(feature->tools));
}

std::string programWords(const ProgramChange& change) {
    const std::string word = toString(change.change);
    if (change.lines_before + change.lines_after == 0) return word + ", no program is written";
    return change.same_bytes ? word + ", the same bytes" : word;
}

std::string differenceWords(double before, double after, int decimals, const std::string& unit) {
    const double least = 0.5 * std::pow(10, -decimals);
    if (std::abs(after - before) < least) return "the same";
    return fmt::format("{:+.{}f}{}{}", after - before, decimals, unit.empty() ? "" : " ", unit);
}

}  // namespace stepmill::report
