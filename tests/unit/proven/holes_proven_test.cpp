// Plans whose holes are spotted, reamed and bored, and proofs of their programs.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/units.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/verify/claim.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
const std::string kSource = STEPMILL_SOURCE_DIR;

/// The tool of the library under another name, as wide as said.
ToolAssembly asWide(const ToolLibrary& library, const std::string& like, const std::string& id, int number,
                    double diameter_mm, double shank_mm) {
    ToolAssembly tool = library.tool(like);
    tool.id = id;
    tool.number = number;
    tool.diameter_mm = diameter_mm;
    tool.shank.diameter_mm = shank_mm;
    return tool;
}

/// The sample library and what bores of 5 and 10 mm want.
ToolLibrary shopForHoles() {
    ToolLibrary library = readToolLibrary(kSource + "/samples/shop_for_holes_tools.json");
    const ToolLibrary& shop = library;
    const ToolAssembly reamer = asWide(shop, "RM8H7", "RM5", 51, 5.006, 4.6);
    const ToolAssembly drill = asWide(shop, "DR5", "DR4_8", 52, 4.8, 6);
    const ToolAssembly head = asWide(shop, "BH20", "BH10", 53, 10.006, 9);
    library.tools.insert(library.tools.end(), {reamer, drill, head});
    return library;
}

const Part& plate() {
    static const Part part = readStep(kSource + "/step_parts/plate_with_holes.step").front();
    return part;
}

HoleTable tableOf(const std::string& entries) {
    return holeTableFromText(R"({"format": 1, "unit": "mm", "holes": [)" + entries + "]}", "holes.json");
}

ProvenPlan planWith(const std::string& entries, const ToolLibrary& library, const std::string& dialect,
                    const Part& part = plate()) {
    Machine machine = defaultMachine();
    machine.dialect = dialect;
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = machine.safe_height_mm;
    request.holes = tableOf(entries);
    return planProven(part, request, library, machine, kTol);
}

const char* const kFits = R"({"diameter": {"min": 4.9, "max": 5.1}, "make": "ream", "fit": "H7"},
                             {"diameter": {"min": 9.9, "max": 10.1}, "make": "bore", "fit": "H7"})";

const ProvenPlan& fitted() {
    static const ProvenPlan proven = planWith(kFits, shopForHoles(), "linuxcnc");
    return proven;
}

int holesOf(const Plan& plan, Role role) {
    int holes = 0;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            if (operation.role == role) holes += operation.holes;
    return holes;
}

bool anySays(const std::vector<ProofFailure>& failures, const std::string& words) {
    return std::any_of(failures.begin(), failures.end(), [&](const ProofFailure& failure) {
        return failure.text.find(words) != std::string::npos;
    });
}

/// What the proof says of the files with one text in plan.json or the program changed.
std::vector<ProofFailure> failuresWith(const std::string& text, const std::string& other, bool in_plan) {
    PlanFiles files = fitted().files;
    std::string& changed = in_plan ? files.plan_json : files.programs.begin()->second.front().text;
    const std::size_t at = changed.find(text);
    EXPECT_NE(at, std::string::npos) << text;
    changed.replace(at, text.size(), other);
    return verifyPlan(files, kTol).failures;
}

/// What is said of the plan against part, library and a hole table.
std::vector<ProofFailure> claimedBy(const std::string& entries) {
    const PlanRecord record = planRecordFromText(fitted().files.plan_json, kTol);
    return compareWithPart(record, {plate(), shopForHoles(), {}, {}, tableOf(entries)}, kTol);
}

TEST(HolesProven, AreSpottedDrilledReamedAndBored) {
    EXPECT_TRUE(fitted().mayRun());
    EXPECT_EQ(holesOf(fitted().plan, Role::Ream), 6);
    EXPECT_EQ(holesOf(fitted().plan, Role::Bore), 4);
    EXPECT_EQ(holesOf(fitted().plan, Role::Spot), 16) << "those through the plate, and those that are reamed";
    EXPECT_EQ(fitted().plan.threads_missing, 0);
}

