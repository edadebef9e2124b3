// Tool libraries.

#include "stepmill/catalog/read_catalog.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/embedded.h"
#include "catalog/library_rules.h"
#include "catalog/schema_check.h"
#include "catalog/schema_words.h"
#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using nlohmann::json;

constexpr const char* kDefaultToolsName = "shop_metric_tools.json";

/// Tools in JSON to tools in millimetres.
/// \pre the JSON keeps the schema and the library's rules
class ToolReader {
  public:
    explicit ToolReader(const std::string& unit) : mm_per_unit_(unit == "inch" ? kMillimetresPerInch : 1.0) {}

    ToolAssembly tool(const json& from) const {
        ToolAssembly tool;
        tool.id = from["id"];
        tool.number = from["number"];
        tool.type = type(from["type"]);
        tool.diameter_mm = length(from, "diameter");
        tool.corner_radius_mm =
            tool.type == ToolType::Ball ? tool.diameter_mm / 2 : length(from, "corner_radius");
        tool.tip_diameter_mm = length(from, "tip_diameter");
        tool.included_angle_deg = from.value("included_angle_deg", 0.0);
        readHoleForm(from, tool);
        tool.flute_length_mm = length(from, "flute_length");
        tool.flutes = from.value("flutes", 0);
        tool.centre_cutting = from.value("centre_cutting", tool.isDrill() || tool.isSpot());
        tool.cutter_material =
            cutterMaterialFrom(from.value("cutter_material", "carbide")).value_or(CutterMaterial::Carbide);
        tool.max_plunge_mm = from.contains("max_plunge") ? length(from, "max_plunge") : usualPlungeMm(tool);
        readStickOut(from["stick_out"], tool);
        tool.shank = shank(from, tool);
        for (const json& cylinder : from.value("holder", json::array()))
            tool.holder.push_back(
                {length(cylinder, "diameter"), length(cylinder, "bottom"), length(cylinder, "top")});
        for (const json& data : from["cutting"])
            tool.cutting.push_back(cutting(data));
        tool.price = from.value("price", 0.0);
        tool.life_min = from.value("life_min", 0.0);
        tool.description = from.value("description", "");
        tool.vendor = from.value("vendor", "");
        tool.product_id = from.value("product_id", "");
        return tool;
    }

  private:
    static ToolType type(const std::string& name) {
        if (const auto known = toolTypeFrom(name)) return *known;
        throw Error(ErrorCode::Internal, name, "a tool type the schema allows and the reader does not know");
    }

    double length(const json& from, const char* field) const { return from.value(field, 0.0) * mm_per_unit_; }

    void readHoleForm(const json& from, ToolAssembly& tool) const {
        const double usual_deg = tool.isSpot() ? kUsualSpotPointDeg : tool.point_angle_deg;
        tool.point_angle_deg = from.value("point_angle_deg", usual_deg);
        if (tool.isDrill())
            tool.self_centring = from.value("self_centring", tool.point_angle_deg >= kSelfCentringPointDeg);
        if (tool.isTap()) readThread(from, tool);
        if (!tool.isSizer()) return;
        const bool reamer = tool.type == ToolType::Reamer;
        const double usual_mm = reamer ? kUsualLeadShare * tool.diameter_mm : 0;
        tool.lead_mm = from.contains("lead") ? length(from, "lead") : usual_mm;
    }

    /// The thread's own diameter: inches in files are rounded.
    static void readThread(const json& from, ToolAssembly& tool) {
        tool.thread = threadFrom(from["thread"].get<std::string>()).value();
        tool.diameter_mm = tool.thread->diameter_mm;
        tool.lead_mm = from.value("lead_threads", kUsualLeadThreads) * tool.thread->pitch_mm;
    }

    /// Of a range the longest stands until a plan chooses: heights in the file are those of that.
    void readStickOut(const json& from, ToolAssembly& tool) const {
        if (from.is_number()) {
            tool.stick_out_mm = from.get<double>() * mm_per_unit_;
            return;
        }
        tool.stick_out_range = {length(from, "min"), length(from, "max")};
        tool.stick_out_mm = tool.stick_out_range->longest_mm;
    }

