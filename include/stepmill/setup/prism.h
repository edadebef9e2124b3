#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "stepmill/planar/region.h"

namespace stepmill {

/// An upright prism in setup coordinates [mm].
struct Prism {
    Region region;        ///< its section at every height; empty: no volume
    double top_z_mm = 0;  ///< not below bottom_z_mm
    double bottom_z_mm = 0;

    double volume_mm3() const { return area(region) * (top_z_mm - bottom_z_mm); }
};

/// Sum of the prisms' volumes [mm3]; what two of them share counts twice. 0 without prisms.
double volumeOf(const std::vector<Prism>& prisms);

/// What one setup took from the stock: prisms whose interiors do not meet, in its coordinates. They err to
/// the side of material: what is not sure to be gone is in none of them. Without prisms the setup took
/// nothing.
struct CutPrisms {
    Eigen::Isometry3d part_to_setup = Eigen::Isometry3d::Identity();
    std::vector<Prism> prisms;
};

}  // namespace stepmill
