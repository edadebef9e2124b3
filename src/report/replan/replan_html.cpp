#include <fmt/format.h>

#include "report/page/document.h"
#include "report/page/drawing.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/replan/replan_words.h"
#include "stepmill/report/replan.h"

namespace stepmill {
namespace {

using report::clockTime;
using report::Element;
using report::fixed;
using report::numbers;
using report::Table;

/// How much of the surroundings a picture shows, as a share of its longer side.
constexpr double kShownAround = 0.12;

Element changeTotals(const PlanChange& change) {
    Table table({"", numbers("before"), numbers("after"), numbers("difference")});
    table.row("machine time", clockTime(change.before.time_s), clockTime(change.after.time_s),
              report::differenceWords(change.before.time_s, change.after.time_s, 1, "s"));
    table.row("cost " + change.currency, fixed(change.before.cost, 2), fixed(change.after.cost, 2),
              report::differenceWords(change.before.cost, change.after.cost, 2, ""));
    table.row("tool changes", std::to_string(change.before.tool_changes),
              std::to_string(change.after.tool_changes),
              report::differenceWords(change.before.tool_changes, change.after.tool_changes, 0, ""));
    return std::move(table).element();
}

Element programsTable(const PlanChange& change) {
    Table table({"setup", "program", numbers("lines before"), numbers("lines after"), numbers("lines kept")});
    for (const ProgramChange& program : change.programs)
        table.row(program.setup_id, report::programWords(program), std::to_string(program.lines_before),
                  std::to_string(program.lines_after), std::to_string(program.lines_kept));
    return std::move(table).element();
}

Element featuresTable(const PlanChange& change) {
    Table table({"feature", "", "before", "after", "what is another"});
    for (const FeatureChange& feature : change.features) {
        Element& row = table.row(feature.id, toString(feature.change), report::featureWords(feature.before),
                                 report::featureWords(feature.after), report::changeWords(feature));
        if (feature.change != Change::Kept) row.set("class", "chosen");
    }
    return std::move(table).element();
}

std::string operationCell(const std::optional<OperationThen>& operation) {
    if (!operation) return "-";
    return fmt::format("{}. T{} {}, {}", operation->place, operation->number, operation->tool,
                       clockTime(operation->time_s));
}

Element operationsTable(const PlanChange& change) {
    Table table({"operation", "", "feature", "before", "after", numbers("lines"), numbers("kept")});
    for (const OperationChange& operation : change.operations) {
        const OperationThen& then = operation.after ? *operation.after : *operation.before;
        Element& row = table.row(operation.id, toString(operation.change), operation.feature_id,
                                 operationCell(operation.before), operationCell(operation.after),
                                 std::to_string(then.lines.size()), std::to_string(operation.lines_kept));
        if (operation.change != Change::Kept) row.set("class", "chosen");
    }
    return std::move(table).element();
}

/// Its ground before, with the outline of the ground after in it, or the other way round.
Element groundFigure(const FeatureChange& feature, const Box2& frame, bool shows_after) {
    const std::string which = shows_after ? "after" : "before";
    report::Drawing drawing(frame, fmt::format("{} {}, from above", feature.id, which));
    const std::optional<FeatureThen>& own = shows_after ? feature.after : feature.before;
    const std::optional<FeatureThen>& other = shows_after ? feature.before : feature.after;
    if (own) drawing.region(own->target, "feature target");
    if (other) drawing.region(other->target, "room");
    return Element("figure", std::move(drawing).element(), Element("figcaption", which));
}

Element pictures(const FeatureChange& feature) {
    Box2 box;
    for (const std::optional<FeatureThen>* side : {&feature.before, &feature.after})
        if (*side) box.extend(boundingBox((*side)->target));
    const Box2 frame = grown(box, kShownAround * box.sizes().maxCoeff());
    return Element("div.pairs", groundFigure(feature, frame, false), groundFigure(feature, frame, true));
}

Element featureSection(const FeatureChange& feature) {
    Element section("section", Element("h3", fmt::format("{}: {}", feature.id, toString(feature.change))));
    if (!feature.causes.empty()) section.add(Element("p", report::changeWords(feature)));
    section.add(pictures(feature));
    return section;
}

bool hasOtherGround(const FeatureChange& feature) {
    return feature.change != Change::Kept && (feature.more_mm2 > 0 || feature.less_mm2 > 0);
}

Element cycleSection(const CycleTimes& times) {
    Element list("ul");
    for (const std::string& line : report::cycleWords(times))
        list.add(Element("li", line));
    return Element("section", Element("h2", "Cycle times, with the machine's acceleration"), std::move(list));
}

}  // namespace

std::string replanHtml(const PlanChange& change) {
    Element main("main", Element("h1", "Planned again: " + change.part_after.file));
    Element inputs("ul");
    for (const std::string& input : report::inputWords(change))
        inputs.add(Element("li", input));
    if (inputs.empty()) inputs.add(Element("li", "part, tools and machine are those of before"));
    main.add(std::move(inputs));
    if (change.sameMachining())
        main.add(Element("p", "Nothing that is machined is another: all operations keep their lines."));
    if (!change.cycle.outcomes.empty()) main.add(cycleSection(change.cycle));
    main.add(changeTotals(change), Element("h2", "Programs"),
             Element("p.soft",
                     "Lines kept are those of operations; block numbers count on over the program and are "
                     "left aside."),
             programsTable(change), Element("h2", "Features: " + report::countWords(change.features)),
             featuresTable(change), Element("h2", "Operations: " + report::countWords(change.operations)),
             operationsTable(change));
    const auto begin = change.features.begin();
    if (std::any_of(begin, change.features.end(), hasOtherGround))
        main.add(Element("h2", "Other ground"), Element("p.soft", "Dashed: the ground of the other plan."));
    for (const FeatureChange& feature : change.features)
        if (hasOtherGround(feature)) main.add(featureSection(feature));
    return report::htmlDocument("Planned again: " + change.part_after.file, std::move(main));
}

}  // namespace stepmill
