// A plan.json that claims less than it should: each weakening is refused on reading or caught against the
// part and the library it was made from, with its place named.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "stepmill/planar/region_json.h"
#include "support/planned_parts.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kTools = kSource + "/samples/shop_metric_tools.json";

struct Weakening {
    std::string name;
    std::function<void(Json& plan)> edit;
};

void PrintTo(const Weakening& weakening, std::ostream* out) {
    *out << weakening.name;
}

/// Every point of a region moved.
void movePoints(Json& region, const std::function<void(Json& point)>& move) {
    for (Json& loop : region["loops"]) {
        move(loop["start"]);
        for (Json& segment : loop["segments"]) {
            move(segment["to"]);
            if (segment.contains("centre")) move(segment["centre"]);
            segment.erase("radius");
        }
    }
}

/// Grown or shrunk about its middle; written as the grid has it.
void scale(Json& region, double by) {
    const Box2 box = boundingBox(regionFromJson(region, "region"));
    const Vec2 middle = (box.min() + box.max()) / 2;
    movePoints(region, [&](Json& point) {
        for (int i = 0; i < 2; ++i)
            point[i] = std::round((middle[i] + by * (point[i].get<double>() - middle[i])) * 1e6) / 1e6;
    });
    region = regionToJson(regionFromJson(region, "region"));
}

void scaleTarget(Json& feature, double by) {
    scale(feature["target"], by);
    feature["area_mm2"] = area(regionFromJson(feature["target"], "target"));
}

void removeFeature(Json& plan, const std::string& id) {
    const auto of_feature = [&](const Json& entry) { return entry["feature"] == id; };
    std::set<std::string> gone;
    for (const Json& operation : plan["operations"])
        if (of_feature(operation)) gone.insert(operation["id"]);
    const auto erase = [](Json& list, const std::function<bool(const Json&)>& out) {
        Json kept = Json::array();
        for (const Json& entry : list)
            if (!out(entry)) kept.push_back(entry);
        list = kept;
    };
    erase(plan["operations"], of_feature);
    erase(plan["features"], [&](const Json& entry) { return entry["id"] == id; });
    for (Json& feature : plan["features"])
        erase(feature["parents"], [&](const Json& entry) { return entry == id; });
    for (Json& setup : plan["setups"]) {
        erase(setup["features"], [&](const Json& entry) { return entry == id; });
        erase(setup["operations"], [&](const Json& entry) { return gone.count(entry) > 0; });
    }
}

Json& toolOf(Json& plan, std::size_t operation) {
    for (Json& tool : plan["tools"])
        if (tool["id"] == plan["operations"][operation]["tool"]) return tool;
    return plan["tools"][0];
}

Json& first(Json& plan, const char* list) {
    return plan[list][0];
}
Json& last(Json& plan, const char* list) {
    return plan[list].back();
}

