#include "sequence/surrogates/surrogate_tools.h"

#include "stepmill/access/lumps.h"

namespace stepmill {

SurrogateTools::SurrogateTools(std::shared_ptr<const SequenceJob> job, const std::vector<ToolReach>& reaches)
    : job_(std::move(job)) {
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = job_->library.tool(reach.tool_id);
        const bool has_data = tool.cuttingFor(job_->options.material) != nullptr;
        if (reach.exclusion() == nullptr && !tool.isForHoles() && has_data)
            all_.push_back({&tool, reach.own()});
    }
}

const SharedRegion& SurrogateTools::obstruction(int surrogate) const {
    return obstructions_.get(surrogate, [&] {
        const Surrogate& asked = all_[surrogate];
        if (asked.reach.wider_obstruction) return *asked.reach.wider_obstruction;
        return SharedRegion(obstructionWithHolder(job_->ground, *asked.tool));
    });
}

}  // namespace stepmill
