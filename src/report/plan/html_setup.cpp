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
#include "report/plan/tool_charts.h"
#include "stepmill/plan/feature_times.h"

namespace stepmill::report {
namespace {

std::string toleranceWords(const Stock& stock, const Measures& in) {
    if (stock.tolerance_mm <= 0) return {};
    return fmt::format(" (sides that are still raw may each stand out {} more)",
                       in.length(stock.tolerance_mm));
}

std::string setupWords(const ReportSubject& subject, const PlannedSetup& setup) {
    if (setup.operations.empty())
        return fmt::format("Tool axis {} of the part. Nothing can be cut from here: there is no program.",
                           axisName(setup.setup.axis));
    return fmt::format(
        "Tool axis {}{} of the part. Stock {} as it arrives{}. Work offset G54: x and y zero at the stock's "
        "lower left corner seen from the spindle, z zero on its top. Program {}, {}. Clamping: {}.",
        axisName(setup.setup.axis), setup.setup.indexed ? " (indexed: not along the box)" : "",
        subject.in.size(setup.setup.stock_bbox_mm.sizes()), toleranceWords(setup.setup.stock, subject.in),
        programName(setup.setup.id, subject.dialect), clockTime(setup.time_s), setup.clamping.text);
}

Element setupFigure(const PlannedSetup& setup) {
    std::string words = "Features seen from the spindle, deeper ones on top.";
    if (!setup.reserve.empty()) words += " Dashed: where stock stays, for later setups or to hold the part.";
    return Element("figure.wide", setupDrawing(setup), Element("figcaption", words));
}

/// The smallest of all bands; "-" where none has one.
std::string cornerWords(const WholeFeature<PlannedFeature>& feature, const Measures& in) {
    std::optional<double> least_mm;
    for (const PlannedFeature* band : feature.bands)
        if (const std::optional<double>& radius_mm = band->feature.min_corner_radius_mm)
            least_mm = std::min(least_mm.value_or(*radius_mm), *radius_mm);
    return least_mm ? in.number(*least_mm) : "-";
}

/// Seen from above: of the band that covers most.
double areaMm2(const WholeFeature<PlannedFeature>& feature) {
    double area_mm2 = 0;
    for (const PlannedFeature* band : feature.bands)
        area_mm2 = std::max(area_mm2, band->feature.area_mm2);
    return area_mm2;
}

/// A row for each, with all its bands.
Element featuresTable(const ReportSubject& subject, const PlannedSetup& setup) {
    const Measures& in = subject.in;
    Table table({"id", "class", "after", numbersIn(in.unit(), "top"), numbersIn(in.unit(), "floor"),
                 numbersIn(in.unit(), "depth"), numbersIn(in.areaUnit(), "area"),
                 numbersIn(in.volumeUnit(), "volume"), numbersIn(in.unit(), "corner R"), "tools",
                 numbers("time"), numbers("× bound")});
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features)) {
        const FeatureTimes times = timesOf(feature, setup.operations, subject.plan.machine);
        table.row(linkTo(featureAnchor(feature), feature.id()), classWords(feature, in),
                  listed(feature.uppermost().parents), in.number(feature.uppermost().top_z_mm, 3),
                  in.number(feature.lowest().floor_z_mm, 3), in.number(feature.depth_mm(), 3),
                  in.area(areaMm2(feature), 1), in.volume(feature.volume_mm3()), cornerWords(feature, in),
                  breakable(toolWords(feature)), clockTime(times.time_s),
                  timesBound(times.time_s, times.lower_bound_s));
    }
    return std::move(table).element();
}

/// The stick-out to set, and the range it was chosen from.
std::string stickOutWords(const ToolAssembly& tool, const Measures& in) {
    if (!tool.stick_out_range) return in.number(tool.stick_out_mm, 1);
    return fmt::format("{} ({}–{})", in.number(tool.stick_out_mm, 1),
                       in.number(tool.stick_out_range->shortest_mm, 1),
                       in.number(tool.stick_out_range->longest_mm, 1));
}

