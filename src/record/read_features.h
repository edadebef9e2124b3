#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/record/plan_record.h"

namespace stepmill::record {

/// The regions and obstacles of a plan.json, for those that refer to them by number.
class ReadTables {
  public:
    /// \pre `plan` keeps schemas/plan.schema.json
    /// \throws Error(InvalidCatalog) naming the loop or region that is none: one that crosses itself or runs
    /// the wrong way proves anything
    explicit ReadTables(const nlohmann::ordered_json& plan);

    /// The entry of that number. A file of a few lines could name a large region a million times: there is an
    /// end to that.
    /// \throws Error(InvalidCatalog) naming `pointer` where there is no such entry
    const Region& region(const nlohmann::ordered_json& number, const std::string& pointer);
    const Obstacle& obstacle(const nlohmann::ordered_json& number, const std::string& pointer);

  private:
    /// \return `region` itself
    const Region& counted(const Region& region, const std::string& pointer);

    std::vector<Region> regions_;
    std::vector<Obstacle> obstacles_;
    std::size_t segments_ = 0;  // of all that was asked for
};

/// The bands that a feature has in the plan.
struct RecordedBands {
    int count = 1;             ///< as it was parted
    std::vector<int> numbers;  ///< of those that common ground has left, from above
};

/// By the feature's id.
using BandsOf = std::map<std::string, RecordedBands>;
BandsOf bandsOf(const nlohmann::ordered_json& plan);

/// Id of the band that an operation or a child names: its members "feature" and "band".
std::string namedBand(const nlohmann::ordered_json& name, const BandsOf& bands);

/// The ids of a feature's bands, from above.
std::vector<std::string> bandIds(const std::string& feature_id, const BandsOf& bands);

/// The bands of one entry of features, from above.
/// \throws Error(InvalidCatalog) naming what contradicts itself
std::vector<RecordedFeature> readFeature(const nlohmann::ordered_json& json, const std::string& pointer,
                                         const BandsOf& bands, ReadTables& tables);

}  // namespace stepmill::record