const std::vector<Weakening> kWeakenings{
    {"obstruction emptied",
     [](Json& plan) { first(plan, "features")["obstruction"]["loops"] = Json::array(); }},
    {"last obstruction emptied",
     [](Json& plan) { last(plan, "features")["obstruction"]["loops"] = Json::array(); }},
    {"obstruction a hundredth smaller",
     [](Json& plan) { scale(first(plan, "features")["obstruction"], 0.99); }},
    {"obstruction smaller by 10 um",
     [](Json& plan) { scale(last(plan, "features")["obstruction"], 0.9998); }},
    {"obstruction moved",
     [](Json& plan) {
         movePoints(first(plan, "features")["obstruction"],
                    [](Json& point) { point[0] = point[0].get<double>() + 0.5; });
     }},
    {"obstruction turned over",
     [](Json& plan) {
         movePoints(first(plan, "features")["obstruction"],
                    [](Json& point) { point[0] = -point[0].get<double>(); });
     }},
    {"obstruction that crosses itself",
     [](Json& plan) {
         first(plan, "features")["obstruction"] = Json::parse(
             R"({"loops": [{"hole": false, "start": [0, 0], "segments": [{"to": [4, 4]}, {"to": [4, 0]}, {"to": [0, 4]}, {"to": [0, 0]}]}]})");
     }},
    {"obstruction left open",
     [](Json& plan) {
         first(plan, "features")["obstruction"]["loops"][0]["segments"].back()["to"] = {1234.5, 6};
     }},
    {"obstruction beyond all numbers",
     [](Json& plan) {
         first(plan, "features")["obstruction"]["loops"][0]["start"] = {1e300, 0};
     }},
    {"target emptied", [](Json& plan) { first(plan, "features")["target"]["loops"] = Json::array(); }},
    {"target larger", [](Json& plan) { scaleTarget(first(plan, "features"), 1.01); }},
    {"target smaller", [](Json& plan) { scaleTarget(first(plan, "features"), 0.99); }},
    {"last target smaller", [](Json& plan) { scaleTarget(last(plan, "features"), 0.999); }},
    {"target of another area", [](Json& plan) { first(plan, "features")["area_mm2"] = 1; }},
    {"top raised", [](Json& plan) { first(plan, "features")["top_z_mm"] = 0.5; }},
    {"floor lowered",
     [](Json& plan) {
         Json& floor = first(plan, "features")["floor_z_mm"];
         floor = floor.get<double>() - 0.5;
     }},
    {"floor raised",
     [](Json& plan) {
         Json& floor = last(plan, "features")["floor_z_mm"];
         floor = floor.get<double>() + 0.01;
     }},
    {"floor over the top", [](Json& plan) { first(plan, "features")["floor_z_mm"] = 20; }},
    {"obstacles removed", [](Json& plan) { first(plan, "features")["obstacles"] = Json::array(); }},
    {"obstacles emptied",
     [](Json& plan) {
         for (Json& obstacle : first(plan, "features")["obstacles"])
             obstacle["section"]["loops"] = Json::array();
     }},
    {"obstacles lowered",
     [](Json& plan) {
         Json& obstacle = last(plan, "features")["obstacles"].back();
         obstacle["top_z_mm"] =
             (obstacle["top_z_mm"].get<double>() + obstacle["bottom_z_mm"].get<double>()) / 2;
     }},
    {"obstacle upside down",
     [](Json& plan) { last(plan, "features")["obstacles"].back()["top_z_mm"] = -999; }},
    {"class with a hole in the floor",
     [](Json& plan) {
         for (Json& feature : plan["features"])
             if (feature["class"].get<std::string>().find("through") == std::string::npos)
                 feature["class"] = "through pocket";
     }},
    {"parent of another setup",
     [](Json& plan) { last(plan, "features")["parents"] = {plan["features"][0]["id"]}; }},
    {"parent of its own",
     [](Json& plan) { first(plan, "features")["parents"] = {plan["features"][0]["id"]}; }},
    {"first feature removed", [](Json& plan) { removeFeature(plan, plan["features"][0]["id"]); }},
    {"last feature removed", [](Json& plan) { removeFeature(plan, plan["features"].back()["id"]); }},
    {"feature twice", [](Json& plan) { plan["features"].push_back(plan["features"][0]); }},
    {"feature twice with nothing in the way",
     [](Json& plan) {
         Json copy = plan["features"][0];
         copy["obstruction"]["loops"] = Json::array();
         plan["features"].push_back(copy);
     }},
    {"feature unlisted", [](Json& plan) { first(plan, "setups")["features"].erase(0); }},
    {"all setups removed",
     [](Json& plan) {
         for (const char* list : {"setups", "features", "operations", "tools"})
             plan[list] = Json::array();
     }},
    {"all setups removed, lists left", [](Json& plan) { plan["setups"] = Json::array(); }},
    {"last setup removed",
     [](Json& plan) {
         const Json ids = last(plan, "setups")["features"];
         for (const Json& id : ids)
             removeFeature(plan, id);
         plan["setups"].erase(plan["setups"].size() - 1);
     }},
    {"all operations removed",
     [](Json& plan) {
         plan["operations"] = Json::array();
         for (Json& setup : plan["setups"])
             setup["operations"] = Json::array();
     }},
    {"operation unlisted", [](Json& plan) { first(plan, "setups")["operations"].erase(0); }},
    {"operation listed twice",
     [](Json& plan) {
         Json& list = first(plan, "setups")["operations"];
         list.push_back(list[0]);
     }},
    {"operation twice", [](Json& plan) { plan["operations"].push_back(plan["operations"][0]); }},
    {"operation of another setup", [](Json& plan) { last(plan, "operations")["setup"] = "S1"; }},
    {"operation's floor raised",
     [](Json& plan) {
         Json& floor = last(plan, "operations")["z_floor_mm"];
         floor = floor.get<double>() + 0.3;
     }},
    {"operation of an unknown tool", [](Json& plan) { first(plan, "operations")["tool"] = "EM99"; }},
    {"tool narrower",
     [](Json& plan) {
         Json& tool = toolOf(plan, 0);
         tool["diameter_mm"] = tool["diameter_mm"].get<double>() - 0.2;
     }},
    {"tool wider",
     [](Json& plan) {
         Json& tool = toolOf(plan, 0);
         tool["diameter_mm"] = tool["diameter_mm"].get<double>() + 0.001;
     }},
    {"ball as it were",
     [](Json& plan) {
         Json& tool = toolOf(plan, 0);
         tool["type"] = "ball";
         tool["corner_radius_mm"] = tool["diameter_mm"].get<double>() / 2;
     }},
    {"ball without its radius", [](Json& plan) { toolOf(plan, 0)["type"] = "ball"; }},
    {"bull as it were",
     [](Json& plan) {
         toolOf(plan, 0)["type"] = "bull";
         toolOf(plan, 0)["corner_radius_mm"] = 0.5;
     }},
    {"corner on a flat cutter",
     [](Json& plan) {
         toolOf(plan, 0)["type"] = "flat";
         toolOf(plan, 0)["corner_radius_mm"] = 1;
     }},
    {"drill as it were", [](Json& plan) { toolOf(plan, 0)["type"] = "drill"; }},
    {"holder removed", [](Json& plan) { toolOf(plan, 0)["holder"] = Json::array(); }},
    {"holder thinner", [](Json& plan) { toolOf(plan, 0)["holder"][0]["diameter_mm"] = 8; }},
    {"holder upside down", [](Json& plan) { toolOf(plan, 0)["holder"][0]["top_mm"] = 0.5; }},
    {"shank thinner", [](Json& plan) { toolOf(plan, 0)["shank"]["diameter_mm"] = 1; }},
    {"stick-out longer",
     [](Json& plan) {
         Json& tool = toolOf(plan, 0);
         tool["stick_out_mm"] = tool["stick_out_mm"].get<double>() + 30;
         for (Json& cylinder : tool["holder"])
             for (const char* end : {"bottom_mm", "top_mm"})
                 cylinder[end] = cylinder[end].get<double>() + 30;
     }},
    {"flutes longer", [](Json& plan) { toolOf(plan, 0)["flute_length_mm"] = 60; }},
    {"tool renamed",
     [](Json& plan) {
         const std::string old = toolOf(plan, 0)["id"];
         toolOf(plan, 0)["id"] = "other";
         for (Json& operation : plan["operations"])
             if (operation["tool"] == old) operation["tool"] = "other";
     }},
    {"two tools of a number",
     [](Json& plan) {
         for (Json& tool : plan["tools"])
             tool["number"] = 5;
     }},
    {"tool number cut to 32 bits", [](Json& plan) { toolOf(plan, 0)["number"] = 4294967301; }},
    {"feed higher",
     [](Json& plan) {
         Json& feed = first(plan, "operations")["feed_mm_per_min"];
         feed = 1.5 * feed.get<double>();
     }},
    {"feed down higher", [](Json& plan) { first(plan, "operations")["plunge_feed_mm_per_min"] = 20000; }},
    {"speed higher",
     [](Json& plan) {
         for (Json& operation : plan["operations"])
             operation["speed_rpm"] = operation["speed_rpm"].get<double>() + 0.9;
     }},
    {"spindle stands", [](Json& plan) { first(plan, "operations")["speed_rpm"] = 0; }},
    {"step-down deeper", [](Json& plan) { first(plan, "operations")["step_down_mm"] = 500; }},
    {"coolant off", [](Json& plan) { first(plan, "operations")["coolant"] = "off"; }},
    {"other material", [](Json& plan) { plan["material"] = "unobtainium"; }},
    {"fixtures removed",
     [](Json& plan) {
         for (Json& setup : plan["setups"])
             setup["fixtures"] = Json::array();
     }},
    {"fixture lower",
     [](Json& plan) {
         for (Json& fixture : first(plan, "setups")["fixtures"])
             fixture["top_z_mm"] = fixture["top_z_mm"].get<double>() - 1;
     }},
    {"fixture smaller", [](Json& plan) { scale(first(plan, "setups")["fixtures"][0]["section"], 0.9); }},
    {"fixture file as it were",
     [](Json& plan) {
         plan["request"]["fixtures"] = {{"file", "clamps.json"}, {"sha256", std::string(64, 'a')}};
         for (Json& setup : plan["setups"])
             setup["fixtures"] = Json::array();
     }},
    {"axis turned over",
     [](Json& plan) {
         for (Json& value : first(plan, "setups")["axis"])
             value = -value.get<double>();
     }},
    {"transform moved",
     [](Json& plan) {
         Json& x = last(plan, "setups")["transform"][3];
         x = x.get<double>() + 0.1;
     }},
    {"stock smaller",
     [](Json& plan) {
         Json& size = first(plan, "setups")["stock"]["size_mm"][0];
         size = size.get<double>() - 5;
     }},
    {"stock lighter",
     [](Json& plan) {
         for (Json* volume : {&plan["stock"]["volume_mm3"], &plan["volume_balance"]["stock_minus_part_mm3"]})
             *volume = volume->get<double>() - 1000;
     }},
    {"part heavier",
     [](Json& plan) {
         Json& part = plan["part"]["volume_mm3"];
         Json& left = plan["volume_balance"]["stock_minus_part_mm3"];
         part = part.get<double>() + 1000;
         left = left.get<double>() - 1000;
     }},
    {"another part", [](Json& plan) { plan["part"]["sha256"] = std::string(64, '0'); }},
    {"another library", [](Json& plan) { plan["tool_library"]["sha256"] = std::string(64, '0'); }},
    {"no request", [](Json& plan) { plan.erase("request"); }},
    {"other margins",
     [](Json& plan) {
         plan["request"]["stock_margin_mm"] = {1, 0, 0};
     }},
    {"another solid", [](Json& plan) { plan["request"]["solid"] = 7; }},
    {"another unit", [](Json& plan) { plan["request"]["unit"] = "inch"; }},
    {"program of another setup", [](Json& plan) { first(plan, "setups")["program"] = "S9.ngc"; }},
    {"program elsewhere", [](Json& plan) { first(plan, "setups")["program"] = "../S1.ngc"; }},
    {"program with an end in its name",
     [](Json& plan) { first(plan, "setups")["program"] = std::string("S1.ngc\0.txt", 11); }},
    {"all of a feature named as standing",
     [](Json& plan) {
         Json& feature = last(plan, "features");
         feature["residual"].push_back({{"region", feature["target"]},
                                        {"area_mm2", feature["area_mm2"]},
                                        {"volume_mm3", feature["volume_mm3"]},
                                        {"reason", "holder collision"}});
     }},
    {"more stays than there is",
     [](Json& plan) {
         Json& feature = last(plan, "features");
         feature["residual"].push_back({{"region", feature["target"]},
                                        {"area_mm2", feature["area_mm2"]},
                                        {"volume_mm3", 1e9},
                                        {"reason", "holder collision"}});
     }},
    {"books that plan more",
     [](Json& plan) { first(plan, "setups")["volume_balance"]["planned_mm3"] = 1e9; }},
    {"books without what stays",
     [](Json& plan) {
         plan["volume_balance"]["residual_mm3"] = plan["volume_balance"]["residual_mm3"].get<double>() + 500;
     }},
    {"a number that is none", [](Json& plan) { first(plan, "features")["top_z_mm"] = nullptr; }},
    {"a number beyond all limits", [](Json& plan) { first(plan, "features")["top_z_mm"] = 1e308; }},
};

