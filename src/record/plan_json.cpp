#include "stepmill/record/plan_json.h"

#include "record/feature_json.h"
#include "record/form_ground_json.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/post/post.h"
#include "stepmill/record/cycle_json.h"

namespace stepmill {

namespace {

using json::Json;
using json::listOf;
using json::number;
using json::point;

Json box(const Box3& b) {
    return Json::array({point(Vec3(b.min())), point(Vec3(b.max()))});
}

/// All digits: a direction rounded to six decimals is another plane.
Json directionJson(const Vec3& direction) {
    Json numbers = Json::array();
    for (const double value : direction)
        numbers.push_back(value == 0 ? 0.0 : value);
    return numbers;
}

Json transformJson(const Eigen::Isometry3d& transform) {
    const Eigen::Matrix4d& matrix = transform.matrix();
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            rows.push_back(number(matrix(row, column)));
    return rows;
}

Json partJson(const Part& part) {
    return {{"file", part.file},
            {"sha256", part.sha256},
            {"name", part.name},
            {"unit_in_file", part.unit_in_file},
            {"bbox_mm", box(part.bbox_mm)},
            {"volume_mm3", number(part.volume_mm3)},
            {"solids", part.count},
            {"surfaces", part.surfaces}};
}

Json stockJson(const Stock& stock) {
    return {{"kind", stock.kind == Stock::Kind::Box ? "box" : "step"},
            {"bbox_mm", box(stock.bbox_mm)},
            {"volume_mm3", number(stock.volume_mm3)},
            {"tolerance_mm", number(stock.tolerance_mm)}};
}

Json numbersJson(const std::vector<double>& numbers) {
    return listOf(numbers, [](double value) { return Json(number(value)); });
}

Json viseJson(const Vise& vise) {
    return {{"opening_mm", number(vise.opening_mm)},
            {"jaw_width_mm", number(vise.jaw_width_mm)},
            {"jaw_height_mm", number(vise.jaw_height_mm)},
            {"jaw_thickness_mm", number(vise.jaw_thickness_mm)},
            {"parallels_mm", numbersJson(vise.parallels_mm)},
            {"grip_mm", number(vise.grip_mm)},
            {"jaw_clearance_mm", number(vise.jaw_clearance_mm)}};
}

Json sourceJson(const std::string& file, const std::string& sha256) {
    return sha256.empty() ? Json(nullptr) : Json{{"file", file}, {"sha256", sha256}};
}

/// What verify needs beside the files to derive setups and features anew.
Json requestJson(const Plan& plan) {
    const PlanRequest& request = plan.request;
    const StockMargin& margin = request.setup.margin;
    const std::optional<Part>& stock = request.setup.stock_part;
    return {{"solid", plan.part.solid_index},
            {"unit", request.unit},
            {"stock_margin_mm", {number(margin.side_mm), number(margin.top_mm), number(margin.bottom_mm)}},
            {"stock", stock ? sourceJson(stock->file, stock->sha256) : Json(nullptr)},
            {"fixtures", sourceJson(request.fixtures.file, request.fixtures.sha256)},
            {"vise", viseJson(request.fixtures.vise)},
            {"plate_mm", number(request.fixtures.plate_mm)},
            {"finish_walls_mm", number(request.sequence.finish.walls_mm)},
            {"finish_floors_mm", number(request.sequence.finish.floors_mm)}};
}

/// What differs from what a plan does by itself.
void addWishes(const PlanRequest& request, Json& json) {
    if (!request.setup.axes.empty()) json["setups"] = listOf(request.setup.axes, directionJson);
    if (!request.setup.forbidden.empty()) json["no_setups"] = listOf(request.setup.forbidden, directionJson);
    if (!request.setup.stock_sizes_mm.empty())
        json["stock_sizes_mm"] = numbersJson(request.setup.stock_sizes_mm);
    if (request.hold) json["hold"] = toString(*request.hold);
    const SequenceOptions usual;
    if (request.sequence.objective != usual.objective)
        json["objective"] = toString(request.sequence.objective);
    if (request.sequence.surrogates != usual.surrogates)
        json["surrogates"] = toString(request.sequence.surrogates);
    if (request.quantity != 1) json["quantity"] = request.quantity;
    if (request.scallop_mm != kUsualScallopMm) json["scallop_mm"] = number(request.scallop_mm);
    if (!request.assign) json["reserve"] = false;
    if (request.break_edges_mm > 0) json["break_edges_mm"] = number(request.break_edges_mm);
    if (!request.cycle_times.empty()) json["cycle_times"] = listOf(request.cycle_times, cycleTargetJson);
}

/// Of roughing what stays on the part too, and the hole table where there is one.
Json requestAndRoughingJson(const Plan& plan) {
    Json json = requestJson(plan);
    if (const HoleTable& holes = plan.request.holes; !holes.sha256.empty())
        json["holes"] = sourceJson(holes.file, holes.sha256);
    if (const std::optional<FinishAllowance>& leaves = plan.request.roughing)
        json["roughing"] = {{"leaves_on_walls_mm", number(leaves->walls_mm)},
                            {"leaves_on_floors_mm", number(leaves->floors_mm)}};
    addWishes(plan.request, json);
    return json;
}

Json cylinderJson(const HolderCylinder& cylinder) {
    return {{"diameter_mm", number(cylinder.diameter_mm)},
            {"bottom_mm", number(cylinder.bottom_mm)},
            {"top_mm", number(cylinder.top_mm)}};
}

Json spindlePointJson(const SpindlePoint& point) {
    return {{"speed_rpm", number(point.speed_rpm)},
            {"power_kw", number(point.power_kw)},
            {"torque_nm", number(point.torque_nm)}};
}

Json machineJson(const Machine& machine) {
    Json json{{"name", machine.name},
              {"rapid_mm_per_min", number(machine.rapid_mm_per_min)},
              {"max_feed_mm_per_min", number(machine.max_feed_mm_per_min)},
              {"max_speed_rpm", number(machine.max_speed_rpm)},
              {"tool_change_s", number(machine.tool_change_s)},
              {"hourly_rate", number(machine.hourly_rate)},
              {"currency", machine.currency},
              {"travel_mm", machine.travel_mm},
              {"magazine_size", machine.magazine_size},
              {"safe_height_mm", number(machine.safe_height_mm)},
              {"side_clearance_mm", number(machine.side_clearance_mm)},
              {"top_clearance_mm", number(machine.top_clearance_mm)},
              {"inside_clearance_mm", number(machine.inside_clearance_mm)},
              {"holder_clearance_mm", number(machine.holder_clearance_mm)},
              {"dialect", machine.dialect}};
    if (!machine.spindle_curve.empty())
        json["spindle"] = {{"efficiency", number(machine.spindle_efficiency)},
                           {"curve", listOf(machine.spindle_curve, spindlePointJson)}};
    if (!machine.spindle_nose.empty()) json["spindle_nose"] = listOf(machine.spindle_nose, cylinderJson);
    if (machine.gauge_over_table_mm[1] > 0) json["gauge_over_table_mm"] = machine.gauge_over_table_mm;
    if (machine.column_behind_mm > 0) json["column_behind_mm"] = number(machine.column_behind_mm);
    if (machine.setup_time_min != kSetupTimeMin) json["setup_time_min"] = number(machine.setup_time_min);
    if (machine.indexed_setup_time_min != kIndexedSetupTimeMin)
        json["indexed_setup_time_min"] = number(machine.indexed_setup_time_min);
    if (machine.load_time_s != kLoadTimeS) json["load_time_s"] = number(machine.load_time_s);
    if (machine.acceleration_mm_per_s2 > 0) {
        json["acceleration_mm_per_s2"] = number(machine.acceleration_mm_per_s2);
        json["junction_deviation_mm"] = number(machine.junction_deviation_mm);
    }
    if (machine.home_by) json["home_by"] = toString(*machine.home_by);
    if (const auto& place = machine.part_change_mm)
        json["part_change_mm"] = {number((*place)[0]), number((*place)[1])};
    return json;
}

Json sharingJson(const ToolSharing& sharing) {
    return {{"features_changed", sharing.features_changed},
            {"tool_changes_alone", sharing.visits_alone},
            {"tool_changes", sharing.visits},
            {"tools_alone", sharing.tools_alone},
            {"tools", sharing.tools},
            {"saved", number(sharing.saved)}};
}

Json toolJson(const ToolAssembly& tool) {
    Json range = nullptr;
    if (tool.stick_out_range)
        range = {number(tool.stick_out_range->shortest_mm), number(tool.stick_out_range->longest_mm)};
    Json json{{"id", tool.id},
              {"number", tool.number},
              {"type", toString(tool.type)},
              {"description", tool.description},
              {"diameter_mm", number(tool.diameter_mm)},
              {"corner_radius_mm", number(tool.corner_radius_mm)},
              {"flute_length_mm", number(tool.flute_length_mm)},
              {"flutes", tool.flutes},
              {"cutter_material", toString(tool.cutter_material)},
              {"max_plunge_mm", number(tool.max_plunge_mm)},
              {"stick_out_mm", number(tool.stick_out_mm)},
              {"stick_out_range_mm", std::move(range)},
              {"shank", cylinderJson(tool.shank)},
              {"holder", listOf(tool.holder, cylinderJson)}};
    if (tool.hasFlanks()) {
        json["tip_diameter_mm"] = number(tool.tip_diameter_mm);
        json["included_angle_deg"] = number(tool.included_angle_deg);
    }
    if (tool.isDrill() || tool.isSpot()) json["point_angle_deg"] = number(tool.point_angle_deg);
    if (tool.self_centring) json["self_centring"] = true;
    if (tool.isTap()) json["thread"] = tool.thread->name;
    if (tool.isTap() || tool.isSizer()) json["lead_mm"] = number(tool.lead_mm);
    return json;
}

/// Tools the operations use, by number.
Json usedToolsJson(const Plan& plan) {
    std::map<int, const ToolAssembly*> used;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations) {
            const ToolAssembly& tool = plan.library.tool(operation.tool_id);
            used.emplace(tool.number, &tool);
        }
    return listOf(used, [](const auto& entry) { return toolJson(*entry.second); });
}

Json reasonJson(const ReasonVolume& entry) {
    return {{"reason", toString(entry.reason)}, {"volume_mm3", number(entry.volume_mm3)}};
}

Json patternTimeJson(const PatternTime& time) {
    return {{"pattern", toString(time.pattern)},
            {"angle_deg", number(time.angle_deg)},
            {"time_s", number(time.time_s)},
            {"at_least", time.at_least}};
}

Json fedPatternJson(const FedPattern& fed) {
    return {{"pattern", fed.pattern}, {"time_s", number(fed.time_s)}};
}

Json regionPatternsJson(const RegionPatterns& region) {
    return listOf(region.weighed, patternTimeJson);
}

Json ratingJson(const CutRating& rating) {
    return {{"step_over_mm", number(rating.step_over_mm)},
            {"step_down_mm", number(rating.step_down_mm)},
            {"slot_step_down_mm", number(rating.slot_step_down_mm)},
            {"removal_cm3_per_min", number(rating.removal_mm3_per_min / kMm3PerCm3)}};
}

Json cutsJson(const CutSummary& cuts) {
    return {{"peak_kw", number(cuts.peak_kw)},
            {"mean_kw", number(cuts.mean_kw)},
            {"limit", toString(cuts.limit)},
            {"deflection_mm", number(cuts.deflection_mm)},
            {"length_shares", listOf(cuts.length_shares, [](double share) { return Json(number(share)); })}};
}

Json cutMaterialJson(const Material& material) {
    return {{"name", material.name},
            {"kc11_n_per_mm2", number(material.kc11_n_per_mm2)},
            {"mc", number(material.mc)},
            {"source", material.source}};
}

Json threadJson(const ThreadCut& thread) {
    return {{"name", thread.thread.name},
            {"full_to_z_mm", number(thread.full_to_z_mm)},
            {"places", listOf(thread.places, [](const Vec2& place) { return point(place); })}};
}

/// \param feature  that it cuts, or form ground
/// \param band  the feature's
Json operationJson(const Operation& operation, const std::string& feature, int band) {
    const Toolpath& path = operation.path;
    Json json{{"id", operation.id},
              {"setup", operation.setup_id},
              {"feature", feature},
              {"band", band},
              {"tool", operation.tool_id},
              {"role", toString(operation.role)},
              {"pattern", path.pattern},
              {"regions", listOf(path.regions, regionPatternsJson)},
              {"layers", path.depths},
              {"z_top_mm", number(operation.z_top_mm)},
              {"z_floor_mm", number(operation.z_floor_mm)},
              {"step_over_mm", number(path.step_over_mm)},
              {"step_down_mm", number(path.step_down_mm)},
              {"feed_mm_per_min", number(path.feed_mm_per_min)},
              {"plunge_feed_mm_per_min", number(path.plunge_feed_mm_per_min)},
              {"speed_rpm", number(operation.speed_rpm)},
              {"coolant", toString(operation.coolant)},
              {"dwell_s", number(operation.dwell_s)},
              {"even_length_mm", number(operation.even_length_mm)},
              {"cut_length_mm", number(path.totals.cut_length_mm)},
              {"feed_air_length_mm", number(path.totals.feed_air_length_mm)},
              {"air_length_mm", number(path.totals.air_length_mm)},
              {"time_s", number(operation.timeS())},
              {"motion_time_s", number(operation.motionS())}};
    if (!path.as_fed.empty()) json["as_fed"] = listOf(path.as_fed, fedPatternJson);
    if (operation.holes > 0) json["holes"] = operation.holes;
    if (operation.thread) json["thread"] = threadJson(*operation.thread);
    if (operation.fit) json["fit"] = operation.fit->name;
    if (operation.ramp_angle_deg > 0) json["ramp_angle_deg"] = number(operation.ramp_angle_deg);
    if (operation.engagement_deg > 0) json["engagement_deg"] = number(operation.engagement_deg);
    if (operation.leaves.any()) {
        json["leaves_on_walls_mm"] = number(operation.leaves.walls_mm);
        json["leaves_on_floor_mm"] = number(operation.leaves.floors_mm);
    }
    if (operation.rating) {
        json["rating"] = ratingJson(*operation.rating);
        json["cuts"] = cutsJson(operation.cuts);
    }
    if (operation.pace != 1) json["pace"] = number(operation.pace);
    if (!operation.takes.empty()) json["takes"] = listOf(operation.takes, reasonJson);
    if (operation.breaks_mm3 > 0) json["breaks_mm3"] = number(operation.breaks_mm3);
    return json;
}

Json balanceJson(const VolumeBalance& balance) {
    return {{"stock_minus_part_mm3", number(balance.stock_minus_part_mm3)},
            {"planned_mm3", number(balance.planned_mm3)},
            {"residual_mm3", number(balance.residual_mm3)},
            {"unreachable_mm3", number(balance.unreachable_mm3)},
            {"residual_by_reason", listOf(balance.residual_by_reason, reasonJson)},
            {"unreachable_by_reason", listOf(balance.unreachable_by_reason, reasonJson)}};
}

Json arrivingStockJson(const Setup& setup) {
    const Stock::Kind kind = setup.stock.kind;
    return {{"kind", kind == Stock::Kind::Box    ? "box"
                     : kind == Stock::Kind::Step ? "step"
                                                 : "in process"},
            {"size_mm", point(Vec3(setup.stock_bbox_mm.sizes()))},
            {"volume_mm3", number(setup.stock.volume_mm3)}};
}

Json clampingJson(const Clamping& clamping) {
    Json json{{"kind", toString(clamping.kind)},
              {"vise", clamping.isVise()},
              {"text", clamping.text},
              {"seat_mm2", number(clamping.seat_mm2)}};
    if (clamping.held_mm > 0) {
        json["held_mm"] = number(clamping.held_mm);
        json["holds_all"] = clamping.holds_all;
    }
    if (!clamping.isVise()) return json;
    json["across"] = point(clamping.across);
    json["opening_mm"] = number(clamping.opening_mm);
    json["from_mm"] = number(clamping.from_mm);
    json["depth_mm"] = number(clamping.depth_mm);
    json["length_mm"] = number(clamping.length_mm);
    json["parallels_mm"] = number(clamping.parallels_mm);
    return json;
}

Json fixtureJson(const Fixture& fixture, RegionTables& regions) {
    return {{"name", fixture.name},
            {"kind", toString(fixture.kind)},
            {"bottom_z_mm", number(fixture.bottom_z_mm)},
            {"top_z_mm", number(fixture.top_z_mm)},
            {"section", regions.add(fixture.section)}};
}

Json orderJson(const WeighedOrder& order) {
    return {{"rule", toString(order.rule)}, {"travel_mm", number(order.travel_mm)}};
}

Json prismJson(const Prism& prism, RegionTables& regions) {
    return {{"bottom_z_mm", number(prism.bottom_z_mm)},
            {"top_z_mm", number(prism.top_z_mm)},
            {"section", regions.add(prism.region)}};
}

Json setupJson(const PlannedSetup& setup, Dialect dialect, RegionTables& regions) {
    Json json{{"id", setup.setup.id},
              {"axis", directionJson(setup.setup.axis)},
              {"transform", transformJson(setup.setup.part_to_setup)},
              {"program", programName(setup.setup.id, dialect)},
              {"features", listOf(wholeFeatures(setup.features), [](const auto& f) { return Json(f.id()); })},
              {"operations", listOf(setup.operations, [](const Operation& o) { return Json(o.id); })},
              {"orders", listOf(setup.orders, orderJson)},
              {"time_s", number(setup.time_s)},
              {"motion_time_s", number(setup.motion_s)},
              {"axis_name", axisName(setup.setup.axis)},
              {"indexed", setup.setup.indexed},
              {"stock", arrivingStockJson(setup.setup)},
              {"clamping", clampingJson(setup.clamping)},
              {"fixtures", listOf(setup.setup.fixtures,
                                  [&](const Fixture& fixture) { return fixtureJson(fixture, regions); })},
              {"volume_balance", balanceJson(setup.balance)}};
    for (const auto& [name, id] : setup.names)
        json["kept_names"].push_back({{"number", name}, {"id", id}});
    if (setup.leaning_mm3) json["leaning_mm3"] = number(*setup.leaning_mm3);
    if (!setup.reserve.empty())
        json["reserve"] =
            listOf(setup.reserve, [&](const Prism& prism) { return prismJson(prism, regions); });
    return json;
}

Json workJson(const WeighedWork& work) {
    return {{"feature", work.feature},
            {"axis_name", work.setup},
            {"volume_mm3", number(work.volume_mm3)},
            {"early_s", number(work.early_s)},
            {"late_s", number(work.late_s)},
            {"left", work.left}};
}

Json choiceJson(const SetupChoice& choice) {
    Json axes = Json::array();
    for (const Vec3& axis : choice.axes)
        axes.push_back(axisName(axis));
    Json json = {{"axes", std::move(axes)}, {"verdict", toString(choice.verdict)}};
    if (!choice.planned) return json;
    json["time_s"] = number(choice.planned->time_s);
    json["setup_s"] = number(choice.planned->setup_s);
    json["stays_mm3"] = number(choice.planned->stays_mm3);
    return json;
}

Json triedJson(const TriedReserve& tried) {
    return {{"setup", tried.setup},
            {"before_s", number(tried.before_s)},
            {"with_s", number(tried.with_s)},
            {"more_stays_mm3", number(tried.stays_mm3)},
            {"verdict", toString(tried.verdict)},
            {"work", listOf(tried.proposal.work, workJson)}};
}

Json formsJson(const Plan& plan, record::FeatureTables& tables) {
    Json forms = Json::array();
    for (const PlannedSetup& setup : plan.setups)
        for (const auto* ground : {&setup.form, &setup.edges})
            if (*ground) forms.push_back(record::formGroundJson(**ground, tables));
    return forms;
}

Json operationJson(const Operation& operation, const record::BandsById& bands) {
    if (operation.role == Role::Form) return operationJson(operation, operation.feature_id, 1);
    const Feature& band = *bands.at(operation.feature_id);
    return operationJson(operation, wholeOf(band), bandNumber(band));
}

Json totalsJson(const PlanTotals& totals) {
    return {{"time_s", number(totals.time_s)},
            {"motion_time_s", number(totals.motion_s)},
            {"cutting_s", number(totals.cutting_s)},
            {"air_s", number(totals.air_s)},
            {"tool_change_s", number(totals.tool_change_s)},
            {"tool_changes", totals.tool_changes},
            {"cost", number(totals.cost)},
            {"lower_bound_s", number(totals.lower_bound_s)}};
}

}  // namespace

