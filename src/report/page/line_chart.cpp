#include "report/page/line_chart.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/page/chart_parts.h"
#include "report/page/drawing.h"
#include "report/page/words.h"
#include "stepmill/core/error.h"

namespace stepmill::report {
namespace {

// The picture, in its own units.
constexpr double kWidth = 520;
constexpr double kHeight = 290;
constexpr double kLeft = 58;
constexpr double kRight = 16;
constexpr double kTop = 34;
constexpr double kBottom = 44;
constexpr double kKeyLine = 15;
/// Room above the highest point.
constexpr double kHeadroom = 1.08;
constexpr double kBesideRule = 4;
/// Words of a rule farther right than this share stand on its left.
constexpr double kTurnWords = 0.75;

class Axes {
  public:
    explicit Axes(const LineChart& chart)
        : height_(kHeight + kKeyLine * static_cast<double>(chart.series.size())) {
        for (const ChartSeries& series : chart.series)
            for (const Vec2& point : series.points)
                most_ = most_.cwiseMax(point);
        most_.y() *= kHeadroom;
    }

    double height() const { return height_; }
    double bottom() const { return kHeight - kBottom; }
    Vec2 at(const Vec2& point) const {
        return {kLeft + point.x() / most_.x() * (kWidth - kLeft - kRight),
                bottom() - point.y() / most_.y() * (bottom() - kTop)};
    }

    void draw(Element& svg, const LineChart& chart) const {
        const double x_step = niceStep(most_.x(), 10);
        for (double x = 0; x <= most_.x(); x += x_step)
            svg.add(lineFrom("line.axis", at({x, 0}), at({x, 0}) + Vec2(0, 4)),
                    textAt("text.tick.middle", at({x, 0}) + Vec2(0, 17), fmt::format("{:g}", x)));
        const double y_step = niceStep(most_.y(), 6);
        for (double y = 0; y <= most_.y(); y += y_step)
            svg.add(lineFrom("line.grid", at({0, y}), at({most_.x(), y})),
                    textAt("text.tick.end", at({0, y}) + Vec2(-6, 4), fmt::format("{:g}", y)));
        svg.add(Element("path.axis")
                    .with("d", fmt::format("M{} {}V{:.1f}H{}", kLeft, kTop, bottom(), kWidth - kRight)),
                textAt("text.title.middle", {(kLeft + kWidth) / 2, kHeight - 8}, chart.x_name),
                textAt("text.title", {6, 14}, chart.y_name));
    }

  private:
    Vec2 most_ = Vec2::Zero();
    double height_;
};

Element seriesClass(std::size_t index, Element shape) {
    return std::move(shape).with("class", fmt::format("series{}", index));
}

void drawSeries(Element& svg, const ChartSeries& series, std::size_t index, const Axes& axes) {
    std::string line;
    for (const Vec2& point : series.points) {
        const Vec2 at = axes.at(point);
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", at.x(), at.y());
        if (series.is_dotted)
            svg.add(seriesClass(
                index,
                Element("circle").with("cx", fixed(at.x(), 1)).with("cy", fixed(at.y(), 1)).with("r", "3")));
    }
    svg.add(seriesClass(index, Element("path").with("d", line)));
}

void drawRule(Element& svg, const ChartRule& rule, const Axes& axes) {
    const double x = axes.at({rule.x, 0}).x();
    const bool turned = x > kTurnWords * kWidth;
    svg.add(lineFrom("line.rule", {x, kTop - 6}, {x, axes.bottom()}),
            textAt(turned ? Tag("text.mark.end") : Tag("text.mark"),
                   {x + (turned ? -kBesideRule : kBesideRule), kTop}, rule.words));
}

void drawKey(Element& svg, const ChartSeries& series, std::size_t index) {
    const double y = kHeight + kKeyLine * static_cast<double>(index) + 4;
    svg.add(seriesClass(index, Element("path").with("d", fmt::format("M{} {:.1f}h22", kLeft, y))),
            textAt("text.tick", {kLeft + 28, y + 4}, series.name));
}

}  // namespace

Element lineChart(const LineChart& chart) {
    STEPMILL_CHECK(chart.series.size() <= kMostSeries, "every line has a colour of its own");
    const Axes axes(chart);
    Element svg = emptySvg("svg.chart", fmt::format("0 0 {} {}", kWidth, axes.height()), chart.label);
    axes.draw(svg, chart);
    for (const ChartRule& rule : chart.rules)
        drawRule(svg, rule, axes);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        drawSeries(svg, chart.series[i], i, axes);
        drawKey(svg, chart.series[i], i);
    }
    return svg;
}

}  // namespace stepmill::report