/// One plan, made once, and edits of it.
class WeakenedPlans : public testing::TestWithParam<Weakening> {
  protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        copyOfPlan(kPart, job());
        plan_ = new Json(Json::parse(readFile(job() / "plan.json")));
        // Who edits a plan writes its manifest anew.
        fs::remove(job() / "manifest.json");
    }

    static void TearDownTestSuite() {
        delete plan_;
        delete folder_;
    }

    static fs::path job() { return fs::path(folder_->path()) / "job"; }

    static ProgramRun verify(const Json& plan) {
        std::ofstream(job() / "plan.json", std::ios::binary) << plan.dump();
        return runProgram({stepmillBinary(), "verify", job().string(), "--part", kPart, "--tools", kTools});
    }

    static inline const std::string kPart = kSource + "/step_parts/four_setups.step";
    static inline TemporaryFolder* folder_ = nullptr;
    static inline const Json* plan_ = nullptr;
};

TEST_P(WeakenedPlans, AreRefusedOrCaught) {
    Json weak = *plan_;
    GetParam().edit(weak);
    ASSERT_NE(weak, *plan_) << "nothing was weakened";
    const ProgramRun run = verify(weak);
    EXPECT_GT(run.exit_code, 1) << run.exit_code << "\n" << run.out;
    EXPECT_NE(run.out + run.err, "");
}

