#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

enum class Objective { Time, Cost };

struct SequenceOptions {
    std::string material;
    Objective objective = Objective::Time;
    /// Rapids between entries go to this height over the stock's top [mm]; 0: the machine's safe height.
    double retract_mm = 0;
};

/// One evaluated edge of the tool DAG: machine D_mn with n.
///
/// Edges to the sink cost nothing and leave every tool that clears all any tool of the library can.
struct DagEdge {
    std::string from;  ///< tool id, empty for the source
    std::string to;    ///< tool id, empty for the sink
    double region_area_mm2 = 0;
    PathTotals totals;
    double time_s = 0;  ///< with one tool change [DSouza2006, eq. 13]
    double cost = 0;    ///< with wear and the hourly rate [DSouza2006, eq. 12]
};

/// Material of a feature that stays, and why.
struct Residual {
    Region region;
    double area_mm2 = 0;
    double volume_mm3 = 0;
    std::string reason;  ///< "corner radius", "no tool fits", "holder collision", "too deep", ...
    std::string advice;  ///< what would machine it ("an end mill of 2.4 mm or less")
};

enum class Role { Face, Rough, Rest, Drill };
std::string toString(Role role);

/// One tool's part in a feature.
struct SequenceStep {
    std::string tool_id;
    Role role = Role::Rough;
    DecomposedArea area;
    Toolpath path;
    PathProof proof;
    double speed_rpm = 0;
};

/// The cheapest sequence of tools for one feature, with all that was weighed.
struct ToolSequence {
    std::string feature_id;
    /// Depth the steps cut to: the feature's floor, or higher where no tool gets down to that.
    double floor_z_mm = 0;
    std::vector<AccessibleArea> tools;  ///< every tool of the library, falling diameter, with exclusions
    std::vector<DagEdge> edges;         ///< evaluated edges, by from then to
    std::vector<SequenceStep> steps;    ///< empty when no tool can machine anything
    double time_s = 0;                  ///< with one tool change a step
    double cost = 0;
    double lower_bound_s = 0;    ///< no plan with these tools can be faster [section 6]
    double cutting_bound_s = 0;  ///< the same without any tool change, for sums over features
    int pruned_edges = 0;        ///< DAG edges whose lower bound ruled them out unevaluated
    std::vector<Residual> residual;
};

/// Time and money of a path by one tool, its change included [DSouza2006, eq. 13 and 12].
struct EdgeCost {
    double time_s = 0;
    double cost = 0;
};
EdgeCost edgeCost(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine);

/// Least time any sequence of these tools needs: for each cell of the target the fastest tool that reaches
/// it, layers x area / (cutter diameter x feed), and one tool change per tool used. The diameter stands
/// where a step-over would be quicker to write but wrong: a first pass cuts full width. 0 when no tool can
/// machine anything. See docs/algorithms/costs.md.
double lowerBoundS(const FeatureGround& ground, const std::vector<AccessibleArea>& tools,
                   const ToolLibrary& library, const SequenceOptions& options, const Machine& machine);

/// The optimal tool sequence for a feature: areas of all tools, costs of all DAG edges on real paths
/// (evaluated in parallel), the cheapest path [algorithms.md, section 7]. The result does not depend on the
/// number of threads. At most n(n+1)/2 edges are evaluated.
///
/// Tools whose holder only lets them do part of the feature take part with that part where they reach more
/// than all others. Where going less deep machines more than that, the steps end at the depth the best tool
/// reaches, and what is below is residual ("too deep").
ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol);

}  // namespace stepmill
