// The section of report.html about one feature: its steps, what stays, and why these tools.

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/html_table.h"
#include "report/page/text.h"
#include "report/plan/feature_drawing.h"
#include "report/plan/html_sections.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// The operations of a feature, which keep the order of its steps.
std::vector<const Operation*> operationsOf(const PlannedSetup& setup, const std::string& feature_id) {
    std::vector<const Operation*> found;
    for (const Operation& operation : setup.operations)
        if (operation.feature_id == feature_id) found.push_back(&operation);
    return found;
}

/// What holders keep from tools, and who reaches it.
std::string lumpsTable(const ToolSequence& sequence) {
    std::string rows;
    for (const AccessibleArea& area : sequence.tools) {
        for (const BlockedLump& lump : area.blocked_lumps) {
            const std::string others = lump.surrogates.empty()
                                           ? "several together"
                                           : fmt::format("{}", fmt::join(lump.surrogates, ", "));
            rows += "<tr>" + cell(area.tool_id) + cell(lump.area_mm2, 2) + cell(others) + cell(lump.reason) +
                    "</tr>\n";
        }
    }
    if (rows.empty()) return {};
    return "<table>" + headRow({"tool", "#kept from it mm²", "surrogates that reach it", "why"}) + rows +
           "</table>\n";
}

std::string surrogateWords(const DagEdge& edge) {
    std::string words;
    for (const SurrogateWork& work : edge.surrogates)
        words += fmt::format("{}{}: {:.2f} mm², {}", words.empty() ? "" : "; ", work.tool, work.area_mm2,
                             clockTime(work.time_s));
    return words;
}

std::string choiceTables(const PlannedFeature& planned) {
    const ToolSequence& sequence = planned.sequence;
    std::string html =
        "<details><summary>Every tool and every pair that was weighed</summary>\n<table>" +
        headRow({"tool", "#coverable mm²", "#of it free of the holder", "#volume cm³", "why not"});
    for (const AccessibleArea& area : sequence.tools)
        html += "<tr>" + cell(area.tool_id) + cell(area.coverable_area_mm2, 2) +
                cell(area.collision_free_area_mm2, 2) + cell(area.access_volume_mm3 / 1000, 3) +
                cell(area.excluded ? area.excluded->text : area.limited) + "</tr>\n";
    html += "</table>\n" + lumpsTable(sequence) + "<table>" +
            headRow({"after", "tool", "#area mm²", "#cut m", "#rapid m", "surrogates", "#time", "#cost"});
    std::set<std::pair<std::string, std::string>> chosen;
    std::string previous;
    for (const SequenceStep& step : sequence.steps) {
        if (step.role == Role::Surrogate || step.tool_id == previous) continue;
        chosen.insert({previous, step.tool_id});
        previous = step.tool_id;
    }
    for (const DagEdge& edge : sequence.edges)
        html += fmt::format("<tr{}>", chosen.count({edge.from, edge.to}) != 0 ? " class=\"chosen\"" : "") +
                cell(edge.from.empty() ? "nothing yet" : edge.from) +
                cell(edge.to.empty() ? "done" : edge.to) + cell(edge.region_area_mm2, 2) +
                cell(edge.totals.cut_length_mm / 1000, 2) + cell(edge.totals.air_length_mm / 1000, 2) +
                cell(surrogateWords(edge)) + numberCell(clockTime(edge.time_s)) + cell(edge.cost, 3) +
                "</tr>\n";
    return html + "</table></details>\n";
}

std::string residualList(const PlannedFeature& planned) {
    std::string html;
    for (const Residual& residual : planned.sequence.residual)
        html += fmt::format("<p class=\"bad\">Stays: {:.3f} mm², {:.2f} mm³ ({}). {}</p>\n",
                            residual.area_mm2, residual.volume_mm3, escapeHtml(toString(residual.reason)),
                            escapeHtml(residual.advice));
    return html;
}

std::string patternsTable(const std::vector<const Operation*>& operations) {
    std::string rows;
    for (const Operation* operation : operations) {
        int region = 0;
        for (const RegionPatterns& patterns : operation->path.regions) {
            std::string others;
            for (std::size_t i = 1; i < patterns.weighed.size(); ++i) {
                const PatternTime& other = patterns.weighed[i];
                others += fmt::format("{}{} {}{}", i > 1 ? ", " : "", toString(other.pattern),
                                      other.at_least ? "at least " : "", clockTime(other.time_s));
            }
            const PatternTime& taken = patterns.weighed.front();
            rows += "<tr>" + cell(operation->id) + cell(operation->tool_id) +
                    numberCell(std::to_string(++region)) + cell(toString(taken.pattern)) +
                    numberCell(clockTime(taken.time_s)) + cell(others) + "</tr>\n";
        }
    }
    if (rows.empty()) return {};
    return "<details><summary>Patterns weighed</summary><table>" +
           headRow({"operation", "tool", "#region", "pattern", "#time", "others"}) + rows +
           "</table></details>\n";
}

}  // namespace

std::string featureHtml(const PlannedSetup& setup, const PlannedFeature& planned) {
    const Feature& feature = planned.feature;
    std::string html =
        fmt::format("<section><h3>{} &middot; {} &middot; {:.3f} mm deep</h3>\n", escapeHtml(feature.id),
                    escapeHtml(toString(feature.feature_class)), feature.depth_mm());
    html += residualList(planned) + "<div class=\"steps\">\n";
    const std::vector<const Operation*> operations = operationsOf(setup, feature.id);
    STEPMILL_CHECK(operations.size() == planned.sequence.steps.size(), "every step is one operation");
    for (std::size_t i = 0; i < planned.sequence.steps.size(); ++i) {
        const SequenceStep& step = planned.sequence.steps[i];
        const Operation* operation = operations[i];
        const double depth_mm = operation->z_top_mm - operation->z_floor_mm;
        html += fmt::format(
            "<figure>{}<figcaption>{}. {} ({}): {:.2f} mm² new ({:.3f} cm³), {} layers of {:.2f} mm, "
            "{}</figcaption>"
            "</figure>\n",
            stepDrawing(planned, i, operation->path), i + 1, escapeHtml(step.tool_id),
            escapeHtml(toString(step.role)), step.area.new_area_mm2, step.area.new_area_mm2 * depth_mm / 1000,
            operation->path.layers, operation->path.step_down_mm, clockTime(operation->path.totals.time_s()));
    }
    if (planned.sequence.steps.empty())
        html += "<figure>" + unmachinedDrawing(planned) + "<figcaption>Not machined.</figcaption></figure>\n";
    return html + "</div>\n" + patternsTable(operations) + choiceTables(planned) + "</section>\n";
}

}  // namespace stepmill