INSTANTIATE_TEST_SUITE_P(All, WeakenedPlans, testing::ValuesIn(kWeakenings));

class WholePlan : public WeakenedPlans {};

TEST_P(WholePlan, IsProvenAgainstPartAndLibrary) {
    const ProgramRun run = verify(*plan_);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

INSTANTIATE_TEST_SUITE_P(One, WholePlan, testing::Values(Weakening{"none", {}}));

/// One number for every field that the format has, by its place; the first of each list stands for all.
void collectNumbers(const Json& value, const Json::json_pointer& place,
                    std::vector<Json::json_pointer>& places) {
    if (value.is_number()) places.push_back(place);
    if (value.is_object())
        for (const auto& [name, item] : value.items())
            collectNumbers(item, place / name, places);
    if (value.is_array() && !value.empty()) collectNumbers(value[0], place / std::size_t{0}, places);
}

TEST_P(WholePlan, EndsInNoBugWhateverItsNumbers) {
    std::vector<Json::json_pointer> places;
    collectNumbers(*plan_, Json::json_pointer(), places);
    EXPECT_GT(places.size(), 100U);
    for (const Json::json_pointer& place : places) {
        for (const double value : {0.0, -1.0, 1.0, 1e-9, 1e6, 1e12, 1e308}) {
            Json plan = *plan_;
            plan[place] = value;
            std::ofstream(job() / "plan.json", std::ios::binary) << plan.dump();
            const ProgramRun run = runProgram({stepmillBinary(), "verify", job().string()});
            EXPECT_GE(run.exit_code, 0) << place.to_string() << " = " << value;
            // A broken promise of ours names its line.
            EXPECT_EQ(run.err.find(".cpp:"), std::string::npos)
                << place.to_string() << " = " << value << run.err;
            EXPECT_LT(run.err.size(), 1000U) << place.to_string() << " = " << value;
        }
    }
}

}  // namespace
}  // namespace stepmill::test
