// The engagement of passes along the front of the ground that is clear.

#include "toolpath/adaptive/front_meter.h"

#include <algorithm>
#include <cmath>

#include "toolpath/engagement/rim.h"

namespace stepmill::toolpath {
namespace {

/// Places looked at lie no farther apart, as a share of the radius ...
constexpr double kPlaceShare = 0.1;
/// ... and divide each edge into so many parts at least.
constexpr int kLeastParts = 4;
/// Beyond so many times the limit it does not matter how much it is exceeded.
constexpr double kFarOver = 1.5;
/// The angle may be more than planned by this share: three quarters of what proofs allow, for what is between
/// the places that are looked at.
constexpr double kOverAngleShare = 0.015;

}  // namespace

EngagementLimit engagementLimit(double radius_mm, double step_over_mm) {
    return {step_over_mm + kProofCuspShare * radius_mm,
            (1 + kOverAngleShare) * std::acos(1 - step_over_mm / radius_mm)};
}

FrontMeter::FrontMeter(const Region& cleared, const IndexedRegion& target, double radius_mm,
                       const EngagementLimit& limit)
    : cleared_(cleared), target_(target), radius_mm_(radius_mm), limit_(limit) {}

FrontCut FrontMeter::measure(const Path& pass) const {
    FrontCut found;
    for (const Edge& edge : edgesOf(pass)) {
        const int parts =
            std::max(kLeastParts, static_cast<int>(std::ceil(length(edge) / (kPlaceShare * radius_mm_))));
        for (int i = 0; i <= parts; ++i) {
            const double share = static_cast<double>(i) / parts;
            look(pointAt(edge, share), tangentAt(edge, share), found);
            if (found.worst_share > kFarOver) return found;
        }
    }
    return found;
}

void FrontMeter::look(const Vec2& at, const Vec2& along, FrontCut& into) const {
    if (cleared_.contains(at)) return;
    Rim rim(at, along, radius_mm_);
    Rim beyond_grazes(at, along, radius_mm_);
    cleared_.boundary().forEachIn(grown(Box2(at), 2 * radius_mm_), [&](const Edge& edge) {
        rim.cover(edge, radius_mm_ * (1 - kProofCuspShare));
        beyond_grazes.cover(edge, radius_mm_ * (1 + kGrazeShare));
    });
    if (rim.isCovered()) return;
    std::vector<const Edge*> near;
    target_.boundary().forEachIn(grown(Box2(at), radius_mm_),
                                 [&](const Edge& edge) { near.push_back(&edge); });
    into.cuts = into.cuts || rim.freeWidthInMm(target_, near) > 0;
    const Engaged engaged = rim.engagedIn(target_, near, beyond_grazes);
    into.worst_share = std::max(
        {into.worst_share, engaged.width_mm / limit_.width_mm, engaged.angle_rad / limit_.angle_rad});
}

}  // namespace stepmill::toolpath
