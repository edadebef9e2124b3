#include <fmt/format.h>

#include "report/page/html_page.h"
#include "report/page/html_style.h"
#include "report/page/html_table.h"
#include "report/page/text.h"
#include "report/plan/html_sections.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

std::string card(const std::string& value, const std::string& label) {
    return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escapeHtml(value),
                       escapeHtml(label));
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
    html +=
        card(timesBound(totals.time_s, totals.lower_bound_s), "times the least possible with these tools");
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

std::string booksSection(const Plan& plan) {
    const VolumeBalance& books = plan.balance;
    std::string html = "<h2>Volume books</h2>\n<table>" + headRow({"account", "reason", "#cm³"});
    const auto row = [](const std::string& account, const std::string& reason, double volume_mm3) {
        return "<tr>" + cell(account) + cell(reason) + cell(volume_mm3 / 1000, 4) + "</tr>\n";
    };
    html += row("stock - part", "", books.stock_minus_part_mm3) + row("planned", "", books.planned_mm3);
    for (const ReasonVolume& entry : books.residual_by_reason)
        html += row("stays", toString(entry.reason), entry.volume_mm3);
    for (const ReasonVolume& entry : books.unreachable_by_reason)
        html += row("in no setup's reach", toString(entry.reason), entry.volume_mm3);
    if (plan.setups.size() > 1) {
        for (const PlannedSetup& setup : plan.setups)
            html +=
                row(setup.setup.id + ": stock as it arrives - part", "", setup.balance.stock_minus_part_mm3) +
                row(setup.setup.id + ": planned", "", setup.balance.planned_mm3);
    }
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features)
            for (const Residual& residual : planned.sequence.residual)
                html += row("left by " + planned.feature.id, toString(residual.reason), residual.volume_mm3);
    return html + fmt::format("</table>\n<p class=\"soft\">Unaccounted: {:.2e} of stock - part.</p>\n",
                              books.gapShare());
}

}  // namespace

std::string reportHtml(const Plan& plan, const Tolerances& tol) {
    std::string html = pageHead(plan.part.name, kReportStyle);
    html += headSection(plan) + sharingWords(plan);
    if (!plan.complete(tol))
        html += "<p class=\"bad\"><b>This plan has gaps: see what stays, below.</b></p>\n";
    for (const PlannedSetup& setup : plan.setups) {
        html += setupHtml(plan, setup, dialectOf(plan.machine));
        html +=
            "<h2>Feature by feature</h2>\n<p class=\"key soft\"><i class=\"key-stays\"></i>must stay"
            "<i class=\"key-target\"></i>target<i class=\"key-swept\"></i>swept by this tool"
            "<i class=\"key-residual\"></i>stays after all tools"
            "<i class=\"key-path\"></i>path, deepest layer"
            "<i class=\"key-open\"></i>open edge</p>\n";
        for (const PlannedFeature& planned : setup.features)
            html += featureHtml(setup, planned);
    }
    html += booksSection(plan);
    return html + pageEnd();
}

}  // namespace stepmill
