// Features of a plan.json, and the tables they refer to.

#include "record/read_features.h"

#include <fmt/format.h>

#include "record/plan_rules.h"
#include "stepmill/core/error.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/planar/region_json.h"

namespace stepmill::record {
namespace {

using Json = nlohmann::ordered_json;

/// Segments of all regions that a plan's features name, each counted as often as it is named. The most of any
/// real part is less than a hundredth; all in memory take a gigabyte.
constexpr std::size_t kMostSegments = 15'000'000;

std::string at(const char* list, std::size_t index) {
    return fmt::format("#/{}/{}", list, index);
}

Loop readLoop(const Json& json, const std::string& pointer) {
    try {
        return loopFromJson(json, pointer);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidRegion) throw;
        failAt(pointer, std::string(error.what()).substr(pointer.size() + 2));
    }
}

std::size_t entry(const Json& number, std::size_t count, const char* list, const std::string& pointer) {
    const auto index = number.get<std::size_t>();
    if (index >= count)
        failAt(pointer, fmt::format("expected the number of one of {} {}, found {}", count, list, index));
    return index;
}

Region readRegion(const Json& numbers, const std::vector<Loop>& loops, const std::string& pointer) {
    Region region;
    for (const Json& number : numbers)
        region.loops.push_back(loops[entry(number, loops.size(), "loops", pointer)]);
    if (const auto fault = diagnose(region)) failAt(pointer, "is no region: " + *fault);
    return region;
}

std::size_t segmentsOf(const Region& region) {
    std::size_t segments = 0;
    for (const Loop& loop : region.loops)
        segments += loop.segments.size();
    return segments;
}

/// The schema allows the words that a reader knows.
FeatureClass featureClass(const Json& word) {
    const auto found = featureClassFrom(word.get<std::string>());
    STEPMILL_CHECK(found.has_value(), "a class the schema allows and the reader does not know");
    return *found;
}

Residual readResidual(const Json& json, const std::string& pointer, ReadTables& tables) {
    Residual residual;
    residual.region = tables.region(json["region"], pointer + "/region");
    residual.area_mm2 = json["area_mm2"];
    residual.volume_mm3 = json["volume_mm3"];
    residual.reason = stayReasonFrom(json["reason"].get<std::string>());
    residual.advice = json.value("advice", "");
    if (json.contains("stays_mm3")) residual.stays_mm3 = json["stays_mm3"];
    if (json.contains("taken_by") && !json["taken_by"].is_null()) residual.taken_by = json["taken_by"];
    return residual;
}

RecordedFeature readBand(const Json& json, const std::string& pointer, ReadTables& tables) {
    RecordedFeature recorded;
    Feature& band = recorded.feature;
    band.top_z_mm = json["top_z_mm"];
    band.floor_z_mm = json["floor_z_mm"];
    band.feature_class = featureClass(json["class"]);
    band.through = !hasFloor(band.feature_class);
    band.point_mm = json.value("point_mm", 0.0);
    if (json.contains("room_below_mm")) band.room_below_mm = json["room_below_mm"];
    band.area_mm2 = json["area_mm2"];
    band.volume_mm3 = json["volume_mm3"];
    band.open_length_mm = json["open_length_mm"];
    band.closed_length_mm = json["closed_length_mm"];
    if (!json["min_corner_radius_mm"].is_null()) band.min_corner_radius_mm = json["min_corner_radius_mm"];
    band.target = tables.region(json["target"], pointer + "/target");
    band.obstruction = tables.region(json["obstruction"], pointer + "/obstruction");
    for (std::size_t i = 0; i < json["obstacles"].size(); ++i)
        band.obstacles.push_back(
            tables.obstacle(json["obstacles"][i], fmt::format("{}/obstacles/{}", pointer, i)));
    for (std::size_t i = 0; i < json["residual"].size(); ++i)
        recorded.residual.push_back(
            readResidual(json["residual"][i], fmt::format("{}/residual/{}", pointer, i), tables));
    checkBand(recorded, pointer);
    return recorded;
}

}  // namespace

ReadTables::ReadTables(const Json& plan) {
    std::vector<Loop> loops;
    for (std::size_t i = 0; i < plan["loops"].size(); ++i)
        loops.push_back(readLoop(plan["loops"][i], at("loops", i)));
    for (std::size_t i = 0; i < plan["regions"].size(); ++i) {
        const std::string pointer = at("regions", i);
        regions_.push_back(counted(readRegion(plan["regions"][i], loops, pointer), pointer));
    }
    for (std::size_t i = 0; i < plan["obstacles"].size(); ++i) {
        const Json& json = plan["obstacles"][i];
        checkUpright(json, at("obstacles", i));
        obstacles_.push_back({json["bottom_z_mm"], json["top_z_mm"],
                              region(json["section"], at("obstacles", i) + "/section")});
    }
}

const Region& ReadTables::counted(const Region& region, const std::string& pointer) {
    segments_ += segmentsOf(region);
    if (segments_ > kMostSegments)
        failAt(pointer, fmt::format("expected no more than {} segments in all regions named", kMostSegments));
    return region;
}

const Region& ReadTables::region(const Json& number, const std::string& pointer) {
    return counted(regions_[entry(number, regions_.size(), "regions", pointer)], pointer);
}

const Obstacle& ReadTables::obstacle(const Json& number, const std::string& pointer) {
    const Obstacle& obstacle = obstacles_[entry(number, obstacles_.size(), "obstacles", pointer)];
    counted(obstacle.section, pointer);
    return obstacle;
}

BandsOf bandsOf(const Json& plan) {
    BandsOf bands;
    for (const Json& feature : plan["features"]) {
        RecordedBands& own = bands[feature["id"]];
        own.count = feature["levels"];
        for (const Json& band : feature["bands"])
            own.numbers.push_back(band["band"]);
    }
    return bands;
}

std::string namedBand(const Json& name, const BandsOf& bands) {
    return bandId(name["feature"], name["band"], bands.at(name["feature"]).count);
}

std::vector<std::string> bandIds(const std::string& feature_id, const BandsOf& bands) {
    const RecordedBands& own = bands.at(feature_id);
    std::vector<std::string> ids;
    for (const int number : own.numbers)
        ids.push_back(bandId(feature_id, number, own.count));
    return ids;
}

std::vector<RecordedFeature> readFeature(const Json& json, const std::string& pointer, const BandsOf& bands,
                                         ReadTables& tables) {
    const RecordedBands& own = bands.at(json["id"]);
    const std::vector<std::string> ids = bandIds(json["id"], bands);
    std::vector<RecordedFeature> read;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        read.push_back(readBand(json["bands"][i], fmt::format("{}/bands/{}", pointer, i), tables));
        Feature& band = read.back().feature;
        band.id = ids[i];
        band.setup_id = json["setup"];
        if (own.count > 1) band.band = Band{json["id"], own.numbers[i], own.count};
        if (json.contains("ground_of")) band.ground_of = json["ground_of"].get<std::vector<std::string>>();
        for (const Json& parent : json["bands"][i]["parents"])
            band.parents.push_back(namedBand(parent, bands));
    }
    return read;
}

}  // namespace stepmill::record
