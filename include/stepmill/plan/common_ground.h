#pragma once

#include <string>
#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Ground that nested features share: to be cut down through all of them at once [common-ground.md].
struct CommonGround {
    std::string id;  ///< "S1.G2.1", of the feature that it becomes
    /// Ids of the nested features, from above, each the next one's only parent.
    std::vector<std::string> levels;
    Region region;  ///< within the targets of all of them
};

/// The features of a setup with the ground taken out of its levels: it becomes a feature of its own, from the
/// first level's top to the last one's floor, which waits for what the first one waited for; what the levels
/// keep waits for it and has its old heights, obstruction and obstacles. Around the ground stands what the
/// levels keep: cutter, shank and holder stay clear of that. Volumes add up to what they did. A level that
/// keeps nothing but slivers is gone, and its children wait for the one above it.
/// \param features  parents before children; so is the result
/// \pre the levels are among the features, and the region is no sliver
std::vector<Feature> withCommonGround(std::vector<Feature> features, const CommonGround& ground,
                                      const Tolerances& tol);

/// Is the region more than a sliver, and within the targets of all levels, which follow one another from
/// above? Only then the features with this ground are as good as those without.
bool isCommonGround(const std::vector<Feature>& features, const CommonGround& ground, const Tolerances& tol);

}  // namespace stepmill
