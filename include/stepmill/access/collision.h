#pragma once

#include <optional>
#include <vector>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// A cylinder of shank or holder that dips below the top of standing material when the tip is on the floor.
struct Blocker {
    std::size_t obstacle = 0;  ///< which of the feature's obstacles stands at its bottom
    double radius_mm = 0;
    double height_mm = 0;  ///< of its bottom over the tip
};

/// Shank, and holder with its clearance (keptOffHolder()), as far as they are wider than the cutter and so
/// not covered by it.
std::vector<HolderCylinder> cylindersOf(const ToolAssembly& tool);

/// Is it a cylinder of the holder, which moves with the stick-out, and not of the shank?
bool isOfHolder(const ToolAssembly& tool, const HolderCylinder& cylinder);
/// How much wider one of cylindersOf() is on each side than the tool itself: the clearance, unless it is the
/// shank [mm].
double clearanceAround(const ToolAssembly& tool, const HolderCylinder& cylinder);

/// How deep the tool may go before its shank or holder, as far as they are wider than the cutter, is below
/// the top of what it cuts [mm].
double freeReachMm(const ToolAssembly& tool);

/// What a cylinder meets whose bottom is at that height: the lowest of a feature's obstacles that reaches
/// higher by more than rounding. It holds those above it, and it may begin over the bottom: heights that
/// should be equal differ by rounding. Nothing where all end below.
std::optional<std::size_t> obstacleAbove(const std::vector<Obstacle>& obstacles, double z_mm,
                                         double rounding_mm);

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

/// Does shank or holder meet material of the feature itself? Where the floor is deeper than they stay above,
/// nothing that the tool leaves of the target, or cuts only later from another component of its centres, may
/// stand within their reach.
bool meetsOwnMaterial(const FeatureGround& ground, const ToolAssembly& tool, const Region& centres);

/// Turns a tool down that would meet what it leaves of the feature itself. [DSouza2006] takes the stock as it
/// is right after the feature; but what shank and holder keep the cutter from stands in their own way as soon
/// as they are below the feature's top.
/// \param reach  toolReach() of the tool
std::optional<Exclusion> ownMaterialTrouble(const FeatureGround& ground, const ToolAssembly& tool,
                                            const ToolReach& reach);

/// Must the axis leave some of `centres`, however little, to keep a cylinder off an obstacle? A strip of
/// centres may be as narrow as a cutter in a slot of its own width leaves it: the whole slot hangs on it.
bool losesCentres(const FeatureGround& ground, const Blocker& blocker, const Region& centres);

}  // namespace stepmill::access
