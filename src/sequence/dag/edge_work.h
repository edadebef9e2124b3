#pragma once

#include <optional>

#include "sequence/dag/evaluate_dag.h"

namespace stepmill {

/// What tool n has to do on an edge, its surrogates' part left out.
struct EdgeWork {
    PathTotals totals;           ///< of the path; by an area model no more than its time
    double region_area_mm2 = 0;  ///< D'_mn
    double new_area_mm2 = 0;     ///< of the target, newly cleared
};

/// Is the choice made on real tool paths?
bool needsPaths(const DagTask& task);

/// The work of n after m (null: nothing swept yet), by the options' cost model; nothing when n has nothing
/// new to clear. The area models [Yao2000] and [Lim2000] know no holes: a drill's work is its path by any
/// model.
/// \param rings  ringsOf(task, n) where needsPaths(task); else unused
std::optional<EdgeWork> edgeWork(const DagTask& task, const Candidate* m, const Candidate& n,
                                 const SharedRings& rings);

}  // namespace stepmill
