#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
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
    /// The part in this slab and in all slabs above it: what a tool from above must keep clear of.
    Region shadow;
    /// Are all part walls of the slab vertical, so that `part` is exact at every height?
    bool vertical_walls = true;
    /// Volume of stock - part in the slab that `part` hides because walls are not vertical [mm3].
    double sloped_volume_mm3 = 0;

    double height_mm() const { return top_z_mm - bottom_z_mm; }
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
    std::vector<std::string> remarks;  ///< levels where a section had to be mended, with what was done

    /// Part material at or above this height: the union of `part` over all layers that reach above z,
    /// empty above the part. Used for holders.
    Region partAbove(double z_mm, const Tolerances& tol) const;
    /// Stock as it arrives at this height.
    const Region& stockAt(double z_mm) const;
};

struct SliceOptions {
    /// A slab with sloped walls is halved while more than this share of its removable volume would hide
    /// behind the walls, ...
    double largest_hidden_share = 0.1;
    /// ... but never below this height [mm].
    double thinnest_slab_mm = 1.0;
    /// Levels closer than this are one [mm].
    double level_merge_mm = 1e-3;
};

/// Slices part and stock of a setup [algorithms.md, section 1].
///
/// Levels: horizontal planar faces, ends and silhouette heights of the other faces, top and bottom of the
/// stock. Vertical slabs are cut once at mid-height; other slabs at both ends and between, united; if a
/// wall leans both ways the slab takes the projection of its facets instead. Sections are cut in parallel;
/// the result does not depend on the number of threads.
/// \throws Error(GeometryKernel) naming the height if a section cannot be closed.
LayerStack slice(const Setup& setup, const Tolerances& tol, const SliceOptions& options = {});

}  // namespace stepmill
