#pragma once

#include <memory>
#include <vector>

#include "stepmill/planar/region.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// Heights closer than this are one, before and after they are rounded for a program [mm].
inline constexpr double kSameCutHeightMm = 3e-4;

/// The ground of one feature while its operations cut it: what of its target stands at each height. It keeps
/// the ways that cutters have gone and makes no areas of them.
class CutGround {
  public:
    /// \param top_z_mm  nothing of it stands higher
    CutGround(const Region& target, double top_z_mm);
    CutGround(CutGround&&) noexcept;
    CutGround& operator=(CutGround&&) noexcept;
    ~CutGround();

    /// An operation has gone this way. Slopes count down to their upper ends.
    void add(const Vec3& start, const std::vector<Move>& moves, double radius_mm);

  private:
    friend class CutFollower;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Widths are asked at places so far apart, as a share of the radius. They are counted from a move's start,
/// so that one that rounding has made longer or shorter is asked at the same places.
inline constexpr double kCutStepShare = 0.2;

/// A stretch of the rim that lies nowhere deeper in material than this share of the radius only grazes it. In
/// a corner of the cutter's own radius a quarter of the rim touches what is left, however thin that is.
inline constexpr double kGrazeShare = 0.02;

/// Proofs take swept ground for narrower by this share of the radius: half of what plans take.
inline constexpr double kProofCuspShare = 0.005;
/// Proofs let the rim's angle be more than planned by this share: between two positions looked at, and by
/// rounding.
inline constexpr double kProofAngleShare = 0.02;

/// Does a CutFollower measure angles beside widths?
enum class CutMeasures { Widths, WidthsAndAngles };

/// How much one move cuts.
struct MoveCut {
    /// Of a level move: width of the cutter's front rim that stands in material, across the direction of
    /// travel, every kCutStepShare of the radius from the move's start on and at its end [mm]. Null for all
    /// others: a slope counts as full width.
    const std::vector<double>* widths_mm = nullptr;
    double widest_mm = 0;
    /// Of a level move, where that is measured: the most of the front rim that stands in material, but for
    /// grazes [rad].
    double engaged_rad = 0;
    /// At most so deep; 0 for rapids and for moves straight up or down. Of a helix as deep as makes the width
    /// what it takes a length (toolpath::helixWidth).
    double depth_mm = 0;
};

/// Follows one operation over the ground and says of each move how wide and how deep it cuts.
///
/// At every position the width is exact: the rim's arcs that lie in the target and in nothing that was swept,
/// from where the rim meets their edges. Positions lie a tenth of the diameter apart at most, from just
/// inside the move's start to just inside its end. Depths of cut that repeat the one above are looked up.
///
/// The depth is the least of the step-down, of what lies under the feature's top, and of what lies under the
/// height at which the same line or arc was gone along before: so a helix cuts its pitch, not all above it.
class CutFollower {
  public:
    /// Keeps `ground`, which must not change meanwhile.
    /// \param step_down_mm  no pass goes deeper than this below what was cut before
    /// \param cusp_share  of the radius: what was swept counts as so much narrower, so that a rim that goes
    ///                    on where it was is in material. A greater share never gives a lesser width.
    CutFollower(const CutGround& ground, double radius_mm, double step_down_mm, double cusp_share,
                CutMeasures measures = CutMeasures::Widths);
    ~CutFollower();
    CutFollower(const CutFollower&) = delete;
    CutFollower& operator=(const CutFollower&) = delete;

    /// The cut of the operation's next move. Its widths stay where they are as long as the follower lives.
    MoveCut next(const Vec3& from, const Move& move);

    /// The same where only the depth is asked: `widths_mm` is null.
    MoveCut nextDepth(const Vec3& from, const Move& move);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace stepmill
