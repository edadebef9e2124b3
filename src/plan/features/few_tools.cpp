#include "plan/features/few_tools.h"

#include <functional>
#include <map>
#include <set>

namespace stepmill {
namespace {

/// By falling diameter.
using MillByDiameter = std::map<double, const ToolAssembly*, std::greater<>>;

MillByDiameter farthestSetOut(const ToolLibrary& library, const std::string& material) {
    MillByDiameter mills;
    for (const ToolAssembly& tool : library.tools) {
        if (tool.isForHoles() || tool.isForm() || tool.cuttingFor(material) == nullptr) continue;
        const ToolAssembly*& mill = mills[tool.diameter_mm];
        if (mill == nullptr || tool.stick_out_mm > mill->stick_out_mm) mill = &tool;
    }
    return mills;
}

}  // namespace

ToolLibrary fewTools(ToolLibrary library, const std::string& material) {
    const MillByDiameter mills = farthestSetOut(library, material);
    std::set<std::string> kept;
    std::size_t next = 0;  // of kFewMills, spread over all
    std::size_t i = 0;
    for (const auto& [diameter_mm, mill] : mills) {
        if (i * (kFewMills - 1) >= next * (mills.size() - 1)) {
            kept.insert(mill->id);
            ++next;
        }
        ++i;
    }
    std::erase_if(library.tools,
                  [&](const ToolAssembly& tool) { return !tool.isForHoles() && kept.count(tool.id) == 0; });
    return library;
}

}  // namespace stepmill
