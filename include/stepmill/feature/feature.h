#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/reason.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/region.h"
#include "stepmill/planar/shared_region.h"

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
    HoleBlind,      ///< a full circle, or several equal ones, with a floor
    HoleThrough,    ///< a full circle, or several equal ones, without a floor
    Engraving       ///< floor, narrower than the smallest cutter of the shop
};
std::string toString(FeatureClass feature_class);
/// The reverse; nothing for another word.
std::optional<FeatureClass> featureClassFrom(std::string_view word);
/// Full circles, with a floor or without.
bool isHole(FeatureClass feature_class);
/// False for what goes through.
bool hasFloor(FeatureClass feature_class);

/// A piece of a target's boundary. The cutter may cross an open piece; a closed one is a wall.
struct BoundaryPiece {
    Path path;
    bool open = false;
};

/// Material above the floor that shank and holder must keep clear of, as an upright prism in setup
/// coordinates. Errs outwards: the true material lies inside.
struct Obstacle {
    double bottom_z_mm = 0;
    double top_z_mm = 0;
    SharedRegion section;  ///< part or stock that stands anywhere at or above bottom_z_mm (the shadow)
};

/// Which of the bands it is that one feature is parted into, one below the other: where its walls lean, every
/// level has a target of its own, and a deep one is cut in several by tools of several lengths.
struct Band {
    std::string of;  ///< id of the whole feature
    int number = 1;  ///< from above, from 1 on
    int count = 1;

    /// Does the feature go on below? Then the band's floor is no face of the part.
    bool isUpper() const { return number < count; }
};

/// Diameters from one to another, both among them [mm].
struct DiameterRange {
    double least_mm = 0;
    double most_mm = 0;

    bool holds(double diameter_mm) const { return diameter_mm >= least_mm && diameter_mm <= most_mm; }
};

/// A removal volume f(p, h) with the floor region p and the depth h [DSouza2006], in setup coordinates. Outer
/// loops of its regions run counter-clockwise, holes clockwise.
struct Feature {
    std::string id;  ///< "S1.F2"
    std::string setup_id;
    std::optional<Band> band;  ///< nothing: the feature is whole
    /// Common ground: ids of the nested features, from above, that it was taken out of, to be cut down
    /// through all of them at once; empty for any other feature [common-ground.md].
    std::vector<std::string> ground_of;
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    std::vector<std::string> parents;  ///< ids that must be machined before this one
    double top_z_mm = 0;
    double floor_z_mm = 0;
    /// Nothing of part or stock lies below the floor; a hole is through, too, where the part leaves a drill
    /// room to come out, as into another hole.
    bool through = false;
    /// Of such a hole over part: so far below the floor that leaves its circle free [mm].
    std::optional<double> room_below_mm;
    /// Of a blind hole: so deep below the floor the part leaves a drill's point free, a cone on the whole
    /// floor; 0: the floor is flat. No volume of the feature [mm].
    double point_mm = 0;
    /// Of holes that are brought to their fit afterwards: drills so wide make them; nothing: drills of their
    /// own width. Set while they are planned alone.
    std::optional<DiameterRange> drilled;
    Region target;             ///< T: the ground to clear down to the floor
    SharedRegion obstruction;  ///< O: what the cutter must not touch while it clears T
    /// What the stock may have too much of beside the obstruction: cutters may cut it, rapids and holders
    /// stay off it. Empty unless onGrownStock() (plan/grown_feature.h) made it.
    Region skirt;
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

/// Over this height nothing stands beside the feature and in it [mm].
double highestMm(const Feature& feature);

/// A part of stock - part that no feature of the setup owns.
struct Unplanned {
    StayReason reason;
    double volume_mm3 = 0;
    double top_z_mm = 0;
    double bottom_z_mm = 0;
    Region region;
};

struct FeatureSet {
    std::vector<Feature> features;  ///< parents before children
    std::vector<Unplanned> unplanned;
};

/// Finds the removal features of a setup [features.md].
///
/// Removal is stock less shadow per layer, its components linked into a forest. A child equal to its parent
/// only deepens it; any other child is a feature nested in its parent. Where earlier setups cut the stock,
/// components may also join that are wider, narrower or several, as long as nothing but air lies between.
///
/// \param tol  components nowhere wider than `sliver_mm` are no features: their volume is booked under
///             `unplanned`
/// \return  Volumes of features and of what is unplanned add up to stock less part as the layers have it, so
///          that walls which lean err to the part's side. No features where nothing is left to remove.
/// \throws  Error(GeometryKernel) where a Boolean of two layers fails.
/// \note    About linear in layers times their edges; the same for any number of threads.
/// \see     assignFaces() (face_owner.h), which fills Feature::faces
FeatureSet recogniseFeatures(const LayerStack& layers, const Tolerances& tol);

/// Turns pockets and slots that a cutter of that diameter fits nowhere into engravings: a shop traces them
/// with a pointed tool instead of clearing them. Holes stay holes. A window has no floor and stays what it
/// is.
void nameEngravings(FeatureSet& found, double smallest_cutter_mm, const Tolerances& tol);

}  // namespace stepmill
