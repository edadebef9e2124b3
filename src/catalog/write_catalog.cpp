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
        Json made{{"id", tool.id}, {"number", tool.number}, {"type", toString(tool.type)}};
        putText(made, "description", tool.description);
        made["diameter"] = length(tool.diameter_mm);
        putForm(made, tool);
        made["flute_length"] = length(tool.flute_length_mm);
        if (tool.flutes > 0) made["flutes"] = tool.flutes;
        if (tool.cutter_material != CutterMaterial::Carbide)
            made["cutter_material"] = toString(tool.cutter_material);
        if (tool.centre_cutting != (tool.isDrill() || tool.isSpot()))
            made["centre_cutting"] = tool.centre_cutting;
        if (tool.max_plunge_mm != usualPlungeMm(tool)) made["max_plunge"] = length(tool.max_plunge_mm);
        putStickOut(made, tool);
        putHolder(made, tool);
        made["cutting"] = Json::array();
        for (const CuttingData& data : tool.cutting)
            made["cutting"].push_back(cutting(data));
        if (tool.price > 0) made["price"] = tool.price;
        if (tool.life_min > 0) made["life_min"] = tool.life_min;
        putText(made, "vendor", tool.vendor);
        putText(made, "product_id", tool.product_id);
        return made;
    }

  private:
    double length(double mm) const { return shortNumber(mm / mm_per_unit_); }

    void putLength(Json& made, const char* field, double mm) const {
        if (mm > 0) made[field] = length(mm);
    }

    static void putText(Json& made, const char* field, const std::string& text) {
        if (!text.empty()) made[field] = text;
    }

    void putForm(Json& made, const ToolAssembly& tool) const {
        if (tool.type != ToolType::Ball) putLength(made, "corner_radius", tool.corner_radius_mm);
        if (tool.hasFlanks()) {
            made["tip_diameter"] = length(tool.tip_diameter_mm);
            made["included_angle_deg"] = shortNumber(tool.included_angle_deg);
        }
        if (tool.isDrill() || tool.isSpot()) made["point_angle_deg"] = shortNumber(tool.point_angle_deg);
        if (tool.isDrill() && tool.self_centring != (tool.point_angle_deg >= kSelfCentringPointDeg))
            made["self_centring"] = tool.self_centring;
        if (tool.isSizer()) made["lead"] = length(tool.lead_mm);
        if (tool.isTap() && tool.thread) {
            made["thread"] = tool.thread->name;
            made["lead_threads"] = shortNumber(tool.lead_mm / tool.thread->pitch_mm);
        }
    }

    void putStickOut(Json& made, const ToolAssembly& tool) const {
        if (tool.stick_out_range)
            made["stick_out"] = {{"min", length(tool.stick_out_range->shortest_mm)},
                                 {"max", length(tool.stick_out_range->longest_mm)}};
        else
            made["stick_out"] = length(tool.stick_out_mm);
    }

    void putHolder(Json& made, const ToolAssembly& tool) const {
        const bool straight =
            tool.shank.diameter_mm == tool.diameter_mm && tool.shank.bottom_mm == tool.flute_length_mm;
        if (tool.shank.diameter_mm > 0 && !straight)
            made["shank"] = {{"diameter", length(tool.shank.diameter_mm)},
                             {"from", length(tool.shank.bottom_mm)}};
        for (const HolderCylinder& cylinder : tool.holder)
            made["holder"].push_back({{"diameter", length(cylinder.diameter_mm)},
                                      {"bottom", length(cylinder.bottom_mm)},
                                      {"top", length(cylinder.top_mm)}});
    }

    Json cutting(const CuttingData& data) const {
        Json made{{"material", data.material}};
        putLength(made, "step_over", data.step_over_mm);
        putLength(made, "step_down", data.step_down_mm);
        putLength(made, "slot_step_down", data.slot_step_down_mm);
        if (data.rated_removal_mm3_per_min > 0)
            made["rated_removal_cm3_per_min"] = shortNumber(data.rated_removal_mm3_per_min / kMm3PerCm3);
        putLength(made, "feed", data.feed_mm_per_min);
        putLength(made, "plunge_feed", data.plunge_feed_mm_per_min);
        putLength(made, "slot_feed", data.slot_feed_mm_per_min);
        if (data.ramp_angle_deg > 0) made["ramp_angle_deg"] = shortNumber(data.ramp_angle_deg);
        made["speed_rpm"] = shortNumber(data.speed_rpm);
        if (data.coolant != Coolant::Flood) made["coolant"] = toString(data.coolant);
        if (data.dwell_s > 0) made["dwell_s"] = shortNumber(data.dwell_s);
        return made;
    }

    double mm_per_unit_;
};

}  // namespace

std::string toolLibraryJson(const ToolLibrary& library, const std::string& description,
                            const FilledFields& filled) {
    Json made{{"format", 1}, {"unit", library.unit}};
    if (!description.empty()) made["description"] = description;
    made["tools"] = Json::array();
    const ToolWriter writer(library.unit);
    for (const ToolAssembly& tool : library.tools) {
        Json& written = made["tools"].emplace_back(writer.tool(tool));
        const auto fields = filled.find(tool.id);
        if (fields == filled.end()) continue;
        for (const FilledField& field : fields->second)
            written["filled"].push_back({{"field", field.field}, {"source", field.source}});
    }
    return laidOut(made) + "\n";
}

}  // namespace stepmill
