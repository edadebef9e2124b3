#include "plan/operations/stick_outs.h"

#include <map>

namespace stepmill {

ToolLibrary withStickOuts(ToolLibrary library, const std::vector<PlannedSetup>& setups) {
    std::map<std::string, double> needed_mm;
    for (const PlannedSetup& setup : setups)
        for (const PlannedFeature& planned : setup.features)
            for (const SequenceStep& step : planned.sequence.steps) {
                double& needed = needed_mm[step.tool_id];
                needed = std::max(needed, step.least_stick_out_mm);
            }
    for (ToolAssembly& tool : library.tools) {
        const auto found = needed_mm.find(tool.id);
        if (!tool.stick_out_range || found == needed_mm.end()) continue;
        tool = setTo(std::move(tool), found->second);
    }
    return library;
}

}  // namespace stepmill
