#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/inspect/inspect_words.h"
#include "report/page/html_page.h"
#include "report/page/html_table.h"
#include "report/page/text.h"
#include "stepmill/report/inspection.h"
#include "stepmill/report/part_views.h"

namespace stepmill {

namespace {

/// Tints that the style knows; more features take them by turns.
constexpr int kTints = 8;

constexpr const char* kStyle = R"css(
:root { --ink:#1d2733; --soft:#5d6b7a; --line:#d5dce3; --paper:#fff; --accent:#0b6e99; }
* { box-sizing:border-box; }
body { font:14px/1.45 "DejaVu Sans",Helvetica,Arial,sans-serif; color:var(--ink); background:#eef1f4; margin:0; }
main { max-width:1080px; margin:0 auto; background:var(--paper); padding:28px 36px 48px; }
h1 { font-size:26px; margin:0 0 2px; } h2 { font-size:18px; margin:34px 0 10px; border-bottom:2px solid var(--ink); }
h3 { font-size:15px; margin:24px 0 6px; } p { margin:4px 0 10px; } .soft { color:var(--soft); }
table { border-collapse:collapse; width:100%; font-size:12.5px; margin:6px 0 12px; }
th { text-align:left; border-bottom:1.5px solid var(--ink); padding:3px 8px 3px 0; vertical-align:bottom; }
td { border-bottom:1px solid var(--line); padding:3px 8px 3px 0; vertical-align:top; }
td.n, th.n { text-align:right; font-variant-numeric:tabular-nums; white-space:nowrap; }
td:first-child { white-space:nowrap; }
.views { display:grid; grid-template-columns:repeat(2,1fr); gap:14px; }
figure { margin:0; border:1px solid var(--line); border-radius:6px; padding:8px; break-inside:avoid; }
figcaption { font-size:12px; color:var(--soft); padding-top:5px; }
svg { width:100%; height:300px; display:block; } svg path { vector-effect:non-scaling-stroke; fill:none; }
.visible { stroke:#1d2733; stroke-width:1.1; } .hidden { stroke:#9aa7b4; stroke-width:.5; stroke-dasharray:3 2.5; }
i.key { display:inline-block; width:13px; height:13px; margin-right:6px; border:1px solid #8f9ba7; }
svg .tint0{fill:#8ec9e3} svg .tint1{fill:#f4c97a} svg .tint2{fill:#a7d8a1} svg .tint3{fill:#e3a6a1}
svg .tint4{fill:#c3b1e1} svg .tint5{fill:#f2e394} svg .tint6{fill:#9adbd1} svg .tint7{fill:#e6b8d3}
i.tint0{background:#8ec9e3} i.tint1{background:#f4c97a} i.tint2{background:#a7d8a1} i.tint3{background:#e3a6a1}
i.tint4{background:#c3b1e1} i.tint5{background:#f2e394} i.tint6{background:#9adbd1} i.tint7{background:#e6b8d3}
.warn { border-left:4px solid #e0a100; background:#fff8e1; padding:5px 10px; margin:5px 0; font-size:13px; }
@media print { body { background:#fff; font-size:11px; } main { max-width:none; padding:0; } @page { size:A4; margin:14mm; } }
)css";

/// Features of the whole part take the tints in turn.
std::map<std::string, int> tintsOf(const Inspection& inspection) {
    std::map<std::string, int> tints;
    int next = 0;
    for (const InspectedSetup& setup : inspection.setups)
        for (const InspectedFeature& inspected : setup.features)
            tints[inspected.feature.id] = next++ % kTints;
    return tints;
}

std::string featureRow(const InspectedFeature& inspected, int tint) {
    const Feature& feature = inspected.feature;
    const auto measured = [&](auto words) {
        return numberCell(inspected.measures ? words(*inspected.measures) : std::string("?"));
    };
    return fmt::format("<tr><td><i class=\"key tint{}\"></i>{}</td>", tint, escapeHtml(feature.id)) +
           cell(toString(feature.feature_class)) + cell(inspected.hole) +
           cell(fmt::format("{}", fmt::join(feature.parents, ", "))) +
           numberCell(fmt::format("{:.3f}", feature.depth_mm())) +
           measured([](const FeatureMeasures& m) { return fmt::format("{:.2f}", m.width_mm); }) +
           measured([](const FeatureMeasures& m) { return fmt::format("{:.2f}", m.depth_to_width); }) +
           measured([](const FeatureMeasures& m) { return cornerWords(m); }) +
           measured([](const FeatureMeasures& m) { return wallWords(m); }) +
           numberCell(fmt::format("{:.3f}", feature.volume_mm3 / 1000)) +
           cell(fmt::format("{}", fmt::join(costDrivers(inspected), "; "))) + "</tr>\n";
}

std::string setupSection(const Inspection& inspection, const InspectedSetup& setup,
                         const std::map<std::string, int>& tints) {
    const Vec3 size = setup.setup.stock_bbox_mm.sizes();
    std::string html = fmt::format(
        "<h2>Setup {}</h2>\n<p>Tool axis {} of the part{}. Stock {:.2f} &times; {:.2f} &times; {:.2f} mm as "
        "it "
        "arrives. {}</p>\n",
        escapeHtml(setup.setup.id), escapeHtml(axisName(setup.setup.axis)),
        setup.setup.indexed ? " (indexed)" : "", size.x(), size.y(), size.z(),
        escapeHtml(setup.clamping.text));
    std::vector<int> shades(inspection.part.faces.size(), -1);
    for (const InspectedFeature& inspected : setup.features)
        for (const FaceRow& row : inspection.faces)
            if (row.feature == inspected.feature.id) shades[row.index] = tints.at(row.feature);
    html += "<div class=\"views\">\n";
    for (const View& view : shadedViews(inspection.part, setup.setup.part_to_setup, shades))
        html +=
            fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", view.svg, escapeHtml(view.title));
    html += "</div>\n";
    if (setup.features.empty()) return html;
    html +=
        "<table>" + headRow({"feature", "class", "hole", "after", "#depth mm", "#width mm", "#depth/width",
                             "#corner R", "#wall × height", "#volume cm³", "what makes it costly"});
    for (const InspectedFeature& inspected : setup.features)
        html += featureRow(inspected, tints.at(inspected.feature.id));
    return html + "</table>\n";
}

std::string holesSection(const Inspection& inspection) {
    if (inspection.holes.empty()) return {};
    std::string html =
        "<h2>Holes</h2>\n<table>" + headRow({"#count", "class", "steps, mm from the entry", "which"});
    for (const HoleGroup& group : groupHoles(inspection.holes)) {
        std::vector<std::string> ids;
        for (const Hole* hole : group.holes)
            ids.push_back(hole->id);
        html += "<tr>" + numberCell(std::to_string(group.holes.size())) + cell(group.name) +
                cell(group.steps) + cell(fmt::format("{}", fmt::join(ids, ", "))) + "</tr>\n";
    }
    return html + "</table>\n";
}

std::string booksSection(const InspectedBooks& books) {
    std::string html = "<h2>Volume books</h2>\n<table>" + headRow({"entry", "#cm³"});
    const auto line = [&](const std::string& name, double volume_mm3) {
        html += "<tr>" + cell(name) + numberCell(fmt::format("{:.4f}", volume_mm3 / 1000)) + "</tr>\n";
    };
    line("stock minus part", books.stock_minus_part_mm3);
    line("features", books.features_mm3);
    for (const ReasonVolume& left : books.left)
        line("stays: " + toString(left.reason), left.volume_mm3);
    return html +
           fmt::format("</table>\n<p class=\"soft\">Not accounted for: {:.1e} of stock minus part.</p>\n",
                       books.gapShare());
}

}  // namespace

std::string inspectionHtml(const Inspection& inspection) {
    const Part& part = inspection.part;
    const Vec3 size = part.bbox_mm.sizes();
    std::string html = pageHead(part.name, kStyle) +
                       fmt::format(
                           "<h1>{}</h1>\n<p class=\"soft\">{} &middot; {:.2f} &times; {:.2f} &times; "
                           "{:.2f} mm (file unit: {}) &middot; {} faces &middot; {:.3f} cm³</p>\n",
                           escapeHtml(part.name), escapeHtml(part.file), size.x(), size.y(), size.z(),
                           escapeHtml(part.unit_in_file), part.faces.size(), part.volume_mm3 / 1000);
    for (const std::string& warning : inspection.warnings)
        html += "<div class=\"warn\">" + escapeHtml(warning) + "</div>\n";
    if (const auto notes = notesOn(inspection); !notes.empty()) {
        html += "<h2>What makes it costly</h2>\n<ul>\n";
        for (const std::string& note : notes)
            html += "<li>" + escapeHtml(note) + "</li>\n";
        html += "</ul>\n";
    }
    const std::map<std::string, int> tints = tintsOf(inspection);
    for (const InspectedSetup& setup : inspection.setups)
        html += setupSection(inspection, setup, tints);
    return html + holesSection(inspection) + booksSection(inspection.books) + pageEnd();
}

}  // namespace stepmill
