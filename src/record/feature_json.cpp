// Features as plan.json has them.

#include "record/feature_json.h"

#include "stepmill/plan/feature_times.h"

namespace stepmill::record {
namespace {

using json::Json;
using json::listOf;
using json::number;
using json::numberOrNull;

/// A column of a table: what `value` tells of each row.
template <typename Rows, typename Value>
Json columnOf(const Rows& rows, Value value) {
    return listOf(rows, [&](const auto& row) { return number(value(row)); });
}

std::vector<const ToolReach*> takingPart(const ToolSequence& sequence) {
    std::vector<const ToolReach*> tools;
    for (const ToolReach& reach : sequence.tools)
        if (reach.exclusion() == nullptr) tools.push_back(&reach);
    return tools;
}

double accessibleMm2(const ToolReach* reach) {
    return (reach->limited() != nullptr ? reach->own() : reach->cutter).coverable_area_mm2;
}

Json toolsJson(const ToolSequence& sequence) {
    const std::vector<const ToolReach*> tools = takingPart(sequence);
    return {{"tool", listOf(tools, [](const ToolReach* reach) { return reach->tool_id; })},
            {"accessible_area_mm2", columnOf(tools, accessibleMm2)},
            {"coverable_area_mm2",
             columnOf(tools, [](const ToolReach* reach) { return reach->cleared().coverable_area_mm2; })},
            {"collision_free_area_mm2",
             columnOf(tools, [](const ToolReach* reach) { return reach->collision_free_area_mm2; })}};
}

/// The tools that take no part, by reason.
Json excludedJson(const ToolSequence& sequence) {
    std::map<ExclusionReason, std::vector<std::string>> tools;
    for (const ToolReach& reach : sequence.tools)
        if (const Exclusion* excluded = reach.exclusion()) tools[excluded->reason].push_back(reach.tool_id);
    return listOf(tools, [](const auto& entry) {
        return Json{{"reason", toString(entry.first)}, {"tools", entry.second}};
    });
}

/// What holders keep from tools; the surrogates are those that reach all of it alone, null where nobody does.
Json blockedLumpsJson(const ToolSequence& sequence) {
    Json lumps = Json::array();
    for (const ToolReach& reach : sequence.tools) {
        if (reach.surrogates() == nullptr) continue;
        for (const BlockedLump& lump : reach.surrogates()->lumps)
            lumps.push_back({{"tool", reach.tool_id},
                             {"area_mm2", number(lump.area_mm2)},
                             {"surrogates", lump.surrogates.empty() ? Json(nullptr) : Json(lump.surrogates)},
                             {"reason", lump.reason}});
    }
    return lumps;
}

std::string fromOf(const DagEdge& edge) {
    return edge.from.empty() ? "source" : edge.from.name();
}
std::string toOf(const DagEdge& edge) {
    return edge.to.empty() ? "sink" : edge.to.name();
}

Json edgesJson(const std::vector<DagEdge>& edges) {
    return {{"from", listOf(edges, fromOf)},
            {"to", listOf(edges, toOf)},
            {"region_area_mm2", columnOf(edges, [](const DagEdge& edge) { return edge.region_area_mm2; })},
            {"cut_length_mm", columnOf(edges, [](const DagEdge& edge) { return edge.totals.cut_length_mm; })},
            {"air_length_mm", columnOf(edges, [](const DagEdge& edge) { return edge.totals.air_length_mm; })},
            {"time_s", columnOf(edges, [](const DagEdge& edge) { return edge.time_s; })},
            {"cost", columnOf(edges, [](const DagEdge& edge) { return edge.cost; })}};
}

Json surrogatesJson(const std::vector<DagEdge>& edges) {
    Json surrogates = Json::array();
    for (const DagEdge& edge : edges)
        for (const SurrogateWork& work : edge.surrogates)
            surrogates.push_back({{"from", fromOf(edge)},
                                  {"to", toOf(edge)},
                                  {"tool", work.tool},
                                  {"area_mm2", number(work.area_mm2)},
                                  {"time_s", number(work.totals.time_s())}});
    return surrogates;
}

Json residualJson(const Residual& residual, RegionTables& regions) {
    Json json{{"region", regions.add(residual.region)},
              {"area_mm2", number(residual.area_mm2)},
              {"volume_mm3", number(residual.volume_mm3)},
              {"reason", toString(residual.reason)},
              {"advice", residual.advice}};
    if (!residual.stays_mm3) return json;
    json["stays_mm3"] = number(*residual.stays_mm3);
    json["taken_by"] = residual.taken_by.empty() ? Json(nullptr) : Json(residual.taken_by);
    return json;
}

/// The bands that a band waits for.
Json parentsJson(const Feature& band, const BandsById& bands) {
    return listOf(band.parents, [&](const std::string& id) {
        const Feature& parent = *bands.at(id);
        return Json{{"feature", wholeOf(parent)}, {"band", bandNumber(parent)}};
    });
}

Json bandJson(const PlannedFeature& planned, const BandsById& bands, FeatureTables& tables) {
    const Feature& band = planned.feature;
    const ToolSequence& sequence = planned.sequence;
    Json json{{"band", bandNumber(band)},
              {"class", toString(band.feature_class)},
              {"parents", parentsJson(band, bands)},
              {"top_z_mm", number(band.top_z_mm)},
              {"floor_z_mm", number(band.floor_z_mm)},
              {"area_mm2", number(band.area_mm2)},
              {"volume_mm3", number(band.volume_mm3)},
              {"open_length_mm", number(band.open_length_mm)},
              {"closed_length_mm", number(band.closed_length_mm)},
              {"min_corner_radius_mm", numberOrNull(band.min_corner_radius_mm)},
              {"target", tables.regions.add(band.target)},
              {"obstruction", tables.regions.add(band.obstruction)},
              {"obstacles", listOf(band.obstacles,
                                   [&](const Obstacle& obstacle) {
                                       return tables.obstacles.add(obstacle, tables.regions);
                                   })},
              {"tools", toolsJson(sequence)},
              {"excluded", excludedJson(sequence)},
              {"blocked_lumps", blockedLumpsJson(sequence)},
              {"dag",
               {{"edges", edgesJson(sequence.edges)},
                {"surrogates", surrogatesJson(sequence.edges)},
                {"path", listOf(sequence.way, [](const DagNode& node) { return node.name(); })}}},
              {"time_s", number(sequence.time_s)},
              {"motion_time_s", number(sequence.motion_s)},
              {"lower_bound_s", number(sequence.lower_bound_s)},
              {"residual", listOf(sequence.residual, [&](const Residual& residual) {
                   return residualJson(residual, tables.regions);
               })}};
    if (band.point_mm > 0) json["point_mm"] = number(band.point_mm);
    if (band.room_below_mm) json["room_below_mm"] = number(*band.room_below_mm);
    return json;
}

}  // namespace

std::size_t ObstacleTable::add(const Obstacle& obstacle, RegionTables& regions) {
    Json row{{"bottom_z_mm", number(obstacle.bottom_z_mm)},
             {"top_z_mm", number(obstacle.top_z_mm)},
             {"section", regions.add(obstacle.section)}};
    const auto [found, is_new] = numbers_.emplace(row.dump(), rows_.size());
    if (is_new) rows_.push_back(std::move(row));
    return found->second;
}

BandsById bandsById(const std::vector<PlannedFeature>& features) {
    BandsById bands;
    for (const PlannedFeature& planned : features)
        bands[planned.feature.id] = &planned.feature;
    return bands;
}

Json featureJson(const WholeFeature<PlannedFeature>& feature, const std::vector<Operation>& operations,
                 const BandsById& bands, const Machine& machine, FeatureTables& tables) {
    const FeatureTimes times = timesOf(feature, operations, machine);
    Json json{{"id", feature.id()},
              {"setup", feature.uppermost().setup_id},
              {"class", toString(feature.featureClass())},
              {"levels", bandCount(feature.uppermost())},
              {"top_z_mm", number(feature.uppermost().top_z_mm)},
              {"floor_z_mm", number(feature.lowest().floor_z_mm)},
              {"depth_mm", number(feature.depth_mm())},
              {"volume_mm3", number(feature.volume_mm3())},
              {"time_s", number(times.time_s)},
              {"motion_time_s", number(times.motion_s)},
              {"lower_bound_s", number(times.lower_bound_s)},
              {"bands", listOf(feature.bands,
                               [&](const PlannedFeature* band) { return bandJson(*band, bands, tables); })}};
    if (!feature.uppermost().ground_of.empty()) json["ground_of"] = feature.uppermost().ground_of;
    return json;
}

}  // namespace stepmill::record