    /// A library that says nothing of the shank means a straight one of the cutter's diameter.
    HolderCylinder shank(const json& from, const ToolAssembly& tool) const {
        if (!from.contains("shank")) return {tool.diameter_mm, tool.flute_length_mm, tool.stick_out_mm};
        return {length(from["shank"], "diameter"), length(from["shank"], "from"), tool.stick_out_mm};
    }

    CuttingData cutting(const json& from) const {
        CuttingData data;
        data.material = from["material"];
        data.step_over_mm = length(from, "step_over");
        data.step_down_mm = length(from, "step_down");
        data.slot_step_down_mm = length(from, "slot_step_down");
        data.rated_removal_mm3_per_min = from.value("rated_removal_cm3_per_min", 0.0) * kMm3PerCm3;
        data.feed_mm_per_min = length(from, "feed");
        data.plunge_feed_mm_per_min = length(from, "plunge_feed");
        data.slot_feed_mm_per_min = length(from, "slot_feed");
        data.ramp_angle_deg = from.value("ramp_angle_deg", 0.0);
        data.speed_rpm = from["speed_rpm"];
        data.coolant = coolantFrom(from.value("coolant", "flood")).value_or(Coolant::Flood);
        data.dwell_s = from.value("dwell_s", 0.0);
        if (from.contains("adaptive")) data.adaptive = adaptive(from["adaptive"]);
        return data;
    }

    AdaptiveData adaptive(const json& from) const {
        return {length(from, "step_over"), length(from, "step_down"), length(from, "feed"),
                from.value("speed_rpm", 0.0), length(from, "lift")};
    }

    double mm_per_unit_;
};

std::vector<CatalogFinding> unknownFieldDoubts(const std::vector<std::string>& pointers) {
    std::vector<CatalogFinding> findings;
    findings.reserve(pointers.size());
    for (const std::string& pointer : pointers)
        findings.push_back({pointer, "a field Stepmill does not know; kept aside, not used", true});
    return findings;
}

ParsedJson checkedLibrary(std::string_view text, const json& schema) {
    ParsedJson parsed = checkedJson(text, schema);
    if (parsed.findings.empty()) {
        parsed.findings = checkLibraryRules(parsed.value);
        std::stable_partition(parsed.findings.begin(), parsed.findings.end(),
                              [](const CatalogFinding& finding) { return !finding.doubt; });
    }
    return parsed;
}

}  // namespace

std::vector<CatalogFinding> checkToolLibrary(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    const json schema = schemaJson(SchemaName::Tools);
    ParsedJson parsed = checkedLibrary(readFile(path, max_bytes), schema);
    if (!parsed.value.is_discarded()) {
        const auto doubts = unknownFieldDoubts(SchemaWords(schema).unknownFields(parsed.value));
        parsed.findings.insert(parsed.findings.end(), doubts.begin(), doubts.end());
    }
    return parsed.findings;
}

std::vector<std::string> findLibraryErrors(const std::filesystem::path& path) {
    std::vector<std::string> lines;
    for (const CatalogFinding& finding : checkToolLibrary(path))
        if (!finding.doubt) lines.push_back(finding.pointer + ": " + finding.text);
    return lines;
}

ToolLibrary toolLibraryFromText(std::string_view text, const std::string& file_name) {
    const json schema = schemaJson(SchemaName::Tools);
    const ParsedJson parsed = checkedLibrary(text, schema);
    throwFirstError(parsed.findings, file_name);
    ToolLibrary library;
    library.file = file_name;
    library.sha256 = sha256(text);
    library.unit = parsed.value["unit"];
    const ToolReader reader(library.unit);
    for (const json& tool : parsed.value["tools"])
        library.tools.push_back(reader.tool(tool));
    library.unknown_fields = SchemaWords(schema).unknownFields(parsed.value);
    return library;
}

FilledFields filledFieldsIn(std::string_view library_text) {
    FilledFields fields;
    const json library = json::parse(library_text);
    for (const json& tool : library["tools"])
        for (const json& filled : tool.value("filled", json::array()))
            fields[tool["id"]].push_back({filled["field"], filled["source"]});
    return fields;
}

ToolLibrary readToolLibrary(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return toolLibraryFromText(readFile(path, max_bytes), path.filename().string());
}

ToolLibrary defaultToolLibrary() {
    return toolLibraryFromText(embedded::kDefaultTools, kDefaultToolsName);
}

}  // namespace stepmill
