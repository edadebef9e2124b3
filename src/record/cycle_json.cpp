#include "stepmill/record/cycle_json.h"

#include "stepmill/catalog/json_values.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using json::Json;
using json::listOf;
using json::number;

Json usedTimeJson(const UsedTime& used) {
    Json json{{"use", toString(used.use)}, {"time_s", number(used.time_s)}};
    if (used.limit) json["limit"] = toString(*used.limit);
    return json;
}

Json outcomeJson(const CycleOutcome& outcome) {
    return {{"of", outcome.target.of},
            {"asked_s", number(outcome.target.time_s)},
            {"planned_s", number(outcome.planned_s)},
            {"pace", number(outcome.pace)},
            {"time_s", number(outcome.time_s)},
            {"bound_s", number(outcome.bound_s)},
            {"met", outcome.isMet()},
            {"uses", listOf(outcome.uses, usedTimeJson)}};
}

Json stepJson(const CycleStep& step) {
    Json json{{"way", toString(step.way)},
              {"of", step.of},
              {"before_s", number(step.before_s)},
              {"after_s", number(step.after_s)},
              {"taken", step.taken}};
    if (step.leaves_more) json["leaves_more"] = true;
    if (step.way == CycleWay::Feeds) json["pace"] = number(step.pace);
    if (!step.feature.empty()) json["feature"] = step.feature;
    if (!step.tool.empty()) json["tool"] = step.tool;
    if (step.way != CycleWay::Diameter) return json;
    json["wanted_mm"] = number(step.wanted_mm);
    json["diameter_mm"] = number(step.diameter_mm);
    json["passes"] = step.passes;
    return json;
}

/// The schema allows the words that a reader knows.
template <typename Enum>
Enum known(const std::optional<Enum>& value) {
    STEPMILL_CHECK(value.has_value(), "the schema allows known words alone");
    return *value;
}

UsedTime usedTimeFrom(const Json& json) {
    UsedTime used;
    used.use = known(timeUseFrom(json["use"].get<std::string>()));
    if (json.contains("limit")) used.limit = known(feedLimitFrom(json["limit"].get<std::string>()));
    used.time_s = json["time_s"];
    return used;
}

CycleOutcome outcomeFrom(const Json& json) {
    CycleOutcome outcome;
    outcome.target = {json["of"], json["asked_s"]};
    outcome.planned_s = json["planned_s"];
    outcome.pace = json["pace"];
    outcome.time_s = json["time_s"];
    outcome.bound_s = json["bound_s"];
    for (const Json& use : json["uses"])
        outcome.uses.push_back(usedTimeFrom(use));
    return outcome;
}

CycleStep stepFrom(const Json& json) {
    CycleStep step;
    step.way = known(cycleWayFrom(json["way"].get<std::string>()));
    step.of = json["of"];
    step.before_s = json["before_s"];
    step.after_s = json["after_s"];
    step.taken = json["taken"];
    step.leaves_more = json.contains("leaves_more");
    step.pace = json.value("pace", 1.0);
    step.feature = json.value("feature", "");
    step.tool = json.value("tool", "");
    step.wanted_mm = json.value("wanted_mm", 0.0);
    step.diameter_mm = json.value("diameter_mm", 0.0);
    step.passes = json.value("passes", 0);
    return step;
}

}  // namespace

Json cycleTargetJson(const CycleTarget& target) {
    return {{"of", target.of}, {"time_s", number(target.time_s)}};
}

Json cycleTimesJson(const CycleTimes& times) {
    return {{"outcomes", listOf(times.outcomes, outcomeJson)}, {"steps", listOf(times.steps, stepJson)}};
}

CycleTimes cycleTimesFrom(const Json& json) {
    CycleTimes times;
    for (const Json& outcome : json["outcomes"])
        times.outcomes.push_back(outcomeFrom(outcome));
    for (const Json& step : json["steps"])
        times.steps.push_back(stepFrom(step));
    return times;
}

}  // namespace stepmill
