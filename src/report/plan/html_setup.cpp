// Sections of report.html that belong to one setup.

#include <algorithm>
#include <set>
#include <span>

#include <fmt/format.h>

#include "report/page/part_drawings.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/feature_drawing.h"
#include "report/plan/html_sections.h"
#include "stepmill/plan/feature_times.h"

namespace stepmill::report {
namespace {

std::string toleranceWords(const Stock& stock) {
    if (stock.tolerance_mm <= 0) return {};
    return fmt::format(" (sides that are still raw may each stand out {} mm more)",
                       fixed(stock.tolerance_mm, 2));
}

std::string setupWords(const PlannedSetup& setup, Dialect dialect) {
    return fmt::format(
        "Tool axis {}{} of the part. Stock {} as it arrives{}. Work offset G54: x and y zero at the stock's "
        "lower left corner seen from the spindle, z zero on its top. Program {}, {}. Clamping: {}.",
        axisName(setup.setup.axis), setup.setup.indexed ? " (indexed: not along the box)" : "",
        sizeWords(setup.setup.stock_bbox_mm.sizes()), toleranceWords(setup.setup.stock),
        programName(setup.setup.id, dialect), clockTime(setup.time_s), setup.clamping.text);
}

Element setupFigure(const PlannedSetup& setup) {
    return Element("figure.wide", setupDrawing(setup),
                   Element("figcaption", "Features seen from the spindle, deeper ones on top."));
}

/// The smallest of all bands; "-" where none has one.
std::string cornerWords(const WholeFeature<PlannedFeature>& feature) {
    std::optional<double> least_mm;
    for (const PlannedFeature* band : feature.bands)
        if (const std::optional<double>& radius_mm = band->feature.min_corner_radius_mm)
            least_mm = std::min(least_mm.value_or(*radius_mm), *radius_mm);
    return least_mm ? fixed(*least_mm, 2) : "-";
}

/// Seen from above: of the band that covers most.
double areaMm2(const WholeFeature<PlannedFeature>& feature) {
    double area_mm2 = 0;
    for (const PlannedFeature* band : feature.bands)
        area_mm2 = std::max(area_mm2, band->feature.area_mm2);
    return area_mm2;
}

/// A row for each, with all its bands.
Element featuresTable(const PlannedSetup& setup, const Machine& machine) {
    Table table({"id", "class", "after", numbers("top"), numbers("floor"), numbers("depth mm"),
                 numbers("area mm²"), numbers("volume cm³"), numbers("corner R"), "tools", numbers("time"),
                 numbers("× bound")});
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features)) {
        const FeatureTimes times = timesOf(feature, machine);
        table.row(linkTo(featureAnchor(feature), feature.id()), toString(feature.featureClass()),
                  listed(feature.uppermost().parents), fixed(feature.uppermost().top_z_mm, 3),
                  fixed(feature.lowest().floor_z_mm, 3), fixed(feature.depth_mm(), 3),
                  fixed(areaMm2(feature), 1), fixed(feature.volume_mm3() / 1000, 3), cornerWords(feature),
                  toolWords(feature), clockTime(times.time_s), timesBound(times.time_s, times.lower_bound_s));
    }
    return std::move(table).element();
}

/// The stick-out to set, and the range it was chosen from.
std::string stickOutWords(const ToolAssembly& tool) {
    if (!tool.stick_out_range) return fixed(tool.stick_out_mm, 1);
    return fmt::format("{:.1f} ({:.1f}–{:.1f})", tool.stick_out_mm, tool.stick_out_range->shortest_mm,
                       tool.stick_out_range->longest_mm);
}

/// The holder's cylinders; a plan's tools stand in the machine, so the nose's follow them.
std::string holderWords(const ToolAssembly& tool, const Machine& machine) {
    std::vector<std::string> cylinders;
    const std::size_t own = tool.holder.size() - std::min(tool.holder.size(), machine.spindle_nose.size());
    for (const HolderCylinder& cylinder : std::span(tool.holder).first(own))
        cylinders.push_back(
            fmt::format("{:.1f}: {:.1f}–{:.1f}", cylinder.diameter_mm, cylinder.bottom_mm, cylinder.top_mm));
    if (own < tool.holder.size())
        cylinders.push_back(fmt::format("spindle nose from {:.1f}", tool.holder[own].bottom_mm));
    return listed(cylinders);
}

