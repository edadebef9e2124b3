#include "stepmill/catalog/usual_values.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "catalog/embedded.h"
#include "catalog/schema_check.h"

namespace stepmill {
namespace {

using nlohmann::json;

UsualFor usualFor(const json& from) {
    UsualFor tools;
    for (const json& type : from["types"])
        tools.types.push_back(toolTypeFrom(type.get<std::string>()).value());
    tools.from_mm = from.value("from_mm", 0.0);
    tools.to_mm = from.value("to_mm", 0.0);
    return tools;
}

UsualAssembly assemblyFrom(const json& from) {
    UsualAssembly usual;
    usual.tools = usualFor(from);
    usual.flutes = from.value("flutes", 0);
    usual.flute_length_diameters = from.value("flute_length_diameters", 0.0);
    usual.stick_out_diameters = from.value("stick_out_diameters", 0.0);
    usual.over_flutes_mm = from.value("over_flutes_mm", 0.0);
    for (const json& cylinder : from.value("holder", json::array()))
        usual.holder.push_back({cylinder["diameter_mm"], cylinder["height_mm"]});
    usual.life_min = from.value("life_min", 0.0);
    usual.source = from["source"];
    return usual;
}

UsualCutting cuttingFrom(const json& from) {
    UsualCutting usual;
    usual.tools = usualFor(from);
    usual.material = from["material"];
    usual.cutting_speed_m_per_min = from["cutting_speed_m_per_min"];
    usual.most_rpm = from.value("most_rpm", 0.0);
    usual.feed_per_tooth_diameters = from.value("feed_per_tooth_diameters", 0.0);
    usual.feed_per_turn_diameters = from.value("feed_per_turn_diameters", 0.0);
    usual.step_over_diameters = from.value("step_over_diameters", 0.0);
    usual.step_down_diameters = from.value("step_down_diameters", 0.0);
    usual.plunge_share = from.value("plunge_share", 0.0);
    usual.ramp_angle_deg = from.value("ramp_angle_deg", 0.0);
    usual.source = from["source"];
    return usual;
}

}  // namespace

bool UsualFor::fits(const ToolAssembly& tool) const {
    return std::find(types.begin(), types.end(), tool.type) != types.end() && tool.diameter_mm >= from_mm &&
           (to_mm == 0 || tool.diameter_mm < to_mm);
}

UsualValues usualValuesFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::CuttingData));
    throwFirstError(parsed.findings, file_name);
    UsualValues usual{file_name, {}, {}};
    for (const json& entry : parsed.value.value("assemblies", json::array()))
        usual.assemblies.push_back(assemblyFrom(entry));
    for (const json& entry : parsed.value.value("cutting", json::array()))
        usual.cutting.push_back(cuttingFrom(entry));
    return usual;
}

UsualValues readUsualValues(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return usualValuesFromText(readFile(path, max_bytes), path.filename().string());
}

UsualValues builtInUsualValues() {
    return usualValuesFromText(embedded::kUsualCuttingData, "usual_cutting_data.json");
}

}  // namespace stepmill
