#include "stepmill/record/plan_record.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "record/form_ground_json.h"
#include "record/plan_rules.h"
#include "record/read_region.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"
#include "stepmill/post/post.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPlanFile = "plan.json";

using record::failAt;
using record::readRegion;

void requireUpright(double bottom_z_mm, double top_z_mm, const std::string& pointer) {
    if (top_z_mm <= bottom_z_mm) failAt(pointer + "/top_z_mm", "expected a top above the bottom");
}

HolderCylinder cylinder(const Json& json) {
    return {json["diameter_mm"], json["bottom_mm"], json["top_mm"]};
}

ToolAssembly tool(const Json& json) {
    ToolAssembly tool;
    tool.id = json["id"];
    tool.number = json["number"];
    tool.type = *toolTypeFrom(json["type"].get<std::string>());
    tool.description = json["description"];
    tool.diameter_mm = json["diameter_mm"];
    tool.corner_radius_mm = json["corner_radius_mm"];
    tool.tip_diameter_mm = json.value("tip_diameter_mm", 0.0);
    tool.included_angle_deg = json.value("included_angle_deg", 0.0);
    tool.flute_length_mm = json["flute_length_mm"];
    tool.stick_out_mm = json["stick_out_mm"];
    tool.shank = cylinder(json["shank"]);
    for (const Json& one : json["holder"])
        tool.holder.push_back(cylinder(one));
    return tool;
}

/// The schema allows the words that a reader knows; another is a bug.
template <typename Enum>
Enum known(const std::optional<Enum>& value, const std::string& word) {
    if (!value)
        throw Error(ErrorCode::Internal, word, "a word the schema allows and the reader does not know");
    return *value;
}

PlannedFeature feature(const Json& json, const std::string& pointer) {
    PlannedFeature planned;
    Feature& feature = planned.feature;
    feature.id = json["id"];
    feature.setup_id = json["setup"];
    feature.parents = json["parents"].get<std::vector<std::string>>();
    feature.top_z_mm = json["top_z_mm"];
    feature.floor_z_mm = json["floor_z_mm"];
    feature.feature_class = known(featureClassFrom(json["class"].get<std::string>()), json["class"]);
    feature.through = !hasFloor(feature.feature_class);
    feature.area_mm2 = json["area_mm2"];
    feature.volume_mm3 = json["volume_mm3"];
    feature.target = readRegion(json["target"], pointer + "/target");
    feature.obstruction = readRegion(json["obstruction"], pointer + "/obstruction");
    for (std::size_t i = 0; i < json["obstacles"].size(); ++i) {
        const Json& from = json["obstacles"][i];
        const std::string at = fmt::format("{}/obstacles/{}", pointer, i);
        requireUpright(from["bottom_z_mm"], from["top_z_mm"], at);
        feature.obstacles.push_back(
            {from["bottom_z_mm"], from["top_z_mm"], readRegion(from["section"], at + "/section")});
    }
    for (std::size_t i = 0; i < json["residual"].size(); ++i) {
        const Json& from = json["residual"][i];
        Residual residual;
        residual.region = readRegion(from["region"], fmt::format("{}/residual/{}/region", pointer, i));
        residual.area_mm2 = from["area_mm2"];
        residual.volume_mm3 = from["volume_mm3"];
        residual.reason = stayReasonFrom(from["reason"].get<std::string>());
        planned.sequence.residual.push_back(std::move(residual));
    }
    record::checkFeature(planned, pointer);
    return planned;
}

RecordedOperation operation(const Json& json, const std::map<std::string, ToolAssembly>& tools) {
    RecordedOperation operation;
    operation.id = json["id"];
    operation.setup_id = json["setup"];
    operation.feature_id = json["feature"];
    operation.tool = tools.at(json["tool"]);
    operation.role = known(roleFrom(json["role"].get<std::string>()), json["role"]);
    operation.pattern = json["pattern"];
    operation.depths = json["layers"];
    operation.z_floor_mm = json["z_floor_mm"];
    operation.leaves = {json.value("leaves_on_walls_mm", 0.0), json.value("leaves_on_floor_mm", 0.0)};
    operation.step_down_mm = json["step_down_mm"];
    operation.feed_mm_per_min = json["feed_mm_per_min"];
    operation.plunge_feed_mm_per_min = json["plunge_feed_mm_per_min"];
    operation.speed_rpm = json["speed_rpm"];
    operation.coolant = *coolantFrom(json["coolant"].get<std::string>());
    operation.dwell_s = json["dwell_s"];
    if (json.contains("takes"))
        for (const Json& entry : json["takes"])
            operation.takes.push_back(
                {stayReasonFrom(entry["reason"].get<std::string>()), entry["volume_mm3"]});
    return operation;
}

