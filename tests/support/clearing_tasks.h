#pragma once

#include <algorithm>
#include <optional>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/toolpath/toolpath.h"
#include "support/tool_makers.h"

namespace stepmill::test {

inline Machine machineWithRapid(double rapid_mm_per_min) {
    Machine machine;
    machine.rapid_mm_per_min = rapid_mm_per_min;
    return machine;
}
inline const Machine kMachine = machineWithRapid(5000);

/// A block around `target` that has it as a pocket; `open` regions are cut out of the block as well.
inline Region blockAround(const Region& target, const Region& open, const Tolerances& tol) {
    const Box2 box = grown(boundingBox(target), 15);
    const Region block = subtract(makeRectangle(box.min(), box.max()), target, tol);
    return open.empty() ? block : subtract(block, open, tol);
}

/// A way into a component of free centres: over an open edge where its boundary leaves the target by the
/// radius, else a helix in its widest place.
inline Entry entryInto(const Region& component, const Region& target, double radius_mm,
                       const Tolerances& tol) {
    for (const auto& [from, segment] : eachEdge(component)) {
        const Vec2 middle = pointAt(from, segment, 0.5);
        if (!contains(target, middle) && distanceToBoundary(target, middle) >= radius_mm - 1e-4)
            return {EntryKind::OpenEdge, middle, 0, Vec2::Zero()};
    }
    const auto widest = ClearanceDiagram(component, tol).largestInscribedDisc();
    if (!widest) return {};
    return {EntryKind::Helix, widest->centre, std::min(0.6 * radius_mm, widest->radius_mm), Vec2::Zero()};
}

/// What a tool with these areas has to do in a feature: all of its free centres, or a decomposed area's.
inline ClearingTask taskOf(const Feature& feature, const CutterArea& tool, const DecomposedArea& decomposed,
                           const Machine& machine, Pattern pattern = Pattern::Best) {
    ClearingTask task;
    task.free_centres = tool.free_centres;
    task.entries = tool.entries;
    task.slot_middles = tool.slot_middles;
    task.centres = decomposed.centres;
    task.cleared_centres = decomposed.cleared_centres;
    task.target = feature.target;
    task.obstruction = tool.obstructionIn(feature);
    task.top_z_mm = feature.top_z_mm;
    task.floor_z_mm = feature.floor_z_mm;
    task.retract_z_mm = machine.safe_height_mm;
    task.pattern = pattern;
    return task;
}

/// The whole of a target with a tool of that radius, free centres by offsets alone.
inline ClearingTask fullTask(const Region& target, const Region& obstruction, double radius_mm,
                             const Tolerances& tol) {
    ClearingTask task;
    task.target = target;
    task.obstruction = obstruction;
    task.free_centres = subtract(offset(target, radius_mm, tol), offset(obstruction, radius_mm, tol), tol);
    task.centres = task.free_centres;
    for (const Region& component : components(task.free_centres))
        task.entries.push_back(entryInto(component, target, radius_mm, tol));
    task.top_z_mm = 0;
    task.floor_z_mm = -6;
    task.retract_z_mm = 5;
    return task;
}

/// What a smaller tool has left to do after a larger one [accessibility.md, step 5].
inline ClearingTask restTask(const Region& target, const Region& obstruction, double larger_mm,
                             double radius_mm, const Tolerances& tol) {
    ClearingTask task = fullTask(target, obstruction, radius_mm, tol);
    const Region larger = fullTask(target, obstruction, larger_mm, tol).free_centres;
    task.cleared_centres = larger.empty() ? Region{} : offset(larger, larger_mm - radius_mm, tol);
    const ClearanceDiagram left(subtract(task.free_centres, task.cleared_centres, tol), tol);
    task.centres = left.opening(tol.sliver_mm / 2);
    return task;
}

}  // namespace stepmill::test
