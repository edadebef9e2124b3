#include "record/form_ground_json.h"

#include <cmath>

#include <fmt/format.h>

#include "record/plan_rules.h"
#include "record/read_region.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/planar/region_json.h"

namespace stepmill::record {
namespace {

using Json = nlohmann::ordered_json;
using json::listOf;
using json::number;

/// Heights in plan.json have six decimals [mm].
constexpr double kWrittenMm = 2e-6;

Json bandJson(const Obstacle& band) {
    return {{"bottom_z_mm", number(band.bottom_z_mm)},
            {"top_z_mm", number(band.top_z_mm)},
            {"section", regionToJson(band.section)}};
}

std::vector<Obstacle> bandsFrom(const Json& list, const std::string& pointer) {
    std::vector<Obstacle> bands;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string at = fmt::format("{}/{}", pointer, i);
        bands.push_back(
            {list[i]["bottom_z_mm"], list[i]["top_z_mm"], readRegion(list[i]["section"], at + "/section")});
        if (bands[i].top_z_mm <= bands[i].bottom_z_mm)
            failAt(at + "/top_z_mm", "expected a top above the bottom");
        if (i > 0 && bands[i].bottom_z_mm < bands[i - 1].top_z_mm - kWrittenMm)
            failAt(at + "/bottom_z_mm", "expected bands one over the other");
    }
    return bands;
}

}  // namespace

Json formGroundJson(const FormGround& ground) {
    return {{"id", ground.id},
            {"setup", ground.setup_id},
            {"window", regionToJson(ground.window)},
            {"must_stand", listOf(ground.must_stand, bandJson)},
            {"stairs", listOf(ground.stairs, bandJson)},
            {"obstacles", listOf(ground.obstacles, bandJson)}};
}

FormGround formGroundFrom(const Json& json, const std::string& pointer) {
    FormGround ground;
    ground.id = json["id"];
    ground.setup_id = json["setup"];
    ground.window = readRegion(json["window"], pointer + "/window");
    ground.must_stand = bandsFrom(json["must_stand"], pointer + "/must_stand");
    ground.stairs = bandsFrom(json["stairs"], pointer + "/stairs");
    ground.obstacles = bandsFrom(json["obstacles"], pointer + "/obstacles");
    // What lies between two bands would be ground that nothing is known of.
    for (std::size_t i = 1; i < ground.must_stand.size(); ++i)
        if (std::abs(ground.must_stand[i].bottom_z_mm - ground.must_stand[i - 1].top_z_mm) > kWrittenMm)
            failAt(fmt::format("{}/must_stand/{}/bottom_z_mm", pointer, i), "expected bands without gaps");
    return ground;
}

}  // namespace stepmill::record
