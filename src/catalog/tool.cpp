#include "stepmill/catalog/tool.h"

#include <algorithm>
#include <set>

#include "stepmill/core/error.h"

namespace stepmill {

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

std::string toString(ToolType type) {
    switch (type) {
        case ToolType::Flat:
            return "flat";
        case ToolType::Ball:
            return "ball";
        case ToolType::Bull:
            return "bull";
        case ToolType::Drill:
            return "drill";
        case ToolType::Face:
            return "face";
    }
    return {};
}

std::optional<ToolType> toolTypeFrom(std::string_view word) {
    for (const ToolType type :
         {ToolType::Flat, ToolType::Ball, ToolType::Bull, ToolType::Drill, ToolType::Face})
        if (toString(type) == word) return type;
    return std::nullopt;
}

std::string toString(Coolant coolant) {
    switch (coolant) {
        case Coolant::Off:
            return "off";
        case Coolant::Mist:
            return "mist";
        case Coolant::Flood:
            return "flood";
    }
    return {};
}

std::optional<Coolant> coolantFrom(std::string_view word) {
    for (const Coolant coolant : {Coolant::Off, Coolant::Mist, Coolant::Flood})
        if (toString(coolant) == word) return coolant;
    return std::nullopt;
}

}  // namespace stepmill
