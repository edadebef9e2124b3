#include <fmt/format.h>

#include "report/page/words.h"
#include "report/plan/over_bound.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/plan/feature_times.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

using report::clockTime;
using report::counted;
using report::timesBound;
using report::toolWords;

/// Where features took other tools than their own cheapest.
std::string sharingLine(const ToolSharing& sharing) {
    if (sharing.features_changed == 0) return {};
    const std::string fewer =
        sharing.tools < sharing.tools_alone
            ? fmt::format("{} instead of {}; ", counted(sharing.tools, "tool"), sharing.tools_alone)
            : "";
    return fmt::format("tools shared: {}{} {} other tools than their own cheapest\n", fewer,
                       counted(sharing.features_changed, "feature"),
                       sharing.features_changed == 1 ? "takes" : "take");
}

/// With all its bands.
std::string featureLine(const WholeFeature<PlannedFeature>& feature, const std::vector<Operation>& operations,
                        const Machine& machine) {
    const FeatureTimes times = timesOf(feature, operations, machine);
    const double stays_mm3 = feature.sum([](const PlannedFeature& band) {
        double sum_mm3 = 0;
        for (const Residual& residual : band.sequence.residual)
            sum_mm3 += residual.stays_mm3.value_or(residual.volume_mm3);
        return sum_mm3;
    });
    const std::string ground = report::groundWords(feature.uppermost());
    return fmt::format(
        "{:<9} {:<26} {:>6.2f} mm {:>7.2f} cm3 {:>9} {:>6}  {:<34} {:>6.3f} cm3\n", feature.id(),
        ground.empty() ? report::classWords(feature, report::Measures(false)) : ground, feature.depth_mm(),
        feature.volume_mm3() / 1000, clockTime(times.time_s), timesBound(times.time_s, times.lower_bound_s),
        plainLine(toolWords(feature)), stays_mm3 / 1000);
}

/// What form cutters do in each setup; empty where there are none.
std::string formLines(const Plan& plan) {
    std::string text;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations) {
            if (operation.role != Role::Form) continue;
            double taken_mm3 = operation.breaks_mm3;
            for (const ReasonVolume& taken : operation.takes)
                taken_mm3 += taken.volume_mm3;
            const std::string off = operation.breaks_mm3 > 0 ? "edges"
                                    : operation.holes > 0 ? fmt::format("cones of {} holes", operation.holes)
                                                          : "leaning walls";
            text += fmt::format("{}: {} takes {:.3f} cm3 off {} in {}, {} levels\n", operation.id,
                                plainLine(operation.tool_id), taken_mm3 / 1000, off,
                                clockTime(operation.timeS()), operation.path.depths);
        }
    return text;
}

/// What became of the setups that were weighed and not taken; empty where there was no choice.
std::string choiceLines(const Assignment& assignment) {
    std::string text;
    int untried = 0;
    for (const SetupChoice& choice : assignment.choices) {
        if (choice.verdict == SetupVerdict::Taken) continue;
        if (choice.verdict == SetupVerdict::NoTime) {
            ++untried;
            continue;
        }
        text += fmt::format("setups {} instead: {}", report::axesWords(choice), toString(choice.verdict));
        if (choice.planned)
            text += fmt::format(", {} and {} to set up", clockTime(choice.planned->time_s),
                                clockTime(choice.planned->setup_s));
        text += "\n";
    }
    if (untried > 0)
        text += fmt::format("{} other {} of setups: no time to plan {}\n", untried,
                            untried == 1 ? "set" : "sets", untried == 1 ? "it" : "them");
    return text;
}

}  // namespace

std::string summaryText(const Plan& plan) {
    const Vec3 size = plan.part.bbox_mm.sizes();
    std::string text =
        fmt::format("{}  {:.2f} x {:.2f} x {:.2f} mm (file unit: {}), {}, {}\n\n", plainLine(plan.part.name),
                    size.x(), size.y(), size.z(), plainLine(plan.part.unit_in_file), plainLine(plan.material),
                    plainLine(plan.machine.name));
    text += fmt::format("{:<9} {:<26} {:>9} {:>11} {:>9} {:>6}  {:<34} {:>10}\n", "feature", "class", "depth",
                        "volume", "time", "x best", "tools", "stays");
    for (const PlannedSetup& setup : plan.setups) {
        text += fmt::format("{} along {}{}: {}\n", setup.setup.id, axisName(setup.setup.axis),
                            setup.setup.indexed ? " (indexed)" : "",
                            setup.operations.empty() ? "nothing can be cut from here, no program"
                                                     : plainLine(setup.clamping.text));
        for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features))
            text += featureLine(feature, setup.operations, plan.machine);
    }
    text += formLines(plan) + choiceLines(plan.assignment);
    const PlanTotals& totals = plan.totals;
    text += fmt::format("\ntotal {} (cutting {}, rapids {}, {} tool changes {}), {:.2f} {}\n",
                        clockTime(totals.time_s), clockTime(totals.cutting_s), clockTime(totals.air_s),
                        totals.tool_changes, clockTime(totals.tool_change_s), totals.cost,
                        plainLine(plan.machine.currency));
    if (plan.machine.acceleration_mm_per_s2 > 0)
        text += fmt::format("with the machine's acceleration {}\n", clockTime(totals.motion_s));
    text += sharingLine(plan.sharing);
    text += fmt::format("no sequences of these tools over these features can take less than {}",
                        clockTime(totals.lower_bound_s));
    const std::string over = report::overBoundWords(plan);
    text += over.empty() ? "\n" : "; " + over + "\n";
    const VolumeBalance& books = plan.balance;
    text += fmt::format(
        "books: stock - part {:.3f} cm3 = planned {:.3f} + stays {:.3f} + out of reach {:.3f} (gap {})\n",
        books.stock_minus_part_mm3 / 1000, books.planned_mm3 / 1000, books.residual_mm3 / 1000,
        books.unreachable_mm3 / 1000, report::gapWords(books.gapShare()));
    for (const Warning& warning : plan.warnings)
        text += fmt::format("warning: {}{}: {}\n", plainLine(warning.subject),
                            warning.count > 1 ? fmt::format(" and {} more", warning.count - 1) : "",
                            plainLine(warning.text));
    return text;
}

}  // namespace stepmill
