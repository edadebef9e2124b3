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

Region regionOf(const Json& plan, const Json& number) {
    Region region;
    for (const Json& loop : plan["regions"][number.get<std::size_t>()])
        region.loops.push_back(loopFromJson(plan["loops"][loop.get<std::size_t>()], "loop"));
    return region;
}

/// One more region for a member of the plan, of these loops: what else has the old one keeps it.
void setLoops(Json& plan, Json& number, const Json& loops) {
    Json region = Json::array();
    for (const Json& loop : loops) {
        region.push_back(plan["loops"].size());
        plan["loops"].push_back(loop);
    }
    number = plan["regions"].size();
    plan["regions"].push_back(region);
}

void setRegion(Json& plan, Json& number, const Region& region) {
    Json loops = Json::array();
    for (const Loop& loop : region.loops)
        loops.push_back(loopToJson(loop));
    setLoops(plan, number, loops);
}

/// Every point of a region moved.
void movePoints(Json& plan, Json& number, const std::function<Vec2(const Vec2& point)>& move) {
    Region region = regionOf(plan, number);
    for (Loop& loop : region.loops) {
        loop.start = snapToGrid(move(loop.start));
        for (Segment& segment : loop.segments) {
            segment.to = snapToGrid(move(segment.to));
            if (!segment.arc) continue;
            segment.arc->centre = snapToGrid(move(segment.arc->centre));
            segment.arc->radius_mm = snapToGrid((segment.to - segment.arc->centre).norm());
        }
    }
    setRegion(plan, number, region);
}

/// Grown or shrunk about its middle; written as the grid has it.
void scale(Json& plan, Json& number, double by) {
    const Box2 box = boundingBox(regionOf(plan, number));
    const Vec2 middle = (box.min() + box.max()) / 2;
    movePoints(plan, number, [&](const Vec2& point) { return Vec2(middle + by * (point - middle)); });
}

