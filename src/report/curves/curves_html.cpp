// curves.html: what cutters of every diameter reach, of the part and of each feature.

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "report/curves/curve_chart.h"
#include "report/page/document.h"
#include "report/page/drawing.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "stepmill/report/curves.h"

namespace stepmill::report {

namespace {

/// More numbers than this on one chart cannot be read; the rest is in curves.csv.
constexpr std::size_t kMostMarks = 9;
/// A drop of this share of the feature's volume is a jump to the eye.
constexpr double kJumpShare = 2e-3;

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

std::optional<Element> eventTable(const FeatureCurve& feature, const std::vector<AccessEvent>& events) {
    Table table({"no.", numbers("diameter"), "cause", "at", numbers("lost to wider cutters")});
    for (std::size_t i = 0; i < events.size(); ++i)
        table.row(std::to_string(i + 1), fixed(events[i].diameter_mm, 3) + " mm", causeText(events[i]),
                  placesText(events[i].at), lostText(events[i], feature));
    return std::move(table).elementIfAny();
}

std::optional<Element> moreEventsWords(const AccessCurve& curve, const std::vector<AccessEvent>& shown) {
    if (shown.size() == curve.events.size()) return std::nullopt;
    return Element("p.soft", fmt::format("{} more in curves.csv.", curve.events.size() - shown.size()));
}

/// The feature from above; every event shown as the disc that just no longer fits there.
Element eventDrawing(const FeatureCurve& feature, const std::vector<AccessEvent>& events) {
    constexpr double kSurroundings = 0.1;
    const Box2 box = boundingBox(feature.feature.target);
    Drawing drawing(grown(box, kSurroundings * box.sizes().maxCoeff()), feature.feature.id + " from above");
    drawing.region(feature.feature.obstruction, "obstruction");
    drawing.region(feature.feature.target, "target");
    for (const AccessEvent& event : events) {
        const char* css_class = event.kind == AccessEventKind::Neck           ? "neck"
                                : event.kind == AccessEventKind::CornerRadius ? "corner"
                                                                              : "room";
        for (const Vec2& at : event.at)
            drawing.dot(at, event.diameter_mm / 2, css_class);
    }
    return std::move(drawing).element();
}

CurveChart chartOf(const FeatureCurve& feature, const std::vector<AccessEvent>& events, double to_mm) {
    CurveChart chart;
    chart.title = "Access volume of " + feature.feature.id;
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

Element featureSection(const FeatureCurve& curve, double to_mm) {
    const Feature& feature = curve.feature;
    const std::vector<AccessEvent> events = shownEvents(curve.curve);
    Element drawing(
        "figure", eventDrawing(curve, events),
        Element("figcaption", "Discs that just do not pass: red necks, dashed rooms; blue corner radii"));
    return Element("section", Element("h2", feature.id + " · " + toString(feature.feature_class)),
                   Element("p", fmt::format("{:.4g} mm deep, {:.2f} cm². {}", feature.depth_mm(),
                                            feature.area_mm2 / 100, adviceText(curve.curve, to_mm))),
                   Element("div.beside", Element("figure", curveChart(chartOf(curve, events, to_mm))),
                           std::move(drawing)),
                   eventTable(curve, events), moreEventsWords(curve.curve, events))
        .at(Anchor("feature", feature.id));
}

/// The jumps of all features that matter to the part, by diameter, labelled with feature and diameter.
std::vector<ChartMark> partMarks(const PartCurves& curves, const AccessCurve& sum) {
    std::vector<ChartMark> marks;
    for (const FeatureCurve& feature : curves.features)
        for (const AccessEvent& event : feature.curve.events) {
            const double drop_mm3 = dropOf(event) * feature.feature.depth_mm();
            const bool is_jump = drop_mm3 > kJumpShare * sum.samples.front().volume_mm3;
            if (!is_jump) continue;
            marks.push_back({event.diameter_mm, 0, drop_mm3, is_jump,
                             fmt::format("{} {:.4g}", feature.feature.id, event.diameter_mm)});
        }
    std::stable_sort(marks.begin(), marks.end(),
                     [](const ChartMark& a, const ChartMark& b) { return a.drop_mm3 > b.drop_mm3; });
    if (marks.size() > kMostMarks) marks.resize(kMostMarks);
    std::stable_sort(marks.begin(), marks.end(),
                     [](const ChartMark& a, const ChartMark& b) { return a.diameter_mm < b.diameter_mm; });
    constexpr double kJustBelowMm = 3e-4;
    for (ChartMark& mark : marks)
        mark.volume_mm3 = sum.volumeAt(std::max(0.0, mark.diameter_mm - kJustBelowMm));
    return marks;
}

/// The part's own chart with its largest jumps.
Element partFigure(const PartCurves& curves) {
    const AccessCurve sum = sumOf(curves);
    CurveChart chart;
    chart.title = "Access volume of the part";
    chart.width = 1000;
    chart.height = 340;
    chart.to_mm = curves.to_mm;
    chart.samples = sum.samples;
    chart.marks = partMarks(curves, sum);
    const std::string what = curves.features.size() == 1
                                 ? std::string("One feature")
                                 : fmt::format("{} features together", curves.features.size());
    return Element("figure", curveChart(chart),
                   Element("figcaption", what + ". " + adviceText(sum, curves.to_mm)));
}

/// A link to each feature's section.
Element contents(const PartCurves& curves) {
    Element links("nav");
    for (const FeatureCurve& feature : curves.features)
        links.add(linkTo(Anchor("feature", feature.feature.id), feature.feature.id));
    return links;
}

}  // namespace
}  // namespace stepmill::report

std::string stepmill::curvesHtml(const PartCurves& curves) {
    using namespace report;
    Element main(
        "main", Element("h1", curves.part_name),
        Element("p.soft", curves.file +
                              " · what one cutter of each diameter reaches, by geometry alone: how it "
                              "gets in, its length and its holder do not count"));
    if (curves.features.empty())
        main.add(Element("p", "No feature to machine."));
    else
        main.add(partFigure(curves), contents(curves));
    for (const FeatureCurve& feature : curves.features)
        main.add(featureSection(feature, curves.to_mm));
    return htmlDocument(curves.part_name + ": access curves", std::move(main));
}
