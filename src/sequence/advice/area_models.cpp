#include "stepmill/sequence/advice/area_models.h"

#include "sequence/dag/candidate.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

constexpr EnumWord<CostModel> kCostModels[] = {
    {CostModel::Path, "paths"}, {CostModel::Yao, "yao"}, {CostModel::Lim, "lim"}};

/// `reach` of each tool, area or volume, and the edges' costs by node numbers.
CheapestPath cheapestByReach(const std::vector<double>& reach,
                             const std::function<double(int, int)>& edge_cost) {
    const double most = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
    std::vector<bool> ends;
    for (const double reached : reach)
        ends.push_back(most > 0 && reached >= most * (1 - kFullAccessShare));
    return cheapestPath(
        static_cast<int>(reach.size()),
        [&](int m, int n) {
            const double before = m == kSource ? 0 : reach[m];
            return reach[n] > before ? edge_cost(m, n) : kNoEdge;
        },
        ends);
}

std::vector<double> valuesOf(const std::vector<AreaModelTool>& tools, double AreaModelTool::*member) {
    std::vector<double> values;
    for (const AreaModelTool& tool : tools)
        values.push_back(tool.*member);
    return values;
}

}  // namespace

std::string toString(CostModel model) {
    return wordOf(kCostModels, model);
}

std::optional<CostModel> costModelFrom(std::string_view word) {
    return valueOf(kCostModels, word);
}

double removalRateMm3PerS(const CuttingData& cutting) {
    return cutting.step_over_mm * cutting.step_down_mm * cutting.feed_mm_per_min / kSecondsPerMinute;
}

AreaModelTool areaModelTool(double radius_mm, double coverable_mm2, double depth_mm,
                            const CuttingData& cutting) {
    const int layers = toolpath::depthsFor(depth_mm, cutting.step_down_mm);
    AreaModelTool tool;
    tool.radius_mm = radius_mm;
    tool.area_mm2 = coverable_mm2;
    tool.volume_mm3 = coverable_mm2 * depth_mm;
    tool.area_rate_mm2_per_s = cutting.step_over_mm * cutting.feed_mm_per_min / kSecondsPerMinute / layers;
    tool.rate_mm3_per_s = tool.area_rate_mm2_per_s * depth_mm;
    return tool;
}

double yaoFactorSPerMm(const std::vector<AreaModelTool>& tools) {
    double sum = 0;
    for (const AreaModelTool& tool : tools)
        sum += tool.radius_mm / tool.area_rate_mm2_per_s;
    return tools.empty() ? 0 : sum / static_cast<double>(tools.size());
}

double yaoEdgeS(double area_before_mm2, const AreaModelTool& to, const YaoConstants& constants) {
    const double new_mm2 = std::max(0.0, to.area_mm2 - area_before_mm2);
    return constants.tool_change_s + constants.factor_s_per_mm * new_mm2 / to.radius_mm;
}

double limEdgeS(double volume_before_mm3, const AreaModelTool& to, double tool_change_s) {
    return tool_change_s + std::max(0.0, to.volume_mm3 - volume_before_mm3) / to.rate_mm3_per_s;
}

CheapestPath cheapestByYao(const std::vector<AreaModelTool>& tools, const YaoConstants& constants,
                           FirstChange first) {
    const YaoConstants without_change{0, constants.factor_s_per_mm};
    return cheapestByReach(valuesOf(tools, &AreaModelTool::area_mm2), [&](int m, int n) {
        if (m == kSource)
            return yaoEdgeS(0, tools[n], first == FirstChange::Free ? without_change : constants);
        return yaoEdgeS(tools[m].area_mm2, tools[n], constants);
    });
}

CheapestPath cheapestByLim(const std::vector<AreaModelTool>& tools, double tool_change_s, FirstChange first) {
    return cheapestByReach(valuesOf(tools, &AreaModelTool::volume_mm3), [&](int m, int n) {
        if (m == kSource) return limEdgeS(0, tools[n], first == FirstChange::Free ? 0 : tool_change_s);
        return limEdgeS(tools[m].volume_mm3, tools[n], tool_change_s);
    });
}

}  // namespace stepmill
