#include "stepmill/plan/operation.h"

namespace stepmill {

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
