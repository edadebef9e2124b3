#include "report/curves/curve_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/page/text.h"

namespace stepmill {

namespace {

constexpr double kLeft = 64;
constexpr double kRight = 46;
constexpr double kTop = 22;
constexpr double kBottom = 42;

/// Step of 1, 2 or 5 times a power of ten that divides the range into at most that many.
double niceStep(double range, int most) {
    const double rough = range / most;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

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
    double full() const { return full_mm3_; }

    std::string svg() const {
        std::string text;
        const double bottom = y(0);
        const double right = chart_.width - kRight;
        for (const double share : {0.25, 0.5, 0.75, 1.0})
            text += fmt::format(
                "<line class=\"grid\" x1=\"{0}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
                "<text class=\"tick\" x=\"{3:.1f}\" y=\"{4:.1f}\">{5:.0f} %</text>\n",
                kLeft, right, y(share * full_mm3_), right + 5, y(share * full_mm3_) + 4, 100 * share);
        const bool in_cm3 = full_mm3_ >= 1000;
        const double unit = in_cm3 ? 1000 : 1;
        const double step = niceStep(full_mm3_ / unit, 5);
        for (double value = 0; value * unit <= full_mm3_ * 1.0001; value += step)
            text += fmt::format(
                "<line class=\"axis\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
                "<text class=\"tick end\" x=\"{3}\" y=\"{4:.1f}\">{5:g}</text>\n",
                kLeft - 4, kLeft, y(value * unit), kLeft - 7, y(value * unit) + 4, value);
        const double step_mm = niceStep(chart_.to_mm, 12);
        for (double value = 0; value <= chart_.to_mm * 1.0001; value += step_mm)
            text += fmt::format(
                "<line class=\"axis\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
                "<text class=\"tick middle\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4:g}</text>\n",
                x(value), bottom, bottom + 4, bottom + 17, value);
        text += fmt::format(
            "<path class=\"axis\" d=\"M {0} {1} V {2:.1f} H {3:.1f}\"/>"
            "<text class=\"name middle\" x=\"{4:.1f}\" y=\"{5:.1f}\">diameter of the cutter [mm]</text>"
            "<text class=\"name\" x=\"6\" y=\"12\">access volume [{6}]</text>\n",
            kLeft, kTop - 6, bottom, right, (kLeft + right) / 2, chart_.height - 6, in_cm3 ? "cm³" : "mm³");
        return text;
    }

  private:
    const CurveChart& chart_;
    double full_mm3_;
    double top_mm3_;
};

std::string curveSvg(const CurveChart& chart, const Axes& axes) {
    std::string line;
    for (const AccessSample& sample : chart.samples)
        line += fmt::format("{}{:.2f} {:.2f}", line.empty() ? "M" : "L", axes.x(sample.diameter_mm),
                            axes.y(sample.volume_mm3));
    return fmt::format("<path class=\"area\" d=\"{0}V{1:.2f}H{2:.2f}Z\"/><path class=\"curve\" d=\"{0}\"/>\n",
                       line, axes.y(0), axes.x(chart.samples.front().diameter_mm));
}

std::string dashedLine(double x, double from_y, double to_y) {
    return fmt::format("<line class=\"drop\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1:.2f}\" y2=\"{2:.2f}\"/>\n",
                       x, from_y, to_y);
}

/// Numbers stand above their point, and step up where they would cover the one before.
std::string marksSvg(const CurveChart& chart, const Axes& axes) {
    std::string text;
    double last_x = -100;
    double last_y = 0;
    for (const ChartMark& mark : chart.marks) {
        const double x = axes.x(mark.diameter_mm);
        const double y = axes.y(mark.volume_mm3);
        if (mark.is_jump)
            text += fmt::format(
                "<line class=\"jump\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1:.2f}\" y2=\"{2:.2f}\"/>\n", x, y,
                axes.y(mark.volume_mm3 - mark.drop_mm3));
        text += dashedLine(x, axes.y(mark.volume_mm3 - mark.drop_mm3), axes.y(0));
        text += fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\"/>\n",
                            mark.is_jump ? "jump-dot" : "kink-dot", x, y);
        double label_y = y - 9;
        if (x - last_x < 8.0 * static_cast<double>(mark.label.size()) + 4 && label_y > last_y - 12)
            label_y = last_y - 12;
        label_y = std::max(label_y, 10.0);
        text += fmt::format("<text class=\"mark{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n",
                            mark.is_jump ? " jump-text" : "", x + 3, label_y, escapeHtml(mark.label));
        last_x = x;
        last_y = label_y;
    }
    return text;
}

}  // namespace

std::string chartSvg(const CurveChart& chart) {
    const Axes axes(chart);
    return fmt::format(
        "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">\n{}{}{}</svg>\n",
        chart.width, chart.height, axes.svg(), curveSvg(chart, axes), marksSvg(chart, axes));
}

}  // namespace stepmill
