#include <gtest/gtest.h>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/file.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using Lines = std::vector<std::string>;

/// One setup, one round pocket, one operation: every list of the format has an entry.
json minimalPlan() {
    json plan = json::parse(R"({
    "format": 2,
    "stepmill": {"version": "0.1.0"},
    "part": {"file": "disc.step", "name": "", "unit_in_file": "mm", "bbox_mm": [[0, 0, 0], [40, 40, 10]],
             "volume_mm3": 14429.2, "solids": 1, "surfaces": {"plane": 7, "cylinder": 1}},
    "stock": {"kind": "box", "bbox_mm": [[0, 0, 0], [40, 40, 10]], "volume_mm3": 16000},
    "machine": {"name": "Mill", "rapid_mm_per_min": 30000, "tool_change_s": 5, "hourly_rate": 80},
    "material": "aluminium",
    "tool_library": {"file": "tools.json"}, "cost_model": "paths",
    "setups": [{"id": "S1", "axis": [0, 0, 1], "transform": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -10, 0, 0, 0, 1],
                "program": "S1.ngc", "features": ["S1.F1"], "operations": ["S1.O1"], "time_s": 60}],
    "tools": [{"id": "EM8", "number": 8, "type": "flat", "description": "", "diameter_mm": 8, "corner_radius_mm": 0,
               "flute_length_mm": 20, "stick_out_mm": 30, "stick_out_range_mm": null,
               "shank": {"diameter_mm": 8, "bottom_mm": 20, "top_mm": 30},
               "holder": [{"diameter_mm": 28, "bottom_mm": 30, "top_mm": 60}]}],
    "features": [{
        "id": "S1.F1", "setup": "S1", "class": "closed pocket", "levels": 1,
        "top_z_mm": 0, "floor_z_mm": -5, "depth_mm": 5, "volume_mm3": 1570.8, "time_s": 55, "motion_time_s": 56,
        "lower_bound_s": 40, "bands": [{
        "band": 1, "class": "closed pocket", "parents": [{"feature": "S1.F1", "band": 2}],
        "top_z_mm": 0, "floor_z_mm": -5, "area_mm2": 314.16, "volume_mm3": 1570.8, "open_length_mm": 0, "closed_length_mm": 62.83,
        "min_corner_radius_mm": 10,
        "target": 0, "obstruction": 1, "obstacles": [0],
        "tools": {"tool": ["EM8"], "accessible_area_mm2": [314.16], "coverable_area_mm2": [314.16],
                  "collision_free_area_mm2": [300]},
        "excluded": [{"reason": "too wide", "tools": ["EM25"]}],
        "blocked_lumps": [{"tool": "EM8", "area_mm2": 14.16, "surrogates": null, "reason": "holder collision"}],
        "dag": {"edges": {"from": ["source"], "to": ["EM8"], "region_area_mm2": [314.16], "cut_length_mm": [200],
                          "air_length_mm": [30], "time_s": [55], "cost": [1.2]},
                "surrogates": [{"from": "source", "to": "EM8", "tool": "EM6", "area_mm2": 14.16, "time_s": 4}],
                "path": ["EM8"]},
        "time_s": 55, "motion_time_s": 56, "lower_bound_s": 40,
        "residual": [{"region": 2, "area_mm2": 0.5, "volume_mm3": 2.5, "reason": "corner radius"}]}]}],
    "operations": [{
        "id": "S1.O1", "setup": "S1", "feature": "S1.F1", "band": 1, "tool": "EM8", "role": "rough",
        "pattern": "contour-parallel",
        "regions": [[{"pattern": "contour-parallel", "angle_deg": 0, "time_s": 54, "at_least": false}]],
        "layers": 1, "z_top_mm": 0, "z_floor_mm": -5, "step_over_mm": 3.6,
        "step_down_mm": 5, "feed_mm_per_min": 1900, "plunge_feed_mm_per_min": 570, "speed_rpm": 11950,
        "coolant": "flood", "dwell_s": 0,
        "even_length_mm": 90, "cut_length_mm": 200, "feed_air_length_mm": 5, "air_length_mm": 30, "time_s": 55,
        "motion_time_s": 56}],
    "totals": {"time_s": 60, "cutting_s": 50, "air_s": 5, "tool_change_s": 5, "tool_changes": 1, "cost": 1.3,
               "lower_bound_s": 45},
    "volume_balance": {"stock_minus_part_mm3": 1570.8, "planned_mm3": 1568.3, "residual_mm3": 2.5,
                       "unreachable_mm3": 0},
    "warnings": [{"code": "residual", "subject": "S1.F1", "text": "a corner stays"}],
    "obstacles": [{"bottom_z_mm": -5, "top_z_mm": 0, "section": 2}],
    "regions": [[0], [1], []],
    "loops": [[[30000000, 20000000], [-20000000, 0, -10000000, 0, 1], [20000000, 0, 10000000, 0, 1]],
              [[0, 0], [40000000, 0], [0, 40000000], [-40000000, 0], [0, -40000000]]]})");
    plan["part"]["sha256"] = std::string(64, '0');
    plan["tool_library"]["sha256"] = std::string(64, 'a');
    return plan;
}

