#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {

/// Cost models of the tool DAG's edges: real paths, or one of the papers' area models for quick looks and for
/// comparison [costs.md, 'Cost models'].
enum class CostModel {
    Path,  ///< real tool paths [DSouza2006, eq. 12 and 13]
    Yao,   ///< k_c + k (A_j - A_i) / r_j [Yao2000, section 5.3]
    Lim    ///< volume / removal rate [Lim2000, eq. 1], and a tool change
};

std::string toString(CostModel model);  ///< "paths", "yao", "lim"
std::optional<CostModel> costModelFrom(std::string_view word);

/// Tools reach the same when what they reach differs by no more than this share of the most any reaches.
inline constexpr double kFullAccessShare = 1e-5;

/// One tool as the area models see it: what it reaches of a feature (or of all of them) and how fast it cuts.
struct AreaModelTool {
    double radius_mm = 0;
    double area_mm2 = 0;        ///< coverable area
    double volume_mm3 = 0;      ///< coverable area x depth: the tool access volume of [Lim2000]
    double rate_mm3_per_s = 0;  ///< material removal rate
    /// Area cleared down to the floor in a second, all depths of cut counted.
    double area_rate_mm2_per_s = 0;
};

/// Material a cutter removes in steady cutting: step-over x step-down x feed [mm3/s]. 0 where one of them is
/// not given.
double removalRateMm3PerS(const CuttingData& cutting);

/// A tool in a feature of this depth, which it clears in as few even depths of cut as the step-down allows.
/// \pre cutting.step_over_mm > 0 and cutting.feed_mm_per_min > 0
AreaModelTool areaModelTool(double radius_mm, double coverable_mm2, double depth_mm,
                            const CuttingData& cutting);

/// The two constants of [Yao2000], which the paper leaves to experiment.
struct YaoConstants {
    double tool_change_s = 0;    ///< k_c
    double factor_s_per_mm = 0;  ///< k: seconds for each mm2 of area at 1 mm of radius
};

/// k for these tools: the mean of radius / area rate, which is what k would be for each of them alone. One k
/// stands for all, so tools with a generous step-over look slower than they are and the others faster.
/// \return 0 without tools
double yaoFactorSPerMm(const std::vector<AreaModelTool>& tools);

/// Edge (i, j) of [Yao2000]: k_c + k (A_j - A_i) / r_j [s]. `area_before_mm2` is A_i, 0 for the source.
/// \pre to.radius_mm > 0
double yaoEdgeS(double area_before_mm2, const AreaModelTool& to, const YaoConstants& constants);

/// Edge (i, j) of [Lim2000]: (V_j - V_i) / rate_j + tool change [s]. `volume_before_mm3` is V_i, 0 for the
/// source; for the paper's own totals let the first tool's change be 0.
/// \pre to.rate_mm3_per_s > 0
double limEdgeS(double volume_before_mm3, const AreaModelTool& to, double tool_change_s);

/// Does the change to the first tool of a sequence cost time? In [Yao2000] it does, in [Lim2000] it does not.
enum class FirstChange { Counted, Free };

/// Cheapest sequences by the area models, over tools in falling diameter [s]. A tool that reaches no more
/// than the one before it has no edge from it; sequences end with a tool that reaches all any of them does,
/// within kFullAccessShare. Empty when no tool reaches anything. The number of tools never rises with the
/// tool change time. O(n^2).
CheapestPath cheapestByYao(const std::vector<AreaModelTool>& tools, const YaoConstants& constants,
                           FirstChange first = FirstChange::Counted);
CheapestPath cheapestByLim(const std::vector<AreaModelTool>& tools, double tool_change_s,
                           FirstChange first = FirstChange::Counted);

}  // namespace stepmill
