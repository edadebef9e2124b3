// `stepmill quote` of a part and of a folder.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/page_check.h"
#include "support/run_program.h"
#include "support/text_file.h"
#include "support/told.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kParts = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/";

class Quotes : public testing::Test {
  protected:
    static ProgramRun quote(Words more) {
        more.insert(more.begin(), {stepmillBinary(), "quote"});
        return runProgram(more);
    }

    TemporaryFolder folder_;
    fs::path out_ = fs::path(folder_.path()) / "out";
};

TEST_F(Quotes, APartsQuoteIsPrintedAndWrittenInEveryForm) {
    const ProgramRun run =
        quote({kParts + "rounded_pocket.step", "--quantity", "1,10,100", "-o", out_.string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(tells(run.out, {"setting up 20.0 min", "1 clamping"}));
    EXPECT_TRUE(tells(run.out, {"not in it", "stock material"}));
    const Json json = Json::parse(slurp(out_ / "quote.json"));
    ASSERT_EQ(json.at("lots").size(), 3U);
    EXPECT_EQ(json.at("lots")[2].at("quantity"), 100);
    EXPECT_EQ(json.at("costly").size(), 1U);
    const std::string table = slurp(out_ / "quote.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
    expectSoundPage(slurp(out_ / "quote.html"), "quote.html");
}

TEST_F(Quotes, TermsChangeThePrice) {
    const auto once = [](const Words& more) {
        Words words{kParts + "shoulder_block.step", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        return Json::parse(quote(words).out).at("once").get<double>();
    };
    EXPECT_GT(once({"--setup-min", "60"}), once({}));
    EXPECT_EQ(once({"--setup-min", "0", "--programming-min", "0"}), 0);
    EXPECT_EQ(quote({kParts + "shoulder_block.step", "--quantity", "0"}).exit_code, 2);
    EXPECT_EQ(quote({kParts + "shoulder_block.step", "--quantity", "1,many"}).exit_code, 2);
}

TEST_F(Quotes, AFolderHasOneTableAndNamesWhatHasNoPlan) {
    const fs::path parts = fs::path(folder_.path()) / "parts";
    fs::create_directories(parts / "a");
    fs::copy_file(kParts + "shoulder_block.step", parts / "a" / "x.step");
    fs::copy_file(kParts + "open_slots.step", parts / "x.step");
    std::ofstream(parts / "noise.step") << "no STEP";
    const ProgramRun run = quote({parts.string(), "--quantity", "5,50", "-o", out_.string()});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(tells(run.err, {"noise.step"}));
    const std::string table = slurp(out_ / "quotes.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5) << table;
    EXPECT_EQ(quote({parts.string()}).exit_code, 2) << "a folder of quotes needs one to write to";
}

}  // namespace
}  // namespace stepmill::test
