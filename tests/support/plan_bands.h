#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace stepmill::test {

/// A band of a plan.json.
struct BandOfPlan {
    std::string id;  ///< "S1.F2.3", or "S1.F2" where it is the only one
    nlohmann::ordered_json band;
    std::vector<std::string> parents;  ///< ids of bands
};

/// Id of what `name` names in its members "feature" and "band".
inline std::string bandNamed(const nlohmann::ordered_json& name, const nlohmann::ordered_json& plan) {
    const std::string feature = name.at("feature");
    for (const auto& one : plan.at("features"))
        if (one.at("id") == feature && one.at("levels") > 1)
            return feature + "." + std::to_string(name.at("band").get<int>());
    return feature;
}

/// All bands, feature by feature.
inline std::vector<BandOfPlan> bandsOf(const nlohmann::ordered_json& plan) {
    std::vector<BandOfPlan> bands;
    for (const auto& feature : plan.at("features")) {
        for (const auto& band : feature.at("bands")) {
            std::vector<std::string> parents;
            for (const auto& parent : band.at("parents"))
                parents.push_back(bandNamed(parent, plan));
            bands.push_back(
                {bandNamed({{"feature", feature.at("id")}, {"band", band.at("band")}}, plan), band, parents});
        }
    }
    return bands;
}

}  // namespace stepmill::test