/// The holder's cylinders; a plan's tools stand in the machine, so the nose's follow them.
std::string holderWords(const ToolAssembly& tool, const Machine& machine, const Measures& in) {
    std::vector<std::string> cylinders;
    const std::size_t own = tool.holder.size() - std::min(tool.holder.size(), machine.spindle_nose.size());
    for (const HolderCylinder& cylinder : std::span(tool.holder).first(own))
        cylinders.push_back(fmt::format("{}: {}–{}", in.number(cylinder.diameter_mm, 1),
                                        in.number(cylinder.bottom_mm, 1), in.number(cylinder.top_mm, 1)));
    if (own < tool.holder.size())
        cylinders.push_back("spindle nose from " + in.number(tool.holder[own].bottom_mm, 1));
    return listed(cylinders);
}

Element toolsTable(const ReportSubject& subject, const PlannedSetup& setup) {
    const Plan& plan = subject.plan;
    const Measures& in = subject.in;
    std::set<int> seen;
    Table table({numbers("T"), "id", "description", numbersIn(in.unit(), "Ø"),
                 numbersIn(in.unit(), "corner R"), numbersIn(in.unit(), "flutes"),
                 numbersIn(in.unit(), "stick-out"), std::string("holder Ø from–to ") + in.unit()});
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        if (!seen.insert(tool.number).second) continue;
        table.row(std::to_string(tool.number), breakable(tool.id), breakable(tool.description),
                  in.number(tool.diameter_mm, 3), in.number(tool.corner_radius_mm),
                  in.number(tool.flute_length_mm, 1), stickOutWords(tool, in),
                  holderWords(tool, plan.machine, in));
    }
    return std::move(table).element();
}

std::string leavesWords(const FinishAllowance& leaves, const Measures& in) {
    if (!leaves.any()) return {};
    return fmt::format(", leaves {} on walls, {} on the floor", in.length(leaves.walls_mm),
                       in.length(leaves.floors_mm));
}

std::string roleWords(const Operation& operation, const Measures& in) {
    const std::string thread = operation.thread ? " " + operation.thread->thread.name : "";
    return toString(operation.role) + thread + leavesWords(operation.leaves, in);
}

std::string clearanceWords(const Operation& operation, const Measures& in) {
    if (operation.holes > 0) return "-";
    return in.fine(operation.proof.least_clearance_mm);
}

Element operationsTable(const ReportSubject& subject, const PlannedSetup& setup) {
    const Measures& in = subject.in;
    Table table({"id", "feature", "tool", "role", "pattern", numbers("layers"),
                 numbersIn(in.unit(), "step-down"), numbersIn(in.unit(), "step-over"),
                 numbersIn(in.feedUnit(), "feed"), numbersIn(in.feedUnit(), "plunge"), numbers("rpm"),
                 "coolant", numbersIn(in.wayUnit(), "even"), numbersIn(in.wayUnit(), "cut"),
                 numbersIn(in.wayUnit(), "in air"), numbersIn(in.wayUnit(), "rapid"),
                 numbersIn(in.fineUnit(), "clear of part"), numbers("time"), numbers("with acceleration")});
    for (const Operation& operation : setup.operations) {
        const Toolpath& path = operation.path;
        const PathTotals& totals = path.totals;
        table
            .row(operation.id, linkTo(workAnchor(operation), operation.feature_id),
                 breakable(operation.tool_id), roleWords(operation, in), path.pattern,
                 std::to_string(path.depths), in.number(path.step_down_mm), in.number(path.step_over_mm),
                 in.feed(path.feed_mm_per_min), in.feed(path.plunge_feed_mm_per_min),
                 fixed(operation.speed_rpm, 0), toString(operation.coolant),
                 in.wayNumber(operation.even_length_mm), in.wayNumber(totals.cut_length_mm),
                 in.wayNumber(totals.feed_air_length_mm), in.wayNumber(totals.air_length_mm),
                 clearanceWords(operation, in), clockTime(operation.timeS()), clockTime(operation.motionS()))
            .mark(operationAnchor(operation.id));
    }
    return std::move(table).element();
}

/// Why feeds go by nothing but the library.
std::string whyLibraryFeeds(const Plan& plan) {
    if (plan.request.sequence.cut_material) return "the machine's file tells no spindle";
    if (plan.request.materials_file.empty()) return "as was asked for (--library-feeds)";
    return fmt::format("{} does not say what cuts of {} ask for", plan.request.materials_file, plan.material);
}

