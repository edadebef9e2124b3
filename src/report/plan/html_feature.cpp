// The section of report.html about one feature: its steps, what stays, and why these tools.

#include <fmt/format.h>

#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/dag_drawing.h"
#include "report/plan/feature_drawing.h"
#include "report/plan/html_sections.h"
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

Element toolsTable(const ToolSequence& sequence) {
    Table table({"tool", numbers("coverable mm²"), numbers("of it free of the holder"), numbers("volume cm³"),
                 "why not"});
    for (const ToolReach& reach : sequence.tools) {
        const CutterArea& cleared = reach.cleared();
        table.row(reach.tool_id, fixed(cleared.coverable_area_mm2, 2),
                  fixed(reach.collision_free_area_mm2, 2), fixed(cleared.access_volume_mm3 / 1000, 3),
                  whyNotAll(reach));
    }
    return std::move(table).element();
}

/// What holders keep from tools, and who reaches it.
std::optional<Element> lumpsTable(const ToolSequence& sequence) {
    Table table({"tool", numbers("kept from it mm²"), "surrogates that reach it", "why"});
    for (const ToolReach& reach : sequence.tools) {
        if (reach.surrogates() == nullptr) continue;
        for (const BlockedLump& lump : reach.surrogates()->lumps)
            table.row(reach.tool_id, fixed(lump.area_mm2, 2),
                      lump.surrogates.empty() ? "several together" : listed(lump.surrogates), lump.reason);
    }
    return std::move(table).elementIfAny();
}

std::string surrogateWords(const DagEdge& edge) {
    std::string words;
    for (const SurrogateWork& work : edge.surrogates)
        words += fmt::format("{}{}: {:.2f} mm², {}", words.empty() ? "" : "; ", work.tool, work.area_mm2,
                             clockTime(work.time_s));
    return words;
}

Element edgesTable(const ToolSequence& sequence) {
    Table table({"after", "tool", numbers("area mm²"), numbers("cut m"), numbers("rapid m"), "surrogates",
                 numbers("time"), numbers("cost")});
    const DagWay chosen = chosenWay(sequence);
    for (const DagEdge& edge : sequence.edges) {
        Element& row =
            table.row(edge.from.empty() ? "nothing yet" : edge.from, edge.to.empty() ? "done" : edge.to,
                      fixed(edge.region_area_mm2, 2), fixed(edge.totals.cut_length_mm / 1000, 2),
                      fixed(edge.totals.air_length_mm / 1000, 2), surrogateWords(edge),
                      clockTime(edge.time_s), fixed(edge.cost, 3));
        if (chosen.count({edge.from, edge.to}) != 0) row.set("class", "chosen");
    }
    return std::move(table).element();
}

Element choiceTables(const ToolSequence& sequence) {
    return Element("details", Element("summary", "Every tool and every pair that was weighed"),
                   toolsTable(sequence), lumpsTable(sequence), edgesTable(sequence));
}

/// \param what  "Stays", "Stays in S1.F2.3"
std::vector<Element> residualList(const ToolSequence& sequence, const std::string& what) {
    std::vector<Element> list;
    for (const Residual& residual : sequence.residual)
        list.push_back(
            Element("p.bad", fmt::format("{}: {:.3f} mm², {:.2f} mm³ ({}). {}", what, residual.area_mm2,
                                         residual.volume_mm3, toString(residual.reason), residual.advice)));
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

std::optional<Element> patternsTable(const std::vector<const Operation*>& operations) {
    Table table({"operation", "tool", numbers("region"), "pattern", numbers("time"), "others"});
    for (const Operation* operation : operations) {
        int region = 0;
        for (const RegionPatterns& patterns : operation->path.regions) {
            const PatternTime& taken = patterns.weighed.front();
            table.row(linkTo(operationAnchor(operation->id), operation->id), operation->tool_id,
                      std::to_string(++region), toString(taken.pattern), clockTime(taken.time_s),
                      otherPatterns(patterns));
        }
    }
    if (table.empty()) return std::nullopt;
    return Element("details", Element("summary", "Patterns weighed"), std::move(table).element());
}

Element stepFigure(const PlannedFeature& planned, std::size_t index, const Operation& operation) {
    const SequenceStep& step = planned.sequence.steps[index];
    const Toolpath& path = operation.path;
    const double depth_mm = operation.z_top_mm - operation.z_floor_mm;
    const std::string words = fmt::format(
        "{}. {} ({}): {:.2f} mm² new ({:.3f} cm³), {} layers of {:.2f} mm, {}", index + 1, step.tool_id,
        toString(step.role), step.area.new_area_mm2, step.area.new_area_mm2 * depth_mm / 1000, path.depths,
        path.step_down_mm, clockTime(path.totals.time_s()));
    return Element("figure", stepDrawing(planned, index, path), Element("figcaption", words));
}

Element stepFigures(const PlannedFeature& planned, const std::vector<const Operation*>& operations) {
    const std::size_t steps = planned.sequence.steps.size();
    STEPMILL_CHECK(operations.size() == steps, "every step is one operation");
    Element figures("div.pairs");
    for (std::size_t i = 0; i < steps; ++i)
        figures.add(stepFigure(planned, i, *operations[i]));
    if (steps == 0)
        figures.add(Element("figure", unmachinedDrawing(planned), Element("figcaption", "Not machined.")));
    return figures;
}

/// What a band's steps sweep, and all that was weighed.
std::vector<Element> bandContent(const PlannedSetup& setup, const PlannedFeature& planned) {
    const std::vector<const Operation*> operations = operationsOf(setup, planned.feature.id);
    std::vector<Element> content{stepFigures(planned, operations)};
    if (std::optional<Element> patterns = patternsTable(operations)) content.push_back(std::move(*patterns));
    if (std::optional<Element> dag = dagDrawing(planned.sequence)) content.push_back(std::move(*dag));
    content.push_back(choiceTables(planned.sequence));
    return content;
}

Element bandFold(const PlannedSetup& setup, const PlannedFeature& planned) {
    const Feature& band = planned.feature;
    const std::string words =
        fmt::format("{} · {} · from {:.3f} to {:.3f} mm · {:.1f} mm² · {} · {}", band.id,
                    toString(band.feature_class), band.top_z_mm, band.floor_z_mm, band.area_mm2,
                    toolWords(planned.sequence), clockTime(planned.sequence.time_s));
    return Element("details.band", Element("summary", words), bandContent(setup, planned))
        .at(bandAnchor(band.id));
}

std::string headWords(const WholeFeature<PlannedFeature>& feature) {
    std::string words = fmt::format("{} · {} · {:.3f} mm deep", feature.id(),
                                    toString(feature.featureClass()), feature.depth_mm());
    if (feature.bands.size() > 1) words += fmt::format(" · {} bands", feature.bands.size());
    return words;
}

}  // namespace

Element featureSection(const PlannedSetup& setup, const WholeFeature<PlannedFeature>& feature) {
    Element section("section", Element("h3", headWords(feature)));
    section.mark(featureAnchor(feature));
    const bool in_bands = feature.bands.size() > 1;
    for (const PlannedFeature* band : feature.bands)
        section.add(residualList(band->sequence, in_bands ? "Stays in " + band->feature.id : "Stays"));
    for (const PlannedFeature* band : feature.bands) {
        if (in_bands)
            section.add(bandFold(setup, *band));
        else
            section.add(bandContent(setup, *band));
    }
    return section;
}

}  // namespace stepmill::report
