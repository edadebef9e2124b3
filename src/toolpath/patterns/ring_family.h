#pragma once

#include <vector>

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// The curves of every component of one tool's free centres, pattern by pattern, before clipping to what is
/// left to cut.
class RingFamily {
  public:
    /// A curve of a pattern: closed and in climb direction, or a stretch of one, or a line.
    struct Ring {
        Path path;
        int level = 0;            ///< step-overs from the boundary the pattern starts at; lines: row number
        bool outside_in = false;  ///< comes before the rings of the next level, not after them
        bool either_way = false;  ///< may as well be cut from its end
    };
    /// One way to go over a component.
    struct Variant {
        Pattern pattern = Pattern::ContourInsideOut;
        double angle_rad = 0;  ///< of lines
        std::vector<Ring> rings;
        /// Rings leave the component; what lies outside is cut off.
        bool leaves_component = false;
        /// Rows of a line pattern, by level; its rings run along the walls after them.
        std::vector<Ring> lines;
        double line_spacing_mm = 0;
    };
    struct Component {
        Region region;
        /// Free centres with the guard to all boundaries.
        Region guarded;
        /// Of these, what lines have to run through: half a step-over around the target.
        Region line_ground;
        IndexedRegion indexed;         ///< the region
        EdgeIndex walls;               ///< of the boundary, where a disc touches what must stay
        std::vector<Edge> open_sides;  ///< of the boundary, where it only touches the target
        bool slot = false;             ///< as wide as the cutter: the middles are the only curves
        /// Contour-parallel from inside out first; no two give the same path.
        std::vector<Variant> variants;
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
bool cutsNothing(const IndexedRegion& target, double radius_mm, const Vec2& p, const Tolerances& tol);
/// The same of the disc all along an edge. Looked at every half radius: where a larger cutter's ground comes
/// up to a wall in between, the disc touches the target in one place and cuts on both sides of it.
bool cutsNothing(const IndexedRegion& target, double radius_mm, const Edge& edge, const Tolerances& tol);

/// May a region be cut by that pattern?
bool isAskedFor(const ClearingTask& task, Pattern pattern);

/// Do curves of neighbouring levels run side by side somewhere?
bool adjacent(const EdgeIndex& a, const EdgeIndex& b, double step_over_mm);

/// May the axis go straight from a to b, both known to be free centres of the component? Keeps the guard
/// from walls; over open sides, where no guard is needed, the ends may lie on the boundary.
bool isFreeWay(const RingFamily::Component& component, const Vec2& a, const Vec2& b, const Tolerances& tol);

}  // namespace toolpath

}  // namespace stepmill
