// The curve of coverable area, sampled where it bends and jumps.

#include "access/curve_sampling.h"

#include <cmath>
#include <utility>

#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::access {

namespace {

double coverableArea(const FeatureGround& ground, const Region& centres, double radius_mm) {
    if (centres.empty()) return 0;
    if (ground.walledIn()) return area(ground.targetOpening(radius_mm));
    const Tolerances& tol = ground.tolerances();
    return area(intersect(swept(centres, radius_mm, tol), ground.feature().target, tol));
}

class Sampler {
  public:
    Sampler(const FeatureGround& ground, double max_error_mm2)
        : ground_(ground), tol_(ground.tolerances()), max_error_mm2_(max_error_mm2) {}

    CurveSamples sample(const std::vector<double>& diameters_mm) {
        probes_.push_back(probe(diameters_mm.front()));
        for (std::size_t i = 1; i < diameters_mm.size(); ++i)
            refine(probes_.back(), probe(diameters_mm[i]));
        return {std::move(probes_), std::move(jumps_)};
    }

  private:
    Probe probe(double diameter_mm) const {
        Probe probe{diameter_mm, 0, 0, 0};
        if (diameter_mm == 0) {
            const Region& target = ground_.feature().target;
            return {0, area(target), components(target).size(), target.loops.size()};
        }
        const Region centres = centresFor(ground_, diameter_mm / 2);
        probe.area_mm2 = coverableArea(ground_, centres, diameter_mm / 2);
        probe.pieces = components(centres).size();
        probe.loops = centres.loops.size();
        return probe;
    }

    /// Is the straight line from low to high good enough? Since the curve never rises, a small drop answers
    /// for itself; else the middle is asked.
    bool isStraight(const Probe& low, const Probe& middle, const Probe& high) const {
        if (low.area_mm2 - high.area_mm2 <= max_error_mm2_) return true;
        // An arch that starts as a square root is 1.21 times as high at its top as at its middle.
        return std::abs(middle.area_mm2 - (low.area_mm2 + high.area_mm2) / 2) <= max_error_mm2_ / 2;
    }

    /// Appends probes after `low` up to and with `high`.
    /// \pre probes_.back() is `low`
    void refine(const Probe low, const Probe& high) {
        const bool changes = low.pieces != high.pieces || low.loops != high.loops;
        if (high.diameter_mm - low.diameter_mm <= 2 * tol_.linear_mm) {
            if (changes || low.area_mm2 - high.area_mm2 > max_error_mm2_) jumps_.push_back({low, high});
            probes_.push_back(high);
            return;
        }
        if (!changes && low.area_mm2 - high.area_mm2 <= tol_.area_mm2) {
            probes_.push_back(high);
            return;
        }
        const Probe middle = probe((low.diameter_mm + high.diameter_mm) / 2);
        const bool changes_inside = changes || middle.pieces != low.pieces || middle.loops != low.loops;
        if (!changes_inside && isStraight(low, middle, high)) {
            probes_.push_back(middle);
            probes_.push_back(high);
            return;
        }
        refine(low, middle);
        refine(middle, high);
    }

    const FeatureGround& ground_;
    const Tolerances& tol_;
    double max_error_mm2_;
    std::vector<Probe> probes_;
    std::vector<Bracket> jumps_;
};

}  // namespace

Region centresFor(const FeatureGround& ground, double radius_mm) {
    if (ground.walledIn()) return ground.targetOffset(-radius_mm);
    const Tolerances& tol = ground.tolerances();
    return withoutSliverComponents(
        subtract(ground.targetOffset(radius_mm), ground.obstructionOffset(radius_mm), tol), tol);
}

CurveSamples sampleCurve(const FeatureGround& ground, const std::vector<double>& diameters_mm,
                         double max_error_mm2) {
    return Sampler(ground, max_error_mm2).sample(diameters_mm);
}

}  // namespace stepmill::access
