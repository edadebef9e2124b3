#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "report/curves/curve_chart.h"
#include "report/page/html_page.h"
#include "report/page/svg.h"
#include "report/page/text.h"
#include "stepmill/report/curves.h"

namespace stepmill {

namespace {

/// More numbers than this on one chart cannot be read; the rest is in curves.csv.
constexpr std::size_t kMostMarks = 9;
/// A drop of this share of the feature's volume is a jump to the eye.
constexpr double kJumpShare = 2e-3;

constexpr const char* kStyle = R"css(
:root { --ink:#1d2733; --soft:#5d6b7a; --line:#d5dce3; --paper:#fff; --accent:#0b6e99; --jump:#b3261e; }
* { box-sizing:border-box; }
body { font:14px/1.45 "DejaVu Sans",Helvetica,Arial,sans-serif; color:var(--ink); background:#eef1f4; margin:0; }
main { max-width:1080px; margin:0 auto; background:var(--paper); padding:28px 36px 48px; }
h1 { font-size:26px; margin:0 0 2px; } h2 { font-size:18px; margin:34px 0 8px; border-bottom:2px solid var(--ink); }
p { margin:4px 0 10px; } .soft { color:var(--soft); }
.pair { display:grid; grid-template-columns:1fr 330px; gap:14px; align-items:start; }
figure { margin:0; border:1px solid var(--line); border-radius:6px; padding:8px; break-inside:avoid; }
figcaption { font-size:12px; color:var(--soft); padding-top:5px; }
svg { width:100%; display:block; } .plan svg { height:272px; }
.plan path, .plan circle { vector-effect:non-scaling-stroke; fill:none; }
.plan .obstruction { fill:#c3ccd5; stroke:#8f9ba7; stroke-width:.5; }
.plan .target { fill:#fdf6df; stroke:#1d2733; stroke-width:1.3; }
.plan .neck { stroke:var(--jump); stroke-width:1.4; fill:#b3261e22; }
.plan .corner { stroke:var(--accent); stroke-width:1.2; } .plan .room { stroke:var(--jump); stroke-width:1.2;
  stroke-dasharray:4 3; }
.chart .grid { stroke:#e3e8ed; } .chart .axis { stroke:#1d2733; fill:none; }
.chart .tick { font-size:11px; fill:var(--soft); } .chart .name { font-size:11.5px; fill:var(--ink); }
.chart .middle { text-anchor:middle; } .chart .end { text-anchor:end; }
.chart .area { fill:#8ec9e3; fill-opacity:.32; } .chart .curve { fill:none; stroke:var(--accent); stroke-width:2;
  stroke-linejoin:round; }
.chart .jump { stroke:var(--jump); stroke-width:2.4; } .chart .drop { stroke:#9aa7b4; stroke-width:.8;
  stroke-dasharray:2 3; }
.chart .jump-dot { fill:var(--jump); } .chart .kink-dot { fill:#fff; stroke:var(--accent); stroke-width:1.8; }
.chart .mark { font-size:11.5px; font-weight:700; fill:var(--accent); paint-order:stroke; stroke:#fff;
  stroke-width:3px; } .chart .jump-text { fill:var(--jump); }
table { border-collapse:collapse; width:100%; font-size:12.5px; margin:8px 0 4px; }
th { text-align:left; border-bottom:1.5px solid var(--ink); padding:3px 8px 3px 0; vertical-align:bottom; }
td { border-bottom:1px solid var(--line); padding:3px 8px 3px 0; vertical-align:top; }
td.n, th.n { text-align:right; font-variant-numeric:tabular-nums; white-space:nowrap; }
@media print { body { background:#fff; } main { max-width:none; padding:0; } @page { size:A4; margin:14mm; } }
)css";

double dropOf(const AccessEvent& event) {
    return std::max(0.0, event.area_before_mm2 - event.area_after_mm2);
}

bool isJump(const AccessEvent& event, const AccessCurve& curve) {
    return dropOf(event) > kJumpShare * curve.samples.front().area_mm2;
}

/// The events that matter most, in order of diameter: the largest jumps, then corners, then necks.
std::vector<AccessEvent> shownEvents(const AccessCurve& curve) {
    std::vector<AccessEvent> events = curve.events;
    const auto rank = [&](const AccessEvent& event) {
        const int kind = event.kind == AccessEventKind::CornerRadius ? 0 : 1;
        return std::make_tuple(isJump(event, curve) ? -dropOf(event) : 0.0, kind, -event.diameter_mm);
    };
    std::stable_sort(events.begin(), events.end(),
                     [&](const AccessEvent& a, const AccessEvent& b) { return rank(a) < rank(b); });
    if (events.size() > kMostMarks) events.resize(kMostMarks);
    std::sort(events.begin(), events.end(), [](const AccessEvent& a, const AccessEvent& b) {
        return std::tie(a.diameter_mm, a.kind) < std::tie(b.diameter_mm, b.kind);
    });
    return events;
}

std::string causeText(const AccessEvent& event) {
    const std::size_t places = event.at.size();
    switch (event.kind) {
        case AccessEventKind::Neck:
            return places == 1 ? "neck of this width" : fmt::format("{} necks of this width", places);
        case AccessEventKind::CornerRadius:
            return fmt::format("{} of radius {:.4g} mm", places == 1 ? "inside corner" : "inside corners",
                               event.diameter_mm / 2);
        case AccessEventKind::Vanishes:
            return places == 1 ? "widest disc of a room" : fmt::format("widest discs of {} rooms", places);
    }
    return {};
}

std::string placesText(const std::vector<Vec2>& places) {
    constexpr std::size_t kMostPlaces = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), kMostPlaces); ++i)
        text += fmt::format("{}({:.2f}, {:.2f})", i == 0 ? "" : " ", places[i].x(), places[i].y());
    if (places.size() > kMostPlaces) text += fmt::format(" and {} more", places.size() - kMostPlaces);
    return text;
}

std::string lostText(const AccessEvent& event, const FeatureCurve& feature) {
    if (!isJump(event, feature.curve))
        return event.kind == AccessEventKind::CornerRadius ? "from here on, a little" : "-";
    const double full_mm2 = feature.curve.samples.front().area_mm2;
    return fmt::format("{:.2f} cm³ ({:.1f} %)", dropOf(event) * feature.feature.depth_mm() / 1000,
                       100 * dropOf(event) / full_mm2);
}

std::string eventTable(const FeatureCurve& feature, const std::vector<AccessEvent>& events) {
    if (events.empty()) return {};
    std::string html =
        "<table><tr><th>no.</th><th class=\"n\">diameter</th><th>cause</th><th>at</th>"
        "<th class=\"n\">lost to wider cutters</th></tr>\n";
    for (std::size_t i = 0; i < events.size(); ++i)
        html += fmt::format(
            "<tr><td>{}</td><td class=\"n\">{:.3f} mm</td><td>{}</td><td>{}</td><td "
            "class=\"n\">{}</td></tr>\n",
            i + 1, events[i].diameter_mm, causeText(events[i]), placesText(events[i].at),
            lostText(events[i], feature));
    html += "</table>\n";
    if (events.size() < feature.curve.events.size())
        html += fmt::format("<p class=\"soft\">{} more in curves.csv.</p>\n",
                            feature.curve.events.size() - events.size());
    return html;
}

/// The feature from above; every event shown as the disc that just no longer fits there.
std::string planSvg(const FeatureCurve& feature, const std::vector<AccessEvent>& events) {
    constexpr double kSurroundings = 0.1;
    const Box2 box = boundingBox(feature.feature.target);
    SvgDrawing svg(grown(box, kSurroundings * box.sizes().maxCoeff()));
    svg.region(feature.feature.obstruction, "obstruction");
    svg.region(feature.feature.target, "target");
    for (const AccessEvent& event : events) {
        const char* css_class = event.kind == AccessEventKind::Neck           ? "neck"
                                : event.kind == AccessEventKind::CornerRadius ? "corner"
                                                                              : "room";
        for (const Vec2& at : event.at)
            svg.dot(at, event.diameter_mm / 2, css_class);
    }
    return svg.text();
}

CurveChart chartOf(const FeatureCurve& feature, const std::vector<AccessEvent>& events, double to_mm) {
    CurveChart chart;
    chart.to_mm = to_mm;
    chart.samples = feature.curve.samples;
    const double depth_mm = feature.feature.depth_mm();
    for (std::size_t i = 0; i < events.size(); ++i)
        chart.marks.push_back({events[i].diameter_mm, events[i].area_before_mm2 * depth_mm,
                               dropOf(events[i]) * depth_mm, isJump(events[i], feature.curve),
                               std::to_string(i + 1)});
    return chart;
}

/// Does the curve jump right above this sample, so that a cutter exactly as wide as the neck is out?
bool jumpsAbove(const AccessCurve& curve, double diameter_mm) {
    constexpr double kJumpWidthMm = 3e-4;
    const double here = curve.volumeAt(diameter_mm);
    return here - curve.volumeAt(diameter_mm + kJumpWidthMm) > kJumpShare * curve.samples.front().volume_mm3;
}

std::string adviceText(const AccessCurve& curve, double to_mm) {
    constexpr double kAll = 0.9995;
    constexpr double kMost = 0.9;
    const auto cutters = [&](double diameter_mm) {
        if (diameter_mm >= to_mm) return fmt::format("every cutter up to {:.4g} mm", to_mm);
        if (jumpsAbove(curve, diameter_mm)) return fmt::format("cutters under {:.2f} mm", diameter_mm);
        return fmt::format("cutters up to {:.2f} mm", std::floor(100 * diameter_mm + 0.1) / 100);
    };
    const double all_mm = widestReaching(curve, kAll);
    const double most_mm = widestReaching(curve, kMost);
    const std::string all = "All is reached by " + cutters(all_mm);
    return most_mm <= all_mm ? all + "." : fmt::format("{}, 90 % by {}.", all, cutters(most_mm));
}

std::string featureSection(const FeatureCurve& feature, double to_mm) {
    const std::vector<AccessEvent> events = shownEvents(feature.curve);
    return fmt::format(
        "<section><h2>{} &middot; {}</h2>\n<p>{:.4g} mm deep, {:.2f} cm². {}</p>\n<div class=\"pair\">"
        "<figure>{}</figure><figure class=\"plan\">{}<figcaption>Discs that just do not pass: red necks, "
        "dashed rooms; blue corner radii</figcaption></figure></div>\n{}</section>\n",
        escapeHtml(feature.feature.id), escapeHtml(toString(feature.feature.feature_class)),
        feature.feature.depth_mm(), feature.feature.area_mm2 / 100, adviceText(feature.curve, to_mm),
        chartSvg(chartOf(feature, events, to_mm)), planSvg(feature, events), eventTable(feature, events));
}

/// The part's own chart: its largest jumps, labelled with feature and diameter.
std::string partSection(const PartCurves& curves) {
    const AccessCurve sum = sumOf(curves);
    CurveChart chart;
    chart.width = 1000;
    chart.height = 340;
    chart.to_mm = curves.to_mm;
    chart.samples = sum.samples;
    const double full_mm3 = sum.samples.front().volume_mm3;
    for (const FeatureCurve& feature : curves.features) {
        for (const AccessEvent& event : feature.curve.events) {
            const double drop_mm3 = dropOf(event) * feature.feature.depth_mm();
            const bool is_jump = drop_mm3 > kJumpShare * full_mm3;
            if (!is_jump) continue;
            chart.marks.push_back({event.diameter_mm, 0, drop_mm3, is_jump,
                                   fmt::format("{} {:.4g}", feature.feature.id, event.diameter_mm)});
        }
    }
    std::stable_sort(chart.marks.begin(), chart.marks.end(),
                     [](const ChartMark& a, const ChartMark& b) { return a.drop_mm3 > b.drop_mm3; });
    if (chart.marks.size() > kMostMarks) chart.marks.resize(kMostMarks);
    std::stable_sort(chart.marks.begin(), chart.marks.end(),
                     [](const ChartMark& a, const ChartMark& b) { return a.diameter_mm < b.diameter_mm; });
    constexpr double kJustBelowMm = 3e-4;
    for (ChartMark& mark : chart.marks)
        mark.volume_mm3 = sum.volumeAt(std::max(0.0, mark.diameter_mm - kJustBelowMm));
    return fmt::format("<figure>{}<figcaption>{}. {}</figcaption></figure>\n", chartSvg(chart),
                       curves.features.size() == 1
                           ? std::string("One feature")
                           : fmt::format("{} features together", curves.features.size()),
                       adviceText(sum, curves.to_mm));
}

}  // namespace

std::string curvesHtml(const PartCurves& curves) {
    std::string html = pageHead(curves.part_name + ": access curves", kStyle) +
                       fmt::format(
                           "<h1>{}</h1>\n<p class=\"soft\">{} &middot; what one cutter of each diameter "
                           "reaches, by geometry alone: how it "
                           "gets in, its length and its holder do not count</p>\n",
                           escapeHtml(curves.part_name), escapeHtml(curves.file));
    if (curves.features.empty()) {
        html += "<p>No feature to machine.</p>\n";
    } else {
        html += partSection(curves);
        for (const FeatureCurve& feature : curves.features)
            html += featureSection(feature, curves.to_mm);
    }
    return html + pageEnd();
}

}  // namespace stepmill
