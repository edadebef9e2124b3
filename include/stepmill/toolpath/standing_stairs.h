#pragma once

#include <vector>

#include "stepmill/catalog/cutter_form.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// Ways of a tip at one height.
struct LevelWays {
    double tip_z_mm = 0;
    std::vector<Path> ways;
};

/// A way of the tip that goes up and down with the ground: straight from each point to the next.
using SurfaceWay = std::vector<Vec3>;

/// The stairs of a form ground while form cutters take them off.
///
/// They are known half-way up slices a tenth of a millimetre high, or as high as the bands or stairs are.
/// What the bands cover of the part beyond its true walls does not count as stairs, so no volume is more than
/// there is.
class StandingStairs {
  public:
    StandingStairs(const FormGround& ground, const Tolerances& tol);

    /// What stands at one height in one component of the window, and what height it stands for.
    struct Slice {
        double z_mm = 0;
        double bottom_mm = 0;
        double top_mm = 0;
        Region region;

        double height_mm() const { return top_mm - bottom_mm; }
    };
    const std::vector<Slice>& slices() const { return slices_; }
    double volumeMm3() const;

    /// Takes off what a cutter sweeps along the ways. Ways far below a slice are left out of its account:
    /// what they reach there is no more than what others above them did.
    void cut(const LevelWays& level, const CutterForm& form);
    /// The same along ways that go up and down. At a height it counts no more than the radius that the cutter
    /// has there at a few heights over its tip, so it is a little less than they take.
    void cut(const std::vector<SurfaceWay>& ways, const CutterForm& form);

  private:
    void addSlices(const Obstacle& stair, double bottom_mm, double top_mm, const std::vector<Obstacle>& bands,
                   const std::vector<Region>& places);

    Tolerances tol_;
    std::vector<Slice> slices_;  ///< from below to above
};

/// The ways of a path's feeds that go level, by height from above; plunges and rapids cut nothing here, and
/// surfaceWays() are left out.
std::vector<LevelWays> levelWays(const Vec3& start, const std::vector<Move>& moves);

/// Straight feeds one after another, some of which go up or down sideways.
std::vector<SurfaceWay> surfaceWays(const Vec3& start, const std::vector<Move>& moves);

}  // namespace stepmill
