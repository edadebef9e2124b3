#include "stepmill/record/plan_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "record/form_ground_json.h"
#include "record/plan_rules.h"
#include "record/read_features.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/post/post.h"
#include "stepmill/record/cycle_json.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;
using record::BandsOf;
using record::failAt;
using record::ReadTables;

/// A direction that was written down is no more than this longer or shorter than 1.
constexpr double kUnitRounding = 1e-6;

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
    tool.point_angle_deg = json.value("point_angle_deg", tool.point_angle_deg);
    if (json.contains("thread")) tool.thread = threadFrom(json["thread"].get<std::string>());
    tool.lead_mm = json.value("lead_mm", 0.0);
    tool.self_centring = json.value("self_centring", false);
    tool.flute_length_mm = json["flute_length_mm"];
    tool.flutes = json.value("flutes", 0);
    tool.cutter_material = *cutterMaterialFrom(json.value("cutter_material", "carbide"));
    tool.max_plunge_mm = json.value("max_plunge_mm", std::numeric_limits<double>::infinity());
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

/// The value of a word that need not be there.
template <typename Enum>
Enum knownOr(const Json& json, const char* key, std::optional<Enum> (*from)(std::string_view), Enum usual) {
    if (!json.contains(key)) return usual;
    const std::string word = json[key];
    return known(from(word), word);
}

CutRating rating(const Json& json) {
    return {json["step_over_mm"], json["step_down_mm"], json["slot_step_down_mm"],
            json["removal_cm3_per_min"].get<double>() * kMm3PerCm3};
}

ThreadCut threadCut(const Json& operation) {
    const Json& json = operation["thread"];
    ThreadCut cut;
    cut.thread = threadFrom(json["name"].get<std::string>()).value();
    cut.tip_z_mm = operation["z_floor_mm"];
    cut.full_to_z_mm = json["full_to_z_mm"];
    for (const Json& place : json["places"])
        cut.places.emplace_back(place[0], place[1]);
    return cut;
}

RecordedOperation operation(const Json& json, const std::map<std::string, ToolAssembly>& tools,
                            const BandsOf& bands) {
    RecordedOperation operation;
    operation.id = json["id"];
    operation.setup_id = json["setup"];
    operation.feature_id =
        json["role"] == "form" ? json["feature"].get<std::string>() : record::namedBand(json, bands);
    operation.tool = tools.at(json["tool"]);
    operation.role = known(roleFrom(json["role"].get<std::string>()), json["role"]);
    operation.pattern = json["pattern"];
    operation.depths = json["layers"];
    operation.z_floor_mm = json["z_floor_mm"];
    operation.leaves = {json.value("leaves_on_walls_mm", 0.0), json.value("leaves_on_floor_mm", 0.0)};
    operation.step_down_mm = json["step_down_mm"];
    operation.feed_mm_per_min = json["feed_mm_per_min"];
    operation.plunge_feed_mm_per_min = json["plunge_feed_mm_per_min"];
    operation.ramp_angle_deg = json.value("ramp_angle_deg", 0.0);
    operation.engagement_deg = json.value("engagement_deg", 0.0);
    operation.speed_rpm = json["speed_rpm"];
    operation.coolant = *coolantFrom(json["coolant"].get<std::string>());
    operation.dwell_s = json["dwell_s"];
    operation.holes = json.value("holes", operation.role == Role::Drill ? 1 : 0);
    if (json.contains("thread")) operation.thread = threadCut(json);
    if (json.contains("fit")) operation.fit = fitFrom(json["fit"].get<std::string>());
    if (json.contains("rating")) operation.rating = rating(json["rating"]);
    operation.pace = json.value("pace", 1.0);
    if (json.contains("takes"))
        for (const Json& entry : json["takes"])
            operation.takes.push_back(
                {stayReasonFrom(entry["reason"].get<std::string>()), entry["volume_mm3"]});
    operation.breaks_mm3 = json.value("breaks_mm3", 0.0);
    return operation;
}

Fixture fixture(const Json& json, const std::string& pointer, ReadTables& tables) {
    record::checkUpright(json, pointer);
    return {json["name"], tables.region(json["section"], pointer + "/section"), json["bottom_z_mm"],
            json["top_z_mm"], fixtureKindFrom(json.value("kind", "")).value_or(FixtureKind::Clamp)};
}

