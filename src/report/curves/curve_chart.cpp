#include "report/curves/curve_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/page/chart_parts.h"
#include "report/page/drawing.h"
#include "report/page/words.h"

namespace stepmill::report {

namespace {

constexpr double kLeft = 64;
constexpr double kRight = 46;
constexpr double kTop = 22;
constexpr double kBottom = 42;

/// The scales of a chart: where diameters and volumes stand in the picture.
class Axes {
  public:
    explicit Axes(const CurveChart& chart)
        : chart_(chart),
          full_mm3_(std::max(1e-9, chart.samples.front().volume_mm3)),
          top_mm3_(1.06 * full_mm3_) {}

    double x(double diameter_mm) const {
        return kLeft + diameter_mm / chart_.to_mm * (chart_.width - kLeft - kRight);
    }
    double y(double volume_mm3) const {
        return chart_.height - kBottom - volume_mm3 / top_mm3_ * (chart_.height - kTop - kBottom);
    }

    void draw(Element& svg) const {
        drawShares(svg);
        drawVolumes(svg);
        drawDiameters(svg);
        drawNames(svg);
    }

  private:
    double right() const { return chart_.width - kRight; }
    bool inCm3() const { return full_mm3_ >= 1000; }

    void drawShares(Element& svg) const {
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            const double at = y(share * full_mm3_);
            svg.add(lineFrom("line.grid", {kLeft, at}, {right(), at}),
                    textAt("text.tick", {right() + 5, at + 4}, fixed(100 * share, 0) + " %"));
        }
    }

    void drawVolumes(Element& svg) const {
        const double unit = inCm3() ? 1000 : 1;
        const double step = niceStep(full_mm3_ / unit, 5);
        for (double value = 0; value * unit <= full_mm3_ * 1.0001; value += step) {
            const double at = y(value * unit);
            svg.add(lineFrom("line.axis", {kLeft - 4, at}, {kLeft, at}),
                    textAt("text.tick.end", {kLeft - 7, at + 4}, fmt::format("{:g}", value)));
        }
    }

    void drawDiameters(Element& svg) const {
        const double bottom = y(0);
        const double step_mm = niceStep(chart_.to_mm, 12);
        for (double value = 0; value <= chart_.to_mm * 1.0001; value += step_mm) {
            const double at = x(value);
            svg.add(lineFrom("line.axis", {at, bottom}, {at, bottom + 4}),
                    textAt("text.tick.middle", {at, bottom + 17}, fmt::format("{:g}", value)));
        }
    }

    void drawNames(Element& svg) const {
        svg.add(Element("path.axis")
                    .with("d", fmt::format("M {} {} V {:.1f} H {:.1f}", kLeft, kTop - 6, y(0), right())),
                textAt("text.title.middle", {(kLeft + right()) / 2, chart_.height - 6},
                       "diameter of the cutter [mm]"),
                textAt("text.title", {6, 12}, inCm3() ? "access volume [cm³]" : "access volume [mm³]"));
    }

    const CurveChart& chart_;
    double full_mm3_;
    double top_mm3_;
};

void drawCurve(Element& svg, const CurveChart& chart, const Axes& axes) {
    std::string line;
    for (const AccessSample& sample : chart.samples)
        line += fmt::format("{}{:.2f} {:.2f}", line.empty() ? "M" : "L", axes.x(sample.diameter_mm),
                            axes.y(sample.volume_mm3));
    const std::string down_and_back =
        fmt::format("V{:.2f}H{:.2f}Z", axes.y(0), axes.x(chart.samples.front().diameter_mm));
    svg.add(Element("path.area").with("d", line + down_and_back), Element("path.curve").with("d", line));
}

void drawMark(Element& svg, const ChartMark& mark, const Axes& axes) {
    const Vec2 at(axes.x(mark.diameter_mm), axes.y(mark.volume_mm3));
    const Vec2 below(at.x(), axes.y(mark.volume_mm3 - mark.drop_mm3));
    if (mark.is_jump) svg.add(lineFrom("line.jump", at, below));
    svg.add(lineFrom("line.drop", below, {at.x(), axes.y(0)}),
            Element(mark.is_jump ? Tag("circle.jump-dot") : Tag("circle.kink-dot"))
                .with("cx", fixed(at.x(), 2))
                .with("cy", fixed(at.y(), 2))
                .with("r", "4"));
}

/// Numbers stand above their point, and step up where they would cover the one before.
void drawMarks(Element& svg, const CurveChart& chart, const Axes& axes) {
    Vec2 last(-100, 0);
    for (const ChartMark& mark : chart.marks) {
        drawMark(svg, mark, axes);
        const double x = axes.x(mark.diameter_mm);
        double label_y = axes.y(mark.volume_mm3) - 9;
        const bool covers_last = x - last.x() < 8.0 * static_cast<double>(mark.label.size()) + 4;
        if (covers_last && label_y > last.y() - 12) label_y = last.y() - 12;
        label_y = std::max(label_y, 10.0);
        svg.add(textAt(mark.is_jump ? Tag("text.mark.jump-text") : Tag("text.mark"), {x + 3, label_y},
                       mark.label));
        last = {x, label_y};
    }
}

}  // namespace

Element curveChart(const CurveChart& chart) {
    const Axes axes(chart);
    Element svg = emptySvg("svg.chart", fmt::format("0 0 {} {}", chart.width, chart.height), chart.title);
    axes.draw(svg);
    drawCurve(svg, chart, axes);
    drawMarks(svg, chart, axes);
    return svg;
}

}  // namespace stepmill::report
