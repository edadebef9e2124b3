#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/feature_drawing.h"
#include "report/text.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/post/post.h"
#include "stepmill/report/part_views.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

constexpr const char* kStyle = R"css(
:root { --ink:#1d2733; --soft:#5d6b7a; --line:#d5dce3; --paper:#fff; --accent:#0b6e99; --bad:#b3261e; }
* { box-sizing:border-box; }
body { font:14px/1.45 "DejaVu Sans",Helvetica,Arial,sans-serif; color:var(--ink); background:#eef1f4; margin:0; }
main { max-width:1080px; margin:0 auto; background:var(--paper); padding:28px 36px 48px; }
h1 { font-size:26px; margin:0 0 2px; } h2 { font-size:18px; margin:34px 0 10px; border-bottom:2px solid var(--ink); }
h3 { font-size:15px; margin:24px 0 6px; } p { margin:4px 0 10px; } .soft { color:var(--soft); }
.cards { display:flex; flex-wrap:wrap; gap:10px; margin:18px 0; }
.card { flex:1 1 130px; border:1px solid var(--line); border-radius:6px; padding:9px 12px; }
.card b { display:block; font-size:20px; } .card span { color:var(--soft); font-size:12px; }
table { border-collapse:collapse; width:100%; font-size:12.5px; margin:6px 0 12px; }
th { text-align:left; border-bottom:1.5px solid var(--ink); padding:3px 8px 3px 0; vertical-align:bottom; }
td { border-bottom:1px solid var(--line); padding:3px 8px 3px 0; vertical-align:top; }
td.n, th.n { text-align:right; font-variant-numeric:tabular-nums; white-space:nowrap; }
tr.chosen td { background:#e6f3f8; font-weight:600; }
.views, .steps { display:grid; grid-template-columns:repeat(2,1fr); gap:14px; }
figure { margin:0; border:1px solid var(--line); border-radius:6px; padding:8px; break-inside:avoid; }
figcaption { font-size:12px; color:var(--soft); padding-top:5px; }
svg { width:100%; height:290px; display:block; } .wide svg { height:380px; }
svg path, svg circle { vector-effect:non-scaling-stroke; fill:none; }
.visible { stroke:#1d2733; stroke-width:1.1; } .hidden { stroke:#9aa7b4; stroke-width:.6; stroke-dasharray:3 2.5; }
svg .obstruction { fill:#c3ccd5; stroke:#8f9ba7; stroke-width:.5; } svg .target { fill:#fdf6df; } svg .fixture { fill:#e3d3e8; stroke:#8a6b95; stroke-width:.5; }
svg .swept { fill:#8ec9e3; fill-opacity:.55; } .wall { stroke:#1d2733; stroke-width:1.6; }
.open-edge { stroke:#2e8b57; stroke-width:1.6; stroke-dasharray:6 3; } .cut { stroke:#0b4f75; stroke-width:.8; }
svg .residual { fill:#d93025; stroke:#b3261e; stroke-width:.6; }
svg .tint { stroke:#1d2733; stroke-width:.9; fill-opacity:.75; }
svg .tint0{fill:#8ec9e3} svg .tint1{fill:#f4c97a} svg .tint2{fill:#a7d8a1} svg .tint3{fill:#e3a6a1}
svg .tint4{fill:#c3b1e1} svg .tint5{fill:#f2e394} svg .tint6{fill:#9adbd1} svg .tint7{fill:#e6b8d3}
.warn { border-left:4px solid #e0a100; background:#fff8e1; padding:5px 10px; margin:5px 0; font-size:13px; }
.bad { color:var(--bad); } details summary { cursor:pointer; color:var(--accent); font-size:12.5px; }
.key i { display:inline-block; width:16px; height:10px; margin:0 4px 0 12px; border:1px solid #8f9ba7; }
@media print { body { background:#fff; font-size:11px; } main { max-width:none; padding:0; } h2 { break-after:avoid; }
  section { break-inside:auto; } svg { height:225px; } details { display:none; } @page { size:A4; margin:14mm; } }
)css";

std::string cell(const std::string& text) {
    return "<td>" + escapeHtml(text) + "</td>";
}
std::string cell(double value, int decimals) {
    return fmt::format("<td class=\"n\">{:.{}f}</td>", value, decimals);
}
std::string numberCell(const std::string& text) {
    return "<td class=\"n\">" + escapeHtml(text) + "</td>";
}

std::string headRow(const std::vector<std::string>& names) {
    std::string row = "<tr>";
    for (const std::string& name : names) {
        const bool numeric = !name.empty() && name.front() == '#';
        row += fmt::format("<th{}>{}</th>", numeric ? " class=\"n\"" : "",
                           escapeHtml(numeric ? name.substr(1) : name));
    }
    return row + "</tr>\n";
}

std::string card(const std::string& value, const std::string& label) {
    return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escapeHtml(value),
                       escapeHtml(label));
}

std::string times(double value_s, double bound_s) {
    return bound_s > 0 ? fmt::format("{:.2f}", value_s / bound_s) : std::string("-");
}

/// The operations of a feature, which keep the order of its steps.
std::vector<const Operation*> operationsOf(const PlannedSetup& setup, const std::string& feature_id) {
    std::vector<const Operation*> found;
    for (const Operation& operation : setup.operations)
        if (operation.feature_id == feature_id) found.push_back(&operation);
    return found;
}

std::string headSection(const Plan& plan) {
    const Vec3 size = plan.part.bbox_mm.sizes();
    const PlanTotals& totals = plan.totals;
    std::string html = fmt::format(
        "<h1>{}</h1>\n<p class=\"soft\">{} &middot; {:.2f} &times; {:.2f} &times; {:.2f} mm "
        "(file unit: {}) &middot; {} &middot; {} &middot; tools: {}</p>\n",
        escapeHtml(plan.part.name), escapeHtml(plan.part.file), size.x(), size.y(), size.z(),
        escapeHtml(plan.part.unit_in_file), escapeHtml(plan.material), escapeHtml(plan.machine.name),
        escapeHtml(plan.library.file));
    html += "<div class=\"cards\">\n";
    html += card(clockTime(totals.time_s), "machining time");
    if (plan.machine.acceleration_mm_per_s2 > 0)
        html += card(clockTime(totals.motion_s), "of it with the machine's acceleration");
    html += card(fmt::format("{:.2f} {}", totals.cost, plan.machine.currency), "machine and tool cost");
    html += card(times(totals.time_s, totals.lower_bound_s), "times the least possible with these tools");
    html += card(std::to_string(totals.tool_changes), "tool changes");
    html += card(fmt::format("{:.1f} %", totals.time_s > 0 ? 100 * totals.air_s / totals.time_s : 0.0),
                 "of it rapids");
    html += card(fmt::format("{:.2f} cm³", plan.balance.planned_mm3 / 1000), "removed");
    html += card(fmt::format("{:.3f} cm³", (plan.balance.residual_mm3 + plan.balance.unreachable_mm3) / 1000),
                 "stays or is out of reach");
    html += "</div>\n";
    for (const Warning& warning : plan.warnings)
        html += fmt::format("<div class=\"warn\"><b>{}</b>: {}</div>\n", escapeHtml(warning.subject),
                            escapeHtml(warning.text));
    return html;
}

std::string viewsSection(const Plan& plan, const PlannedSetup& setup) {
    std::string html = "<h2>The part as it stands in " + setup.setup.id + "</h2>\n<div class=\"views\">\n";
    for (const View& view : partViews(plan.part, setup.setup.part_to_setup))
        html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", view.svg, view.title);
    return html + "</div>\n";
}

/// What choosing the features' tools together brought; nothing where it changed nothing.
std::string sharingWords(const Plan& plan) {
    const ToolSharing& sharing = plan.sharing;
    if (sharing.features_changed == 0) return {};
    const std::string saved =
        plan.objective == Objective::Time
            ? clockTime(std::abs(sharing.saved))
            : fmt::format("{:.2f} {}", std::abs(sharing.saved), escapeHtml(plan.machine.currency));
    return fmt::format(
        "<p>Tools shared: {} features take other tools than their own cheapest; {} tool changes instead of "
        "{}, "
        "{} tools instead of {}, {} {}.</p>\n",
        sharing.features_changed, sharing.visits, sharing.visits_alone, sharing.tools, sharing.tools_alone,
        saved, sharing.saved >= 0 ? "saved" : "more, for the magazine's places");
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
        setup.setup.id, axisName(setup.setup.axis),
        setup.setup.indexed ? " (indexed: not along the box)" : "", size.x(), size.y(), size.z(),
        programName(setup.setup.id, dialect), clockTime(setup.time_s), setup.clamping.text);
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
                numberCell(times(planned.sequence.time_s, planned.sequence.lower_bound_s)) + "</tr>\n";
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
        html +=
            fmt::format("<p class=\"bad\">Stays: {:.3f} mm², {:.2f} mm³ ({}). {}</p>\n", residual.area_mm2,
                        residual.volume_mm3, escapeHtml(residual.reason), escapeHtml(residual.advice));
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

std::string featureSection(const PlannedSetup& setup, const PlannedFeature& planned) {
    const Feature& feature = planned.feature;
    std::string html = fmt::format("<section><h3>{} &middot; {} &middot; {:.3f} mm deep</h3>\n", feature.id,
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

std::string booksSection(const Plan& plan) {
    const VolumeBalance& books = plan.balance;
    std::string html = "<h2>Volume books</h2>\n<table>" + headRow({"account", "reason", "#cm³"});
    const auto row = [](const std::string& account, const std::string& reason, double volume_mm3) {
        return "<tr>" + cell(account) + cell(reason) + cell(volume_mm3 / 1000, 4) + "</tr>\n";
    };
    html += row("stock - part", "", books.stock_minus_part_mm3) + row("planned", "", books.planned_mm3);
    for (const ReasonVolume& entry : books.residual_by_reason)
        html += row("stays", entry.reason, entry.volume_mm3);
    for (const ReasonVolume& entry : books.unreachable_by_reason)
        html += row("in no setup's reach", entry.reason, entry.volume_mm3);
    if (plan.setups.size() > 1) {
        for (const PlannedSetup& setup : plan.setups)
            html +=
                row(setup.setup.id + ": stock as it arrives - part", "", setup.balance.stock_minus_part_mm3) +
                row(setup.setup.id + ": planned", "", setup.balance.planned_mm3);
    }
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features)
            for (const Residual& residual : planned.sequence.residual)
                html += row("left by " + planned.feature.id, residual.reason, residual.volume_mm3);
    return html + fmt::format("</table>\n<p class=\"soft\">Unaccounted: {:.2e} of stock - part.</p>\n",
                              books.gapShare());
}

}  // namespace

std::string reportHtml(const Plan& plan, const Tolerances& tol) {
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                       escapeHtml(plan.part.name) + "</title><style>" + kStyle +
                       "</style></head>\n<body><main>\n";
    html += headSection(plan) + sharingWords(plan);
    if (!plan.complete(tol))
        html += "<p class=\"bad\"><b>This plan has gaps: see what stays, below.</b></p>\n";
    for (const PlannedSetup& setup : plan.setups) {
        html += viewsSection(plan, setup) + setupSection(setup, dialectOf(plan.machine)) +
                toolsTable(plan, setup) + operationsTable(setup);
        html +=
            "<h2>Feature by feature</h2>\n<p class=\"key soft\"><i style=\"background:#c3ccd5\"></i>must stay"
            "<i style=\"background:#fdf6df\"></i>target<i style=\"background:#8ec9e3\"></i>swept by this tool"
            "<i style=\"background:#d93025\"></i>stays after all tools"
            "<i style=\"background:#0b4f75;height:2px\"></i>path, deepest layer"
            "<i style=\"border:0;border-top:2px dashed #2e8b57;height:0\"></i>open edge</p>\n";
        for (const PlannedFeature& planned : setup.features)
            html += featureSection(setup, planned);
    }
    html += booksSection(plan);
    return html + "</main></body></html>\n";
}

}  // namespace stepmill
