#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/report/tool_page.h"

namespace stepmill {
namespace {

/// Collects lines "name  value".
class Lines {
  public:
    void add(const std::string& name, const std::string& value) {
        if (!value.empty()) text_ += fmt::format("  {:<18}{}\n", name, value);
    }
    void mm(const std::string& name, double value_mm) {
        if (value_mm > 0) add(name, fmt::format("{:.6g} mm", value_mm));
    }
    void heading(const std::string& words) { text_ += words + "\n"; }
    std::string text() && { return std::move(text_); }

  private:
    std::string text_;
};

std::string typeWords(const ToolAssembly& tool) {
    if (tool.isDrill() || tool.isSpot())
        return fmt::format("{}, point {:g} degrees", tool.isSpot() ? "spot drill" : "drill",
                           tool.point_angle_deg);
    if (tool.isSizer()) return fmt::format("{}, lead {:g} mm", toString(tool.type), tool.lead_mm);
    if (tool.hasFlanks())
        return fmt::format("{}, {:g} degrees, tip {:g} mm", toString(tool.type), tool.included_angle_deg,
                           tool.tip_diameter_mm);
    if (tool.isTap() && tool.thread) return "tap " + tool.thread->name;
    return toString(tool.type);
}

std::string stickOutWords(const ToolAssembly& tool) {
    if (tool.stick_out_range)
        return fmt::format("{:.6g} to {:.6g} mm, a plan takes the shortest that clears",
                           tool.stick_out_range->shortest_mm, tool.stick_out_range->longest_mm);
    return fmt::format("{:.6g} mm", tool.stick_out_mm);
}

std::string cuttingWords(const ToolAssembly& tool, const CuttingData& data) {
    std::string words = fmt::format("{:.6g} rpm, {:.6g} mm/min", data.speed_rpm, data.feed_mm_per_min);
    if (data.plunge_feed_mm_per_min > 0) words += fmt::format(", plunge {:.6g}", data.plunge_feed_mm_per_min);
    if (data.step_over_mm > 0) words += fmt::format(", step-over {:.6g} mm", data.step_over_mm);
    if (data.step_down_mm > 0)
        words += fmt::format(", {} {:.6g} mm", tool.isDrill() ? "peck" : "step-down", data.step_down_mm);
    if (data.ramp_angle_deg > 0) words += fmt::format(", ramp {:.4g} degrees", data.ramp_angle_deg);
    return words + ", coolant " + toString(data.coolant);
}

}  // namespace

std::string toolText(const ToolAssembly& tool, const std::vector<FilledField>& filled_fields) {
    Lines lines;
    lines.heading(fmt::format("T{} {}", tool.number, tool.id));
    lines.add("description", tool.description);
    lines.add("type", typeWords(tool));
    lines.mm("diameter", tool.diameter_mm);
    lines.mm("corner radius", tool.corner_radius_mm);
    lines.mm("flute length", tool.flute_length_mm);
    lines.add("flutes", tool.flutes > 0 ? std::to_string(tool.flutes) : "not told");
    lines.add("made of", toString(tool.cutter_material));
    lines.add("stick-out", stickOutWords(tool));
    lines.add("shank",
              fmt::format("diameter {:.6g} mm from {:.6g} mm", tool.shank.diameter_mm, tool.shank.bottom_mm));
    for (const HolderCylinder& cylinder : tool.holder)
        lines.add("holder", fmt::format("diameter {:.6g} mm from {:.6g} to {:.6g} mm", cylinder.diameter_mm,
                                        cylinder.bottom_mm, cylinder.top_mm));
    if (tool.holder.empty()) lines.add("holder", "not told: nothing keeps it off the part");
    for (const CuttingData& data : tool.cutting)
        lines.add("in " + data.material, cuttingWords(tool, data));
    lines.add("life", tool.life_min > 0 ? fmt::format("{:.6g} min", tool.life_min) : "");
    lines.add("price", tool.price > 0 ? fmt::format("{:.6g}", tool.price) : "");
    lines.add("vendor", tool.vendor);
    lines.add("product", tool.product_id);
    for (const FilledField& filled : filled_fields)
        lines.add("not measured", fmt::format("{}: {}", filled.field, filled.source));
    return std::move(lines).text();
}

std::string toolListText(const ToolLibrary& library) {
    std::string text = fmt::format("{:>6} {:<20} {:<8} {:>9} {:>7} {:>9} {:>9}  {}\n", "T", "id", "type",
                                   "diameter", "flutes", "flute mm", "stick-out", "materials");
    for (const ToolAssembly& tool : library.tools) {
        std::vector<std::string> materials;
        for (const CuttingData& data : tool.cutting)
            materials.push_back(data.material);
        text += fmt::format("{:>6} {:<20} {:<8} {:>9.4g} {:>7} {:>9.4g} {:>9.4g}  {}\n", tool.number, tool.id,
                            toString(tool.type), tool.diameter_mm,
                            tool.flutes > 0 ? std::to_string(tool.flutes) : "-", tool.flute_length_mm,
                            tool.stick_out_mm, fmt::join(materials, ", "));
    }
    return text;
}

}  // namespace stepmill
