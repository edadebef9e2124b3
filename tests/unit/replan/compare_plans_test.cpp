// A plate and its revisions, planned after each other.

#include <cmath>
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/file.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/replan/plan_change.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

std::string plateText() {
    return readFile(fs::path(STEPMILL_SOURCE_DIR) / "step_parts/plate_with_holes.step");
}

/// The STEP text with all points of the upright hole moved along x.
std::string withHoleMoved(const std::string& text, const Vec2& centre, double radius_mm, double by_mm) {
    static const std::regex kPoint(R"((CARTESIAN_POINT\('',\()([-0-9.Ee]+),([-0-9.Ee]+),([-0-9.Ee]+)\))");
    std::string moved;
    std::size_t end = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), kPoint), none; it != none; ++it) {
        const Vec2 at(std::stod((*it)[2]), std::stod((*it)[3]));
        const bool of_hole = (at - centre).norm() <= radius_mm + 0.01;
        moved += text.substr(end, it->position() - end);
        moved += of_hole ? (*it)[1].str() + std::to_string(at.x() + by_mm) + "," + (*it)[3].str() + "," +
                               (*it)[4].str() + ")"
                         : it->str();
        end = it->position() + it->length();
    }
    return moved + text.substr(end);
}

Part partOf(const std::string& text) {
    const fs::path file = fs::temp_directory_path() / ("replan_" + sha256(text) + ".step");
    writeFile(file, text);
    Part part = readStep(file).front();
    fs::remove(file);
    part.file = "plate.step";  // programs name it
    return part;
}

RecordedPlan planOf(const std::string& text, const std::vector<EarlierSetup>& earlier = {}) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    request.sequence.cut_material = *defaultMaterials().find("aluminium");
    request.earlier = earlier;
    const ProvenPlan proven =
        planProven(partOf(text), request, defaultToolLibrary(), defaultMachine(), Tolerances());
    EXPECT_TRUE(proven.mayRun());
    return {proven.files, planRecordFromText(proven.files.plan_json, Tolerances())};
}

const RecordedPlan& platePlan() {
    static const RecordedPlan plan = planOf(plateText());
    return plan;
}

RecordedPlan after(const RecordedPlan& before, const std::string& text) {
    return planOf(text, earlierSetups(before.record));
}

const Vec2 kBlindHole(110, 32);
constexpr double kBlindRadius = 5;
constexpr double kMoved = 4;

const FeatureChange& featureOf(const PlanChange& change, const std::string& id) {
    return *std::find_if(change.features.begin(), change.features.end(),
                         [&](const FeatureChange& one) { return one.id == id; });
}

TEST(ComparePlans, FindTheSameBytesWhereNothingChanged) {
    const RecordedPlan again = after(platePlan(), plateText());
    EXPECT_EQ(again.files.plan_json, platePlan().files.plan_json);
    const PlanChange change = comparePlans(platePlan(), again, Tolerances());
    EXPECT_TRUE(change.sameMachining());
    EXPECT_TRUE(change.inputs.empty());
    for (const ProgramChange& program : change.programs)
        EXPECT_TRUE(program.same_bytes);
    for (const FeatureChange& feature : change.features)
        EXPECT_EQ(feature.change, Change::Kept) << feature.id;
    for (const OperationChange& operation : change.operations)
        EXPECT_EQ(operation.lines_kept, static_cast<int>(operation.after->lines.size())) << operation.id;
}

TEST(ComparePlans, KeepAllButAHoleThatMoved) {
    const RecordedPlan revised =
        after(platePlan(), withHoleMoved(plateText(), kBlindHole, kBlindRadius, kMoved));
    const PlanChange change = comparePlans(platePlan(), revised, Tolerances());
    EXPECT_FALSE(change.sameMachining());
    int changed = 0;
    for (const FeatureChange& feature : change.features) {
        ASSERT_TRUE(feature.before && feature.after) << feature.id;
        if (feature.more_mm2 > 0) {
            ++changed;
            EXPECT_EQ(feature.change, Change::Changed) << feature.id;
            EXPECT_EQ(feature.causes.front(), ChangeCause::Ground) << feature.id;
            EXPECT_NEAR(feature.more_mm2, feature.less_mm2, 1e-3);
        } else {
            EXPECT_EQ(feature.change, Change::Kept) << feature.id;
        }
    }
    EXPECT_EQ(changed, 1);
    int last = 0;
    for (const OperationChange& operation : change.operations) {
        ASSERT_TRUE(operation.before && operation.after) << operation.id;
        if (featureOf(change, operation.feature_id).more_mm2 == 0) {
            EXPECT_EQ(operation.change, Change::Kept) << operation.id;
        }
        EXPECT_EQ(operation.before->number, operation.after->number) << operation.id;
        if (operation.setup_id != "S1") continue;
        EXPECT_LT(last, operation.before->place) << operation.id;
        last = operation.before->place;
    }
}

TEST(ComparePlans, NameInputsThatAreOthers) {
    RecordedPlan other = platePlan();
    other.record.material = "steel";
    other.record.library.sha256 = std::string(64, '0');
    other.record.machine.hourly_rate += 1;
    const PlanChange change = comparePlans(platePlan(), other, Tolerances());
    std::vector<std::string> what;
    for (const InputChange& input : change.inputs)
        what.push_back(input.what);
    EXPECT_EQ(what, (std::vector<std::string>{"tool library", "machine /hourly_rate", "material"}));
}

}  // namespace
}  // namespace stepmill
