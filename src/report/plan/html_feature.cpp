// The section of report.html about one feature: its steps, what stays, and why these tools.

#include <fmt/format.h>

#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/dag_drawing.h"
#include "report/plan/feature_drawing.h"
#include "report/plan/html_sections.h"
#include "report/plan/tool_charts.h"
#include "stepmill/core/error.h"

namespace stepmill::report {
namespace {

/// The operations of a feature, which keep the order of its steps.
std::vector<const Operation*> operationsOf(const PlannedSetup& setup, const std::string& feature_id) {
    std::vector<const Operation*> found;
    for (const Operation& operation : setup.operations)
        if (operation.feature_id == feature_id) found.push_back(&operation);
    return found;
}

/// What keeps the tool off the feature or part of it; empty where nothing does or surrogates do that part.
std::string whyNotAll(const ToolReach& reach) {
    if (const Exclusion* excluded = reach.exclusion()) return excluded->text;
    return reach.limited() != nullptr ? reach.limited()->why : std::string();
}

Element toolsTable(const ToolSequence& sequence, const Measures& in) {
    Table table({"tool", numbersIn(in.areaUnit(), "coverable"),
                 numbersIn(in.areaUnit(), "of it free of the holder"), numbersIn(in.volumeUnit(), "volume"),
                 "why not"});
    for (const ToolReach& reach : sequence.tools) {
        const CutterArea& cleared = reach.cleared();
        table.row(reach.tool_id, in.area(cleared.coverable_area_mm2), in.area(reach.collision_free_area_mm2),
                  in.volume(cleared.access_volume_mm3), whyNotAll(reach));
    }
    return std::move(table).element();
}

/// What holders keep from tools, and who reaches it.
std::optional<Element> lumpsTable(const ToolSequence& sequence, const Measures& in) {
    Table table({"tool", numbersIn(in.areaUnit(), "kept from it"), "surrogates that reach it", "why"});
    for (const ToolReach& reach : sequence.tools) {
        if (reach.surrogates() == nullptr) continue;
        for (const BlockedLump& lump : reach.surrogates()->lumps)
            table.row(reach.tool_id, in.area(lump.area_mm2),
                      lump.surrogates.empty() ? "several together" : listed(lump.surrogates), lump.reason);
    }
    return std::move(table).elementIfAny();
}

std::string surrogateWords(const DagEdge& edge, const Measures& in) {
    std::string words;
    for (const SurrogateWork& work : edge.surrogates)
        words += fmt::format("{}{}: {} {}, {}", words.empty() ? "" : "; ", work.tool, in.area(work.area_mm2),
                             in.areaUnit(), clockTime(work.totals.time_s()));
    return words;
}

/// "taken", "runner-up", "last" for an edge to the sink.
std::string wayWords(const DagEdge& edge, const DagWay& chosen, const DagWay& second) {
    const std::pair ends{edge.from, edge.to};
    std::string last = edge.to.empty() ? "may be the last" : "";
    if (chosen.contains(ends)) return edge.to.empty() ? "taken, the last" : "taken";
    if (second.contains(ends)) return edge.to.empty() ? "runner-up, the last" : "runner-up";
    return last;
}

Element edgesTable(const ReportSubject& subject, const ToolSequence& sequence) {
    const Measures& in = subject.in;
    Table table({"after", "tool", numbersIn(in.areaUnit(), "area"), numbersIn(in.wayUnit(), "cut"),
                 numbersIn(in.wayUnit(), "rapid"), "surrogates", numbers("time"),
                 numbersIn(subject.plan.machine.currency.c_str(), "cost"), "way"});
    const DagWays ways = waysOf(subject.plan, sequence);
    const DagWay second = ways.runner_up ? wayAlong(ways.runner_up->nodes) : DagWay{};
    for (const DagEdge& edge : sequence.edges) {
        Element& row = table.row(
            edge.from.empty() ? "nothing yet" : edge.from.name(), edge.to.empty() ? "done" : edge.to.name(),
            in.area(edge.region_area_mm2), in.wayNumber(edge.totals.cut_length_mm),
            in.wayNumber(edge.totals.air_length_mm), surrogateWords(edge, in), clockTime(edge.time_s),
            fixed(edge.cost, 3), wayWords(edge, ways.chosen, second));
        if (ways.chosen.contains({edge.from, edge.to})) row.set("class", "chosen");
    }
    return std::move(table).element();
}

Element choiceTables(const ReportSubject& subject, const ToolSequence& sequence) {
    const std::string pruned =
        fmt::format("{} pairs were never weighed: their lower bounds rule them out.", sequence.pruned_edges);
    return Element("details", Element("summary", "Every tool and every pair that was weighed"),
                   toolsTable(sequence, subject.in), lumpsTable(sequence, subject.in),
                   edgesTable(subject, sequence), Element("p.soft", pruned));
}

/// \param what  "Stays", "Stays in S1.F2.3"
std::vector<Element> residualList(const ToolSequence& sequence, const std::string& what, const Measures& in) {
    std::vector<Element> list;
    for (const Residual& residual : sequence.residual)
        list.push_back(Element(
            "p.bad", fmt::format("{}: {} {}, {} ({}). {}", what, in.area(residual.area_mm2, 3), in.areaUnit(),
                                 in.crumb(residual.volume_mm3), toString(residual.reason), residual.advice)));
    return list;
}

/// All patterns but the one that was taken, with their times.
std::string otherPatterns(const RegionPatterns& patterns) {
    std::vector<std::string> others;
    for (std::size_t i = 1; i < patterns.weighed.size(); ++i) {
        const PatternTime& other = patterns.weighed[i];
        others.push_back(fmt::format("{} {}{}", toString(other.pattern), other.at_least ? "at least " : "",
                                     clockTime(other.time_s)));
    }
    return listed(others);
}

/// Whole paths that were compared at feeds by what they cut, the one that is run first.
std::string comparedAsFed(const Toolpath& path) {
    std::vector<std::string> words;
    for (const FedPattern& fed : path.as_fed)
        words.push_back(fmt::format("{} {}", fed.pattern, clockTime(fed.time_s)));
    return listed(words);
}

std::optional<Element> patternsTable(const std::vector<const Operation*>& operations) {
    Table table({"operation", "tool", numbers("region"), "pattern", numbers("time"), "others", "as fed"});
    for (const Operation* operation : operations) {
        int region = 0;
        for (const RegionPatterns& patterns : operation->path.regions) {
            const PatternTime& taken = patterns.weighed.front();
            ++region;
            table.row(linkTo(operationAnchor(operation->id), operation->id), operation->tool_id,
                      std::to_string(region), toString(taken.pattern), clockTime(taken.time_s),
                      otherPatterns(patterns), region == 1 ? comparedAsFed(operation->path) : "");
        }
    }
    if (table.empty()) return std::nullopt;
    return Element("details", Element("summary", "Patterns weighed"), std::move(table).element());
}

Element stepFigure(const PlannedFeature& planned, std::size_t index, const Operation& operation,
                   const Measures& in) {
    const SequenceStep& step = planned.sequence.steps[index];
    const Toolpath& path = operation.path;
    const double depth_mm = operation.z_top_mm - operation.z_floor_mm;
    const std::string words = fmt::format(
        "{}. {} ({}): {} {} new ({} {}), {} layers of {}, {}", index + 1, step.tool_id, toString(step.role),
        in.area(step.area.new_area_mm2), in.areaUnit(), in.volume(step.area.new_area_mm2 * depth_mm),
        in.volumeUnit(), path.depths, in.length(path.step_down_mm), clockTime(operation.timeS()));
    return Element("figure", stepDrawing(planned, index, path), Element("figcaption", words));
}

Element stepFigures(const PlannedFeature& planned, const std::vector<const Operation*>& operations,
                    const Measures& in) {
    const std::size_t steps = planned.sequence.steps.size();
    STEPMILL_CHECK(operations.size() == steps, "every step is one operation");
    Element figures("div.pairs");
    for (std::size_t i = 0; i < steps; ++i)
        figures.add(stepFigure(planned, i, *operations[i], in));
    if (steps == 0)
        figures.add(Element("figure", unmachinedDrawing(planned), Element("figcaption", "Not machined.")));
    return figures;
}

/// What a band's steps sweep, and all that was weighed.
std::vector<Element> bandContent(ReportSubject& subject, const PlannedSetup& setup,
                                 const PlannedFeature& planned) {
    const std::vector<const Operation*> operations = operationsOf(setup, planned.feature.id);
    std::vector<Element> content{stepFigures(planned, operations, subject.in)};
    if (std::optional<Element> patterns = patternsTable(operations)) content.push_back(std::move(*patterns));
    const std::optional<Element> figures[] = {dagDrawing(subject.plan, planned.sequence, subject.in),
                                              areaFigures(planned, subject.in, subject.area_room),
                                              changeTimeChart(subject.plan, planned.sequence)};
    for (const std::optional<Element>& figure : figures)
        if (figure) content.push_back(*figure);
    content.push_back(choiceTables(subject, planned.sequence));
    return content;
}

Element bandFold(ReportSubject& subject, const PlannedSetup& setup, const PlannedFeature& planned) {
    const Measures& in = subject.in;
    const Feature& band = planned.feature;
    const std::string words = fmt::format(
        "{} · {} · from {} to {} {} · {} {} · {} · {}", band.id, toString(band.feature_class),
        in.number(band.top_z_mm, 3), in.number(band.floor_z_mm, 3), in.unit(), in.area(band.area_mm2, 1),
        in.areaUnit(), toolWords(planned.sequence), clockTime(planned.sequence.time_s));
    return Element("details.band", Element("summary", words), bandContent(subject, setup, planned))
        .at(bandAnchor(band.id));
}

std::string headWords(const WholeFeature<PlannedFeature>& feature, const Measures& in) {
    std::string words = fmt::format("{} · {} · {} deep", feature.id(), classWords(feature, in),
                                    in.length(feature.depth_mm(), 3));
    if (const std::string ground = groundWords(feature.uppermost()); !ground.empty()) words += " · " + ground;
    if (feature.bands.size() > 1) words += fmt::format(" · {} bands", feature.bands.size());
    if (const std::string places = placesOfHoles(feature, in); !places.empty()) words += " · " + places;
    return words;
}

}  // namespace

Element featureSection(ReportSubject& subject, const PlannedSetup& setup,
                       const WholeFeature<PlannedFeature>& feature) {
    Element section("section", Element("h3", headWords(feature, subject.in)));
    section.mark(featureAnchor(feature));
    const bool in_bands = feature.bands.size() > 1;
    for (const PlannedFeature* band : feature.bands)
        section.add(
            residualList(band->sequence, in_bands ? "Stays in " + band->feature.id : "Stays", subject.in));
    for (const PlannedFeature* band : feature.bands) {
        if (in_bands)
            section.add(bandFold(subject, setup, *band));
        else
            section.add(bandContent(subject, setup, *band));
    }
    return section;
}

}  // namespace stepmill::report