Element toolsTable(const Plan& plan, const PlannedSetup& setup) {
    std::set<int> seen;
    Table table({numbers("T"), "id", "description", numbers("Ø mm"), numbers("corner R"),
                 numbers("flutes mm"), numbers("stick-out mm"), "holder Ø from–to mm"});
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        if (!seen.insert(tool.number).second) continue;
        table.row(std::to_string(tool.number), tool.id, tool.description, fixed(tool.diameter_mm, 3),
                  fixed(tool.corner_radius_mm, 2), fixed(tool.flute_length_mm, 1), stickOutWords(tool),
                  holderWords(tool, plan.machine));
    }
    return std::move(table).element();
}

std::string leavesWords(const FinishAllowance& leaves) {
    if (!leaves.any()) return {};
    return fmt::format(", leaves {:g} on walls, {:g} on the floor", leaves.walls_mm, leaves.floors_mm);
}

std::string clearanceWords(const Operation& operation) {
    if (operation.path.pattern == "drill") return "-";
    return fixed(1000 * operation.proof.least_clearance_mm, 2);
}

std::string metres(double length_mm) {
    return fixed(length_mm / 1000, 2);
}

Element operationsTable(const PlannedSetup& setup) {
    Table table({"id", "feature", "tool", "role", "pattern", numbers("layers"), numbers("step-down"),
                 numbers("step-over"), numbers("feed"), numbers("plunge"), numbers("rpm"), "coolant",
                 numbers("even m"), numbers("cut m"), numbers("in air m"), numbers("rapid m"),
                 numbers("clear of part µm"), numbers("time"), numbers("with acceleration")});
    for (const Operation& operation : setup.operations) {
        const Toolpath& path = operation.path;
        const PathTotals& totals = path.totals;
        table
            .row(operation.id, linkTo(workAnchor(operation), operation.feature_id), operation.tool_id,
                 toString(operation.role) + leavesWords(operation.leaves), path.pattern,
                 std::to_string(path.depths), fixed(path.step_down_mm, 2), fixed(path.step_over_mm, 2),
                 fixed(path.feed_mm_per_min, 0), fixed(path.plunge_feed_mm_per_min, 0),
                 fixed(operation.speed_rpm, 0), toString(operation.coolant), metres(operation.even_length_mm),
                 metres(totals.cut_length_mm), metres(totals.feed_air_length_mm),
                 metres(totals.air_length_mm), clearanceWords(operation), clockTime(totals.time_s()),
                 clockTime(totals.motion_time_s))
            .mark(operationAnchor(operation.id));
    }
    return std::move(table).element();
}

/// How the order was found; nothing where there is nothing to order.
std::optional<Element> ordersWords(const PlannedSetup& setup) {
    if (setup.orders.empty() || setup.operations.size() < 2) return std::nullopt;
    std::string words;
    for (const WeighedOrder& order : setup.orders)
        words += fmt::format("{}{}: {:.0f} mm", words.empty() ? "Rapids between operations, " : "; ",
                             toString(order.rule), order.travel_mm);
    return Element("p.soft", words + ". The first is taken.");
}

/// What the colours and lines of a feature's pictures stand for.
Element keys() {
    return Element("p.keys.soft", Element("i.stays"), "must stay", Element("i.target"), "target",
                   Element("i.swept"), "swept by this tool", Element("i.residual"), "stays after all tools",
                   Element("i.path"), "path, deepest layer", Element("i.open"), "open edge");
}

}  // namespace

Element setupSection(const Plan& plan, const PlannedSetup& setup, Dialect dialect) {
    const std::string& id = setup.setup.id;
    Element section("section", Element("h2", "The part as it stands in " + id),
                    figuresOf(partDrawings(plan.part, setup.setup.part_to_setup)),
                    Element("h2", "Setup " + id), Element("p", setupWords(setup, dialect)),
                    setupFigure(setup));
    section.mark(setupAnchor(id));
    section.add(Element("h3", "Features"), featuresTable(setup, plan.machine), Element("h3", "Tools"),
                toolsTable(plan, setup), Element("h3", "Operations in machining order"), ordersWords(setup),
                operationsTable(setup), Element("h2", "Feature by feature"), keys());
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features))
        section.add(featureSection(setup, feature));
    if (setup.form) section.add(formSection(setup));
    return section;
}

}  // namespace stepmill::report
