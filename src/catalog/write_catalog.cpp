// Tool libraries: what read_catalog.cpp reads.

#include "stepmill/catalog/write_catalog.h"

#include "catalog/json_layout.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

/// Inches come back as they were written: 0.25 and not 0.24999999999999997.
double shortNumber(double value) {
    constexpr int kDigits = 9;
    if (value == 0) return 0;
    const double scale = std::pow(10.0, kDigits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

/// Tools in millimetres to tools in JSON.
class ToolWriter {
  public:
    explicit ToolWriter(const std::string& unit) : mm_per_unit_(unit == "inch" ? kMillimetresPerInch : 1.0) {}

    Json tool(const ToolAssembly& tool) const {
        Json json{{"id", tool.id}, {"number", tool.number}, {"type", toString(tool.type)}};
        putText(json, "description", tool.description);
        json["diameter"] = length(tool.diameter_mm);
        putForm(json, tool);
        json["flute_length"] = length(tool.flute_length_mm);
        if (tool.flutes > 0) json["flutes"] = tool.flutes;
        if (tool.cutter_material != CutterMaterial::Carbide)
            json["cutter_material"] = toString(tool.cutter_material);
        if (tool.centre_cutting != tool.isDrill()) json["centre_cutting"] = tool.centre_cutting;
        if (tool.max_plunge_mm != usualPlungeMm(tool)) json["max_plunge"] = length(tool.max_plunge_mm);
        putStickOut(json, tool);
        putHolder(json, tool);
        json["cutting"] = Json::array();
        for (const CuttingData& data : tool.cutting)
            json["cutting"].push_back(cutting(data));
        if (tool.price > 0) json["price"] = tool.price;
        if (tool.life_min > 0) json["life_min"] = tool.life_min;
        putText(json, "vendor", tool.vendor);
        putText(json, "product_id", tool.product_id);
        return json;
    }

  private:
    double length(double mm) const { return shortNumber(mm / mm_per_unit_); }

    void putLength(Json& json, const char* field, double mm) const {
        if (mm > 0) json[field] = length(mm);
    }

    static void putText(Json& json, const char* field, const std::string& text) {
        if (!text.empty()) json[field] = text;
    }

    void putForm(Json& json, const ToolAssembly& tool) const {
        if (tool.type != ToolType::Ball) putLength(json, "corner_radius", tool.corner_radius_mm);
        if (tool.type == ToolType::Chamfer) {
            json["tip_diameter"] = length(tool.tip_diameter_mm);
            json["included_angle_deg"] = shortNumber(tool.included_angle_deg);
        }
        if (tool.isDrill()) json["point_angle_deg"] = shortNumber(tool.point_angle_deg);
        if (tool.isTap() && tool.thread) {
            json["thread"] = tool.thread->name;
            json["lead_threads"] = shortNumber(tool.lead_mm / tool.thread->pitch_mm);
        }
    }

    void putStickOut(Json& json, const ToolAssembly& tool) const {
        if (tool.stick_out_range)
            json["stick_out"] = {{"min", length(tool.stick_out_range->shortest_mm)},
                                 {"max", length(tool.stick_out_range->longest_mm)}};
        else
            json["stick_out"] = length(tool.stick_out_mm);
    }

    void putHolder(Json& json, const ToolAssembly& tool) const {
        const bool straight =
            tool.shank.diameter_mm == tool.diameter_mm && tool.shank.bottom_mm == tool.flute_length_mm;
        if (tool.shank.diameter_mm > 0 && !straight)
            json["shank"] = {{"diameter", length(tool.shank.diameter_mm)},
                             {"from", length(tool.shank.bottom_mm)}};
        for (const HolderCylinder& cylinder : tool.holder)
            json["holder"].push_back({{"diameter", length(cylinder.diameter_mm)},
                                      {"bottom", length(cylinder.bottom_mm)},
                                      {"top", length(cylinder.top_mm)}});
    }

    Json cutting(const CuttingData& data) const {
        Json json{{"material", data.material}};
        putLength(json, "step_over", data.step_over_mm);
        putLength(json, "step_down", data.step_down_mm);
        putLength(json, "slot_step_down", data.slot_step_down_mm);
        if (data.rated_removal_mm3_per_min > 0)
            json["rated_removal_cm3_per_min"] = shortNumber(data.rated_removal_mm3_per_min / kMm3PerCm3);
        putLength(json, "feed", data.feed_mm_per_min);
        putLength(json, "plunge_feed", data.plunge_feed_mm_per_min);
        putLength(json, "slot_feed", data.slot_feed_mm_per_min);
        if (data.ramp_angle_deg > 0) json["ramp_angle_deg"] = shortNumber(data.ramp_angle_deg);
        json["speed_rpm"] = shortNumber(data.speed_rpm);
        if (data.coolant != Coolant::Flood) json["coolant"] = toString(data.coolant);
        if (data.dwell_s > 0) json["dwell_s"] = shortNumber(data.dwell_s);
        return json;
    }

    double mm_per_unit_;
};

}  // namespace

std::string toolLibraryJson(const ToolLibrary& library, const std::string& description,
                            const FilledFields& filled) {
    Json json{{"format", 1}, {"unit", library.unit}};
    if (!description.empty()) json["description"] = description;
    json["tools"] = Json::array();
    const ToolWriter writer(library.unit);
    for (const ToolAssembly& tool : library.tools) {
        Json& written = json["tools"].emplace_back(writer.tool(tool));
        const auto fields = filled.find(tool.id);
        if (fields == filled.end()) continue;
        for (const FilledField& field : fields->second)
            written["filled"].push_back({{"field", field.field}, {"source", field.source}});
    }
    return laidOut(json) + "\n";
}

}  // namespace stepmill
