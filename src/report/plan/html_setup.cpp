// Sections of report.html that belong to one setup.

#include <set>

#include <fmt/format.h>

#include "report/page/html_table.h"
#include "report/page/text.h"
#include "report/plan/feature_drawing.h"
#include "report/plan/html_sections.h"
#include "stepmill/report/part_views.h"

namespace stepmill {
namespace {

std::string viewsSection(const Plan& plan, const PlannedSetup& setup) {
    std::string html =
        "<h2>The part as it stands in " + escapeHtml(setup.setup.id) + "</h2>\n<div class=\"views\">\n";
    for (const View& view : partViews(plan.part, setup.setup.part_to_setup))
        html +=
            fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", view.svg, escapeHtml(view.title));
    return html + "</div>\n";
}

std::string setupSection(const PlannedSetup& setup, Dialect dialect) {
    const Vec3 size = setup.setup.stock_bbox_mm.sizes();
    std::string html = fmt::format(
        "<h2>Setup {}</h2>\n<p>Tool axis {}{} of the part. Stock {:.2f} &times; {:.2f} &times; {:.2f} mm as "
        "it "
        "arrives. "
        "Work offset G54: x and y zero at the stock's lower left corner seen from the spindle, z zero on its "
        "top. "
        "Program {}, {}. Clamping: {}.</p>\n",
        escapeHtml(setup.setup.id), escapeHtml(axisName(setup.setup.axis)),
        setup.setup.indexed ? " (indexed: not along the box)" : "", size.x(), size.y(), size.z(),
        escapeHtml(programName(setup.setup.id, dialect)), clockTime(setup.time_s),
        escapeHtml(setup.clamping.text));
    html += fmt::format(
        "<figure class=\"wide\">{}<figcaption>Features seen from the spindle, deeper ones on top."
        "</figcaption></figure>\n",
        setupDrawing(setup));
    html += "<h3>Features</h3>\n<table>" +
            headRow({"id", "class", "after", "#top", "#floor", "#depth mm", "#area mm²", "#volume cm³",
                     "#corner R", "tools", "#time", "#× bound"});
    for (const PlannedFeature& planned : setup.features) {
        const Feature& feature = planned.feature;
        std::string parents;
        for (const std::string& parent : feature.parents)
            parents += (parents.empty() ? "" : ", ") + parent;
        const std::string tools = toolWords(planned.sequence);
        html += "<tr>" + cell(feature.id) + cell(toString(feature.feature_class)) + cell(parents) +
                cell(feature.top_z_mm, 3) + cell(feature.floor_z_mm, 3) + cell(feature.depth_mm(), 3) +
                cell(feature.area_mm2, 1) + cell(feature.volume_mm3 / 1000, 3) +
                numberCell(feature.min_corner_radius_mm ? fmt::format("{:.2f}", *feature.min_corner_radius_mm)
                                                        : "-") +
                cell(tools) + numberCell(clockTime(planned.sequence.time_s)) +
                numberCell(timesBound(planned.sequence.time_s, planned.sequence.lower_bound_s)) + "</tr>\n";
    }
    return html + "</table>\n";
}

/// The stick-out to set, and the range it was chosen from.
std::string stickOutCell(const ToolAssembly& tool) {
    if (!tool.stick_out_range) return cell(tool.stick_out_mm, 1);
    return numberCell(fmt::format("{:.1f} ({:.1f}–{:.1f})", tool.stick_out_mm,
                                  tool.stick_out_range->shortest_mm, tool.stick_out_range->longest_mm));
}

std::string toolsTable(const Plan& plan, const PlannedSetup& setup) {
    std::set<int> seen;
    std::string html =
        "<h3>Tools</h3>\n<table>" + headRow({"#T", "id", "description", "#Ø mm", "#corner R", "#flutes mm",
                                             "#stick-out mm", "holder Ø from–to mm"});
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        if (!seen.insert(tool.number).second) continue;
        std::string holder;
        for (const HolderCylinder& cylinder : tool.holder)
            holder += fmt::format("{}{:.1f}: {:.1f}–{:.1f}", holder.empty() ? "" : ", ", cylinder.diameter_mm,
                                  cylinder.bottom_mm, cylinder.top_mm);
        html += "<tr>" + numberCell(std::to_string(tool.number)) + cell(tool.id) + cell(tool.description) +
                cell(tool.diameter_mm, 3) + cell(tool.corner_radius_mm, 2) + cell(tool.flute_length_mm, 1) +
                stickOutCell(tool) + cell(holder) + "</tr>\n";
    }
    return html + "</table>\n";
}

std::string leavesWords(const FinishAllowance& leaves) {
    if (!leaves.any()) return {};
    return fmt::format(", leaves {:g} on walls, {:g} on the floor", leaves.walls_mm, leaves.floors_mm);
}

std::string operationsTable(const PlannedSetup& setup) {
    std::string html = "<h3>Operations in machining order</h3>\n<table>" +
                       headRow({"id", "feature", "tool", "role", "pattern", "#layers", "#step-down",
                                "#step-over", "#feed", "#plunge", "#rpm", "coolant", "#even m", "#cut m",
                                "#in air m", "#rapid m", "#clear of part µm", "#time", "#with acceleration"});
    for (const Operation& operation : setup.operations) {
        const Toolpath& path = operation.path;
        html += "<tr>" + cell(operation.id) + cell(operation.feature_id) + cell(operation.tool_id) +
                cell(toString(operation.role) + leavesWords(operation.leaves)) + cell(path.pattern) +
                numberCell(std::to_string(path.layers)) + cell(path.step_down_mm, 2) +
                cell(path.step_over_mm, 2) + cell(path.feed_mm_per_min, 0) +
                cell(path.plunge_feed_mm_per_min, 0) + cell(operation.speed_rpm, 0) +
                cell(toString(operation.coolant)) + cell(operation.even_length_mm / 1000, 2) +
                cell(path.totals.cut_length_mm / 1000, 2) + cell(path.totals.feed_air_length_mm / 1000, 2) +
                cell(path.totals.air_length_mm / 1000, 2) +
                (path.pattern == "drill"
                     ? numberCell("-")
                     : numberCell(fmt::format("{:.2f}", 1000 * operation.proof.least_clearance_mm))) +
                numberCell(clockTime(path.totals.time_s())) +
                numberCell(clockTime(path.totals.motion_time_s)) + "</tr>\n";
    }
    return html + "</table>\n";
}

}  // namespace

std::string timesBound(double value_s, double bound_s) {
    return bound_s > 0 ? fmt::format("{:.2f}", value_s / bound_s) : std::string("-");
}

std::string setupHtml(const Plan& plan, const PlannedSetup& setup, Dialect dialect) {
    return viewsSection(plan, setup) + setupSection(setup, dialect) + toolsTable(plan, setup) +
           operationsTable(setup);
}

}  // namespace stepmill
