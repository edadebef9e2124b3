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

}  // namespace

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