std::string planJson(const Plan& plan) {
    const Dialect dialect = dialectOf(plan.machine);
    record::FeatureTables tables;
    Json setups = Json::array();
    Json features = Json::array();
    Json operations = Json::array();
    for (const PlannedSetup& setup : plan.setups) {
        setups.push_back(setupJson(setup, dialect, tables.regions));
        const record::BandsById bands = record::bandsById(setup.features);
        for (const WholeFeature<PlannedFeature>& feature : wholeFeatures(setup.features))
            features.push_back(record::featureJson(feature, setup.operations, bands, plan.machine, tables));
        for (const Operation& operation : setup.operations)
            operations.push_back(operationJson(operation, bands));
    }
    Json forms = formsJson(plan, tables);
    Json content{{"part", partJson(plan.part)},
                 {"stock", stockJson(plan.stock)},
                 {"request", requestAndRoughingJson(plan)},
                 {"machine", machineJson(plan.machine)},
                 {"material", plan.material},
                 {"tool_library", {{"file", plan.library.file}, {"sha256", plan.library.sha256}}},
                 {"cost_model", toString(plan.cost_model)},
                 {"setups", std::move(setups)},
                 {"tools", usedToolsJson(plan)},
                 {"features", std::move(features)},
                 {"operations", std::move(operations)},
                 {"tool_sharing", sharingJson(plan.sharing)},
                 {"totals", totalsJson(plan.totals)},
                 {"volume_balance", balanceJson(plan.balance)},
                 {"warnings", listOf(plan.warnings,
                                     [](const Warning& warning) {
                                         return Json{{"code", warning.code},
                                                     {"subject", warning.subject},
                                                     {"text", warning.text},
                                                     {"count", warning.count}};
                                     })},
                 {"obstacles", tables.obstacles.rows()},
                 {"regions", tables.regions.regions()},
                 {"loops", tables.regions.loops()}};
    if (plan.request.sequence.cut_material)
        content["cut_material"] = cutMaterialJson(*plan.request.sequence.cut_material);
    if (plan.threads_missing > 0) content["threads_missing"] = plan.threads_missing;
    if (const Assignment& assignment = plan.assignment; !assignment.seen.empty())
        content["setup_axes"] = {{"seen", listOf(assignment.seen, directionJson)},
                                 {"taken", listOf(assignment.axes, directionJson)}};
    if (!plan.assignment.choices.empty())
        content["setup_choices"] = listOf(plan.assignment.choices, choiceJson);
    if (!plan.assignment.tried.empty()) content["assignment"] = listOf(plan.assignment.tried, triedJson);
    if (!plan.cycle.outcomes.empty()) content["cycle_time"] = cycleTimesJson(plan.cycle);
    if (!forms.empty()) content["forms"] = std::move(forms);
    return finishJson(SchemaName::Plan, std::move(content));
}

std::vector<MachineDifference> machineDifferences(std::string_view plan_json, const Machine& machine) {
    const Json recorded = Json::parse(plan_json).at("machine");
    const Json expected = Json::parse(machineJson(machine).dump());
    const auto words = [](const Json& json, const Json::json_pointer& place) {
        return json.contains(place) ? json.at(place).dump() : std::string();
    };
    std::vector<MachineDifference> differences;
    for (const Json& step : Json::diff(recorded, expected)) {
        const Json::json_pointer place(step.at("path").get<std::string>());
        differences.push_back({place.to_string(), words(recorded, place), words(expected, place)});
    }
    return differences;
}

}  // namespace stepmill
