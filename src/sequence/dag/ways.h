#pragma once

#include <functional>
#include <vector>

#include "sequence/dag/evaluate_dag.h"
#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// A way through an evaluated tool DAG.
struct Way {
    std::vector<const ToolAssembly*> visits;  ///< in their order, surrogates among them; none twice in a row
    double paths = 0;                         ///< seconds or money of the paths, without tool changes
    std::vector<int> path;                    ///< node numbers
};

/// What ways are listed from.
struct WaySource {
    const DagResult& dag;
    const std::vector<Candidate>& tools;
    const std::vector<bool>& ends;
    const SurrogateFinder& finder;
    double change_weight = 0;  ///< of one tool change: seconds or money
    /// Does that path leave the same material as the DAG's own?
    std::function<bool(const std::vector<int>&)> leaves_the_same;
};

/// The ways that may be best beside other features, which call tools anyway: the DAG's own first, then those
/// that leave the same and are no worse than another in every company, the cheapest first. Of a DAG with very
/// many ways the cheapest among those looked at.
/// \pre dag.path is not empty
std::vector<Way> listWays(const WaySource& source);

}  // namespace stepmill
