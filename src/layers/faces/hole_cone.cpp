// Countersinks and broken edges of holes among a part's faces.

#include "stepmill/layers/hole_cone.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// Cones whose axes and heights differ by less are one: STEP files have many of them in halves [mm].
constexpr double kSameMm = 5e-3;
/// A cone goes all round where its faces cover its ring but for this share.
constexpr double kAllRoundShare = 0.01;

bool opensUpwards(const FaceTrace& face) {
    return face.surface == SurfaceKind::Cone && face.hollow && face.stand == FaceStand::Leaning &&
           face.cause == SlopeCause::Chamfer && face.axis_point && face.greatest_normal_z > 0 &&
           face.greatest_normal_z < 1 && face.top_z_mm > face.bottom_z_mm;
}

HoleCone coneOf(const FaceTrace& face) {
    const double lean = face.greatest_normal_z;
    const double slope = lean / std::sqrt(1 - lean * lean);
    const double high_mm = face.top_z_mm - face.bottom_z_mm;
    return {snapToGrid(*face.axis_point),
            face.bottom_z_mm,
            face.top_z_mm,
            face.radius_mm - high_mm * slope,
            face.radius_mm,
            lean,
            {face.face}};
}

bool isSame(const HoleCone& a, const HoleCone& b) {
    const auto near = [](double one_mm, double other_mm) { return std::abs(one_mm - other_mm) < kSameMm; };
    return (a.centre - b.centre).norm() < kSameMm && near(a.top_z_mm, b.top_z_mm) &&
           near(a.bottom_z_mm, b.bottom_z_mm) && near(a.radius_mm, b.radius_mm);
}

}  // namespace

std::vector<HoleCone> holeCones(const std::vector<FaceTrace>& traces) {
    std::vector<HoleCone> cones;
    std::vector<double> covered_mm2;
    for (const FaceTrace& face : traces) {
        if (!opensUpwards(face)) continue;
        HoleCone cone = coneOf(face);
        const auto known =
            std::find_if(cones.begin(), cones.end(), [&](const HoleCone& one) { return isSame(one, cone); });
        const double mm2 = area(face.region);
        if (known != cones.end()) {
            known->faces.push_back(face.face);
            covered_mm2[static_cast<std::size_t>(known - cones.begin())] += mm2;
            continue;
        }
        cones.push_back(std::move(cone));
        covered_mm2.push_back(mm2);
    }
    std::vector<HoleCone> whole;
    for (std::size_t i = 0; i < cones.size(); ++i) {
        const HoleCone& cone = cones[i];
        const double ring_mm2 =
            kPi * (cone.radius_mm * cone.radius_mm - cone.foot_radius_mm * cone.foot_radius_mm);
        if (cone.foot_radius_mm > 0 && 2 * cone.radius_mm <= kWidestHoleConeMm &&
            covered_mm2[i] >= (1 - kAllRoundShare) * ring_mm2)
            whole.push_back(cone);
    }
    return whole;
}

}  // namespace stepmill
