#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/error.h"
#include "stepmill/report/rank.h"

namespace stepmill {
namespace {

using json::Json;
using json::listOf;
using json::number;
using json::numberOrNull;
using json::textOrNull;

Json rowJson(const RankedRow& row) {
    return {{"tool", textOrNull(row.cutter.tool)},
            // As given: tables may hold finer numbers than reports print.
            {"diameter_mm", row.cutter.diameter_mm},
            {"volume_cm3", row.cutter.volume_cm3},
            {"clear_volume_cm3", numberOrNull(row.cutter.clear_volume_cm3)},
            {"mrr_cm3_per_min", row.cutter.mrr_cm3_per_min},
            {"time_min", number(row.time_min)},
            {"share_percent", number(100 * row.share)},
            {"rank", row.rank ? Json(*row.rank) : Json(nullptr)},
            {"dvcd_min", numberOrNull(row.dvcd_min)},
            {"rdvc_min", number(row.rdvc_min)},
            {"rdvc_with_tool_changes_min", number(row.rdvc_with_changes_min)}};
}

Json setJson(const Ranking& ranking, const RankedSet& set) {
    Json tools = Json::array();
    Json ids = Json::array();
    for (const int index : set.rows) {
        const AccessRow& cutter = ranking.rows[index].cutter;
        tools.push_back(cutter.diameter_mm);
        if (!cutter.tool.empty()) ids.push_back(cutter.tool);
    }
    return {{"tools", std::move(tools)}, {"tool_ids", std::move(ids)}, {"total_min", number(set.total_min)}};
}

Json rangeJson(const BestSequence& range) {
    return {{"from", number(range.from)},
            {"to", std::isinf(range.to) ? Json(nullptr) : Json(number(range.to))},
            {"tools", range.line.tools},
            {"fixed", number(range.line.fixed)},
            {"per_unit", number(range.line.per_unit)}};
}

Json sensitivityJson(const std::optional<Sensitivity>& sensitivity) {
    if (!sensitivity) return nullptr;
    return {{"parameter", toString(sensitivity->parameter)},
            {"unit", sensitivity->unit},
            {"now", number(sensitivity->now)},
            {"weighs", sensitivity->objective == Objective::Time ? "time_s" : "cost"},
            {"features", listOf(sensitivity->features, [](const FeatureSensitivity& feature) {
                 return Json{{"feature", feature.feature_id},
                             {"ranges", listOf(feature.ranges, rangeJson)},
                             {"failure", textOrNull(feature.failure)}};
             })}};
}

Json bestJson(const std::optional<Purchase>& best) {
    if (!best) return nullptr;
    return {{"tool", best->tool.id},
            {"type", toString(best->tool.type)},
            {"diameter_mm", number(best->tool.diameter_mm)},
            {"stick_out_mm", number(best->tool.stick_out_mm)},
            {"why", best->why},
            {"tools", best->tools},
            {"saved_s", number(best->saved_s)},
            {"saved_cost", number(best->saved_cost)},
            {"more_mm3", number(best->more_mm3)},
            {"holes", best->holes}};
}

Json drillJson(const DrillRow& drill) {
    return {{"tool", drill.tool},
            {"diameter_mm", number(drill.diameter_mm)},
            {"makes", drill.makes},
            {"makes_room_in", drill.makes_room_in},
            {"volume_cm3", number(drill.volume_cm3)},
            {"time_min", number(drill.time_min)}};
}

Json missingJson(const MissingTool& missing) {
    return {
        {"tool", missing.tool}, {"gives", missing.gives}, {"holes", missing.holes}, {"faces", missing.faces}};
}

Json purchasesJson(const std::optional<std::vector<FeaturePurchase>>& purchases) {
    if (!purchases) return nullptr;
    return listOf(*purchases, [](const FeaturePurchase& purchase) {
        const PurchaseAdvice& advice = purchase.advice;
        return Json{{"feature", advice.feature_id},
                    {"time_s", number(advice.time_s)},
                    {"cost", number(advice.cost)},
                    {"stays_mm3", number(advice.stays_mm3)},
                    {"trials", advice.trials},
                    {"best", bestJson(advice.best)},
                    {"failure", textOrNull(purchase.failure)}};
    });
}

}  // namespace

std::string rankJson(const RankReport& report) {
    const Ranking& ranking = report.ranking;
    Json content{{"source",
                  {{"kind", report.is_part ? "part" : "table"},
                   {"file", report.file},
                   {"feature", textOrNull(report.feature)},
                   {"material", textOrNull(report.material)}}},
                 {"tool_change_s", ranking.tool_change_s},
                 {"rows", listOf(ranking.rows, rowJson)},
                 {"greedy", setJson(ranking, ranking.greedy)},
                 {"shortest_path", setJson(ranking, ranking.shortest_path)},
                 {"drills", listOf(report.drills, drillJson)},
                 {"sensitivity", sensitivityJson(report.sensitivity)},
                 {"purchases", purchasesJson(report.purchases)},
                 {"missing", listOf(report.missing, missingJson)}};
    return finishJson(SchemaName::Rank, std::move(content));
}

}  // namespace stepmill
