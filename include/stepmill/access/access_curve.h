#pragma once

#include <string>
#include <vector>

#include "stepmill/access/access.h"

namespace stepmill {

/// What happens to the area a cutter reaches as its diameter passes a certain value.
enum class AccessEventKind {
    Neck,          ///< passage between two walls: wider cutters no longer get through
    CornerRadius,  ///< twice the radius of inside corners: wider cutters leave material in them
    Vanishes       ///< a room no wider cutter fits into
};
std::string toString(AccessEventKind kind);

/// Coverable area and access volume [Lim2000] of a cutter of this diameter.
struct AccessSample {
    double diameter_mm = 0;
    double area_mm2 = 0;
    double volume_mm3 = 0;  ///< area x depth of the feature
};

struct AccessEvent {
    double diameter_mm = 0;
    AccessEventKind kind = AccessEventKind::Neck;
    /// Everywhere it happens at this diameter: middles of necks, centres of corner arcs, where the last disc
    /// stands in a room that vanishes. Ordered by y, then x.
    std::vector<Vec2> at;
    /// Areas just below and just above, at most 2 `linear_mm` apart. A neck of parallel walls and a room that
    /// vanishes make a jump; a neck between two points and a corner radius bend the curve only.
    double area_before_mm2 = 0;
    double area_after_mm2 = 0;
};

/// Coverable area as a function of the cutter's diameter; never rises. A jump stands as two samples at most
/// 2 `linear_mm` apart.
struct AccessCurve {
    std::vector<AccessSample> samples;  ///< by rising diameter
    std::vector<AccessEvent> events;    ///< by rising diameter, then kind
    /// Between samples straight interpolation is no farther off than this [mm2].
    double max_error_mm2 = 0;

    /// Interpolated; constant beyond the ends.
    /// \pre samples not empty
    double areaAt(double diameter_mm) const;
    double volumeAt(double diameter_mm) const;
};

struct AccessCurveOptions {
    /// Largest error of straight interpolation as a share of the target's area.
    double max_error_share = 1e-3;
    /// Even steps the range starts with; only what hides between two of them without changing either the
    /// area beyond the error or the number of centre regions can be missed.
    int first_steps = 32;
};

/// The coverable area for every diameter between `from_mm` and `to_mm`: geometry alone. How a tool gets in
/// (plunge, ramp, helix, over an edge), its flutes and its holder do not count, so the curve belongs to the
/// feature and not to a library; toolReach() of one tool may be less.
///
/// Jumps are enclosed by bisection on the area and on the number of centre regions to 2 `linear_mm`; necks
/// and corner radii come exactly from the walls [docs/algorithms/access-curve.md]. Diameter 0 stands for the
/// limit: the target itself.
/// O(samples) openings and O(n^2) for the necks of n wall edges.
/// \pre 0 <= from_mm < to_mm
AccessCurve accessCurve(const FeatureGround& ground, double from_mm, double to_mm,
                        const AccessCurveOptions& options = {});

}  // namespace stepmill
