#pragma once

#include <map>
#include <string>

#include "stepmill/catalog/json_values.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/plan.h"
#include "stepmill/planar/region_json.h"

namespace stepmill::record {

/// What features refer to by number; every entry stands once, in the order of first use.
class ObstacleTable {
  public:
    /// The obstacle's number.
    std::size_t add(const Obstacle& obstacle, RegionTables& regions);

    const json::Json& rows() const { return rows_; }

  private:
    json::Json rows_ = json::Json::array();
    std::map<std::string, std::size_t> numbers_;  // by the row's text
};

struct FeatureTables {
    RegionTables regions;
    ObstacleTable obstacles;
};

/// The bands of a setup's features.
using BandsById = std::map<std::string, const Feature*>;
BandsById bandsById(const std::vector<PlannedFeature>& features);

/// An entry of plan.json's features, with all its bands.
/// \param operations  of its setup
/// \param bands   of its setup
/// \param tables  get what it refers to
json::Json featureJson(const WholeFeature<PlannedFeature>& feature, const std::vector<Operation>& operations,
                       const BandsById& bands, const Machine& machine, FeatureTables& tables);

}  // namespace stepmill::record
