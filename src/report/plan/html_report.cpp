// report.html: head, setups with their features, volume books.

#include <fmt/format.h>

#include "report/page/document.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/plan/html_sections.h"
#include "report/plan/over_bound.h"
#include "report/viewer/viewer_data.h"
#include "report/viewer/viewer_section.h"
#include "stepmill/core/parallel.h"
#include "stepmill/plan/warning_order.h"
#include "stepmill/report/report.h"

namespace stepmill::report {

namespace {

Element card(const std::string& value, const char* label) {
    return Element("div.card", Element("b", value), Element("span", label));
}

std::string volumeWords(const Measures& in, double volume_mm3, int decimals) {
    return in.volume(volume_mm3, decimals) + " " + in.volumeUnit();
}

Element cards(const Plan& plan, const Measures& in) {
    const PlanTotals& totals = plan.totals;
    const VolumeBalance& books = plan.balance;
    Element cards("div.cards", card(clockTime(totals.time_s), "machining time"));
    if (plan.machine.acceleration_mm_per_s2 > 0)
        cards.add(card(clockTime(totals.motion_s), "the same with the machine's acceleration"));
    cards.add(
        card(fixed(totals.cost, 2) + " " + plan.machine.currency, "machine and tool cost"),
        card(timesBound(totals.time_s, totals.lower_bound_s),
             "times the least of any sequence of these tools over these features"),
        card(std::to_string(totals.tool_changes), "tool changes"),
        card(fixed(totals.time_s > 0 ? 100 * totals.air_s / totals.time_s : 0.0, 1) + " %", "of it rapids"),
        card(volumeWords(in, books.planned_mm3, 2), "removed"),
        card(volumeWords(in, books.residual_mm3 + books.unreachable_mm3, 3), "stays or is out of reach"));
    return cards;
}

/// What the minutes over the bound are; nothing without a bound.
std::optional<Element> boundWords(const Plan& plan) {
    const std::string over = overBoundWords(plan);
    if (over.empty()) return std::nullopt;
    return Element("p.soft",
                   fmt::format("No sequences of these tools over these features can take less than {}; {}.",
                               clockTime(plan.totals.lower_bound_s), over));
}

Element partWords(const Plan& plan, const Measures& in) {
    const Part& part = plan.part;
    return Element("p.soft", fmt::format("{} · {} (file unit: {}) · {} · {} · tools: {}", part.file,
                                         in.size(part.bbox_mm.sizes()), part.unit_in_file, plan.material,
                                         plan.machine.name, plan.library.file));
}

Element warningBox(const Warning& warning) {
    return Element("div.warn", Element("b", subjectWords(warning)), ": " + warning.text);
}

bool isGrave(const Warning& warning) {
    const Consequence consequence = consequenceOf(warning);
    return consequence == Consequence::Danger || consequence == Consequence::MissingOnThePart;
}

/// What is dangerous or missing on the part.
std::vector<Element> graveWarnings(const Plan& plan) {
    std::vector<Element> boxes;
    for (const Warning& warning : plan.warnings)
        if (isGrave(warning)) boxes.push_back(warningBox(warning));
    return boxes;
}

/// What costs more or is good to know, folded; nothing without any.
std::optional<Element> otherWarnings(const Plan& plan) {
    std::vector<Element> boxes;
    for (const Warning& warning : plan.warnings)
        if (!isGrave(warning)) boxes.push_back(warningBox(warning));
    if (boxes.empty()) return std::nullopt;
    const std::string words = fmt::format("{} more about cost, and notes", boxes.size());
    return Element("details.band", Element("summary", words), std::move(boxes));
}

/// What choosing the features' tools together brought; nothing where it changed nothing.
std::optional<Element> sharingWords(const Plan& plan) {
    const ToolSharing& sharing = plan.sharing;
    if (sharing.features_changed == 0) return std::nullopt;
    const std::string saved = plan.objective == Objective::Time
                                  ? clockTime(std::abs(sharing.saved))
                                  : fixed(std::abs(sharing.saved), 2) + " " + plan.machine.currency;
    return Element("p", fmt::format("Tools shared: {} {} other tools than their own cheapest; {} instead of "
                                    "{}, {} {}.",
                                    counted(sharing.features_changed, "feature"),
                                    sharing.features_changed == 1 ? "takes" : "take",
                                    counted(sharing.tools, "tool"), sharing.tools_alone, saved,
                                    sharing.saved >= 0 ? "saved" : "more, for the magazine's places"));
}

std::optional<Element> gapsWords(const Plan& plan, const Tolerances& tol) {
    if (plan.complete(tol)) return std::nullopt;
    return Element("p.bad", Element("b", "This plan has gaps: see what stays, below."));
}

/// Links to the setups and the books.
Element contents(const Plan& plan) {
    Element links("nav");
    for (const PlannedSetup& setup : plan.setups)
        links.add(linkTo(setupAnchor(setup.setup.id), "Setup " + setup.setup.id));
    links.add(linkTo(Anchor("part", "books"), "Volume books"));
    return links;
}

/// ", taken by S2".
std::string takerWords(const Residual& residual) {
    return residual.taken_by.empty() ? "" : ", taken by " + residual.taken_by;
}

Element booksSection(const Plan& plan, const Measures& in) {
    const VolumeBalance& books = plan.balance;
    Table table({"account", "reason", numbersIn(in.volumeUnit(), "volume"),
                 numbersIn(in.volumeUnit(), "of it stays")});
    const auto add = [&table, &in](const std::string& account, const std::string& reason, double volume_mm3) {
        table.row(account, reason, in.volume(volume_mm3, 4), "");
    };
    add("stock - part", "", books.stock_minus_part_mm3);
    add("planned", "", books.planned_mm3);
    for (const ReasonVolume& entry : books.residual_by_reason)
        add("stays", toString(entry.reason), entry.volume_mm3);
    for (const ReasonVolume& entry : books.unreachable_by_reason)
        add("in no setup's reach", toString(entry.reason), entry.volume_mm3);
    if (plan.setups.size() > 1) {
        for (const PlannedSetup& setup : plan.setups) {
            add(setup.setup.id + ": stock as it arrives - part", "", setup.balance.stock_minus_part_mm3);
            add(setup.setup.id + ": planned", "", setup.balance.planned_mm3);
        }
    }
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features)
            for (const Residual& residual : planned.sequence.residual)
                table.row("left by " + planned.feature.id + takerWords(residual), toString(residual.reason),
                          in.volume(residual.volume_mm3, 4),
                          in.volume(residual.stays_mm3.value_or(residual.volume_mm3), 4));
    return Element(
               "section", Element("h2", "Volume books"), std::move(table).element(),
               Element("p.soft", fmt::format("Unaccounted: {} of stock - part.", gapWords(books.gapShare()))))
        .at(Anchor("part", "books"));
}

}  // namespace

