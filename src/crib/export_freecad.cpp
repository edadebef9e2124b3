// Libraries of FreeCAD: what read_freecad.cpp reads.

#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/units.h"
#include "stepmill/crib/export_tools.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

/// Shape files of FreeCAD and the types they are of. A face mill is the flat cutter that it mostly is there.
constexpr EnumWord<ToolType> kShapes[] = {
    {ToolType::Flat, "endmill"},  {ToolType::Ball, "ballend"},     {ToolType::Bull, "bullnose"},
    {ToolType::Drill, "drill"},   {ToolType::Face, "endmill"},     {ToolType::Chamfer, "v-bit"},
    {ToolType::Tap, "tap"},       {ToolType::Spot, "drill"},       {ToolType::Reamer, "reamer"},
    {ToolType::Boring, "reamer"}, {ToolType::Countersink, "v-bit"}};
constexpr EnumWord<ToolType> kShapeTypes[] = {
    {ToolType::Flat, "Endmill"},  {ToolType::Ball, "Ballend"},    {ToolType::Bull, "Bullnose"},
    {ToolType::Drill, "Drill"},   {ToolType::Face, "Endmill"},    {ToolType::Chamfer, "VBit"},
    {ToolType::Tap, "Tap"},       {ToolType::Spot, "Drill"},      {ToolType::Reamer, "Reamer"},
    {ToolType::Boring, "Reamer"}, {ToolType::Countersink, "VBit"}};

/// A name that every file system takes.
std::string fileName(const ToolAssembly& tool) {
    std::string name = fmt::format("T{}_", tool.number);
    for (const char c : tool.id.substr(0, 60))
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    return name + ".fctb";
}

class BitWriter {
  public:
    explicit BitWriter(const std::string& unit)
        : unit_(unit == "inch" ? "in" : "mm"), mm_per_unit_(unit == "inch" ? kMillimetresPerInch : 1.0) {}

    std::string bit(const ToolAssembly& tool) const {
        const std::string shape = wordOf(kShapes, tool.type);
        const Json json{{"version", 2},
                        {"id", tool.id},
                        {"name", tool.description.empty() ? tool.id : tool.description},
                        {"shape", shape + ".fcstd"},
                        {"shape-type", wordOf(kShapeTypes, tool.type)},
                        {"attribute", Json::object()},
                        {"parameter", parameters(tool)}};
        return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }

  private:
    std::string length(double mm) const { return fmt::format("{:.6f} {}", mm / mm_per_unit_, unit_); }
    static std::string angle(double deg) { return fmt::format("{:.4f} °", deg); }

    Json parameters(const ToolAssembly& tool) const {
        Json json{{"Diameter", length(tool.diameter_mm)},
                  {"CuttingEdgeHeight", length(tool.flute_length_mm)},
                  {"Length", length(tool.stick_out_mm + 2 * tool.shank.diameter_mm)},
                  {"ShankDiameter", length(tool.shank.diameter_mm)},
                  {"Stickout", length(tool.stick_out_mm)},
                  {"Flutes", std::to_string(tool.flutes)},
                  {"Material", tool.cutter_material == CutterMaterial::Hss ? "HSS" : "Carbide"}};
        if (tool.type == ToolType::Bull) json["CornerRadius"] = length(tool.corner_radius_mm);
        if (tool.isDrill() || tool.isSpot()) json["TipAngle"] = angle(tool.point_angle_deg);
        if (tool.isTap() && tool.thread) json["Pitch"] = length(tool.thread->pitch_mm);
        if (tool.hasFlanks()) {
            json["TipDiameter"] = length(tool.tip_diameter_mm);
            json["CuttingEdgeAngle"] = angle(tool.included_angle_deg);
        }
        if (!tool.vendor.empty()) json["Vendor"] = tool.vendor;
        if (!tool.product_id.empty()) json["PartNumber"] = tool.product_id;
        return json;
    }

    std::string unit_;
    double mm_per_unit_;
};

}  // namespace

std::vector<CribFile> freeCadFiles(const ToolLibrary& library, const std::string& name) {
    std::vector<CribFile> files;
    Json list = Json::array();
    const BitWriter writer(library.unit);
    for (const ToolAssembly& tool : library.tools) {
        files.push_back({fileName(tool), writer.bit(tool)});
        list.push_back({{"nr", tool.number}, {"path", files.back().name}});
    }
    const Json json{{"version", 1}, {"label", name}, {"tools", list}};
    files.push_back({name + ".fctl", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"});
    return files;
}

}  // namespace stepmill
