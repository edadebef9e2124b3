#include "plan/features/planning_shop.h"

#include <set>
#include <vector>

namespace stepmill {

SmallerLibraries smallerLibraries(const PlanRequest& request, const ToolLibrary& library) {
    std::map<std::string, std::set<std::string>> withheld;
    for (const auto& [feature, caution] : request.cautions)
        withheld[feature].insert(caution.without_tools.begin(), caution.without_tools.end());
    for (const auto& [feature, wish] : request.wishes)
        withheld[feature].insert(wish.without_tools.begin(), wish.without_tools.end());
    SmallerLibraries smaller;
    for (const auto& entry : withheld) {
        if (entry.second.empty()) continue;
        ToolLibrary left = library;
        std::erase_if(left.tools, [&](const ToolAssembly& tool) { return entry.second.count(tool.id) > 0; });
        smaller.emplace(entry.first, std::move(left));
    }
    return smaller;
}

const ToolLibrary& PlanningShop::libraryOf(const std::string& feature) const {
    const auto found = smaller.find(feature);
    return found != smaller.end() ? found->second : library;
}

const FeatureCaution& PlanningShop::cautionOf(const std::string& feature) const {
    static const FeatureCaution kNone;
    const auto found = request.cautions.find(feature);
    return found != request.cautions.end() ? found->second : kNone;
}

}  // namespace stepmill
