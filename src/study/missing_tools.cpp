#include "stepmill/study/missing_tools.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/catalog/cutter_form.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"

namespace stepmill {

MissingTools::MissingTools(const HoleWishes& wishes, const ToolLibrary& library, const std::string& material)
    : wishes_(wishes), library_(library), material_(material) {}

template <typename Serves>
bool MissingTools::hasTool(Serves serves) const {
    return std::any_of(library_.tools.begin(), library_.tools.end(), [&](const ToolAssembly& tool) {
        return tool.cuttingFor(material_) != nullptr && serves(tool);
    });
}

MissingTool& MissingTools::named(const std::string& tool, const std::string& gives) {
    const auto known = std::find_if(list_.begin(), list_.end(),
                                    [&](const MissingTool& missing) { return missing.tool == tool; });
    return known != list_.end() ? *known : list_.emplace_back(MissingTool{tool, gives});
}

void MissingTools::look(const Stage& stage) {
    for (const Feature& feature : stage.found.features) {
        if (!isHole(feature.feature_class)) continue;
        for (const HoleWish& wish : wishes_.of(feature, stage.setup))
            lookAtWish(wish, 2 * holeRadiusMm(feature));
    }
    lookAtChamfers(stage.layers);
}

void MissingTools::lookAtWish(const HoleWish& wish, double diameter_mm) {
    const HoleEntry& entry = *wish.entry;
    const int holes = static_cast<int>(wish.places.size());
    if (entry.make == HoleMaking::Tap && entry.thread && !hasTool([&](const ToolAssembly& tool) {
            return tool.isTap() && tool.thread && sameThread(*tool.thread, *entry.thread);
        }))
        named("tap " + entry.thread->name, "the thread").holes += holes;
    if (entry.make != HoleMaking::Ream || !entry.fit) return;
    const auto limits = boreLimits(*entry.fit, diameter_mm);
    const auto sizes = [&](const ToolAssembly& tool) {
        return limits && tool.isSizer() && tool.diameter_mm >= limits->least_mm &&
               tool.diameter_mm <= limits->most_mm;
    };
    if (!hasTool(sizes))
        named(fmt::format("reamer {:.4g} {}", diameter_mm, entry.fit->name), "the fit").holes += holes;
}

void MissingTools::lookAtChamfers(const LayerStack& layers) {
    for (const FaceTrace& face : layers.traces) {
        if (face.cause != SlopeCause::Chamfer || !chamfers_.insert(face.face).second) continue;
        const double lean = face.least_normal_z;
        const bool cone = face.surface == SurfaceKind::Cone && face.hollow;
        const auto fits = [&](const ToolAssembly& tool) {
            const bool comes = tool.type == ToolType::Chamfer ||
                               (tool.isCountersink() && cone && face.radius_mm <= tool.radius_mm());
            return comes && std::abs(flankLean(tool) - lean) <= kSameLean;
        };
        if (hasTool(fits)) continue;
        const double included_deg = std::round(radToDeg(2 * std::asin(std::clamp(lean, 0.0, 1.0))));
        MissingTool& mill =
            named(fmt::format("chamfer mill, {:g} degrees", included_deg), "chamfers and countersinks");
        ++mill.faces;
        if (cone) ++mill.holes;
    }
}

}  // namespace stepmill