Anchor setupAnchor(const std::string& setup_id) {
    return {"setup", setup_id};
}
Anchor bandAnchor(const std::string& band_id) {
    return {"feature", band_id};
}
Anchor featureAnchor(const WholeFeature<PlannedFeature>& feature) {
    return {"feature", feature.id()};
}
Anchor operationAnchor(const std::string& operation_id) {
    return {"operation", operation_id};
}

namespace {

/// \param viewer  its section, where the page has one
Element mainOf(const Plan& plan, const FacetedPart& part, bool inch, const Tolerances& tol,
               std::optional<Element> viewer) {
    ReportSubject subject{plan, part, Measures(inch), dialectOf(plan.machine)};
    Element main("main", Element("h1", plan.part.name), partWords(plan, subject.in), cards(plan, subject.in),
                 boundWords(plan), gapsWords(plan, tol), graveWarnings(plan), sharingWords(plan),
                 otherWarnings(plan), contents(plan), std::move(viewer));
    main.add(assignmentSection(subject));
    for (const PlannedSetup& setup : plan.setups)
        main.add(setupSection(subject, setup));
    main.add(booksSection(plan, subject.in));
    return main;
}

}  // namespace
}  // namespace stepmill::report

std::string stepmill::reportHtml(const ProvenPlan& proven, const ReportOptions& options,
                                 const Tolerances& tol) {
    using namespace report;
    const Plan& plan = proven.plan;
    const FacetedPart part(plan.part);
    if (!options.viewer)
        return htmlDocument(plan.part.name, mainOf(plan, part, options.inch, tol, std::nullopt));
    part.solid();  // Both take the facets, side by side.
    std::optional<Element> main;
    std::string data;
    parallelInvoke([&] { main = mainOf(plan, part, options.inch, tol, viewerSection()); },
                   [&] { data = viewerData(proven, part, options.inch); });
    return viewerDocument(plan.part.name, std::move(*main), data);
}

std::string stepmill::reportHtml(const Plan& plan, const Tolerances& tol) {
    return report::htmlDocument(
        plan.part.name, report::mainOf(plan, report::FacetedPart(plan.part), false, tol, std::nullopt));
}
