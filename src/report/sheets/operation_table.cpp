// The operations of a setup, in machining order.

#include <algorithm>

#include <fmt/format.h>

#include "report/page/program_lines.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/sheets/sheet_sections.h"

namespace stepmill::report {
namespace {

std::string featureWords(const PlannedSetup& setup, const Operation& operation) {
    if (operation.breaks_mm3 > 0) return "edges";
    if (operation.role == Role::Form)
        return operation.holes > 0 ? fmt::format("{} holes", operation.holes) : "leaning walls";
    for (const PlannedFeature& planned : setup.features)
        if (planned.feature.id == operation.feature_id)
            return shortId(operation.feature_id) + " " + toString(planned.feature.feature_class);
    return shortId(operation.feature_id);
}

std::string whatWords(const Operation& operation) {
    const std::string role = toString(operation.role);
    if (operation.thread) return role + " " + operation.thread->thread.name;
    if (operation.fit) return role + " " + operation.fit->name;
    return role == operation.path.pattern ? role : role + ", " + operation.path.pattern;
}

std::string depthWords(const Operation& operation, const Measures& in) {
    const Toolpath& path = operation.path;
    return path.depths > 1 ? fmt::format("{} × {}", path.depths, in.number(path.step_down_mm))
                           : in.number(path.step_down_mm);
}

std::string leavesWords(const FinishAllowance& leaves, const Measures& in) {
    if (!leaves.any()) return "0";
    return fmt::format("{}, {}", in.number(leaves.walls_mm), in.number(leaves.floors_mm));
}

std::string firstBlock(const PostedProgram* program, const std::string& operation_id) {
    const StartBlock* start = startOf(program, operation_id);
    return start == nullptr ? "-" : start->number;
}

std::string shareWords(double time_s, double all_s) {
    return all_s > 0 ? fixed(100 * time_s / all_s, 0) + " %" : "-";
}

/// What the hardest cut asks of the spindle; empty where nothing is known of that.
std::string powerWords(const PlannedSetup& setup) {
    const Operation* hardest = nullptr;
    for (const Operation& operation : setup.operations)
        if (operation.rating && (hardest == nullptr || operation.cuts.peak_kw > hardest->cuts.peak_kw))
            hardest = &operation;
    if (hardest == nullptr) return {};
    return fmt::format(
        " Feeds are lower in wide cuts and higher in thin ones; the most power is asked for by {}, "
        "{:.1f} kW.",
        shortId(hardest->id), hardest->cuts.peak_kw);
}

}  // namespace

Element operationTable(const SheetSubject& subject, const PlannedSetup& setup) {
    const Measures& in = subject.measures;
    const PostedProgram* program = programOf(subject.proven, setup);
    const std::string unit = in.unit();
    Table table({numbers("no."),
                 "feature",
                 "T",
                 "what",
                 {"Z from, to " + unit, true},
                 {"step-over " + unit, true},
                 {"step-down " + unit, true},
                 {"leaves " + unit, true},
                 {std::string("feed, plunge ") + in.feedUnit(), true},
                 numbers("rpm"),
                 "coolant",
                 numbers("time"),
                 numbers("share"),
                 "from block"});
    for (const Operation& operation : setup.operations) {
        const Toolpath& path = operation.path;
        table.row(shortId(operation.id), featureWords(setup, operation),
                  fmt::format("T{}", subject.plan().library.tool(operation.tool_id).number),
                  whatWords(operation),
                  fmt::format("{}, {}", in.number(operation.z_top_mm), in.number(lowestMm(operation))),
                  path.step_over_mm > 0 ? in.number(path.step_over_mm) : "-", depthWords(operation, in),
                  leavesWords(operation.leaves, in),
                  fmt::format("{}, {}", in.feed(path.feed_mm_per_min), in.feed(path.plunge_feed_mm_per_min)),
                  fixed(operation.speed_rpm, 0), toString(operation.coolant), clockTime(operation.motionS()),
                  shareWords(operation.motionS(), setup.motion_s), firstBlock(program, operation.id));
    }
    std::string more = fmt::format(
        "{} operation{}, {} with tool changes. Climb milling; the tool's centre is programmed, D is not "
        "called.",
        setup.operations.size(), setup.operations.size() == 1 ? "" : "s", clockTime(setup.motion_s));
    more += powerWords(setup);
    return titled("Operations", Element("div", std::move(table).element(), Element("p.soft", more)));
}

}  // namespace stepmill::report
