#include <fmt/format.h>

#include "report/page/words.h"
#include "report/replan/replan_words.h"
#include "stepmill/report/replan.h"

namespace stepmill {
namespace {

using report::clockTime;

std::string totalsText(const PlanChange& change) {
    return fmt::format(
        "total {} instead of {} ({}), {:.2f} instead of {:.2f} {} ({}), {} tool changes instead of {}\n",
        clockTime(change.after.time_s), clockTime(change.before.time_s),
        report::differenceWords(change.before.time_s, change.after.time_s, 1, "s"), change.after.cost,
        change.before.cost, change.currency,
        report::differenceWords(change.before.cost, change.after.cost, 2, change.currency),
        change.after.tool_changes, change.before.tool_changes);
}

std::string featureText(const FeatureChange& change) {
    const std::string head = fmt::format("{:<10} {:<8}", change.id, toString(change.change));
    switch (change.change) {
        case Change::Kept:
            return head + " " + report::featureWords(change.after) + "\n";
        case Change::Changed:
            return fmt::format("{} {}, was {}: {}\n", head, clockTime(change.after->time_s),
                               clockTime(change.before->time_s), report::changeWords(change));
        case Change::New:
            return head + " " + report::featureWords(change.after) + "\n";
        case Change::Dropped:
            return head + " was " + report::featureWords(change.before) + "\n";
    }
    return {};
}

std::string operationText(const OperationChange& change) {
    const OperationThen& then = change.after ? *change.after : *change.before;
    std::string words =
        fmt::format("{:<10} {:<8} {} {} T{} {}, {}", change.id, toString(change.change), change.feature_id,
                    toString(change.role), then.number, then.tool, clockTime(then.time_s));
    if (change.before && change.after && change.change == Change::Changed)
        words += fmt::format(", was {}", clockTime(change.before->time_s));
    if (change.lines_kept > 0 && change.change == Change::Changed)
        words += fmt::format("; {} of {} lines kept", change.lines_kept, change.before->lines.size());
    return words + "\n";
}

std::string programText(const ProgramChange& change) {
    return fmt::format("{} {}: {} lines, {} kept of {}\n", change.setup_id, report::programWords(change),
                       change.lines_after, change.lines_kept, change.lines_before);
}

}  // namespace

std::string replanText(const PlanChange& change) {
    std::string text;
    for (const std::string& input : report::inputWords(change))
        text += input + "\n";
    const std::vector<std::string> cycle = report::cycleWords(change.cycle);
    if (!cycle.empty()) text += "cycle times, with the machine's acceleration:\n";
    for (const std::string& line : cycle)
        text += line + "\n";
    text += "features: " + report::countWords(change.features) + "\n";
    for (const FeatureChange& feature : change.features)
        text += featureText(feature);
    text += "operations: " + report::countWords(change.operations) + "\n";
    for (const OperationChange& operation : change.operations)
        if (operation.change != Change::Kept) text += operationText(operation);
    text += "programs: " + report::countWords(change.programs) + "\n";
    for (const ProgramChange& program : change.programs)
        text += programText(program);
    return text + totalsText(change);
}

}  // namespace stepmill