TEST(HolesProven, TheRingBelowAnInsertsLeadIsNamed) {
    double left_mm3 = 0;
    for (const PlannedFeature& planned : fitted().plan.setups.front().features)
        left_mm3 += residualVolumeMm3(planned.sequence);
    // Two blind holes of 10 mm, milled 9.9 wide, with a lead of 0.2 mm.
    EXPECT_NEAR(left_mm3, 2 * kPi / 4 * (100 - 9.9 * 9.9) * 0.2, 1e-3);
    EXPECT_FALSE(fitted().plan.complete(kTol));
}

TEST(HolesProven, WeakenedFilesAreFound) {
    EXPECT_TRUE(anySays(failuresWith("\"fit\": \"H7\"", "\"fit\": \"F7\"", true), "F7 of "));
    EXPECT_TRUE(anySays(failuresWith(" G98 G85 ", " G98 G81 ", false), "into the bore"));
}

TEST(HolesProven, FitsAreThoseOfTheHoleTable) {
    const std::string reamed = R"({"diameter": {"min": 4.9, "max": 5.1}, "make": "ream", "fit": "H7"})";
    const std::string bored = R"(, {"diameter": {"min": 9.9, "max": 10.1}, "make": "bore", "fit": "H7"})";
    for (const ProofFailure& failure : claimedBy(reamed + bored))
        ADD_FAILURE() << failure.operation << ": " << failure.text;
    const auto asked_no_more = claimedBy(reamed);
    EXPECT_TRUE(anySays(asked_no_more, "brings the hole to H7, which the hole table does not ask for"));
    std::string wider = reamed + bored;
    wider.replace(wider.rfind("H7"), 2, "H8");
    EXPECT_TRUE(anySays(claimedBy(wider), "brings the hole to H7, which the hole table does not ask for"));
}

TEST(HolesProven, EveryDialectIsProven) {
    for (const char* dialect : {"fanuc", "grbl"}) {
        const ProvenPlan proven = planWith(kFits, shopForHoles(), dialect);
        EXPECT_TRUE(proven.mayRun()) << dialect;
        EXPECT_EQ(holesOf(proven.plan, Role::Ream), 6) << dialect;
    }
}

TEST(HolesProven, AFitThatNoToolMakesIsMissing) {
    const ProvenPlan proven = planWith(
        R"({"diameter": {"min": 8.4, "max": 8.6}, "make": "ream", "fit": "H7"})", shopForHoles(), "linuxcnc");
    EXPECT_TRUE(proven.mayRun());
    EXPECT_EQ(proven.plan.threads_missing, 4);
    const auto told = std::find_if(proven.plan.warnings.begin(), proven.plan.warnings.end(),
                                   [](const Warning& warning) { return warning.code == "fit"; });
    ASSERT_NE(told, proven.plan.warnings.end());
    EXPECT_NE(told->text.find("4 holes are not brought to H7: "), std::string::npos) << told->text;
}

TEST(HolesProven, AFlatBlindHoleIsReamedAsFarAsADrillMakesItsWholeWidth) {
    Part block = test::part(test::cut(test::box(0, 0, 0, 60, 40, 30), test::cylinder(30, 20, 10, 4, 21)));
    block.file = "block.step";
    block.sha256 = std::string(64, '0');
    const ProvenPlan proven =
        planWith(R"({"diameter": {"min": 7.9, "max": 8.1}, "make": "ream", "fit": "H7"})", shopForHoles(),
                 "linuxcnc", block);
    EXPECT_TRUE(proven.mayRun());
    EXPECT_EQ(holesOf(proven.plan, Role::Ream), 1);
    EXPECT_TRUE(proven.plan.request.cautions.empty());
}

TEST(HolesProven, WithoutABoringHeadAMillTurnsTheBore) {
    const ProvenPlan proven =
        planWith(R"({"diameter": {"min": 9.9, "max": 10.1}, "make": "bore", "fit": "H7"})",
                 defaultToolLibrary(), "linuxcnc");
    EXPECT_TRUE(proven.mayRun());
    int finished = 0;
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const Operation& operation : setup.operations)
            if (operation.role == Role::Finish) ++finished;
    EXPECT_EQ(finished, 2);
    EXPECT_EQ(proven.plan.threads_missing, 0);
}

}  // namespace
}  // namespace stepmill
