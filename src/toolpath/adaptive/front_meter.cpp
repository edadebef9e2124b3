// The engagement of passes along the front of the ground that is clear.

#include "toolpath/adaptive/front_meter.h"

#include <algorithm>
#include <cmath>

#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "toolpath/engagement/rim.h"

namespace stepmill::toolpath {
namespace {

/// Places looked at lie no farther apart, as a share of the radius ...
constexpr double kPlaceShare = 0.05;
/// ... and divide each edge into so many parts at least.
constexpr int kLeastParts = 4;
/// Beyond so many times the limit it does not matter how much it is exceeded.
constexpr double kFarOver = 1.5;
/// The angle may be more than planned by half of what proofs allow, for what is between the places that are
/// looked at.
constexpr double kOverAngleShare = kProofAngleShare / 2;
/// Swept ground is taken for narrower, and grazes for thinner, than proofs have them by these shares of what
/// those allow: where both would be equal rounding decides.
constexpr double kMoreCusp = 1.1;
constexpr double kThinnerGraze = 0.9;

}  // namespace

EngagementLimit engagementLimit(double radius_mm, double step_over_mm) {
    return {step_over_mm + kProofCuspShare * radius_mm,
            (1 + kOverAngleShare) * engagementRad(radius_mm, step_over_mm)};
}

FrontMeter::FrontMeter(const ClearanceDiagram& cleared, const Region& target, double radius_mm,
                       const EngagementLimit& limit, const Tolerances& tol)
    : cleared_(cleared.region()),
      material_(subtract(target, cleared.offset(radius_mm * (1 - kMoreCusp * kProofCuspShare)), tol)),
      deep_(subtract(target, cleared.offset(radius_mm * (1 + kThinnerGraze * kGrazeShare)), tol)),
      radius_mm_(radius_mm),
      limit_(limit) {}

FrontCut FrontMeter::measure(const Path& pass) const {
    FrontCut found;
    double before_mm = 0;
    for (const Edge& edge : edgesOf(pass)) {
        const double length_mm = length(edge);
        const int parts =
            std::max(kLeastParts, static_cast<int>(std::ceil(length_mm / (kPlaceShare * radius_mm_))));
        for (int i = 0; i <= parts; ++i) {
            const double share = static_cast<double>(i) / parts;
            const double width_mm = look(pointAt(edge, share), tangentAt(edge, share), found);
            found.places.push_back({before_mm + share * length_mm, width_mm});
            if (found.worst_share > kFarOver) return found;
        }
        before_mm += length_mm;
    }
    return found;
}

double FrontMeter::engagementAt(const Vec2& at, const Vec2& along) const {
    FrontCut found;
    look(at, along, found);
    return found.worst_share;
}

double FrontMeter::look(const Vec2& at, const Vec2& along, FrontCut& into) const {
    if (cleared_.contains(at)) return 0;
    const Box2 around = grown(Box2(at), radius_mm_);
    const auto edgesNear = [&](const IndexedRegion& region) {
        std::vector<const Edge*> near;
        region.boundary().forEachIn(around, [&](const Edge& edge) { near.push_back(&edge); });
        return near;
    };
    Rim rim(at, along, radius_mm_);
    const std::vector<const Edge*> near = edgesNear(material_);
    const double width_mm = rim.freeWidthInMm(material_, near);
    if (width_mm <= 0) return 0;
    const Engaged engaged = rim.engagedIn(material_, near, rim.freeIn(deep_, edgesNear(deep_)));
    into.worst_share = std::max(
        {into.worst_share, engaged.width_mm / limit_.width_mm, engaged.angle_rad / limit_.angle_rad});
    return width_mm;
}

}  // namespace stepmill::toolpath
