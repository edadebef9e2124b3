#include "stepmill/access/swept.h"

#include <mutex>
#include <vector>

#include "access/lazy_diagram.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

struct SureSweep::Made {
    Region centres;
    double radius_mm = 0;
    Region given_up;
    Tolerances tol;
    std::once_flag once;
    Region region;
    LazyDiagram diagram;

    const Region& swept() {
        std::call_once(once, [&] {
            if (!centres.empty()) region = sweep();
        });
        return region;
    }

    Region sweep() const {
        const double half_sliver_mm = access::halfSliverMm(tol);
        const Region wide = offset(centres, -half_sliver_mm, tol);
        Region sure = access::swept(wide, radius_mm + half_sliver_mm, tol);
        return given_up.empty() ? sure : subtract(sure, given_up, tol);
    }
};

SureSweep::SureSweep() : made_(std::make_shared<Made>()) {}

SureSweep::SureSweep(Region centres, double radius_mm, Region given_up, const Tolerances& tol) : SureSweep() {
    made_->centres = std::move(centres);
    made_->radius_mm = radius_mm;
    made_->given_up = std::move(given_up);
    made_->tol = tol;
}

SureSweep::SureSweep(Region swept, const Tolerances& tol) : SureSweep() {
    made_->region = std::move(swept);
    made_->tol = tol;
}

const Region& SureSweep::region() const {
    return made_->swept();
}

Region SureSweep::shrunk(double by_mm) const {
    const Region& swept = made_->swept();
    return swept.empty() ? Region{} : made_->diagram.of(swept, made_->tol).offset(-by_mm);
}

namespace access {

Region swept(const Region& centres, double radius_mm, const Tolerances& tol) {
    std::vector<Region> grown;
    for (const Region& component : components(centres))
        grown.push_back(offset(component, radius_mm, tol));
    if (grown.empty()) return {};
    return grown.size() == 1 ? std::move(grown.front()) : unite(grown, tol);
}

}  // namespace access
}  // namespace stepmill
