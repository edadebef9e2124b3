// What is known of parts, written down by people who looked at them, against what inspect says.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kSource = STEPMILL_SOURCE_DIR;
/// Diameters in facts files are rounded to this [mm].
constexpr double kDiameterMm = 5e-3;
/// algorithms.md, section 2.
constexpr double kBooksShare = 1e-3;

std::vector<fs::path> factsFiles() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kSource / "tests/corpus/facts"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// "step_parts/..." lies in the checkout, everything else among the shared parts.
fs::path pathOf(const std::string& part) {
    return part.rfind("step_parts/", 0) == 0 ? kSource / part : kSource / "../shared/parts" / part;
}

std::map<std::string, int> featuresByClass(const Json& inspection) {
    std::map<std::string, int> counts;
    for (const Json& setup : inspection.at("setups"))
        for (const Json& feature : setup.at("features"))
            ++counts[feature.at("class").get<std::string>()];
    return counts;
}

int countHoles(const Json& inspection, const std::string& name, double diameter_mm) {
    int count = 0;
    for (const Json& hole : inspection.at("holes"))
        if (hole.at("class") == name &&
            std::abs(hole.at("diameter_mm").get<double>() - diameter_mm) <= kDiameterMm)
            ++count;
    return count;
}

void check(const Json& facts, const Json& inspection) {
    EXPECT_EQ(inspection.at("setups").size(), facts.at("setups").get<std::size_t>());
    EXPECT_EQ(featuresByClass(inspection), (facts.at("features").get<std::map<std::string, int>>()));
    std::size_t holes = 0;
    for (const Json& hole : facts.at("holes")) {
        const int count = hole.at("count");
        holes += static_cast<std::size_t>(count);
        EXPECT_EQ(countHoles(inspection, hole.at("class"), hole.at("diameter_mm")), count) << hole;
    }
    EXPECT_EQ(inspection.at("holes").size(), holes);
    EXPECT_LE(inspection.at("books").at("gap_share").get<double>(), kBooksShare);
}

TEST(InspectParts, SayWhatTheirFactsFilesSay) {
    int seen = 0;
    for (const fs::path& file : factsFiles()) {
        SCOPED_TRACE(file.filename().string());
        std::ifstream stream(file);
        const Json facts = Json::parse(stream);
        const fs::path part = pathOf(facts.at("part"));
        if (!fs::exists(part)) continue;
        ++seen;
        std::vector<std::string> arguments{stepmillBinary(), "inspect", part.string(), "--json"};
        for (const Json& option : facts.value("options", Json::array()))
            arguments.push_back(option.get<std::string>());
        if (facts.contains("stock")) {
            arguments.push_back("--stock");
            arguments.push_back(pathOf(facts.at("stock")).string());
        }
        const ProgramRun run = runProgram(arguments);
        fmt::print("{:<34} exit {} {:>6.2f} s\n", file.stem().string(), run.exit_code, run.seconds);
        ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 1) << run.err;
        check(facts, Json::parse(run.out));
    }
    EXPECT_GT(seen, 0);
}

TEST(InspectParts, NothingIsWrittenUnlessAskedForAndPagesAreWhole) {
    const TemporaryFolder folder;
    const fs::path out = fs::path(folder.path()) / "pages";
    const std::string part = (kSource / "step_parts/plate_with_holes.step").string();
    const ProgramRun quiet = runProgram({stepmillBinary(), "inspect", part});
    EXPECT_LE(quiet.exit_code, 1) << quiet.err;
    EXPECT_NE(quiet.out.find("Holes"), std::string::npos);
    EXPECT_FALSE(fs::exists("plate_with_holes-curves"));
    const ProgramRun run = runProgram({stepmillBinary(), "inspect", part, "-o", out.string()});
    EXPECT_LE(run.exit_code, 1) << run.err;
    EXPECT_TRUE(fs::exists(out / "inspect.json"));
    std::ifstream page(out / "inspect.html");
    const std::string html((std::istreambuf_iterator<char>(page)), std::istreambuf_iterator<char>());
    EXPECT_NE(html.find("shade tint"), std::string::npos);
    EXPECT_NE(html.find("</html>"), std::string::npos);
}

TEST(InspectParts, TwoRunsGiveTheSameBytes) {
    const std::string part = (kSource / "step_parts/four_setups.step").string();
    const ProgramRun one = runProgram({stepmillBinary(), "inspect", part, "--json", "--jobs", "1"});
    const ProgramRun two = runProgram({stepmillBinary(), "inspect", part, "--json", "--jobs", "2"});
    EXPECT_EQ(one.out, two.out);
    EXPECT_FALSE(one.out.empty());
}

}  // namespace
}  // namespace stepmill::test
