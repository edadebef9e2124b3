#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/layers/face_trace.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// The slab between two neighbouring levels. All regions in setup coordinates.
struct Layer {
    double top_z_mm = 0;
    double bottom_z_mm = 0;
    /// The finished part in this slab. Where walls are not vertical: the union of its sections over the
    /// slab's height, so that a flat cutter reaching the bottom cannot gouge.
    Region part;
    /// The stock as it arrives. Where its walls are not vertical: the union over the height as well.
    Region stock;
    /// What `stock` covers more than the stock itself because its walls are not vertical: cuts of earlier
    /// setups from other sides [mm3]. 0 where they are.
    double stock_air_mm3 = 0;
    /// Where `stock_air_mm3` is not 0: the stock half-way up (of joined slabs, of each of them). What of
    /// `stock` lies beyond is a skin that stands up from the floor or hangs from the top.
    Region stock_half_way;
    /// The part in this slab and in all slabs above it: what a tool from above must keep clear of.
    Region shadow;
    /// Are all part walls of the slab vertical, so that `part` is exact at every height?
    bool vertical_walls = true;
    /// Volume of stock - part in the slab that `part` hides because walls are not vertical [mm3].
    double sloped_volume_mm3 = 0;
    /// The same by what the walls are: each cause once, in the order of the enum; the volumes add up to
    /// `sloped_volume_mm3`. Empty where all walls are vertical.
    std::vector<HiddenVolume> hidden;
    /// How far `part` may reach beyond the union of the true sections [mm]: 0 unless the slab's region had
    /// to be mended from facets (`remarks` says where).
    double mended_by_mm = 0;

    double height_mm() const { return top_z_mm - bottom_z_mm; }
    double middle_z_mm() const { return (top_z_mm + bottom_z_mm) / 2; }
    /// Is its middle between these heights? So is all of it where layers end there.
    bool isWithin(double high_z_mm, double low_z_mm) const {
        return low_z_mm < middle_z_mm() && middle_z_mm() < high_z_mm;
    }
};

/// A setup's solids as planar regions between levels, from the top down. After slicing no module asks
/// OCCT for geometry again.
struct LayerStack {
    std::string setup_id;
    std::vector<Layer> layers;
    double stock_top_z_mm = 0;
    double stock_bottom_z_mm = 0;
    double stock_volume_mm3 = 0;  ///< of the solids themselves
    double part_volume_mm3 = 0;
    bool stock_cut_before = false;     ///< the stock is what earlier setups left
    double removable_mm3 = 0;          ///< Setup::removable_mm3
    std::vector<std::string> remarks;  ///< levels where a section had to be mended, with what was done
    std::vector<FaceTrace> traces;     ///< every face of the part, by face index

    /// Part material at or above this height: the union of `part` over all layers that reach above z,
    /// empty above the part. Used for holders.
    Region partAbove(double z_mm, const Tolerances& tol) const;
    /// Stock as it arrives at this height.
    const Region& stockAt(double z_mm) const;
    /// Vertical walls of the part that stand under some stretch of the path (within `reach_mm`) somewhere
    /// between the heights: the faces that a region's edges come from. Ascending face indices.
    /// O(faces x segments).
    std::vector<int> wallsAlong(const Path& path, double top_z_mm, double bottom_z_mm, double reach_mm) const;
    /// Horizontal faces of the part that look up at this height (within `reach_mm`) and lie at least partly
    /// under the region, ascending face indices.
    std::vector<int> floorsUnder(const Region& region, double z_mm, double reach_mm,
                                 const Tolerances& tol) const;
};

struct SliceOptions {
    /// A slab with sloped walls is halved while more than this share of its removable volume would hide
    /// behind the walls, ...
    double largest_hidden_share = 0.1;
    /// ... but never below this height [mm].
    double thinnest_slab_mm = 1.0;
    /// Levels are one floor to a cutter as long as the stairs that joining their slabs leaves on walls that
    /// lean are no wider than this, about what roughing leaves on a wall, [mm] ...
    double widest_stair_mm = 0.5;
    /// ... and no component loses more than this share of its area by it, none that is a hole anything.
    double largest_joined_share = 0.03;
    /// On stock that earlier setups cut, slabs are not parted either for less than this share of what all
    /// setups have to remove: steps and corners they left would make a slab at every height.
    double least_gain_share = 2e-4;
    /// The same in indexed setups, to which every wall that others cut leans: thin slabs would show steps
    /// alone.
    double least_gain_share_indexed = 5e-3;
    /// Levels closer than this are one [mm].
    double level_merge_mm = 1e-3;
    /// Join neighbouring slabs where no tool from above can tell them apart, or where joining leaves no
    /// more than the stairs above, or, where the upper one is thinner than `thinnest_slab_mm`, costs no
    /// removal component more than `largest_hidden_share` of its area. On stock that earlier setups cut, also
    /// where that costs less than `least_gain_share` in air and lost removal. Never over a horizontal plane
    /// of the part or an end of the stock.
    bool join_slabs = true;
};

/// Slices part and stock of a setup [slicing.md].
///
/// Levels: horizontal planar faces and top and bottom of the stock, which always part two slabs; ends and
/// silhouette heights of the other faces, which do where it matters (`SliceOptions::join_slabs`). Vertical
/// slabs are cut once at mid-height; in other slabs `part` covers the part at every height of the slab. A
/// section that does not close is taken a little beside its height or covered by hulls of its facets: that
/// costs the slab accuracy (`Layer::mended_by_mm`, a remark), never the part. Slabs are cut in parallel;
/// the result does not depend on the number of threads.
/// \throws Error(GeometryKernel) if a face cannot be turned into facets.
/// \note  About linear in the number of faces times layers; docs/algorithms/slicing.md has figures.
LayerStack slice(const Setup& setup, const Tolerances& tol, const SliceOptions& options = {});

}  // namespace stepmill