Clamping clamping(const Json& json) {
    Clamping clamping;
    const HoldKind older = json["vise"].get<bool>() ? HoldKind::Vise : HoldKind::None;
    clamping.kind = anyHoldKindFrom(json.value("kind", "")).value_or(older);
    if (json.contains("across"))
        for (int i = 0; i < 3; ++i)
            clamping.across[i] = json["across"][i];
    clamping.opening_mm = json.value("opening_mm", 0.0);
    clamping.from_mm = json.value("from_mm", 0.0);
    clamping.depth_mm = json.value("depth_mm", 0.0);
    clamping.length_mm = json.value("length_mm", 0.0);
    clamping.parallels_mm = json.value("parallels_mm", 0.0);
    clamping.seat_mm2 = json["seat_mm2"];
    clamping.held_mm = json.value("held_mm", 0.0);
    clamping.holds_all = json.value("holds_all", false);
    clamping.text = json["text"];
    return clamping;
}

Prism prism(const Json& json, const std::string& pointer, ReadTables& tables) {
    record::checkUpright(json, pointer);
    return {tables.region(json["section"], pointer + "/section"), json["top_z_mm"], json["bottom_z_mm"]};
}

RecordedSetup setup(const Json& json, const std::string& pointer, const BandsOf& bands, ReadTables& tables) {
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
        for (std::size_t i = 0; i < json["fixtures"].size(); ++i)
            setup.fixtures.push_back(
                fixture(json["fixtures"][i], fmt::format("{}/fixtures/{}", pointer, i), tables));
    if (json.contains("leaning_mm3")) setup.leaning_mm3 = json["leaning_mm3"];
    if (json.contains("reserve"))
        for (std::size_t i = 0; i < json["reserve"].size(); ++i)
            setup.reserve.push_back(
                prism(json["reserve"][i], fmt::format("{}/reserve/{}", pointer, i), tables));
    if (json.contains("clamping")) setup.clamping = clamping(json["clamping"]);
    setup.time_s = json["time_s"];
    for (const Json& feature : json["features"])
        for (std::string& id : record::bandIds(feature, bands))
            setup.feature_ids.push_back(std::move(id));
    if (json.contains("kept_names"))
        for (const Json& kept : json["kept_names"])
            setup.names[kept["number"]] = kept["id"];
    setup.operation_ids = json["operations"].get<std::vector<std::string>>();
    return setup;
}

Material cutMaterial(const Json& json) {
    return {json["name"], {}, json["kc11_n_per_mm2"], json["mc"], json["source"]};
}

Machine machine(const Json& json) {
    Machine machine;
    machine.name = json["name"];
    machine.rapid_mm_per_min = json["rapid_mm_per_min"];
    machine.max_feed_mm_per_min = json.value("max_feed_mm_per_min", 0.0);
    if (json.contains("travel_mm")) machine.travel_mm = json["travel_mm"].get<std::array<double, 3>>();
    machine.max_speed_rpm = json.value("max_speed_rpm", 0.0);
    if (json.contains("spindle")) {
        machine.spindle_efficiency = json["spindle"]["efficiency"];
        for (const Json& point : json["spindle"]["curve"])
            machine.spindle_curve.push_back({point["speed_rpm"], point["power_kw"], point["torque_nm"]});
    }
    if (json.contains("spindle_nose"))
        for (const Json& one : json["spindle_nose"])
            machine.spindle_nose.push_back(cylinder(one));
    machine.tool_change_s = json["tool_change_s"];
    machine.hourly_rate = json["hourly_rate"];
    machine.currency = json.value("currency", "");
    machine.magazine_size = json.value("magazine_size", 0);
    machine.acceleration_mm_per_s2 = json.value("acceleration_mm_per_s2", 0.0);
    machine.safe_height_mm = json.value("safe_height_mm", 0.0);
    machine.side_clearance_mm = json.value("side_clearance_mm", 0.0);
    machine.top_clearance_mm = json.value("top_clearance_mm", 0.0);
    machine.inside_clearance_mm = json.value("inside_clearance_mm", 0.0);
    machine.holder_clearance_mm = json.value("holder_clearance_mm", 0.0);
    if (json.contains("gauge_over_table_mm"))
        machine.gauge_over_table_mm = json["gauge_over_table_mm"].get<std::array<double, 2>>();
    machine.column_behind_mm = json.value("column_behind_mm", 0.0);
    machine.setup_time_min = json.value("setup_time_min", machine.setup_time_min);
    machine.indexed_setup_time_min = json.value("indexed_setup_time_min", machine.indexed_setup_time_min);
    machine.load_time_s = json.value("load_time_s", machine.load_time_s);
    machine.dialect = json.value("dialect", toString(Dialect::LinuxCnc));
    machine.junction_deviation_mm = json.value("junction_deviation_mm", machine.junction_deviation_mm);
    machine.home_by = homeByFrom(json.value("home_by", ""));
    if (json.contains("part_change_mm"))
        machine.part_change_mm = json["part_change_mm"].get<std::array<double, 2>>();
    return machine;
}

