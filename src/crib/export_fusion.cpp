// Libraries of Fusion: what read_fusion.cpp reads.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "crib/type_words.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "stepmill/crib/export_tools.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

/// Version of the library format whose fields are written.
constexpr int kVersion = 36;

/// Of the form that Fusion wants, the same for the same text.
std::string guidOf(const std::string& text) {
    const std::string digits = sha256(text);
    return fmt::format("{}-{}-{}-{}-{}", digits.substr(0, 8), digits.substr(8, 4), digits.substr(12, 4),
                       digits.substr(16, 4), digits.substr(20, 12));
}

class FusionWriter {
  public:
    explicit FusionWriter(const std::string& unit)
        : unit_(unit == "inch" ? "inches" : "millimeters"),
          mm_per_unit_(unit == "inch" ? kMillimetresPerInch : 1.0) {}

    Json tool(const ToolAssembly& tool) const {
        Json json{{"BMC", toString(tool.cutter_material)},
                  {"description", tool.description},
                  {"geometry", geometry(tool)},
                  {"guid", guidOf(tool.id)}};
        if (!tool.holder.empty()) json["holder"] = holder(tool);
        json["post-process"] = {
            {"break-control", false},       {"comment", tool.id}, {"diameter-offset", tool.number},
            {"length-offset", tool.number}, {"live", true},       {"manual-tool-change", false},
            {"number", tool.number},        {"turret", 0}};
        json["product-id"] = tool.product_id;
        json["product-link"] = "";
        json["start-values"] = {{"presets", Json::array()}};
        for (const CuttingData& data : tool.cutting)
            json["start-values"]["presets"].push_back(preset(tool, data));
        json["type"] = crib::hsmWord(tool.type);
        json["unit"] = unit_;
        json["vendor"] = tool.vendor;
        return json;
    }

  private:
    double length(double mm) const {
        constexpr double kDecimals = 1e7;
        return std::round(mm / mm_per_unit_ * kDecimals) / kDecimals;
    }

    Json geometry(const ToolAssembly& tool) const {
        Json json{{"CSP", false},
                  {"DC", length(tool.diameter_mm)},
                  {"HAND", true},
                  {"LB", length(tool.stick_out_mm)},
                  {"LCF", length(tool.flute_length_mm)},
                  {"NOF", tool.flutes},
                  {"NT", 1},
                  {"OAL", length(tool.stick_out_mm + gripMm(tool))},
                  {"RE", length(tool.corner_radius_mm)},
                  {"SFDM", length(tool.shank.diameter_mm)}};
        if (tool.isDrill() || tool.isSpot())
            json["SIG"] = tool.point_angle_deg;
        else if (tool.isCountersink())
            json["SIG"] = tool.included_angle_deg;
        else if (!tool.isForHoles())
            json["TA"] = tool.type == ToolType::Chamfer ? tool.included_angle_deg / 2 : 0;
        json["TP"] = tool.isTap() && tool.thread ? length(tool.thread->pitch_mm) : 0;
        json["assemblyGaugeLength"] =
            length(tool.holder.empty() ? tool.stick_out_mm : tool.holder.back().top_mm);
        json["shoulder-diameter"] = length(std::min(tool.shank.diameter_mm, tool.diameter_mm));
        json["shoulder-length"] = length(tool.shank.bottom_mm);
        json["tip-diameter"] = length(tool.tip_diameter_mm);
        json["tip-length"] = 0;
        json["tip-offset"] = 0;
        return json;
    }

    /// How much of a tool is in its holder is not told; Fusion wants tools longer than their stick-out.
    static double gripMm(const ToolAssembly& tool) { return 2 * tool.shank.diameter_mm; }

    Json holder(const ToolAssembly& tool) const {
        Json segments = Json::array();
        double at_mm = tool.stick_out_mm;
        for (const HolderCylinder& cylinder : tool.holder) {
            const double diameter = length(cylinder.diameter_mm);
            segments.push_back({{"height", length(cylinder.top_mm - at_mm)},
                                {"lower-diameter", diameter},
                                {"upper-diameter", diameter}});
            at_mm = cylinder.top_mm;
        }
        return {{"description", "holder of " + tool.id},
                {"gaugeLength", length(at_mm - tool.stick_out_mm)},
                {"guid", guidOf("holder " + tool.id)},
                {"product-id", ""},
                {"segments", segments},
                {"type", "holder"},
                {"unit", unit_},
                {"vendor", ""}};
    }

    Json preset(const ToolAssembly& tool, const CuttingData& data) const {
        Json json{{"guid", guidOf(tool.id + "/" + data.material)},
                  {"material", {{"category", "all"}, {"query", data.material}, {"use-hardness", false}}},
                  {"n", data.speed_rpm},
                  {"name", data.material},
                  {"tool-coolant", data.coolant == Coolant::Off ? "disabled" : toString(data.coolant)},
                  {"use-stepdown", data.step_down_mm > 0},
                  {"use-stepover", data.step_over_mm > 0},
                  {"v_f", length(data.feed_mm_per_min)}};
        if (data.plunge_feed_mm_per_min > 0) json["v_f_plunge"] = length(data.plunge_feed_mm_per_min);
        if (data.step_down_mm > 0) json["stepdown"] = length(data.step_down_mm);
        if (data.step_over_mm > 0) json["stepover"] = length(data.step_over_mm);
        if (data.ramp_angle_deg > 0) json["ramp-angle"] = data.ramp_angle_deg;
        return json;
    }

    std::string unit_;
    double mm_per_unit_;
};

}  // namespace

std::string fusionJson(const ToolLibrary& library) {
    Json json{{"data", Json::array()}, {"version", kVersion}};
    const FusionWriter writer(library.unit);
    for (const ToolAssembly& tool : library.tools)
        json["data"].push_back(writer.tool(tool));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stepmill
