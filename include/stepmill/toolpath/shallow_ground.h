#pragma once

#include <vector>

#include "stepmill/access/form_floor.h"
#include "stepmill/planar/box.h"
#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// Ground so flat that levels along it lie far apart, as a form cutter's tip goes over it.
///
/// Looked at in cells: how low the tip may be in each, and how steep that surface of lowest tips is, which is
/// how steep the ground is where the cutter touches it. Safety rests on FormFloor alone; cells only say where
/// passes over the surface are worth it.
class ShallowGround {
  public:
    ShallowGround() = default;  ///< none
    /// \param stairs   what flat layers left over ground that leans so much, seen from above
    /// \param slopes   all stairs, those of one slope joined: their rim is the ground's
    /// \param centres  where the tip may be, as far as the ground is known
    ShallowGround(const FormFloor& floor, const CutterForm& form, const Region& stairs, const Region& slopes,
                  const Region& centres, const Tolerances& tol);

    struct Cell {
        Vec2 at = Vec2::Zero();    ///< its middle
        Vec2 rise = Vec2::Zero();  ///< of the ground, per length in x and y
        double bulge_x = 0;        ///< curvature along x and y where it bulges [1/mm]
        double bulge_y = 0;
        /// The cutter touches the rim of the ground there and rolls over it: how it rises says nothing.
        bool on_rim = false;
    };
    /// Cells that lie together, row by row.
    using Patch = std::vector<Cell>;

    const std::vector<Patch>& patches() const { return patches_; }
    /// Is the tip over such ground there?
    bool isUnder(const Vec2& tip) const;
    /// Is it, or does the cutter only roll over such ground's rim there? Lines take what it meets.
    bool isUnderOrRollsOff(const Vec2& tip) const;
    /// Where the tip may be over the ground and beside it.
    const Region& centres() const { return centres_; }
    double cellMm() const { return cell_mm_; }
    /// How long passes along levels are over the patches, `step_mm` apart in height [mm].
    double levelsMm(double step_mm) const;

  private:
    struct Place {
        int column = 0;
        int row = 0;
    };
    void findHeights(const FormFloor& floor, const Tolerances& tol);
    void findShallow(const CutterForm& form, const Region& stairs, const Region& within_rim);
    void dropNarrow();
    void findRollingOff(double farthest_mm);
    bool isMarked(const std::vector<char>& marks, const Vec2& tip) const;
    void findPatches();
    Vec2 middleOf(const Place& place) const;
    std::size_t indexOf(const Place& place) const;
    bool isIn(const Place& place) const;
    double heightAt(const Place& place) const;
    Vec2 riseAt(const Place& place) const;
    double bulgeAt(const Place& place, const Place& step) const;

    Region centres_;
    double cell_mm_ = 0;
    Box2 box_;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<double> heights_;  ///< of the tip, by cell; NaN: not asked for
    std::vector<char> shallow_;
    std::vector<char> on_rim_;
    std::vector<char> rolls_off_;  ///< or shallow
    std::vector<Patch> patches_;
};

}  // namespace stepmill::toolpath
