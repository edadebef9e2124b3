#pragma once

#include "setup/facets.h"

namespace stepmill::setup {

/// Faces this near to level or upright are floors or walls (0.6 degrees).
inline constexpr double kUprightSine = 0.01;

/// How a tool along an axis meets a place in front of a face.
enum class Reach : char {
    None,     ///< the part is in the way
    Poor,     ///< free, but the place lies deep in a narrow gap: long slim tools
    Steps,    ///< free, but the face is neither floor nor wall to this axis: flat cutters leave steps on it
    Finished  ///< free, and the face is a floor or a wall within reach of common tools
};

/// Places that all axes reach in the same way.
struct SampleGroup {
    std::vector<Reach> reach;      ///< by axis
    std::vector<double> depth_mm;  ///< by axis: mean way a tool has through the stock; 0 where in the way
    double volume_share = 0;       ///< of all volume to be removed
    /// Sum over the part's faces of the share of the face's places, and a little for sharp corners.
    double faces = 0;
    /// Of `volume_share`, what lies in front of planes, cylinders and cones: worth a setup that finishes it.
    double ruled_share = 0;
};

/// Places a little in front of the part's faces, wherever there is material to be removed there, and which
/// axes reach them. A place stands for its share of the face times the free height above it to the stock's
/// skin, or half the gap to the part opposite. Sharp corners between planes have places as well, that no axis
/// along them reaches and that are worth less than a setup: a tool along a corner leaves it round.
///
/// \param stock  its facets are asked unless it is a box
std::vector<SampleGroup> sampleReach(const Part& part, const FaceFacets& part_facets, const Stock& stock,
                                     const Facets& stock_facets, const std::vector<Vec3>& axes);

}  // namespace stepmill::setup
