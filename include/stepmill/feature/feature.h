#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/region.h"

namespace stepmill {

enum class FeatureClass {
    Face,           ///< open all round: the whole top of the stock or of a boss
    ClosedPocket,   ///< floor, no open edge
    OpenPocket,     ///< floor, some open edges
    SlotBlind,      ///< constant width, one open end
    SlotThrough,    ///< constant width, open at two ends
    Step,           ///< open on one or more sides along a straight wall
    ThroughPocket,  ///< no floor: a window
    OpenProfile,    ///< no floor, open edges: the part's outside, a notch
    HoleBlind,      ///< one full circle with a floor
    HoleThrough,    ///< one full circle without a floor
    Engraving       ///< floor, narrower than the smallest cutter of the shop
};
std::string toString(FeatureClass feature_class);
/// One full circle, with a floor or without.
bool isHole(FeatureClass feature_class);

/// A piece of a target's boundary on one side of which the cutter may (open) or may not (closed) go.
struct BoundaryPiece {
    Path path;
    bool open = false;
};

/// Material above the floor that holders must keep clear of: `section` up to `top_z_mm`.
struct Obstacle {
    double bottom_z_mm = 0;
    double top_z_mm = 0;
    Region section;  ///< part or stock still standing anywhere at or above bottom_z_mm (shadow)
};

/// A removal volume f(p, h): floor region p and depth h [DSouza2006], in setup coordinates.
struct Feature {
    std::string id;  ///< "S1.F2"
    std::string setup_id;
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    std::vector<std::string> parents;  ///< ids that must be machined before this one
    double top_z_mm = 0;
    double floor_z_mm = 0;
    bool through = false;                 ///< nothing of part or stock lies below the floor
    Region target;                        ///< T: to be cleared down to the floor
    Region obstruction;                   ///< O: must not be touched while doing so
    std::vector<BoundaryPiece> boundary;  ///< the target's boundary, open and closed pieces in loop order
    double open_length_mm = 0;
    double closed_length_mm = 0;
    /// Smallest radius of concave wall arcs; nothing when a closed corner is sharp or there is no wall arc.
    std::optional<double> min_corner_radius_mm;
    /// In-process stock right after this feature: the shadows over the floor, from below to above.
    std::vector<Obstacle> obstacles;
    double area_mm2 = 0;
    double volume_mm3 = 0;
    /// Part faces it makes, by PartFace::index, ascending; empty until assignFaces() (face_owner.h).
    std::vector<int> faces;

    double depth_mm() const { return top_z_mm - floor_z_mm; }
};

/// What of stock - part a setup's features do not own, with the reason.
struct Unplanned {
    std::string reason;  ///< "undercut", "wall not vertical"
    double volume_mm3 = 0;
    double top_z_mm = 0;
    double bottom_z_mm = 0;
    Region region;
};

struct FeatureSet {
    std::vector<Feature> features;  ///< parents before children
    std::vector<Unplanned> unplanned;
};

/// Finds the removal features of a setup [algorithms.md, section 2]: removal = stock - shadow per layer,
/// its components linked into a forest; a child equal to its parent only deepens it, any other child is a
/// feature nested in its parent.
FeatureSet recogniseFeatures(const LayerStack& layers, const Tolerances& tol);

/// Pockets and slots with a floor into which a cutter of that diameter does not go anywhere become
/// engravings: a shop traces them with a point instead of clearing them. Holes stay holes.
void nameEngravings(FeatureSet& found, double smallest_cutter_mm, const Tolerances& tol);

}  // namespace stepmill
