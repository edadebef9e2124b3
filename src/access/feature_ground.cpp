#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "access/farthest_room.h"
#include "access/lazy_diagram.h"
#include "stepmill/access/access.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// How closely widestCutterMm() answers where the target has open edges [mm].
constexpr double kWidestCutterStepMm = 0.01;
/// Farther than that beyond all of the target an offset leaves nothing of it, rounding and all [mm].
constexpr double kBeyondMm = 0.005;

/// Radius of the widest disc clear of the obstruction that is centred in the target: the least distance at
/// which the grown obstruction covers the target. Distances alone answer most of its halvings.
double widestRadiusFromOutside(const Feature& feature, LazyDiagram& obstruction, const Tolerances& tol) {
    const access::FarthestRoom known =
        access::farthestRoom(feature.target, feature.obstruction, std::sqrt(4 * tol.area_mm2 / kPi));
    const auto roomFor = [&](double radius_mm) {
        if (radius_mm <= known.reached_mm) return true;
        if (radius_mm >= known.most_mm + kBeyondMm) return false;
        const Region grown = obstruction.of(feature.obstruction, tol).offset(radius_mm);
        return area(subtract(feature.target, grown, tol)) > tol.area_mm2;
    };
    Box2 box = boundingBox(feature.target);
    box.extend(boundingBox(feature.obstruction));
    double room_mm = 0;
    double too_much_mm = box.sizes().norm();
    while (too_much_mm - room_mm > kWidestCutterStepMm) {
        const double middle_mm = (room_mm + too_much_mm) / 2;
        (roomFor(middle_mm) ? room_mm : too_much_mm) = middle_mm;
    }
    return room_mm;
}

/// Clearances of the edges along which they stay the same for some length.
std::vector<double> evenWidths(const MedialAxis& axis, const Tolerances& tol) {
    constexpr double kLeastLengthShare = 0.1;
    std::vector<double> found_mm;
    for (const MedialAxis::Edge& edge : axis.edges) {
        const MedialAxis::Node& from = axis.nodes[edge.from];
        const MedialAxis::Node& to = axis.nodes[edge.to];
        const double least_mm = std::min(from.clearance_mm, to.clearance_mm);
        const bool even = std::abs(from.clearance_mm - to.clearance_mm) <= tol.sliver_mm;
        if (even && (from.point - to.point).norm() > kLeastLengthShare * least_mm)
            found_mm.push_back(least_mm);
    }
    return found_mm;
}

}  // namespace

struct FeatureGround::Impl {
    Feature feature;
    Tolerances tol;
    bool walled_in = false;
    // Tools share diameters and holders, and each is asked about again and again.
    LazyDiagram target;
    LazyDiagram obstruction;
    std::vector<std::unique_ptr<LazyDiagram>> obstacles;

    const ClearanceDiagram& targetDiagram() { return target.of(feature.target, tol); }
    /// Clearances of the stretches of the target that keep their width.
    std::once_flag slots_once;
    std::vector<double> slots_mm;
    std::once_flag widest_once;
    double widest_mm = 0;
};

FeatureGround::FeatureGround(const Feature& feature, const Tolerances& tol)
    : impl_(std::make_unique<Impl>()) {
    impl_->feature = feature;
    impl_->tol = tol;
    impl_->walled_in = feature.open_length_mm <= tol.sliver_mm;
    for (std::size_t i = 0; i < feature.obstacles.size(); ++i)
        impl_->obstacles.push_back(std::make_unique<LazyDiagram>());
}

FeatureGround::~FeatureGround() = default;
FeatureGround::FeatureGround(FeatureGround&&) noexcept = default;

const Feature& FeatureGround::feature() const {
    return impl_->feature;
}

const Tolerances& FeatureGround::tolerances() const {
    return impl_->tol;
}

bool FeatureGround::walledIn() const {
    return impl_->walled_in;
}

Region FeatureGround::targetOffset(double distance_mm) const {
    return impl_->targetDiagram().offset(distance_mm);
}

Region FeatureGround::targetOpening(double radius_mm) const {
    if (impl_->feature.target.empty()) return {};
    return impl_->targetDiagram().opening(radius_mm);
}

Region FeatureGround::targetRestCentres(double large_mm, double small_mm) const {
    if (impl_->feature.target.empty()) return {};
    return impl_->targetDiagram().restCentres(large_mm, small_mm);
}

Region FeatureGround::obstructionOffset(double distance_mm) const {
    return impl_->obstruction.of(impl_->feature.obstruction, impl_->tol).offset(distance_mm);
}

Region FeatureGround::obstacleOffset(std::size_t index, double distance_mm) const {
    const Region& section = impl_->feature.obstacles.at(index).section;
    return impl_->obstacles.at(index)->of(section, impl_->tol).offset(distance_mm);
}

bool FeatureGround::hasSlotOf(double radius_mm) const {
    const Tolerances& tol = impl_->tol;
    if (tol.fit_mm <= 0 || impl_->feature.target.empty()) return false;
    std::call_once(impl_->slots_once,
                   [&] { impl_->slots_mm = evenWidths(impl_->targetDiagram().medialAxis(), tol); });
    const auto& slots = impl_->slots_mm;
    return std::any_of(slots.begin(), slots.end(), [&](double clearance_mm) {
        return clearance_mm > radius_mm - tol.fit_mm && clearance_mm < radius_mm + tol.sliver_mm / 2;
    });
}

double FeatureGround::widestCutterMm() const {
    std::call_once(impl_->widest_once, [&] {
        const Feature& feature = impl_->feature;
        if (feature.target.empty()) return;
        if (impl_->walled_in) {
            const auto disc = impl_->targetDiagram().largestInscribedDisc();
            impl_->widest_mm = disc ? 2 * disc->radius_mm : 0;
        } else if (feature.obstruction.empty()) {
            impl_->widest_mm = std::numeric_limits<double>::infinity();
        } else {
            impl_->widest_mm = 2 * widestRadiusFromOutside(feature, impl_->obstruction, impl_->tol);
        }
    });
    return impl_->widest_mm;
}

std::optional<ClearanceDiagram::Disc> FeatureGround::widestDiscInTarget() const {
    if (impl_->feature.target.empty()) return std::nullopt;
    return impl_->targetDiagram().largestInscribedDisc();
}

}  // namespace stepmill
