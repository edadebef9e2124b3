#pragma once

#include <cstddef>
#include <vector>

#include "planar/clearance_diagram_trace.h"

namespace stepmill::clearance {

/// A tree of boxes over a region's true lines and arcs, for questions of distance.
class SiteIndex {
  public:
    SiteIndex() = default;
    explicit SiteIndex(const SiteSet& set);

    /// Does any line or arc come closer to p? O(log n) where few do.
    bool closerThan(const Vec2& p, double distance_mm) const;

  private:
    struct Node {
        Box2 box;
        std::size_t begin = 0;  ///< sites below it, in sites_
        std::size_t end = 0;
        int left = -1;  ///< its first child; -1 for a leaf
        int right = -1;
    };
    int build(std::size_t begin, std::size_t end);

    std::vector<Site> sites_;
    std::vector<Box2> boxes_;  ///< of the sites
    std::vector<Node> nodes_;
};

/// Distances from the boundary an offset may have.
struct DistanceBand {
    double least_mm = 0;
    double most_mm = 0;
};

/// Do joints and points between them keep that distance from the whole boundary? Catches a topology that the
/// chords got wrong.
bool keepDistance(const SiteIndex& index, const std::vector<Loop>& loops, const DistanceBand& band);

}  // namespace stepmill::clearance