/// What feeds go by.
std::string cutsWords(const Plan& plan) {
    const std::optional<Material>& material = plan.request.sequence.cut_material;
    if (!material || plan.machine.spindle_curve.empty())
        return fmt::format("Feeds are the library's, whatever is cut: {}.", whyLibraryFeeds(plan));
    return fmt::format(
        "Feeds follow what each move cuts of {} (kc1.1 {:g} N/mm², mc {:g}: {}). Power is that of "
        "the spindle's motor.",
        material->name, material->kc11_n_per_mm2, material->mc, material->source);
}

std::string percent(double share) {
    return fixed(100 * share, 0);
}

/// What the cuts ask of spindle and tools.
Element cutsTable(const PlannedSetup& setup, const Measures& in) {
    Table table({"id", "tool", numbers("peak kW"), numbers("mean kW"), "ruled by",
                 numbersIn(in.fineUnit(), "bends"), numbers("% in air"), numbers("to ¼ D"), numbers("to ½ D"),
                 numbers("to ¾ D"), numbers("to D")});
    for (const Operation& operation : setup.operations) {
        if (!operation.rating) continue;
        const CutSummary& cuts = operation.cuts;
        table.row(operation.id, operation.tool_id, fixed(cuts.peak_kw, 2), fixed(cuts.mean_kw, 2),
                  toString(cuts.limit), in.fine(cuts.deflection_mm), percent(cuts.length_shares[0]),
                  percent(cuts.length_shares[1]), percent(cuts.length_shares[2]),
                  percent(cuts.length_shares[3]), percent(cuts.length_shares[4]));
    }
    return std::move(table).element();
}

/// Is some operation's feed by what it cuts?
bool hasRatings(const PlannedSetup& setup) {
    return std::any_of(setup.operations.begin(), setup.operations.end(),
                       [](const Operation& operation) { return operation.rating.has_value(); });
}

/// How the order was found; nothing where there is nothing to order.
std::optional<Element> ordersWords(const PlannedSetup& setup, const Measures& in) {
    if (setup.orders.empty() || setup.operations.size() < 2) return std::nullopt;
    std::string words;
    for (const WeighedOrder& order : setup.orders)
        words += fmt::format("{}{}: {}", words.empty() ? "Rapids between operations, " : "; ",
                             toString(order.rule), in.length(order.travel_mm, 0));
    return Element("p.soft", words + ". The first is taken.");
}

/// What the colours and lines of a feature's pictures stand for.
Element keys() {
    return Element("p.keys.soft", Element("i.stays"), "must stay", Element("i.target"), "target",
                   Element("i.swept"), "swept by this tool", Element("i.residual"), "stays after all tools",
                   Element("i.path"), "path, deepest layer", Element("i.open"), "open edge");
}

}  // namespace

Element setupSection(ReportSubject& subject, const PlannedSetup& setup) {
    const std::string& id = setup.setup.id;
    Element section("section", Element("h2", "The part as it stands in " + id),
                    figuresOf(partDrawings(subject.part, setup.setup.part_to_setup)),
                    Element("h2", "Setup " + id), Element("p", setupWords(subject, setup)),
                    setupFigure(setup));
    section.mark(setupAnchor(id));
    section.add(Element("h3", "Features"), featuresTable(subject, setup), Element("h3", "Tools"),
                toolsTable(subject, setup), toolCharts(subject.plan, setup, subject.in),
                Element("h3", "Operations in machining order"), ordersWords(setup, subject.in),
                operationsTable(subject, setup), Element("h3", "Cuts"),
                Element("p.soft", cutsWords(subject.plan)));
    if (hasRatings(setup)) section.add(cutsTable(setup, subject.in));
    section.add(Element("h2", "Feature by feature"), keys());
    for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features))
        section.add(featureSection(subject, setup, feature));
    if (setup.form) section.add(formSection(subject, setup));
    if (setup.edges) section.add(edgeSection(subject, setup));
    return section;
}

}  // namespace stepmill::report
