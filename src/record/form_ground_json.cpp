#include "record/form_ground_json.h"

#include <cmath>
#include <map>

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

/// The loops of a ground's regions, each once: most are the same in many bands.
class LoopTable {
  public:
    Json indices(const Region& region) {
        Json list = Json::array();
        for (const Loop& loop : region.loops) {
            Json json = regionToJson({{loop}})["loops"].front();
            const auto [found, is_new] = known_.try_emplace(json.dump(), loops_.size());
            if (is_new) loops_.push_back(std::move(json));
            list.push_back(found->second);
        }
        return list;
    }

    Json bands(const std::vector<Obstacle>& bands) {
        return listOf(bands, [&](const Obstacle& band) -> Json {
            return {{"bottom_z_mm", number(band.bottom_z_mm)},
                    {"top_z_mm", number(band.top_z_mm)},
                    {"section", indices(band.section)}};
        });
    }

    const Json& loops() const { return loops_; }

  private:
    std::map<std::string, std::size_t> known_;
    Json loops_ = Json::array();
};

/// The region that a list of indices into `loops` names, checked.
Region regionOf(const Json& indices, const Json& loops, const std::string& pointer) {
    Json region = Json::array();
    for (const Json& index : indices) {
        if (index.get<std::size_t>() >= loops.size()) failAt(pointer, "names a loop that is not there");
        region.push_back(loops[index.get<std::size_t>()]);
    }
    return readRegion({{"loops", std::move(region)}}, pointer);
}

std::vector<Obstacle> bandsFrom(const Json& list, const Json& loops, const std::string& pointer) {
    std::vector<Obstacle> bands;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string at = fmt::format("{}/{}", pointer, i);
        bands.push_back({list[i]["bottom_z_mm"], list[i]["top_z_mm"],
                         regionOf(list[i]["section"], loops, at + "/section")});
        if (bands[i].top_z_mm <= bands[i].bottom_z_mm)
            failAt(at + "/top_z_mm", "expected a top above the bottom");
        if (i > 0 && bands[i].bottom_z_mm < bands[i - 1].top_z_mm - kWrittenMm)
            failAt(at + "/bottom_z_mm", "expected bands one over the other");
    }
    return bands;
}

}  // namespace

Json formGroundJson(const FormGround& ground) {
    LoopTable table;
    Json json{{"id", ground.id},
              {"setup", ground.setup_id},
              {"window", table.indices(ground.window)},
              {"must_stand", table.bands(ground.must_stand)},
              {"stairs", table.bands(ground.stairs)},
              {"obstacles", table.bands(ground.obstacles)}};
    json["loops"] = table.loops();
    return json;
}

FormGround formGroundFrom(const Json& json, const std::string& pointer) {
    FormGround ground;
    ground.id = json["id"];
    ground.setup_id = json["setup"];
    ground.window = regionOf(json["window"], json["loops"], pointer + "/window");
    ground.must_stand = bandsFrom(json["must_stand"], json["loops"], pointer + "/must_stand");
    ground.stairs = bandsFrom(json["stairs"], json["loops"], pointer + "/stairs");
    ground.obstacles = bandsFrom(json["obstacles"], json["loops"], pointer + "/obstacles");
    // What lies between two bands would be ground that nothing is known of.
    for (std::size_t i = 1; i < ground.must_stand.size(); ++i)
        if (std::abs(ground.must_stand[i].bottom_z_mm - ground.must_stand[i - 1].top_z_mm) > kWrittenMm)
            failAt(fmt::format("{}/must_stand/{}/bottom_z_mm", pointer, i), "expected bands without gaps");
    return ground;
}

}  // namespace stepmill::record
