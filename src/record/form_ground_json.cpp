#include "record/form_ground_json.h"

#include <cmath>

#include <fmt/format.h>

#include "record/plan_rules.h"
#include "stepmill/catalog/json_values.h"

namespace stepmill::record {
namespace {

using Json = nlohmann::ordered_json;
using json::listOf;
using json::number;

/// Heights in plan.json have six decimals [mm].
constexpr double kWrittenMm = 2e-6;

Json numbersOf(const std::vector<Obstacle>& bands, FeatureTables& tables) {
    return listOf(bands, [&](const Obstacle& band) { return tables.obstacles.add(band, tables.regions); });
}

Json sharpJson(const SharpStretch& stretch) {
    return {{"at", json::point(stretch.at)}, {"length_mm", number(stretch.length_mm)}, {"why", stretch.why}};
}

SharpStretch sharpFrom(const Json& json) {
    return {Vec3(json["at"][0].get<double>(), json["at"][1].get<double>(), json["at"][2].get<double>()),
            json["length_mm"].get<double>(), json["why"].get<std::string>()};
}

std::vector<Obstacle> bandsFrom(const Json& numbers, const std::string& pointer, ReadTables& tables) {
    std::vector<Obstacle> bands;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::string at = fmt::format("{}/{}", pointer, i);
        bands.push_back(tables.obstacle(numbers[i], at));
        if (i > 0 && bands[i].bottom_z_mm < bands[i - 1].top_z_mm - kWrittenMm)
            failAt(at, "expected bands one over the other");
    }
    return bands;
}

}  // namespace

Json formGroundJson(const FormGround& ground, FeatureTables& tables) {
    Json json{{"id", ground.id},
              {"setup", ground.setup_id},
              {"window", tables.regions.add(ground.window)},
              {"must_stand", numbersOf(ground.must_stand, tables)},
              {"stairs", numbersOf(ground.stairs, tables)},
              {"obstacles", numbersOf(ground.obstacles, tables)}};
    if (ground.isOfEdges()) json["edges_mm"] = number(ground.edges_mm);
    if (!ground.sharp.empty()) json["sharp"] = listOf(ground.sharp, sharpJson);
    return json;
}

FormGround formGroundFrom(const Json& json, const std::string& pointer, ReadTables& tables) {
    FormGround ground;
    ground.id = json["id"];
    ground.setup_id = json["setup"];
    ground.window = tables.region(json["window"], pointer + "/window");
    ground.must_stand = bandsFrom(json["must_stand"], pointer + "/must_stand", tables);
    ground.stairs = bandsFrom(json["stairs"], pointer + "/stairs", tables);
    ground.obstacles = bandsFrom(json["obstacles"], pointer + "/obstacles", tables);
    ground.edges_mm = json.value("edges_mm", 0.0);
    if (json.contains("sharp"))
        for (const Json& stretch : json["sharp"])
            ground.sharp.push_back(sharpFrom(stretch));
    // What lies between two bands would be ground that nothing is known of.
    for (std::size_t i = 1; i < ground.must_stand.size(); ++i)
        if (std::abs(ground.must_stand[i].bottom_z_mm - ground.must_stand[i - 1].top_z_mm) > kWrittenMm)
            failAt(fmt::format("{}/must_stand/{}", pointer, i), "expected bands without gaps");
    return ground;
}

}  // namespace stepmill::record
