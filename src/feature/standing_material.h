#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "feature/removal_forest.h"
#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// What stands in a setup while a feature is machined: the finished part and the stock that features
/// other than it and its ancestors own, each seen from above.
///
/// A removal component that nothing of the stock's boundary bounds is walled in by the shadow, so no disc
/// outside can reach into it without meeting the shadow first, and none inside can leave it. Only open
/// components can be in each other's way; all others are left out, which keeps the regions simple.
class StandingMaterial {
  public:
    StandingMaterial(const LayerStack& layers, const RemovalForest& forest, const Tolerances& tol);

    /// Everything standing at or above the bottom of `layer`, once the components in `removed` (ascending)
    /// are gone.
    const SharedRegion& above(int layer, const std::vector<int>& removed);

    /// The same for `layer` and all above it, from below to above, equal neighbours merged.
    std::vector<Obstacle> obstacles(int layer, const std::vector<int>& removed);

  private:
    /// What stands whatever is machined: the shadow, and what no feature takes.
    const SharedRegion& ground(int layer);

    /// Are the removed components of the layer bounded by the shadow alone?
    bool walledIn(int layer, const std::vector<int>& removed) const;
    std::vector<int> inTheWay(int layer, const std::vector<int>& removed) const;

    /// The ground of a layer with components of it and of layers above, ascending.
    const SharedRegion& united(int layer, std::vector<int> standing);

    const LayerStack& layers_;
    const RemovalForest& forest_;
    const Tolerances& tol_;
    std::deque<SharedRegion> grounds_;  ///< of the layers asked for so far, from the top
    std::vector<bool> leaves_;          ///< is anything left in this layer or above?
    std::map<std::pair<int, std::vector<int>>, SharedRegion> known_;
};

}  // namespace stepmill::feature
