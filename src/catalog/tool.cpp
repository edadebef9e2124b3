#include "stepmill/catalog/tool.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

constexpr EnumWord<ToolType> kToolTypes[] = {
    {ToolType::Flat, "flat"},     {ToolType::Ball, "ball"},    {ToolType::Bull, "bull"},
    {ToolType::Drill, "drill"},   {ToolType::Face, "face"},    {ToolType::Chamfer, "chamfer"},
    {ToolType::Tap, "tap"},       {ToolType::Spot, "spot"},    {ToolType::Countersink, "countersink"},
    {ToolType::Reamer, "reamer"}, {ToolType::Boring, "boring"}};
constexpr EnumWord<Coolant> kCoolants[] = {
    {Coolant::Off, "off"}, {Coolant::Mist, "mist"}, {Coolant::Flood, "flood"}};
constexpr EnumWord<CutterMaterial> kCutterMaterials[] = {{CutterMaterial::Carbide, "carbide"},
                                                         {CutterMaterial::Hss, "hss"}};

}  // namespace

const CuttingData* ToolAssembly::cuttingFor(const std::string& material_name) const {
    const auto found = std::find_if(cutting.begin(), cutting.end(),
                                    [&](const CuttingData& data) { return data.material == material_name; });
    return found == cutting.end() ? nullptr : &*found;
}

ToolAssembly setTo(ToolAssembly tool, double stick_out_mm) {
    const double by_mm = stick_out_mm - tool.stick_out_mm;
    tool.stick_out_mm = stick_out_mm;
    if (tool.shank.diameter_mm > 0) tool.shank.top_mm += by_mm;
    for (HolderCylinder& cylinder : tool.holder) {
        cylinder.bottom_mm += by_mm;
        cylinder.top_mm += by_mm;
    }
    return tool;
}

std::vector<HolderCylinder> keptOffHolder(const ToolAssembly& tool) {
    std::vector<HolderCylinder> holder = tool.holder;
    for (HolderCylinder& cylinder : holder) {
        cylinder.diameter_mm += 2 * tool.holder_clearance_mm;
        cylinder.bottom_mm = std::max(0.0, cylinder.bottom_mm - tool.holder_clearance_mm);
    }
    return holder;
}

std::string clearanceWords(const ToolAssembly& tool) {
    if (tool.holder_clearance_mm <= 0) return {};
    return fmt::format(", with {:g} mm of clearance", tool.holder_clearance_mm);
}

const ToolAssembly& ToolLibrary::tool(const std::string& id) const {
    const auto found =
        std::find_if(tools.begin(), tools.end(), [&](const ToolAssembly& tool) { return tool.id == id; });
    if (found == tools.end()) throw Error(ErrorCode::Internal, "tool " + id, "not in library " + file);
    return *found;
}

std::vector<std::string> ToolLibrary::materials() const {
    std::set<std::string> names;
    for (const ToolAssembly& tool : tools)
        for (const CuttingData& data : tool.cutting)
            names.insert(data.material);
    return {names.begin(), names.end()};
}

double usualPlungeMm(const ToolAssembly& tool) {
    constexpr double kWidestPlungerMm = 6;
    constexpr double kPlungeShare = 0.5;
    if (!tool.centre_cutting || tool.diameter_mm > kWidestPlungerMm) return 0;
    return kPlungeShare * tool.diameter_mm;
}

double slotStepDownMm(const ToolAssembly& tool, const CuttingData& cutting) {
    constexpr double kUsualSlotShare = 0.5;
    const double slot_mm =
        cutting.slot_step_down_mm > 0 ? cutting.slot_step_down_mm : kUsualSlotShare * tool.diameter_mm;
    return cutting.step_down_mm > 0 ? std::min(slot_mm, cutting.step_down_mm) : slot_mm;
}

double ratedRemovalMm3PerMin(const CuttingData& cutting) {
    if (cutting.rated_removal_mm3_per_min > 0) return cutting.rated_removal_mm3_per_min;
    return cutting.step_over_mm * cutting.step_down_mm * cutting.feed_mm_per_min;
}

std::string toString(CutterMaterial material) {
    return wordOf(kCutterMaterials, material);
}

std::optional<CutterMaterial> cutterMaterialFrom(std::string_view word) {
    return valueOf(kCutterMaterials, word);
}

std::string toString(ToolType type) {
    return wordOf(kToolTypes, type);
}

std::optional<ToolType> toolTypeFrom(std::string_view word) {
    return valueOf(kToolTypes, word);
}

std::string toString(Coolant coolant) {
    return wordOf(kCoolants, coolant);
}

std::optional<Coolant> coolantFrom(std::string_view word) {
    return valueOf(kCoolants, word);
}

}  // namespace stepmill
