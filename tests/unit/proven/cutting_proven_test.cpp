// Plans whose feeds follow what is cut, and proofs of that.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>
#include <sstream>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/record/plan_json.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

PlanRequest requestFor(const char* material) {
    PlanRequest request;
    request.sequence.material = material;
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    request.sequence.cut_material = *defaultMaterials().find(material);
    return request;
}

ProvenPlan planOf(const PlanRequest& request, const char* sample = "rounded_pocket") {
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + sample + ".step").front();
    return planProven(part, request, defaultToolLibrary(), defaultMachine(), Tolerances());
}

const ProvenPlan& inAluminium() {
    static const ProvenPlan proven = planOf(requestFor("aluminium"));
    return proven;
}

/// The program with the feed on one line made higher by that factor.
/// \param index  of the lines with a feed
PlanFiles withFaster(PlanFiles files, double factor, const std::function<bool(double)>& which) {
    std::string& text = files.programs.begin()->second.front().text;
    static const std::regex kFeed("F([0-9.]+)");
    std::istringstream lines(text);
    std::string changed;
    bool done = false;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!done && line.rfind("N", 0) == 0 && std::regex_search(line, found, kFeed) &&
            which(std::stod(found[1].str()))) {
            line = std::regex_replace(line, kFeed, "F" + std::to_string(factor * std::stod(found[1].str())));
            done = true;
        }
        changed += line + "\n";
    }
    text = changed;
    return files;
}

TEST(CuttingPlan, IsProvenAndSaysWhatItsCutsAskFor) {
    const ProvenPlan& proven = inAluminium();
    ASSERT_TRUE(proven.verification.proven()) << proven.verification.failures.front().text;
    const Json plan = Json::parse(proven.files.plan_json);
    EXPECT_EQ(plan["cut_material"]["name"], "aluminium 6061");
    EXPECT_EQ(plan["machine"]["spindle"]["curve"].size(), 2U);
    for (const Json& operation : plan["operations"]) {
        if (operation["role"] == "drill" || operation["role"] == "finish") continue;
        ASSERT_TRUE(operation.contains("rating")) << operation["id"];
        EXPECT_GT(operation["cuts"]["peak_kw"], 0);
        EXPECT_LE(operation["cuts"]["peak_kw"], 11);
        double sum = 0;
        for (const Json& share : operation["cuts"]["length_shares"])
            sum += share.get<double>();
        EXPECT_NEAR(sum, 1, 1e-4);
    }
}

TEST(CuttingPlan, IsProvenInSteel) {
    const ProvenPlan proven = planOf(requestFor("steel"));
    EXPECT_TRUE(proven.verification.proven());
}

// Its pocket's corners are as round as the cutter: the strip lies all before the front there.
TEST(CuttingPlan, SlowsAFinishingPassWhereItTurnsInACornerOfItsOwnRadius) {
    PlanRequest request = requestFor("aluminium");
    request.sequence.finish.walls_mm = 0.3;
    const ProvenPlan proven = planOf(request);
    ASSERT_TRUE(proven.verification.proven()) << proven.verification.failures.front().text;
    const Operation& walls = proven.plan.setups.front().operations.back();
    ASSERT_EQ(walls.role, Role::Finish);
    double slow_mm = 0;
    double full_mm = 0;
    int slow = 0;
    Vec3 from = walls.path.start;
    for (const Move& move : walls.path.moves) {
        const double feed = walls.path.feedOf(move);
        EXPECT_LE(feed, walls.path.feed_mm_per_min);
        if (move.kind == MoveKind::Feed && !move.arc) {
            const bool slows = feed < 0.7 * walls.path.feed_mm_per_min;
            (slows ? slow_mm : full_mm) += (move.to - from).norm();
            slow += slows ? 1 : 0;
        }
        from = move.to;
    }
    EXPECT_EQ(slow, 4) << "one before every corner";
    EXPECT_LT(slow_mm, 8);
    EXPECT_GT(full_mm, 150);
}

// From inside out the quickest pattern at the library's feeds begins with a slot to the bosses.
TEST(CuttingPlan, CutsAnOpenFaceFromOutsideIn) {
    const ProvenPlan proven = planOf(requestFor("aluminium"), "bossed_pocket");
    ASSERT_TRUE(proven.verification.proven()) << proven.verification.failures.front().text;
    const Operation& face = proven.plan.setups.front().operations.front();
    EXPECT_EQ(face.path.pattern, toString(Pattern::StockOffset));
    EXPECT_LT(face.cuts.length_shares.back(), 0.06) << "in full width";
    ASSERT_GT(face.path.as_fed.size(), 1u);
    EXPECT_EQ(face.path.as_fed.front().pattern, face.path.pattern);
    for (const FedPattern& other : face.path.as_fed)
        EXPECT_GE(other.time_s, face.path.as_fed.front().time_s) << other.pattern;
    // What it was chosen by is what it takes.
    EXPECT_NEAR(face.path.as_fed.front().time_s, face.path.totals.motion_time_s,
                0.02 * face.path.totals.motion_time_s);
}

TEST(CuttingPlan, KeepsTheLibrarysFeedsWithoutASpindle) {
    Machine machine = defaultMachine();
    machine.spindle_curve.clear();
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/rounded_pocket.step").front();
    const Plan plan = planPart(part, requestFor("aluminium"), defaultToolLibrary(), machine, Tolerances());
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations) {
            EXPECT_FALSE(operation.rating);
            for (const Move& move : operation.path.moves)
                EXPECT_TRUE(move.feed_mm_per_min == 0 || isGlide(move));
        }
}

TEST(CuttingProof, FindsASlotThatIsFedTooFast) {
    const ProvenPlan& proven = inAluminium();
    double feed = 0;
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const Operation& operation : setup.operations)
            if (operation.rating) feed = std::max(feed, operation.path.feed_mm_per_min);
    const PlanFiles spoilt =
        withFaster(proven.files, 1.1, [&](double found) { return found > 0.3 * feed && found < 0.7 * feed; });
    const Verification verification = verifyPlan(spoilt, Tolerances());
    ASSERT_FALSE(verification.proven());
    EXPECT_NE(verification.failures.front().text.find("are allowed"), std::string::npos)
        << verification.failures.front().text;
    EXPECT_GT(verification.failures.front().line, 0);
}

TEST(CuttingProof, FindsAPlungeIntoMaterialThatIsFedTooFast) {
    // Its holes are plunged into, depth by depth, and that is the one cutter with this feed down.
    const char* plunge = "F485.00";
    PlanFiles spoilt = planOf(requestFor("aluminium"), "plate_with_holes").files;
    std::string& text = spoilt.programs.begin()->second.front().text;
    ASSERT_NE(text.find(plunge), std::string::npos);
    text = std::regex_replace(text, std::regex(plunge), "F970.00");
    const Verification verification = verifyPlan(spoilt, Tolerances());
    ASSERT_FALSE(verification.proven());
    EXPECT_EQ(verification.failures.front().text, "a rapid meets material that is still there");
}

TEST(CuttingProof, TakesLowerFeeds) {
    const PlanFiles slower = withFaster(inAluminium().files, 0.8, [](double) { return true; });
    EXPECT_TRUE(verifyPlan(slower, Tolerances()).proven());
}

TEST(CuttingProof, RefusesARatingWithoutForces) {
    PlanFiles files = inAluminium().files;
    Json plan = Json::parse(files.plan_json);
    plan.erase("cut_material");
    files.plan_json = plan.dump();
    EXPECT_THROW(verifyPlan(files, Tolerances()), Error);
}

}  // namespace
}  // namespace stepmill
