#pragma once

#include <string>
#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Ground that nested features share: to be cut down through all of them at once; or of one feature, cut
/// before the rest of it, or down to a depth before what lies below [common-ground.md].
struct CommonGround {
    std::string id;  ///< "S1.G2.1", of the feature that it becomes
    /// Ids of the nested features, from above, each the next one's only parent.
    std::vector<std::string> levels;
    Region region;  ///< within the targets of all of them
    /// Where it ends: the last level's floor, or above that, where it takes all of that level's target and
    /// the level goes on below it.
    double floor_z_mm = 0;
};

/// The features of a setup with the ground taken out of its levels: it becomes a feature of its own, from the
/// first level's top to its own floor, which waits for what the first one waited for; what the levels
/// keep waits for it and has its old heights but below a higher floor, obstruction and obstacles. Around the
/// ground stands what the levels keep: cutter, shank and holder stay clear of that. Volumes add up to what
/// they did. A level that keeps nothing but slivers is gone, and its children wait for the one above it.
/// \param features  parents before children; so is the result
/// \pre the levels are among the features, and the region is no sliver
std::vector<Feature> withCommonGround(std::vector<Feature> features, const CommonGround& ground,
                                      const Tolerances& tol);

/// Is the region more than a sliver, and within the targets of all levels, which follow one another from
/// above? All of a last level whose floor it does not reach, and not all of a single one else? Only then the
/// features with this ground are as good as those without.
bool isCommonGround(const std::vector<Feature>& features, const CommonGround& ground, const Tolerances& tol);

}  // namespace stepmill