Lines errorsWith(const std::string& pointer, const json& value) {
    json plan = minimalPlan();
    plan[json::json_pointer(pointer)] = value;
    return schemaErrors(SchemaName::Plan, plan.dump());
}

TEST(PlanSchema, TakesAMinimalPlan) {
    EXPECT_EQ(schemaErrors(SchemaName::Plan, minimalPlan().dump()), Lines{});
}

TEST(PlanSchema, TakesNullWhereTheFormatAllowsIt) {
    EXPECT_EQ(errorsWith("/features/0/bands/0/min_corner_radius_mm", nullptr), Lines{});
    EXPECT_EQ(errorsWith("/features/0/bands/0/blocked_lumps/0/surrogates", json::array({"EM6"})), Lines{});
}

TEST(PlanSchema, RefusesAMisspeltField) {
    EXPECT_EQ(errorsWith("/totals/cutting_sec", 3),
              Lines{"#/totals/cutting_sec: unknown field; \"cutting_s\" is the nearest known one"});
}

TEST(PlanSchema, ListsTheKnownFieldsWhenNoneIsNear) {
    EXPECT_EQ(errorsWith("/stepmill/built_on_monday", true),
              Lines{"#/stepmill/built_on_monday: unknown field; expected one of version"});
}

TEST(PlanSchema, RefusesEveryPlanThatLacksAField) {
    const json plan = minimalPlan();
    for (const auto& [name, value] : plan.items()) {
        json lacking = plan;
        lacking.erase(name);
        const Lines errors = schemaErrors(SchemaName::Plan, lacking.dump());
        ASSERT_EQ(errors.size(), 1U) << name;
        EXPECT_EQ(errors[0].rfind("#: expected the field \"" + name + "\"", 0), 0U) << errors[0];
    }
}

TEST(PlanSchema, RefusesEveryOperationThatLacksAField) {
    const json operation = minimalPlan()["operations"][0];
    for (const auto& [name, value] : operation.items()) {
        json lacking = operation;
        lacking.erase(name);
        const Lines errors = errorsWith("/operations/0", lacking);
        ASSERT_EQ(errors.size(), 1U) << name;
        EXPECT_EQ(errors[0].rfind("#/operations/0: expected the field \"" + name + "\"", 0), 0U) << errors[0];
    }
}

TEST(PlanSchema, RefusesEveryFeatureThatLacksAField) {
    const json feature = minimalPlan()["features"][0];
    for (const auto& [name, value] : feature.items()) {
        json lacking = feature;
        lacking.erase(name);
        const Lines errors = errorsWith("/features/0", lacking);
        ASSERT_EQ(errors.size(), 1U) << name;
        EXPECT_EQ(errors[0].rfind("#/features/0: expected the field \"" + name + "\"", 0), 0U) << errors[0];
    }
}

TEST(PlanSchema, RefusesEveryBandThatLacksAField) {
    const json band = minimalPlan()["features"][0]["bands"][0];
    for (const auto& [name, value] : band.items()) {
        json lacking = band;
        lacking.erase(name);
        const Lines errors = errorsWith("/features/0/bands/0", lacking);
        ASSERT_EQ(errors.size(), 1U) << name;
        EXPECT_EQ(errors[0].rfind("#/features/0/bands/0: expected the field \"" + name + "\"", 0), 0U)
            << errors[0];
    }
}

