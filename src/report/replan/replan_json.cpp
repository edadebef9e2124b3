#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/record/cycle_json.h"
#include "stepmill/report/replan.h"

namespace stepmill {
namespace {

using json::Json;
using json::listOf;
using json::number;

Json sourceJson(const RecordedFile& file) {
    return {{"file", file.file}, {"sha256", file.sha256}};
}

Json replanTotalsJson(const PlanTotals& totals) {
    return {{"time_s", number(totals.time_s)},
            {"cost", number(totals.cost)},
            {"tool_changes", totals.tool_changes}};
}

Json inputJson(const InputChange& input) {
    return {{"what", input.what}, {"before", input.before}, {"after", input.after}};
}

Json programJson(const ProgramChange& program) {
    return {{"setup", program.setup_id},
            {"change", toString(program.change)},
            {"lines_before", program.lines_before},
            {"lines_after", program.lines_after},
            {"lines_kept", program.lines_kept},
            {"same_bytes", program.same_bytes}};
}

Json thenJson(const std::optional<FeatureThen>& feature) {
    if (!feature) return nullptr;
    return {{"class", toString(feature->feature_class)},
            {"top_z_mm", number(feature->top_z_mm)},
            {"floor_z_mm", number(feature->floor_z_mm)},
            {"volume_mm3", number(feature->volume_mm3)},
            {"tools", feature->tools},
            {"time_s", number(feature->time_s)}};
}

Json thenJson(const std::optional<OperationThen>& operation) {
    if (!operation) return nullptr;
    return {{"place", operation->place},
            {"tool", operation->tool},
            {"number", operation->number},
            {"time_s", number(operation->time_s)},
            {"lines", operation->lines.size()}};
}

Json featureChangeJson(const FeatureChange& feature) {
    return {{"id", feature.id},
            {"setup", feature.setup_id},
            {"change", toString(feature.change)},
            {"causes", listOf(feature.causes, [](ChangeCause cause) { return Json(toString(cause)); })},
            {"more_mm2", number(feature.more_mm2)},
            {"less_mm2", number(feature.less_mm2)},
            {"before", thenJson(feature.before)},
            {"after", thenJson(feature.after)}};
}

Json operationChangeJson(const OperationChange& operation) {
    return {{"id", operation.id},
            {"setup", operation.setup_id},
            {"feature", operation.feature_id},
            {"role", toString(operation.role)},
            {"change", toString(operation.change)},
            {"lines_kept", operation.lines_kept},
            {"before", thenJson(operation.before)},
            {"after", thenJson(operation.after)}};
}

}  // namespace

std::string replanJson(const PlanChange& change) {
    Json json{
        {"part", {{"before", sourceJson(change.part_before)}, {"after", sourceJson(change.part_after)}}},
        {"inputs", listOf(change.inputs, inputJson)},
        {"currency", change.currency},
        {"totals", {{"before", replanTotalsJson(change.before)}, {"after", replanTotalsJson(change.after)}}},
        {"programs", listOf(change.programs, programJson)},
        {"features", listOf(change.features, featureChangeJson)},
        {"operations", listOf(change.operations, operationChangeJson)}};
    if (!change.cycle.outcomes.empty()) json["cycle_time"] = cycleTimesJson(change.cycle);
    return finishJson(SchemaName::Replan, std::move(json));
}

}  // namespace stepmill
