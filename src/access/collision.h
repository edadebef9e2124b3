#pragma once

#include <vector>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// A cylinder of shank or holder that dips below the top of standing material when the tip is on the floor.
struct Blocker {
    std::size_t obstacle = 0;  ///< which of the feature's obstacles stands at its bottom
    double radius_mm = 0;
    double height_mm = 0;  ///< of its bottom over the tip
};

/// Shank and holder as far as they are wider than the cutter, and so not covered by it.
std::vector<HolderCylinder> cylindersOf(const ToolAssembly& tool);

/// Those of cylindersOf() with standing material at their bottom's height. The obstacles are shadows, so what
/// stands at the bottom's height counts for the whole cylinder.
std::vector<Blocker> blockers(const Feature& feature, const ToolAssembly& tool);

/// Centres where neither cutter nor shank nor holder touches anything: `centres` without each obstacle grown
/// by its cylinder's radius [DSouza2006, Alg. 3].
Region collisionFreeCentres(const FeatureGround& ground, const std::vector<Blocker>& blockers,
                            Region centres);

/// The feature as a cutter of radius r without shank and holder would have to see it to keep these clear:
/// a cylinder of radius R stays off an obstacle exactly when a disc of radius r stays off the obstacle grown
/// by R - r. Target and obstruction change, the obstacles are gone.
Feature withoutHolder(const FeatureGround& ground, const std::vector<Blocker>& blockers, double radius_mm);

/// Must the axis leave some of `centres` to keep a cylinder off an obstacle?
bool losesCentres(const FeatureGround& ground, const Blocker& blocker, const Region& centres);

}  // namespace stepmill::access