TEST(PlanSchema, RefusesAFeatureWithoutBands) {
    EXPECT_EQ(errorsWith("/features/0/bands", json::array()),
              Lines{"#/features/0/bands: expected a list of 1 to 9999 items, found a list of 0"});
}

TEST(PlanSchema, RefusesNanometresThatAreNotWhole) {
    EXPECT_EQ(
        errorsWith("/loops/0/1/0", 0.5),
        Lines{"#/loops/0/1/0: expected a whole number from -2000000000000 to 2000000000000, found 0.5"});
}

TEST(PlanSchema, RefusesASegmentOfOneNumber) {
    EXPECT_EQ(errorsWith("/loops/0/1", {5}),
              Lines{"#/loops/0/1: expected a list of 2 to 6 items, found a list of 1"});
}

TEST(PlanSchema, RefusesANumberThatBecameNull) {
    EXPECT_EQ(errorsWith("/operations/0/time_s", nullptr),
              Lines{"#/operations/0/time_s: expected a number from 0 to 1e+15, found null"});
}

TEST(PlanSchema, RefusesAnUnknownRole) {
    EXPECT_EQ(
        errorsWith("/operations/0/role", "polish"),
        Lines{
            "#/operations/0/role: expected one of \"face\", \"rough\", \"rest\", \"surrogate\", \"cleanup\", "
            "\"drill\", \"bore\", \"tap\", \"spot\", \"ream\", \"finish\", \"form\", found \"polish\""});
}

TEST(PlanSchema, RefusesATransformOfTwelveNumbers) {
    EXPECT_EQ(errorsWith("/setups/0/transform", json(std::vector<int>(12, 0))),
              Lines{"#/setups/0/transform: expected a list of 16 items, found a list of 12"});
}

TEST(PlanSchema, RefusesADigestThatIsNone) {
    EXPECT_EQ(errorsWith("/part/sha256", "12AB"),
              Lines{"#/part/sha256: expected a text like ^[0-9a-f]{64}$, found \"12AB\""});
}

TEST(PlanSchema, RefusesAFeatureIdWithoutItsSetup) {
    EXPECT_EQ(errorsWith("/setups/0/features/0", "F1"),
              Lines{"#/setups/0/features/0: expected a text like "
                    "^S[0-9]{1,4}\\.(F[0-9]{1,6}|G[0-9]{1,6}(\\.[0-9]{1,4}){1,2})$, found \"F1\""});
}

TEST(PlanSchema, TakesAnySurfaceKindButOnlyCounts) {
    EXPECT_EQ(errorsWith("/part/surfaces/bspline", 3), Lines{});
    EXPECT_EQ(errorsWith("/part/surfaces/bspline", 0.5),
              Lines{"#/part/surfaces/bspline: expected a whole number from 1 to 10000000, found 0.5"});
}

TEST(SchemaErrors, GiveOneLineForTextThatIsNotJson) {
    const Lines errors = schemaErrors(SchemaName::Machine, "{\n \"format\": 1,,\n}");
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].rfind("#: not JSON at line 2, column 14: ", 0), 0U) << errors[0];
}

TEST(SchemaErrors, CountColumnsInCharactersNotBytes) {
    const Lines errors = schemaErrors(SchemaName::Machine, "[\"\xC3\xA4\xC3\xB6\", x]");
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].rfind("#: not JSON at line 1, column 8: ", 0), 0U) << errors[0];
}

TEST(SchemaErrors, GiveOneLineForAWrongTopLevel) {
    EXPECT_EQ(schemaErrors(SchemaName::Tools, "[]"), Lines{"#: expected an object, found a list of 0"});
}

TEST(SchemaText, IsTheFileInTheSchemasFolder) {
    const std::filesystem::path folder = std::filesystem::path(STEPMILL_SOURCE_DIR) / "schemas";
    EXPECT_EQ(schemaText(SchemaName::Tools), readFile(folder / "tools.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Machine), readFile(folder / "machine.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Plan), readFile(folder / "plan.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Inspect), readFile(folder / "inspect.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Rank), readFile(folder / "rank.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Verify), readFile(folder / "verify.schema.json"));
    EXPECT_EQ(schemaText(SchemaName::Manifest), readFile(folder / "manifest.schema.json"));
}

}  // namespace
}  // namespace stepmill
