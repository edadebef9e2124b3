#include "stepmill/report/curves.h"

#include <algorithm>

#include <fmt/format.h>

namespace stepmill {

namespace {

struct CsvRow {
    double diameter_mm;
    double area_mm2;
    double volume_mm3;
    std::string event;
};

std::string placesText(const std::vector<Vec2>& places) {
    std::string text;
    for (const Vec2& at : places)
        text += fmt::format("{}({:.4f} {:.4f})", text.empty() ? "" : " ", at.x(), at.y());
    return text;
}

std::string rowsText(std::vector<CsvRow> rows, const std::string& name) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const CsvRow& a, const CsvRow& b) { return a.diameter_mm < b.diameter_mm; });
    std::string text;
    for (const CsvRow& row : rows)
        text += fmt::format("{:.6f},{},{:.4f},{:.4f},{}\n", row.diameter_mm, name, row.area_mm2,
                            row.volume_mm3, row.event);
    return text;
}

std::vector<CsvRow> rowsOf(const AccessCurve& curve, double depth_mm) {
    std::vector<CsvRow> rows;
    for (const AccessSample& sample : curve.samples)
        rows.push_back({sample.diameter_mm, sample.area_mm2, sample.volume_mm3, ""});
    for (const AccessEvent& event : curve.events)
        rows.push_back({event.diameter_mm, event.area_after_mm2, event.area_after_mm2 * depth_mm,
                        toString(event.kind) + " at " + placesText(event.at)});
    return rows;
}

}  // namespace

std::string curvesCsv(const PartCurves& curves) {
    std::string text = "diameter_mm,feature,coverable_area_mm2,access_volume_mm3,event\n";
    for (const FeatureCurve& feature : curves.features)
        text += rowsText(rowsOf(feature.curve, feature.feature.depth_mm()), feature.feature.id);
    return text + rowsText(rowsOf(sumOf(curves), 0), "part");
}

}  // namespace stepmill
