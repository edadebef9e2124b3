#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "layers/monotone_piece.h"
#include "layers/stock/askew_cut.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill::layers {

/// A prism across a setup's axis, seen along its own.
struct LyingCut {
    int cut = 0;  ///< prisms of one setup have one number and are sorted along the sweep
    std::vector<MonotonePiece> outline;  ///< x: place along the slab, y: height in the setup
    double low_mm = 1e300;
    double high_mm = -1e300;
    Vec2 origin;  ///< of places and reaches, in the setup's plane
    Vec2 along;   ///< direction of places
    Vec2 sweep;   ///< direction of the prism's axis
    double from_mm = 0;
    double to_mm = 0;

    /// Corners of what a stretch of places covers in the plane, from the prism's near end to `reach_to`,
    /// counter-clockwise.
    std::vector<Vec2> box(double place_from, double place_to, double reach_to) const;
    /// Do the boxes lie along x and y?
    bool alongAxes() const;
};

/// At which of the heights between two something is air.
enum class AtHeights { All, Some };

/// What is air at all or some of the heights between two, as what it comes from.
struct AirParts {
    std::vector<int> upright;    ///< numbers of the upright prisms there
    std::vector<Box2> boxes;     ///< of lying prisms along x or y
    std::vector<Region> turned;  ///< rectangles of other lying prisms
};

/// The air that earlier setups cut into a stock, seen from another setup.
///
/// Prisms along the same axis are upright here, in either sense. Prisms across it lie: between two heights
/// they are rectangles, from where their outline is clear of both ends of the slab and of all between.
/// Prisms along other axes are polygons a little inside theirs (askew_cut.h). Everything follows from the
/// prisms' lines and arcs: no solid is cut and nothing is sampled, so faces that coincide do no harm.
class StockAir {
  public:
    /// \param setup            its stock's cuts, seen in its coordinates
    /// \param least_level_mm3  smaller cuts add no planes()
    StockAir(const Setup& setup, double least_level_mm3, const Tolerances& tol);

    bool empty() const { return upright_.empty() && lying_.empty() && askew_.empty(); }
    /// Are there cuts to which walls lean at every height, along axes askew to the setup's?
    bool leans() const { return !askew_.empty(); }
    /// Heights of horizontal walls of the cuts and of the ends of their outlines [mm], ascending.
    const std::vector<double>& planes() const { return planes_; }
    /// The height nearest to the middle, in the middle half of the slab, where the outline of a cut turns
    /// or bends; the middle itself where there is none.
    double bendNearMiddle(double bottom_mm, double top_mm) const;
    /// What is air at every height of the slab. O(edges of the cuts) and a union. The union of the upright
    /// prisms is made once for all slabs they span.
    Region between(double bottom_mm, double top_mm) const;
    /// The ground without what is air at all, or what may be air at some height of the slab. Of the cuts only
    /// those near the ground cost anything.
    Region subtractedFrom(const Region& ground, double bottom_mm, double top_mm, AtHeights which) const;
    /// What is air at that height.
    Region at(double z_mm) const { return between(z_mm, z_mm); }
    /// Air at that height over the region [mm2], from boundaries and scan lines.
    double areaIn(const Region& over, double z_mm) const;
    /// Is `between` all the air there is in the slab?
    bool isUpright(double bottom_mm, double top_mm) const;
    /// Air in the slab over the region [mm3]; where walls lean by quadrature over as many stretches between
    /// bends, with 32 to about a thousandth of what they hide. Areas come from boundaries and scan lines: one
    /// boolean for each set of upright prisms, none for each height.
    double volumeIn(const Region& over, double bottom_mm, double top_mm, int most_stretches) const;

  private:
    class Meter;

    void add(const CutPrisms& cut, const Setup& setup);
    AirParts partsBetween(double bottom_mm, double top_mm, AtHeights which = AtHeights::All) const;
    void addLyingBoxes(double bottom_mm, double top_mm, AtHeights which, AirParts& air) const;
    std::vector<Region> air(double bottom_mm, double top_mm, AtHeights which,
                            const std::optional<Box2>& near) const;
    Region uprightUnion(const std::vector<int>& numbers) const;
    Region stackedUnion(double bottom_mm, double top_mm) const;
    void addLying(const CutPrisms& cut, const Eigen::Isometry3d& to_setup);
    void addHeights(const std::vector<MonotonePiece>& loop, bool parts_slabs, LyingCut& lying);

    Tolerances tol_;
    double least_level_mm3_;
    std::vector<Prism> upright_;
    std::vector<LyingCut> lying_;
    std::vector<AskewCut> askew_;
    std::vector<double> planes_;
    std::vector<double> bends_;  ///< heights where the outline of a cut turns or bends

    /// Unions of upright prisms by their numbers. Shared by the slabs, whatever thread cuts them.
    struct Unions {
        std::mutex mutex;
        std::map<std::vector<int>, Region> by_numbers;
    };
    std::unique_ptr<Unions> unions_ = std::make_unique<Unions>();
};

}  // namespace stepmill::layers
