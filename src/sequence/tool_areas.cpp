#include "sequence/tool_areas.h"

#include "access/collision.h"

namespace stepmill {

AccessibleArea areaFor(const FeatureGround& ground, const ToolAssembly& tool,
                       const SequenceOptions& options) {
    AccessibleArea area = accessibleArea(ground, tool, options.material);
    if (options.clear_of_own_material)
        if (auto trouble = access::ownMaterialTrouble(ground, tool, area)) area.excluded = std::move(trouble);
    return area;
}

}  // namespace stepmill
