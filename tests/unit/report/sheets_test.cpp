// Setup sheets of a planned part.

#include <gtest/gtest.h>

#include "report/sheets/sheet_sections.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/report/sheets.h"
#include "support/page_check.h"

namespace stepmill {
namespace {

using test::expectSoundPage;
using test::readPage;

const ProvenPlan& provenShoulder() {
    static const ProvenPlan proven = [] {
        PlanRequest request;
        request.setup.stock_tolerance_mm = 0.5;
        request.sequence.material = "aluminium";
        request.sequence.retract_mm = defaultMachine().safe_height_mm;
        const std::string file = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/shoulder_block.step";
        Plan plan =
            planPart(readStep(file).front(), request, defaultToolLibrary(), defaultMachine(), Tolerances());
        PlanFiles files = postedFiles(plan);
        return ProvenPlan{std::move(plan), std::move(files), {}};
    }();
    return proven;
}

std::string sheetsWith(const SheetOptions& options) {
    return sheetsHtml(provenShoulder(), options, Tolerances());
}

std::string textOf(const std::string& page) {
    return readPage(page).text;
}

TEST(Sheets, AreASoundPageThatIsTheSameEveryTime) {
    const std::string page = sheetsWith({});
    expectSoundPage(page, "sheets.html");
    EXPECT_EQ(page, sheetsWith({}));
}

TEST(Sheets, ShowEveryOperationWithItsBlockOfTheProgram) {
    const std::string text = textOf(sheetsWith({}));
    const auto& programs = provenShoulder().files.programs;
    const PostedProgram& program = programs.begin()->second.front();
    for (const Operation& operation : provenShoulder().plan.setups.front().operations) {
        // "(From N14 S1.O2)" in the program's head.
        const std::size_t at = program.text.find(" " + operation.id + ")");
        ASSERT_NE(at, std::string::npos) << operation.id;
        const std::size_t from = program.text.rfind(' ', at - 1) + 1;
        const std::string number = program.text.substr(from, at - from);
        EXPECT_NE(text.find(number), std::string::npos) << number;
    }
}

TEST(Sheets, SayWhatTheShopSaysAndLeaveALineForTheRest) {
    SheetOptions options;
    options.job.customer = "Example Ltd";
    options.job.quantity = 25;
    const std::string page = sheetsWith(options);
    EXPECT_NE(textOf(page).find("Example Ltd"), std::string::npos);
    const std::string blank = "class=\"blank\"";
    EXPECT_NE(page.find(blank), std::string::npos);
    EXPECT_GT(sheetsWith({}).find(blank), 0u);
}

TEST(Sheets, TellHowMuchLargerTheBlankMayBe) {
    const std::string text = textOf(sheetsWith({}));
    EXPECT_NE(text.find("X and Y up to 1.00 mm larger, Z up to 0.50 mm"), std::string::npos) << text;
    EXPECT_NE(text.find("at most 0.50 mm a side"), std::string::npos) << text;
}

TEST(Sheets, HaveInchesWhereTheShopDoes) {
    SheetOptions options;
    options.inch = true;
    const std::string text = textOf(sheetsWith(options));
    EXPECT_NE(text.find("X and Y up to 0.039 in larger, Z up to 0.020 in"), std::string::npos) << text;
    EXPECT_EQ(text.find("step-over mm"), std::string::npos);
    EXPECT_NE(text.find("step-over in"), std::string::npos);
}

TEST(Sheets, WithoutAProofWarnOfDangerAndNameNoProgram) {
    ProvenPlan failed = provenShoulder();
    failed.verification.failures.push_back({"S1.ngc", 1, "S1.O1", "cuts too deep"});
    const std::string page = sheetsHtml(failed, {}, Tolerances());
    EXPECT_NE(page.find("squawk danger"), std::string::npos);
    EXPECT_EQ(page.find("S1.ngc"), std::string::npos);
}

TEST(Sheets, AreOfSetupsInWhichSomethingIsCut) {
    ProvenPlan idle = provenShoulder();
    PlannedSetup& second = idle.plan.setups.emplace_back(idle.plan.setups.front());
    second.setup.id = "S2";
    second.operations.clear();
    idle.plan.warnings = {{"residual", "S2.F1", "something stays", 1}};
    const std::string text = textOf(sheetsHtml(idle, {}, Tolerances()));
    EXPECT_NE(text.find("Setup S1 of 2"), std::string::npos);
    EXPECT_EQ(text.find("Setup S2"), std::string::npos);
    EXPECT_NE(text.find("S2: nothing can be cut from there"), std::string::npos);
    EXPECT_NE(text.find("something stays"), std::string::npos);
}

TEST(Sheets, GradeWarningsByWhatComesOfThem) {
    ProvenPlan warned = provenShoulder();
    warned.plan.warnings = {{"residual", "S1.F1", "something stays", 1}, {"travel", "S1", "too small", 1}};
    const std::string page = sheetsHtml(warned, {}, Tolerances());
    const std::size_t danger = page.find("squawk danger");
    const std::size_t caution = page.find("squawk caution");
    ASSERT_NE(caution, std::string::npos);
    EXPECT_LT(danger, caution);
}

TEST(Sheets, NamesThatTryToSteerThePageAreText) {
    for (const std::string& name :
         {std::string("</title><script>alert(1)</script>\" ' & \x1b \xff"), std::string(300, 'W'),
          std::string("\xe2\x80\xae gnp.exe \xe2\x81\xa6")}) {
        SheetOptions options;
        options.job.part = options.job.customer = options.job.document = name;
        options.job.notes = {name};
        expectSoundPage(sheetsWith(options), name);
    }
}

TEST(Measures, GiveInchesOneMoreDecimal) {
    using report::Measures;
    EXPECT_EQ(Measures(false).length(12.5), "12.50 mm");
    EXPECT_EQ(Measures(true).length(12.7), "0.500 in");
    EXPECT_EQ(Measures(true).feed(254), "10.0");
    EXPECT_EQ(Measures(false).number(-0.001), "0.00");
    EXPECT_EQ(Measures(false).number(-10), "-10.00");
}

}  // namespace
}  // namespace stepmill