Stock stock(const Json& json) {
    Stock stock;
    stock.kind = json["kind"] == "box" ? Stock::Kind::Box : Stock::Kind::Step;
    for (int i = 0; i < 3; ++i) {
        stock.bbox_mm.min()[i] = json["bbox_mm"][0][i];
        stock.bbox_mm.max()[i] = json["bbox_mm"][1][i];
    }
    stock.raw_bbox_mm = stock.bbox_mm;
    stock.volume_mm3 = json["volume_mm3"];
    stock.tolerance_mm = json.value("tolerance_mm", 0.0);
    return stock;
}

void readForms(const Json& plan, ReadTables& tables, PlanRecord& record) {
    if (!plan.contains("forms")) return;
    for (std::size_t i = 0; i < plan["forms"].size(); ++i) {
        FormGround ground = record::formGroundFrom(plan["forms"][i], fmt::format("#/forms/{}", i), tables);
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

Vise vise(const Json& json) {
    return {json["opening_mm"],
            json["jaw_width_mm"],
            json["jaw_height_mm"],
            json["jaw_thickness_mm"],
            json["parallels_mm"].get<std::vector<double>>(),
            json["grip_mm"],
            json["jaw_clearance_mm"]};
}

RecordedFile file(const Json& json) {
    return json.is_null() ? RecordedFile{} : RecordedFile{json["file"], json["sha256"]};
}

/// A list that a request may leave out.
std::vector<Vec3> directions(const Json& request, const char* list) {
    std::vector<Vec3> directions;
    if (request.contains(list))
        for (const Json& one : request[list])
            directions.emplace_back(one[0], one[1], one[2]);
    return directions;
}

RecordedRequest request(const Json& json) {
    const Json& margin = json["stock_margin_mm"];
    RecordedRequest request{json["solid"],
                            json["unit"],
                            {margin[0], margin[1], margin[2]},
                            file(json["stock"]),
                            file(json["fixtures"]),
                            json.contains("holes") ? file(json["holes"]) : RecordedFile{},
                            {json["finish_walls_mm"], json["finish_floors_mm"]},
                            {},
                            directions(json, "setups"),
                            directions(json, "no_setups"),
                            knownOr(json, "objective", objectiveFrom, SequenceOptions{}.objective),
                            knownOr(json, "surrogates", surrogateRuleFrom, SequenceOptions{}.surrogates),
                            json.value("quantity", 1),
                            json.value("scallop_mm", kUsualScallopMm),
                            json.value("break_edges_mm", 0.0),
                            json.value("reserve", true),
                            json.value("stock_sizes_mm", std::vector<double>{}),
                            json.contains("vise") ? std::optional(vise(json["vise"])) : std::nullopt,
                            json.value("plate_mm", kPlateThicknessMm),
                            holdKindFrom(json.value("hold", "")),
                            {}};
    if (json.contains("roughing"))
        request.roughing = {json["roughing"]["leaves_on_walls_mm"], json["roughing"]["leaves_on_floors_mm"]};
    if (json.contains("cycle_times"))
        for (const Json& target : json["cycle_times"])
            request.cycle_times.push_back({target["of"], target["time_s"]});
    return request;
}

/// A list that the books may leave out.
std::vector<ReasonVolume> reasonVolumes(const Json& books, const char* list) {
    std::vector<ReasonVolume> volumes;
    if (books.contains(list))
        for (const Json& entry : books[list])
            volumes.push_back({stayReasonFrom(entry["reason"].get<std::string>()), entry["volume_mm3"]});
    return volumes;
}

void readBalance(const Json& plan, const Tolerances& tol, PlanRecord& record) {
    const Json& books = plan["volume_balance"];
    record.rounding_mm3 =
        std::max(kVolumeRoundingMm3, tol.volume_share * books["stock_minus_part_mm3"].get<double>());
    record.books.stock_minus_part_mm3 = books["stock_minus_part_mm3"];
    record.books.planned_mm3 = books["planned_mm3"];
    record.books.residual_mm3 = books["residual_mm3"];
    record.books.unreachable_mm3 = books["unreachable_mm3"];
    record.books.residual_by_reason = reasonVolumes(books, "residual_by_reason");
    record.books.unreachable_by_reason = reasonVolumes(books, "unreachable_by_reason");
}

SetupChoice setupChoice(const Json& json) {
    SetupChoice choice;
    for (const Json& axis : json["axes"])
        choice.axes.push_back(parseAxis(axis.get<std::string>()).value_or(Vec3::UnitZ()));
    const std::string verdict = json["verdict"];
    choice.verdict = known(setupVerdictFrom(verdict), verdict);
    if (json.contains("time_s")) choice.planned = {json["time_s"], json["setup_s"], json["stays_mm3"]};
    return choice;
}

TriedReserve triedReserve(const Json& json) {
    TriedReserve tried;
    tried.setup = json["setup"];
    tried.before_s = json["before_s"];
    tried.with_s = json["with_s"];
    tried.stays_mm3 = json["more_stays_mm3"];
    const std::string verdict = json["verdict"];
    tried.verdict = known(verdictFrom(verdict), verdict);
    for (const Json& work : json["work"])
        tried.proposal.work.push_back({work["feature"], work["axis_name"], work["volume_mm3"],
                                       work["early_s"], work["late_s"], work["left"]});
    return tried;
}

/// A list of unit vectors.
std::vector<Vec3> setupAxes(const Json& plan, const char* list) {
    std::vector<Vec3> axes = directions(plan["setup_axes"], list);
    for (std::size_t i = 0; i < axes.size(); ++i)
        if (std::abs(axes[i].norm() - 1) > kUnitRounding)
            failAt(fmt::format("#/setup_axes/{}/{}", list, i), "expected a direction of length 1");
    return axes;
}

Assignment assignment(const Json& plan) {
    Assignment assignment;
    if (!plan.contains("setup_axes")) return assignment;
    assignment.axes = setupAxes(plan, "taken");
    assignment.seen = setupAxes(plan, "seen");
    if (plan.contains("setup_choices"))
        for (const Json& choice : plan["setup_choices"])
            assignment.choices.push_back(setupChoice(choice));
    if (plan.contains("assignment"))
        for (const Json& tried : plan["assignment"])
            assignment.tried.push_back(triedReserve(tried));
    return assignment;
}

void readTimes(const Json& plan, PlanRecord& record) {
    for (const Json& one : plan["operations"])
        record.operation_s[one["id"]] = one["time_s"];
    const Json& totals = plan["totals"];
    record.totals.time_s = totals["time_s"];
    record.totals.cutting_s = totals["cutting_s"];
    record.totals.air_s = totals["air_s"];
    record.totals.tool_change_s = totals["tool_change_s"];
    record.totals.tool_changes = totals["tool_changes"];
    record.totals.cost = totals["cost"];
}

/// The format that a text which breaks the schema says it has; 0 where it says none.
int formatOf(std::string_view text) {
    const Json plan = Json::parse(text, nullptr, false);
    const bool told = plan.is_object() && plan.contains("format") && plan["format"].is_number_integer();
    return told ? plan["format"].get<int>() : 0;
}

/// Says what is wrong first with a text that breaks the schema; of a plan of another format all would be.
[[noreturn]] void failBySchema(std::string_view text, const std::string& error) {
    const int format = formatOf(text);
    const int expected = schemaFormat(SchemaName::Plan);
    if (format != 0 && format != expected)
        failAt(
            "#/format",
            fmt::format("expected {}, found {}: the plan was made by another version of stepmill; plan the "
                        "part again",
                        expected, format));
    const std::size_t colon = error.find(": ");
    if (colon == std::string::npos) failAt("", error);
    failAt(error.substr(0, colon), error.substr(colon + 2));
}

void readFeatures(const Json& plan, const BandsOf& bands, ReadTables& tables, PlanRecord& record) {
    for (std::size_t i = 0; i < plan["features"].size(); ++i)
        for (RecordedFeature& band :
             record::readFeature(plan["features"][i], fmt::format("#/features/{}", i), bands, tables)) {
            const std::string id = band.feature.id;
            record.features[id] = std::move(band);
        }
}

}  // namespace

PlanRecord planRecordFromText(std::string_view text, const Tolerances& tol) {
    const std::vector<std::string> errors = schemaErrors(SchemaName::Plan, text);
    if (!errors.empty()) failBySchema(text, errors.front());
    const Json plan = Json::parse(text);
    record::checkPlanRules(plan);
    record::checkBooks(plan, tol);
    PlanRecord record;
    record.part_file = plan["part"]["file"];
    record.part_sha256 = plan["part"]["sha256"];
    record.part_name = plan["part"]["name"];
    record.material = plan["material"];
    record.cost_model = costModelFrom(plan.value("cost_model", "paths")).value();
    if (plan.contains("cut_material")) record.cut_material = cutMaterial(plan["cut_material"]);
    record.machine = machine(plan["machine"]);
    if (plan.contains("request")) record.request = request(plan["request"]);
    record.library = file(plan["tool_library"]);
    record.part_volume_mm3 = plan["part"]["volume_mm3"];
    record.stock_volume_mm3 = plan["stock"]["volume_mm3"];
    record.stock = stock(plan["stock"]);
    for (const Json& one : plan["tools"]) {
        ToolAssembly read = tool(one);
        read.holder_clearance_mm = record.machine.holder_clearance_mm;
        record.tools[one["id"]] = std::move(read);
    }
    const BandsOf bands = record::bandsOf(plan);
    ReadTables tables(plan);
    readFeatures(plan, bands, tables, record);
    for (const Json& one : plan["operations"])
        record.operations[one["id"]] = operation(one, record.tools, bands);
    for (std::size_t i = 0; i < plan["setups"].size(); ++i)
        record.setups.push_back(setup(plan["setups"][i], fmt::format("#/setups/{}", i), bands, tables));
    readForms(plan, tables, record);
    noteTravel(plan, record);
    readBalance(plan, tol, record);
    readTimes(plan, record);
    record.assignment = assignment(plan);
    record.threads_missing = plan.value("threads_missing", 0);
    if (plan.contains("cycle_time")) record.cycle = cycleTimesFrom(plan["cycle_time"]);
    return record;
}

namespace {

/// The whole features of a setup, as far as its bands tell; by name alone those that common ground took.
std::vector<EarlierFeature> earlierFeatures(const PlanRecord& record, const RecordedSetup& setup) {
    std::map<std::string, EarlierFeature> features;
    std::map<std::string, double> ground_tops;  // by the first of its levels, which may begin below it
    for (const std::string& id : setup.feature_ids) {
        const Feature& band = record.features.at(id).feature;
        for (const std::string& level : band.ground_of) {
            const std::string whole = level.substr(0, level.find('.', level.find('.') + 1));
            features.emplace(whole, EarlierFeature{whole, band.feature_class, 0, 0, {}});
        }
        if (!band.ground_of.empty()) {
            ground_tops.emplace(band.ground_of.front(), band.top_z_mm);
            continue;
        }
        const auto ground_top = ground_tops.find(id);
        const double top_z_mm = ground_top != ground_tops.end() ? ground_top->second : band.top_z_mm;
        EarlierFeature& whole = features[wholeOf(band)];
        if (whole.target.empty())
            whole = {wholeOf(band), band.feature_class, top_z_mm, band.floor_z_mm, band.target};
        whole.floor_z_mm = band.floor_z_mm;
    }
    std::vector<EarlierFeature> list;
    for (auto& [id, feature] : features)
        list.push_back(std::move(feature));
    return list;
}

}  // namespace

std::vector<EarlierSetup> earlierSetups(const PlanRecord& record) {
    std::vector<EarlierSetup> setups;
    for (const RecordedSetup& setup : record.setups) {
        EarlierSetup& earlier = setups.emplace_back();
        earlier.id = setup.id;
        earlier.axis = setup.axis;
        earlier.leaning_mm3 = setup.leaning_mm3;
        earlier.features = earlierFeatures(record, setup);
        for (const std::string& id : setup.operation_ids) {
            const RecordedOperation& operation = record.operations.at(id);
            earlier.operations.push_back({id, operation.feature_id, operation.tool.id, operation.role});
        }
    }
    return setups;
}

std::optional<EarlierAssignment> earlierAssignment(const PlanRecord& record) {
    EarlierAssignment earlier{record.assignment, record.books.leftMm3()};
    Assignment& assignment = earlier.assignment;
    const bool hasty =
        std::any_of(assignment.choices.begin(), assignment.choices.end(),
                    [](const SetupChoice& choice) { return choice.verdict == SetupVerdict::NoTime; });
    if (assignment.seen.empty() || hasty) return std::nullopt;
    assignment.reserves.resize(assignment.axes.size());
    std::size_t place = 0;  // setups in which nothing is cut have one too
    for (const RecordedSetup& setup : record.setups) {
        while (place < assignment.axes.size() && assignment.axes[place] != setup.axis)
            ++place;
        if (place == assignment.axes.size()) return std::nullopt;
        assignment.reserves[place++] = {setup.part_to_setup, setup.reserve};
    }
    return earlier;
}

}  // namespace stepmill
