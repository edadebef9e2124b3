#include "stepmill/report/tool_page.h"

#include <fmt/format.h>

#include "report/page/chart_parts.h"
#include "report/page/drawing.h"
#include "report/page/words.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using report::Element;
using report::fixed;

// All in mm of the tool; y counts down from the picture's upper edge.
constexpr double kMargin = 6;
constexpr double kWords = 3.2;      ///< height of letters
constexpr double kWordsWidth = 62;  ///< of the words on the right
constexpr double kLeader = 5;       ///< from the tool to its words
constexpr double kLeastGap = 1.35 * kWords;

/// The cutter's outline, from its tip's right end round to the left one.
std::string cutterPath(const ToolAssembly& tool, const std::function<std::string(double, double)>& at) {
    const double r = tool.radius_mm();
    const double top = tool.flute_length_mm;
    const bool has_point = tool.isDrill() || tool.isSpot();
    const bool is_cone = has_point || tool.hasFlanks();
    double tip_r = r - tool.corner_radius_mm;
    double corner_z = tool.corner_radius_mm;
    if (is_cone) {
        const double angle_deg = has_point ? tool.point_angle_deg : tool.included_angle_deg;
        tip_r = tool.tip_diameter_mm / 2;
        corner_z = std::min((r - tip_r) / std::tan(degToRad(angle_deg / 2)), top);
    }
    const std::string join =
        is_cone || corner_z == 0 ? "L" : fmt::format("A{0:.3f} {0:.3f} 0 0 0 ", tool.corner_radius_mm);
    return "M" + at(tip_r, 0) + join + at(r, corner_z) + "L" + at(r, top) + "L" + at(-r, top) + "L" +
           at(-r, corner_z) + join + at(-tip_r, 0) + "Z";
}

/// A height with what is written beside it.
struct Label {
    double z_mm;
    double radius_mm;
    std::string words;
};

std::vector<Label> labelsOf(const ToolAssembly& tool) {
    std::vector<Label> labels{{0, 0, "tip"},
                              {tool.flute_length_mm, tool.radius_mm(),
                               fmt::format("flutes {:g}, Ø {:g}", tool.flute_length_mm, tool.diameter_mm)}};
    if (tool.shank.bottom_mm < tool.stick_out_mm)
        labels.push_back(
            {(tool.shank.bottom_mm + tool.stick_out_mm) / 2, tool.shank.diameter_mm / 2,
             fmt::format("shank Ø {:g} from {:g}", tool.shank.diameter_mm, tool.shank.bottom_mm)});
    labels.push_back(
        {tool.stick_out_mm, tool.shank.diameter_mm / 2, fmt::format("stick-out {:g}", tool.stick_out_mm)});
    for (const HolderCylinder& cylinder : tool.holder)
        labels.push_back({cylinder.top_mm, cylinder.diameter_mm / 2,
                          fmt::format("holder Ø {:g} up to {:g}", cylinder.diameter_mm, cylinder.top_mm)});
    return labels;
}

class ToolPicture {
  public:
    explicit ToolPicture(const ToolAssembly& tool) : tool_(tool) {
        radius_mm_ = std::max(tool.radius_mm(), tool.shank.diameter_mm / 2);
        height_mm_ = tool.stick_out_mm;
        for (const HolderCylinder& cylinder : tool.holder) {
            radius_mm_ = std::max(radius_mm_, cylinder.diameter_mm / 2);
            height_mm_ = std::max(height_mm_, cylinder.top_mm);
        }
    }

    std::string svg() {
        const double width = 2 * radius_mm_ + 2 * kMargin + kLeader + kWordsWidth;
        // Words may need more room than a short tool.
        const double height = std::max(height_mm_, kLeastGap * 8) + 2 * kMargin + 3 * kWords;
        Element svg = report::emptySvg("svg", fmt::format("0 0 {:.3f} {:.3f}", width, height),
                                       fmt::format("{} to scale", plainLine(tool_.id)));
        svg.set("width", fmt::format("{:.3f}mm", kToolPictureScale * width));
        svg.set("height", fmt::format("{:.3f}mm", kToolPictureScale * height));
        bottom_ = height - kMargin - 3 * kWords;
        svg.add(Element("rect").with("width", "100%").with("height", "100%").with("fill", "#ffffff"));
        addTool(svg);
        addLabels(svg);
        svg.add(words(kMargin, height - kMargin,
                      fmt::format("T{} {} ({}), 1 mm of the tool is {:g} mm here", tool_.number,
                                  plainLine(tool_.id), toString(tool_.type), kToolPictureScale)));
        return svg.markup() + "\n";
    }

  private:
    double x(double radius_mm) const { return kMargin + radius_mm_ + radius_mm; }
    double y(double z_mm) const { return bottom_ - z_mm; }

    static Element shape(std::string data, const char* fill) {
        return Element("path")
            .with("d", std::move(data))
            .with("fill", fill)
            .with("stroke", "#333333")
            .with("stroke-width", "0.25");
    }

    static Element words(double at_x, double at_y, const std::string& text) {
        return report::textAt("text", {at_x, at_y}, text)
            .with("font-family", "sans-serif")
            .with("font-size", fixed(kWords, 2))
            .with("fill", "#222222");
    }

    void addCylinder(Element& svg, double diameter_mm, double from_mm, double to_mm, const char* fill) const {
        if (!(to_mm > from_mm)) return;
        svg.add(shape(fmt::format("M{0:.3f} {2:.3f}H{1:.3f}V{3:.3f}H{0:.3f}Z", x(-diameter_mm / 2),
                                  x(diameter_mm / 2), y(from_mm), y(to_mm)),
                      fill));
    }

    void addTool(Element& svg) const {
        for (const HolderCylinder& cylinder : tool_.holder)
            addCylinder(svg, cylinder.diameter_mm, cylinder.bottom_mm, cylinder.top_mm, "#c9ced6");
        // A neck between flutes and shank is no thicker than the cutter.
        addCylinder(svg, std::min(tool_.diameter_mm, tool_.shank.diameter_mm), tool_.flute_length_mm,
                    tool_.shank.bottom_mm, "#e6e8ec");
        addCylinder(svg, tool_.shank.diameter_mm, tool_.shank.bottom_mm, tool_.stick_out_mm, "#e6e8ec");
        svg.add(shape(cutterPath(tool_,
                                 [this](double radius_mm, double z_mm) {
                                     return fmt::format("{:.3f} {:.3f} ", x(radius_mm), y(z_mm));
                                 }),
                      "#f2c46d"));
    }

    /// Words keep apart: each moves up as far as the one below it asks.
    void addLabels(Element& svg) const {
        const double at_x = x(radius_mm_) + kLeader;
        double lowest_y = bottom_ + kLeastGap;
        for (const Label& label : labelsOf(tool_)) {
            const double at_y = std::min(y(label.z_mm), lowest_y - kLeastGap);
            lowest_y = at_y;
            svg.add(shape(fmt::format("M{:.3f} {:.3f}L{:.3f} {:.3f}", x(label.radius_mm), y(label.z_mm),
                                      at_x - 1, at_y),
                          "none"));
            svg.add(words(at_x, at_y + kWords / 3, label.words));
        }
    }

    const ToolAssembly& tool_;
    double radius_mm_ = 0;
    double height_mm_ = 0;
    double bottom_ = 0;
};

}  // namespace

std::string toolSvg(const ToolAssembly& tool) {
    return ToolPicture(tool).svg();
}

}  // namespace stepmill
