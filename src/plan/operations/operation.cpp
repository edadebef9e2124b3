#include "stepmill/plan/operation.h"

#include <algorithm>

namespace stepmill {

double lowestMm(const Operation& operation) {
    double lowest_mm = operation.path.start.z();
    for (const Move& move : operation.path.moves)
        lowest_mm = std::min(lowest_mm, move.to.z());
    return lowest_mm;
}

std::optional<CuttingModel> cuttingModelOf(const OperationSheet& operation, const Material& material,
                                           const Machine& machine) {
    if (!operation.rating) return std::nullopt;
    CuttingData cutting;
    cutting.step_over_mm = operation.rating->step_over_mm;
    cutting.step_down_mm = operation.rating->step_down_mm;
    cutting.slot_step_down_mm = operation.rating->slot_step_down_mm;
    cutting.rated_removal_mm3_per_min = operation.rating->removal_mm3_per_min;
    cutting.feed_mm_per_min = operation.feed_mm_per_min;
    cutting.speed_rpm = operation.speed_rpm;
    const std::optional<CuttingFacts> facts = cuttingFacts(operation.tool, cutting, material, machine);
    if (!facts) return std::nullopt;
    CuttingFacts driven = *facts;
    driven.pace = std::max(1.0, operation.pace);
    return CuttingModel(driven);
}

OperationSheet sheetOf(const Operation& operation, const ToolLibrary& library) {
    const Toolpath& path = operation.path;
    return {operation,
            library.tool(operation.tool_id),
            path.pattern,
            path.depths,
            path.step_down_mm,
            path.feed_mm_per_min,
            path.plunge_feed_mm_per_min};
}

}  // namespace stepmill
