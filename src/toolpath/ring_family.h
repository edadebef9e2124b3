#pragma once

#include <vector>

#include "stepmill/toolpath/toolpath.h"
#include "toolpath/curve.h"

namespace stepmill {

/// The rings of every component of one tool's free centres, before clipping to what is left to cut.
class RingFamily {
  public:
    /// A closed curve in climb direction.
    struct Ring {
        Loop loop;
        int level = 0;            ///< step-overs from the boundary the family starts at
        bool outside_in = false;  ///< comes before the rings of the next level, not after them
    };
    struct Component {
        Region region;
        std::vector<toolpath::Edge> boundary;
        std::vector<Ring> rings;
        /// Rings follow the walls alone and leave the component over its open sides.
        bool follows_walls = false;
    };

    /// \pre 0 < step_over_mm <= radius_mm
    RingFamily(const ClearingTask& task, double radius_mm, double step_over_mm, const Tolerances& tol);

    double radiusMm() const { return radius_mm_; }
    double stepOverMm() const { return step_over_mm_; }
    const std::vector<Component>& components() const { return components_; }

  private:
    double radius_mm_;
    double step_over_mm_;
    std::vector<Component> components_;
};

namespace toolpath {

/// Points nearer to a boundary than this are on it: rings keep the guard from the boundaries they follow.
double onBoundaryMm(const Tolerances& tol);

/// Does a disc at p do no more than touch the target?
bool cutsNothing(const Region& target, double radius_mm, const Vec2& p, const Tolerances& tol);

/// Do curves of neighbouring levels run side by side somewhere?
bool adjacent(const std::vector<Edge>& a, const std::vector<Edge>& b, double step_over_mm);

}  // namespace toolpath

}  // namespace stepmill
