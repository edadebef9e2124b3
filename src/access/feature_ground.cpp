#include <algorithm>
#include <limits>
#include <map>
#include <mutex>

#include "access/lazy_diagram.h"
#include "stepmill/access/access.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// How closely widestCutterMm() answers where the target has open edges [mm].
constexpr double kWidestCutterStepMm = 0.01;

Region offsetOf(LazyDiagram& diagram, const Region& region, double distance_mm, const Tolerances& tol) {
    if (region.empty() || distance_mm == 0) return region;
    return diagram.of(region, tol).offset(distance_mm);
}

/// Radius of the widest disc clear of the obstruction that is centred in the target: the least distance at
/// which the grown obstruction covers the target.
double widestRadiusFromOutside(const FeatureGround& ground) {
    const Region& target = ground.feature().target;
    const auto roomFor = [&](double radius_mm) {
        const Region left = subtract(target, ground.obstructionOffset(radius_mm), ground.tolerances());
        return area(left) > ground.tolerances().area_mm2;
    };
    Box2 box = boundingBox(target);
    const Box2 walls = boundingBox(ground.feature().obstruction);
    box.extend(walls);
    double room_mm = 0;
    double too_much_mm = box.sizes().norm();
    while (too_much_mm - room_mm > kWidestCutterStepMm) {
        const double middle_mm = (room_mm + too_much_mm) / 2;
        (roomFor(middle_mm) ? room_mm : too_much_mm) = middle_mm;
    }
    return room_mm;
}

/// What shank and holder keep off, with what it was grown to: tools have few holders between them, and each
/// is asked about again and again.
class LazyObstacle {
  public:
    Region offset(const Region& section, double distance_mm, const Tolerances& tol) {
        {
            const std::lock_guard lock(mutex_);
            if (const auto known = offsets_.find(distance_mm); known != offsets_.end()) return known->second;
        }
        // Not under the lock: making it may start tasks. Two threads that make the same make equal ones.
        Region made = offsetOf(diagram_, section, distance_mm, tol);
        const std::lock_guard lock(mutex_);
        return offsets_.emplace(distance_mm, std::move(made)).first->second;
    }

  private:
    LazyDiagram diagram_;
    std::mutex mutex_;
    std::map<double, Region> offsets_;
};

}  // namespace

struct FeatureGround::Impl {
    Feature feature;
    Tolerances tol;
    bool walled_in = false;
    std::unique_ptr<LazyDiagram> target = std::make_unique<LazyDiagram>();
    std::unique_ptr<LazyDiagram> obstruction = std::make_unique<LazyDiagram>();
    std::vector<std::unique_ptr<LazyObstacle>> obstacles;
    std::once_flag widest_once;
    double widest_mm = 0;
};

FeatureGround::FeatureGround(const Feature& feature, const Tolerances& tol)
    : impl_(std::make_unique<Impl>()) {
    impl_->feature = feature;
    impl_->tol = tol;
    impl_->walled_in = feature.open_length_mm <= tol.sliver_mm;
    for (std::size_t i = 0; i < feature.obstacles.size(); ++i)
        impl_->obstacles.push_back(std::make_unique<LazyObstacle>());
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
    return offsetOf(*impl_->target, impl_->feature.target, distance_mm, impl_->tol);
}

Region FeatureGround::targetOpening(double radius_mm) const {
    if (impl_->feature.target.empty()) return {};
    return impl_->target->of(impl_->feature.target, impl_->tol).opening(radius_mm);
}

Region FeatureGround::targetRestCentres(double large_mm, double small_mm) const {
    if (impl_->feature.target.empty()) return {};
    return impl_->target->of(impl_->feature.target, impl_->tol).restCentres(large_mm, small_mm);
}

Region FeatureGround::obstructionOffset(double distance_mm) const {
    return offsetOf(*impl_->obstruction, impl_->feature.obstruction, distance_mm, impl_->tol);
}

Region FeatureGround::obstacleOffset(std::size_t index, double distance_mm) const {
    return impl_->obstacles.at(index)->offset(impl_->feature.obstacles.at(index).section, distance_mm,
                                              impl_->tol);
}

double FeatureGround::widestCutterMm() const {
    std::call_once(impl_->widest_once, [&] {
        const Feature& feature = impl_->feature;
        if (feature.target.empty()) return;
        if (impl_->walled_in) {
            const auto disc = impl_->target->of(feature.target, impl_->tol).largestInscribedDisc();
            impl_->widest_mm = disc ? 2 * disc->radius_mm : 0;
        } else if (feature.obstruction.empty()) {
            impl_->widest_mm = std::numeric_limits<double>::infinity();
        } else {
            impl_->widest_mm = 2 * widestRadiusFromOutside(*this);
        }
    });
    return impl_->widest_mm;
}

std::optional<ClearanceDiagram::Disc> FeatureGround::widestDiscInTarget() const {
    if (impl_->feature.target.empty()) return std::nullopt;
    return impl_->target->of(impl_->feature.target, impl_->tol).largestInscribedDisc();
}

}  // namespace stepmill
