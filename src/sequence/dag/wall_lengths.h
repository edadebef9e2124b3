#pragma once

#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

/// Wall that a cutter touches; no way along it is shorter [mm].
struct WallLength {
    double least_mm = 0;         ///< of straight walls and of those that bulge, sure to be touched
    double most_mm = 0;          ///< of the same, sure to hold all that is touched
    double hollow_least_mm = 0;  ///< the centre's way along hollow arcs, sure to be gone
};

/// The walls of a feature: edges of its target that lie on what must stay.
class Walls {
  public:
    Walls(const Feature& feature, const Tolerances& tol);

    /// Material up to a wall is cut by none but a centre at the radius from it, so that the cutter goes along
    /// all of the wall that it touches, but for what tolerances let stand at the ends of each stretch. Rooms
    /// hardly wider than the cutter, where one way touches both walls, count in `most_mm` alone.
    /// Cost: walls times the logarithm of the boundary of the free centres.
    WallLength touchedBy(const CutterArea& cutter) const;

  private:
    std::vector<Edge> walls_;
    Tolerances tol_;
};

}  // namespace stepmill