RecordedSetup setup(const Json& json, const std::string& pointer) {
    RecordedSetup setup;
    setup.id = json["id"];
    for (int i = 0; i < 3; ++i)
        setup.axis[i] = json["axis"][i];
    for (int i = 0; i < 16; ++i)
        setup.part_to_setup.matrix()(i / 4, i % 4) = json["transform"][i];
    setup.axis_name = json.value("axis_name", "");
    setup.program = json["program"];
    if (json.contains("stock"))
        for (int i = 0; i < 3; ++i)
            setup.stock_size_mm[i] = json["stock"]["size_mm"][i];
    if (json.contains("fixtures"))
        for (std::size_t i = 0; i < json["fixtures"].size(); ++i) {
            const Json& one = json["fixtures"][i];
            const std::string at = fmt::format("{}/fixtures/{}", pointer, i);
            requireUpright(one["bottom_z_mm"], one["top_z_mm"], at);
            setup.fixtures.push_back({one["name"], readRegion(one["section"], at + "/section"),
                                      one["bottom_z_mm"], one["top_z_mm"]});
        }
    setup.time_s = json["time_s"];
    setup.feature_ids = json["features"].get<std::vector<std::string>>();
    setup.operation_ids = json["operations"].get<std::vector<std::string>>();
    return setup;
}

Machine machine(const Json& json) {
    Machine machine;
    machine.name = json["name"];
    machine.rapid_mm_per_min = json["rapid_mm_per_min"];
    machine.max_feed_mm_per_min = json.value("max_feed_mm_per_min", 0.0);
    if (json.contains("travel_mm")) machine.travel_mm = json["travel_mm"].get<std::array<double, 3>>();
    machine.max_speed_rpm = json.value("max_speed_rpm", 0.0);
    machine.dialect = json.value("dialect", toString(Dialect::LinuxCnc));
    return machine;
}

void readForms(const Json& plan, PlanRecord& record) {
    if (!plan.contains("forms")) return;
    for (std::size_t i = 0; i < plan["forms"].size(); ++i) {
        FormGround ground = record::formGroundFrom(plan["forms"][i], fmt::format("#/forms/{}", i));
        const std::string id = ground.id;
        record.forms[id] = std::move(ground);
    }
}

/// Who plans for a machine that is too small is told so.
void noteTravel(const Json& plan, PlanRecord& record) {
    for (const Json& warning : plan["warnings"])
        for (RecordedSetup& setup : record.setups)
            if (warning["code"] == "travel" && warning["subject"] == setup.id) setup.within_travel = false;
}

RecordedFile file(const Json& json) {
    return json.is_null() ? RecordedFile{} : RecordedFile{json["file"], json["sha256"]};
}

RecordedRequest request(const Json& json) {
    const Json& margin = json["stock_margin_mm"];
    return {json["solid"],       json["unit"],           {margin[0], margin[1], margin[2]},
            file(json["stock"]), file(json["fixtures"]), {json["finish_walls_mm"], json["finish_floors_mm"]}};
}

void readBalance(const Json& plan, const Tolerances& tol, PlanRecord& record) {
    const Json& books = plan["volume_balance"];
    record.rounding_mm3 =
        std::max(kVolumeRoundingMm3, tol.volume_share * books["stock_minus_part_mm3"].get<double>());
    record.books.stock_minus_part_mm3 = books["stock_minus_part_mm3"];
    record.books.planned_mm3 = books["planned_mm3"];
    record.books.residual_mm3 = books["residual_mm3"];
    record.books.unreachable_mm3 = books["unreachable_mm3"];
    for (const char* list : {"residual_by_reason", "unreachable_by_reason"})
        if (books.contains(list))
            for (const Json& entry : books[list])
                record.left.push_back(
                    {stayReasonFrom(entry["reason"].get<std::string>()), entry["volume_mm3"]});
}

}  // namespace

PlanRecord planRecordFromText(std::string_view text, const Tolerances& tol) {
    const std::vector<std::string> errors = schemaErrors(SchemaName::Plan, text);
    if (!errors.empty()) {
        const std::size_t colon = errors.front().find(": ");
        if (colon == std::string::npos) failAt("", errors.front());
        failAt(errors.front().substr(0, colon), errors.front().substr(colon + 2));
    }
    const Json plan = Json::parse(text);
    record::checkPlanRules(plan);
    record::checkBooks(plan, tol);
    PlanRecord record;
    record.part_file = plan["part"]["file"];
    record.part_sha256 = plan["part"]["sha256"];
    record.part_name = plan["part"]["name"];
    record.material = plan["material"];
    record.machine = machine(plan["machine"]);
    if (plan.contains("request")) record.request = request(plan["request"]);
    record.library = file(plan["tool_library"]);
    record.part_volume_mm3 = plan["part"]["volume_mm3"];
    record.stock_volume_mm3 = plan["stock"]["volume_mm3"];
    for (const Json& one : plan["tools"])
        record.tools[one["id"]] = tool(one);
    for (std::size_t i = 0; i < plan["features"].size(); ++i)
        record.features[plan["features"][i]["id"]] =
            feature(plan["features"][i], fmt::format("#/features/{}", i));
    for (const Json& one : plan["operations"])
        record.operations[one["id"]] = operation(one, record.tools);
    for (std::size_t i = 0; i < plan["setups"].size(); ++i)
        record.setups.push_back(setup(plan["setups"][i], fmt::format("#/setups/{}", i)));
    readForms(plan, record);
    noteTravel(plan, record);
    readBalance(plan, tol, record);
    return record;
}

}  // namespace stepmill
