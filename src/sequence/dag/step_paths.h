#pragma once

#include <vector>

#include "sequence/dag/evaluate_dag.h"

namespace stepmill {

/// Pattern of the paths that edges are weighed by. Weighing all patterns on every edge costs several times as
/// much and rarely changes which tools are cheapest. The chosen steps get the best pattern of all.
inline constexpr Pattern kWeighedPattern = Pattern::ContourInsideOut;

/// The steps of tool n itself after m (null: nothing swept yet), with the paths that the edge is weighed by:
/// one, or after a drill that stayed over a flat floor what is beside it and then all below. None: n has
/// nothing to cut.
/// \param rings  ringsOf() the tool
std::vector<SequenceStep> makePaths(const DagTask& task, const Candidate* m, const Candidate& n,
                                    const SharedRings& rings);

/// Are these paths weighed at feeds by what they cut, where that is known? Over open ground a first tool's
/// are not: another pattern will go round what is a full slot for the weighed one.
bool isWeighedAsFed(const DagTask& task, const Candidate* m);

/// The rings that all paths of one tool share while edges are weighed; null for a drill.
SharedRings ringsOf(const DagTask& task, const Candidate& tool);

/// The steps of tool n of a chosen path, after m (null for the first), with the tool paths to run: of the
/// quickest patterns, and proved. They do not contain the surrogates' steps. Where it is known what cuts ask
/// for (SequenceOptions::cut_material), the first tool's patterns are the quickest at feeds by what they cut.
/// \throws Error(Internal) if a path gouges
std::vector<SequenceStep> makeSteps(const DagTask& task, const Candidate* m, const Candidate& n);
/// The same where it is one step: of a feature without such a drill.
SequenceStep makeStep(const DagTask& task, const Candidate* m, const Candidate& n);

}  // namespace stepmill
