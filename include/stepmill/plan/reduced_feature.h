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

/// The planned feature of an id.
using PlannedById = std::function<const PlannedFeature&(const std::string& id)>;

/// The features that a feature waits for directly, ...
std::vector<const PlannedFeature*> parentsOf(const Feature& feature, const PlannedById& planned);
/// ... and with those that these wait for: nearest first, each once.
std::vector<const PlannedFeature*> ancestorsOf(const Feature& feature, const PlannedById& planned);

/// Takes what the features above left, and the fixtures that reach above its floor, out of a feature's target
/// and adds them to what cutter and holder must keep clear of: no tool meets material that was believed gone,
/// nor what holds the part. A through hole with a fixture under it is through no more: drills stop at its
/// floor. \param parents    the feature's own parents, planned \param ancestors  all features it waits for,
/// planned
ReducedFeature reduced(const Feature& feature, const std::vector<const PlannedFeature*>& parents,
                       const std::vector<const PlannedFeature*>& ancestors,
                       const std::vector<Fixture>& fixtures, const Tolerances& tol);

}  // namespace stepmill
