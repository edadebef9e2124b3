#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/plan/assignment.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// A feature of a plan that is made again, whole, in setup coordinates.
struct EarlierFeature {
    std::string id;  ///< "S1.F2"
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    double top_z_mm = 0;
    double floor_z_mm = 0;
    /// Of its uppermost band; empty where common ground took it and it is known by name alone.
    Region target;
};

struct EarlierOperation {
    std::string id;  ///< "S1.O3"
    std::string feature_id;
    std::string tool_id;
    Role role = Role::Rough;
};

/// What a plan that is made again keeps of one of its setups: names, and the order of what is still there.
struct EarlierSetup {
    std::string id;
    Vec3 axis = Vec3::UnitZ();  ///< in part coordinates
    std::vector<EarlierFeature> features;
    std::vector<EarlierOperation> operations;  ///< in machining order
    std::optional<double> leaning_mm3;         ///< PlannedSetup::leaning_mm3
};

/// Which setup cut what in a plan that is made again with the same tools, machine, material and fixtures.
struct EarlierAssignment {
    Assignment assignment;
    double left_mm3 = 0;  ///< of stock minus part at its end
};

/// The setup of that id and axis; null for none.
const EarlierSetup* earlierOf(const Setup& setup, const std::vector<EarlierSetup>& earlier);

/// Ids that features keep from an earlier plan, by those their numbers would give them: of whole features,
/// and those that differ alone.
using FeatureNames = std::map<std::string, std::string>;

/// Which earlier feature each is: the one with the same ground, else of the same kind the one that shares
/// most of its ground, else one of the same size and depth that moved. What is new gets numbers that no
/// earlier feature has.
/// \param found  of the setup, as they are numbered
FeatureNames namesFrom(const EarlierSetup& earlier, const FeatureSet& found, const Tolerances& tol);

/// The features by their names, wherever they are named.
FeatureSet renamed(FeatureSet found, const FeatureNames& names);

}  // namespace stepmill
