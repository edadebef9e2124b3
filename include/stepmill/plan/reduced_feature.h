#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What passes leave of so little area is named, however small the feature; more than a small share of it is
/// a fault of its path [mm2].
inline constexpr double kCrumbMm2 = 0.01;

/// A feature as it can be planned below others that left material standing and beside fixtures.
struct ReducedFeature {
    Feature feature;                ///< with an empty target when nothing of it is free
    std::vector<Residual> blocked;  ///< what of the feature lies below material that stays, or fixtures
};

/// Material that stands above a feature, seen from above, and how high it may stand.
struct Standing {
    Region region;
    double top_z_mm = 0;
};

/// The feature with more for cutter, shank and holder to keep clear of; its target stays.
Feature beside(Feature feature, const std::vector<Standing>& standing, const Tolerances& tol);

/// A feature that is cut before another, with what its tools leave of it: as it is planned, or as plan.json
/// has it. Both live elsewhere.
struct CutFeature {
    const Feature* feature;
    const std::vector<Residual>* left;
};
inline CutFeature asCut(const PlannedFeature& planned) {
    return {&planned.feature, &planned.sequence.residual};
}

/// The cut feature of an id.
using CutById = std::function<CutFeature(const std::string& id)>;

/// The features that a feature waits for directly, ...
std::vector<CutFeature> parentsOf(const Feature& feature, const CutById& cut);
/// ... and with those that these wait for: nearest first, each once.
std::vector<CutFeature> ancestorsOf(const Feature& feature, const CutById& cut);

/// Takes what the features above left, and the fixtures that reach above its floor, out of a feature's target
/// and adds them to what cutter and holder must keep clear of: no tool meets material that was believed gone,
/// nor what holds the part. A through hole with a fixture under it is through no more: drills stop at its
/// floor.
/// \param parents    the feature's own parents
/// \param ancestors  all features it waits for
ReducedFeature reduced(const Feature& feature, const std::vector<CutFeature>& parents,
                       const std::vector<CutFeature>& ancestors, const std::vector<Fixture>& fixtures,
                       const Tolerances& tol);
/// The same with parents and ancestors as they were cut.
ReducedFeature reduced(const Feature& feature, const CutById& cut, const std::vector<Fixture>& fixtures,
                       const Tolerances& tol);

}  // namespace stepmill