void scaleTarget(Json& plan, Json& band, double by) {
    scale(plan, band["target"], by);
    band["area_mm2"] = area(regionOf(plan, band["target"]));
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
        for (Json& band : feature["bands"])
            erase(band["parents"], of_feature);
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

/// A band as parents name it.
Json nameOf(const Json& feature) {
    return {{"feature", feature["id"]}, {"band", 1}};
}

Json& first(Json& plan, const char* list) {
    return plan[list][0];
}
Json& last(Json& plan, const char* list) {
    return plan[list].back();
}

/// The uppermost band of the first feature and the lowest of the last.
Json& firstBand(Json& plan) {
    return first(plan, "features")["bands"][0];
}
Json& lastBand(Json& plan) {
    return last(plan, "features")["bands"].back();
}

/// The feature's own heights follow its bands', so that nothing but the change itself is wrong.
void setHeights(Json& feature) {
    feature["top_z_mm"] = feature["bands"].front()["top_z_mm"];
    feature["floor_z_mm"] = feature["bands"].back()["floor_z_mm"];
    feature["depth_mm"] = feature["top_z_mm"].get<double>() - feature["floor_z_mm"].get<double>();
}

Json& lastObstacle(Json& plan) {
    return plan["obstacles"][lastBand(plan)["obstacles"].back().get<std::size_t>()];
}

/// Parts the band, at its middle, into two that are as before together.
void partBand(Json& feature, Json& plan) {
    Json upper = feature["bands"][0];
    Json lower = upper;
    const double middle_mm = (upper["top_z_mm"].get<double>() + upper["floor_z_mm"].get<double>()) / 2;
    upper["floor_z_mm"] = lower["top_z_mm"] = middle_mm;
    upper["volume_mm3"] = lower["volume_mm3"] = upper["volume_mm3"].get<double>() / 2;
    lower["band"] = feature["levels"] = 2;
    lower["parents"] = {nameOf(feature)};
    feature["bands"] = {upper, lower};
    for (Json& operation : plan["operations"])
        if (operation["feature"] == feature["id"]) operation["band"] = 2;
}

const std::vector<Weakening> kWeakenings{
    {"another format", [](Json& plan) { plan["format"] = 1; }},
    {"obstruction emptied", [](Json& plan) { setRegion(plan, firstBand(plan)["obstruction"], {}); }},
    {"last obstruction emptied", [](Json& plan) { setRegion(plan, lastBand(plan)["obstruction"], {}); }},
    {"obstruction a hundredth smaller",
     [](Json& plan) { scale(plan, firstBand(plan)["obstruction"], 0.99); }},
    {"obstruction smaller by 10 um", [](Json& plan) { scale(plan, lastBand(plan)["obstruction"], 0.9998); }},
    {"obstruction moved",
     [](Json& plan) {
         movePoints(plan, firstBand(plan)["obstruction"],
                    [](const Vec2& point) { return Vec2(point + Vec2(0.5, 0)); });
     }},
    {"obstruction turned over",
     [](Json& plan) {
         movePoints(plan, firstBand(plan)["obstruction"],
                    [](const Vec2& point) { return Vec2(-point.x(), point.y()); });
     }},
    {"obstruction that crosses itself",
     [](Json& plan) {
         setLoops(plan, firstBand(plan)["obstruction"],
                  Json::parse("[[[0,0],[4000000,4000000],[0,-4000000],[-4000000,4000000],[0,-4000000]]]"));
     }},
    {"obstruction left open",
     [](Json& plan) {
         setLoops(plan, firstBand(plan)["obstruction"],
                  Json::parse("[[[0,0],[4000000,0],[0,4000000],[-4000000,0],[0,-3000000]]]"));
     }},
    {"obstruction beyond all numbers", [](Json& plan) { plan["loops"][0][0][0] = 1e300; }},
    {"loop beyond a kilometre", [](Json& plan) { plan["loops"][0][0][0] = 1900000000000; }},
    {"obstruction that is none", [](Json& plan) { firstBand(plan)["obstruction"] = 9999; }},
    {"region of a loop that is none", [](Json& plan) { plan["regions"][0] = {9999}; }},
    {"region of a loop twice", [](Json& plan) { plan["regions"][0].push_back(plan["regions"][0][0]); }},
    {"regions all one",
     [](Json& plan) {
         for (Json& region : plan["regions"])
             region = plan["regions"][0];
     }},
    {"target emptied", [](Json& plan) { setRegion(plan, firstBand(plan)["target"], {}); }},
    {"target larger", [](Json& plan) { scaleTarget(plan, firstBand(plan), 1.01); }},
    {"target smaller", [](Json& plan) { scaleTarget(plan, firstBand(plan), 0.99); }},
    {"last target smaller", [](Json& plan) { scaleTarget(plan, lastBand(plan), 0.999); }},
    {"target of another area", [](Json& plan) { firstBand(plan)["area_mm2"] = 1; }},
    {"top raised",
     [](Json& plan) {
         firstBand(plan)["top_z_mm"] = 0.5;
         setHeights(first(plan, "features"));
     }},
    {"top of the whole raised", [](Json& plan) { first(plan, "features")["top_z_mm"] = 0.5; }},
    {"floor lowered",
     [](Json& plan) {
         Json& floor = firstBand(plan)["floor_z_mm"];
         floor = floor.get<double>() - 0.5;
         setHeights(first(plan, "features"));
     }},
    {"floor raised",
     [](Json& plan) {
         Json& floor = lastBand(plan)["floor_z_mm"];
         floor = floor.get<double>() + 0.01;
         setHeights(last(plan, "features"));
     }},
    {"floor over the top",
     [](Json& plan) {
         firstBand(plan)["floor_z_mm"] = 20;
         setHeights(first(plan, "features"));
     }},
    {"floor of the whole lowered",
     [](Json& plan) {
         Json& feature = first(plan, "features");
         feature["floor_z_mm"] = feature["floor_z_mm"].get<double>() - 0.5;
     }},
    {"feature in bands that it has not", [](Json& plan) { partBand(first(plan, "features"), plan); }},
    {"bands with a gap",
     [](Json& plan) {
         Json& feature = first(plan, "features");
         partBand(feature, plan);
         feature["bands"][1]["top_z_mm"] = feature["bands"][1]["top_z_mm"].get<double>() - 0.1;
     }},
    {"bands that wait for each other",
     [](Json& plan) {
         Json& feature = first(plan, "features");
         partBand(feature, plan);
         feature["bands"][0]["parents"] = {{{"feature", feature["id"]}, {"band", 2}}};
     }},
    {"feature without bands", [](Json& plan) { first(plan, "features")["bands"] = Json::array(); }},
    {"operation on a band that is none", [](Json& plan) { first(plan, "operations")["band"] = 2; }},
    {"volume of another feature", [](Json& plan) { first(plan, "features")["volume_mm3"] = 1e6; }},
    {"obstacles removed", [](Json& plan) { firstBand(plan)["obstacles"] = Json::array(); }},
    {"obstacles emptied",
     [](Json& plan) {
         for (Json& obstacle : plan["obstacles"])
             setRegion(plan, obstacle["section"], {});
     }},
    {"obstacles lowered",
     [](Json& plan) {
         Json& obstacle = lastObstacle(plan);
         obstacle["top_z_mm"] =
             (obstacle["top_z_mm"].get<double>() + obstacle["bottom_z_mm"].get<double>()) / 2;
     }},
    {"obstacle upside down", [](Json& plan) { lastObstacle(plan)["top_z_mm"] = -999; }},
    {"obstacle that is none", [](Json& plan) { firstBand(plan)["obstacles"].push_back(9999); }},
    {"class with a hole in the floor",
     [](Json& plan) {
         for (Json& feature : plan["features"])
             for (Json& band : feature["bands"])
                 if (band["class"].get<std::string>().find("through") == std::string::npos)
                     band["class"] = "through pocket";
     }},
    {"parent of another setup",
     [](Json& plan) { lastBand(plan)["parents"] = {nameOf(plan["features"][0])}; }},
    {"parent of its own", [](Json& plan) { firstBand(plan)["parents"] = {nameOf(plan["features"][0])}; }},
    {"first feature removed", [](Json& plan) { removeFeature(plan, plan["features"][0]["id"]); }},
    {"last feature removed", [](Json& plan) { removeFeature(plan, plan["features"].back()["id"]); }},
    {"feature twice", [](Json& plan) { plan["features"].push_back(plan["features"][0]); }},
    {"feature twice with nothing in the way",
     [](Json& plan) {
         Json copy = plan["features"][0];
         setRegion(plan, copy["bands"][0]["obstruction"], {});
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
    {"fixture smaller",
     [](Json& plan) { scale(plan, first(plan, "setups")["fixtures"][0]["section"], 0.9); }},
    {"a jaw that is said to be a clamp",
     [](Json& plan) { first(plan, "setups")["fixtures"][0]["kind"] = "clamp"; }},
    {"no way to hold it", [](Json& plan) { first(plan, "setups")["clamping"]["kind"] = "none"; }},
    {"no clamping", [](Json& plan) { first(plan, "setups").erase("clamping"); }},
    {"less grip", [](Json& plan) { first(plan, "setups")["clamping"]["depth_mm"] = 4.9; }},
    {"a vise that opens wider", [](Json& plan) { plan["request"]["vise"]["opening_mm"] = 900; }},
    {"a vise with less grip", [](Json& plan) { plan["request"]["vise"]["grip_mm"] = 1; }},
    {"a thicker plate", [](Json& plan) { plan["request"]["plate_mm"] = 90; }},
    {"held by other means", [](Json& plan) { plan["request"]["hold"] = "plate"; }},
    {"another blank", [](Json& plan) { plan["request"]["stock_sizes_mm"] = {45.0}; }},
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
         Json& band = lastBand(plan);
         band["residual"].push_back({{"region", band["target"]},
                                     {"area_mm2", band["area_mm2"]},
                                     {"volume_mm3", band["volume_mm3"]},
                                     {"reason", "holder collision"}});
     }},
    {"more stays than there is",
     [](Json& plan) {
         Json& band = lastBand(plan);
         band["residual"].push_back({{"region", band["target"]},
                                     {"area_mm2", band["area_mm2"]},
                                     {"volume_mm3", 1e9},
                                     {"reason", "holder collision"}});
     }},
    {"books that plan more",
     [](Json& plan) { first(plan, "setups")["volume_balance"]["planned_mm3"] = 1e9; }},
    {"books without what stays",
     [](Json& plan) {
         plan["volume_balance"]["residual_mm3"] = plan["volume_balance"]["residual_mm3"].get<double>() + 500;
     }},
    {"rapids that may go nearer to a raw side",
     [](Json& plan) { plan["machine"]["side_clearance_mm"] = 0.1; }},
    {"rapids that may go nearer to a raw top", [](Json& plan) { plan["machine"]["top_clearance_mm"] = 0.1; }},
    {"holders that may go nearer", [](Json& plan) { plan["machine"]["holder_clearance_mm"] = 0; }},
    {"a machine without spindle nose", [](Json& plan) { plan["machine"].erase("spindle_nose"); }},
    {"a spindle that comes down to the table",
     [](Json& plan) {
         plan["machine"]["gauge_over_table_mm"] = {0.1, 900};
     }},
    {"a machine that travels farther",
     [](Json& plan) {
         plan["machine"]["travel_mm"] = {9000, 9000, 9000};
     }},
    {"a quicker machine", [](Json& plan) { plan["machine"]["max_feed_mm_per_min"] = 99000; }},
    {"a number that is none", [](Json& plan) { firstBand(plan)["top_z_mm"] = nullptr; }},
    {"a number beyond all limits", [](Json& plan) { firstBand(plan)["top_z_mm"] = 1e308; }},
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

/// Takes each of these values for each number of the plan's.
void expectNoBug(const Json& original, const fs::path& job, const std::vector<double>& values) {
    std::vector<Json::json_pointer> places;
    collectNumbers(original, Json::json_pointer(), places);
    EXPECT_GT(places.size(), 100U);
    for (const Json::json_pointer& place : places) {
        for (const double value : values) {
            Json plan = original;
            plan[place] = value;
            std::ofstream(job / "plan.json", std::ios::binary) << plan.dump();
            const ProgramRun run = runProgram({stepmillBinary(), "verify", job.string()});
            EXPECT_GE(run.exit_code, 0) << place.to_string() << " = " << value;
            // A broken promise of ours names its line.
            EXPECT_EQ(run.err.find(".cpp:"), std::string::npos)
                << place.to_string() << " = " << value << run.err;
            EXPECT_LT(run.err.size(), 1000U) << place.to_string() << " = " << value;
        }
    }
}

TEST_P(WholePlan, EndsInNoBugWhateverItsNumbers) {
    expectNoBug(*plan_, job(), {0.0, -1.0, 1e-9, 1e308});
}

/// The rest of the values: a process each.
class OtherNumbers : public WholePlan {};

TEST_P(OtherNumbers, AreNoBugsEither) {
    expectNoBug(*plan_, job(), {1.0, 1e6, 1e12});
}

INSTANTIATE_TEST_SUITE_P(Slow, OtherNumbers, testing::Values(Weakening{"none", {}}));

}  // namespace
}  // namespace stepmill::test
