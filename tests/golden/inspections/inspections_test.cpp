// What inspect finds in parts: against what a person says of them (tests/corpus/facts), and against what it
// said before (the goldens here).

#include <gtest/gtest.h>

#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/golden.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Diameters in facts files are rounded to this [mm].
constexpr double kDiameterMm = 5e-3;
/// Volumes by slab and by feature agree to this share [features.md].
constexpr double kBooksShare = 1e-3;

const fs::path kFacts = fs::path(STEPMILL_SOURCE_DIR) / "tests/corpus/facts";

std::vector<std::string> factsFiles() {
    std::vector<std::string> stems;
    for (const auto& entry : fs::directory_iterator(kFacts))
        if (entry.path().extension() == ".json") stems.push_back(entry.path().stem());
    std::sort(stems.begin(), stems.end());
    return stems;
}

/// "nist/part.stp" on this machine.
fs::path pathOf(const fs::path& part) {
    return fs::path(folderOfParts(part.parent_path())) / part.filename();
}

/// As a person counts them: a feature of several equal holes as each of these.
std::map<std::string, int> featuresByClass(const Json& inspection) {
    std::map<std::string, int> counts;
    for (const Json& setup : inspection.at("setups"))
        for (const Json& feature : setup.at("features")) {
            const std::size_t holes = feature.contains("holes") ? feature.at("holes").size() : 0;
            counts[feature.at("class").get<std::string>()] +=
                static_cast<int>(std::max<std::size_t>(1, holes));
        }
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

/// Counts of features are facts only where the part was drawn for them.
void expectFacts(const Json& facts, const Json& inspection) {
    EXPECT_EQ(inspection.at("setups").size(), facts.at("setups").get<std::size_t>());
    if (facts.contains("features")) {
        EXPECT_EQ(featuresByClass(inspection), (facts.at("features").get<std::map<std::string, int>>()));
    }
    std::size_t holes = 0;
    for (const Json& hole : facts.at("holes")) {
        const int count = hole.at("count");
        holes += static_cast<std::size_t>(count);
        EXPECT_EQ(countHoles(inspection, hole.at("class"), hole.at("diameter_mm")), count) << hole;
    }
    EXPECT_EQ(inspection.at("holes").size(), holes);
    EXPECT_LE(inspection.at("books").at("gap_share").get<double>(), kBooksShare);
}

/// One line a feature and a hole.
std::string goldenText(const Json& inspection) {
    std::string text;
    for (const Json& setup : inspection.at("setups")) {
        text += setup.at("id").get<std::string>() + "\n";
        for (const Json& feature : setup.at("features"))
            text +=
                fmt::format("  {} {}, {:.3f} mm3\n", feature.at("id").get<std::string>(),
                            feature.at("class").get<std::string>(), feature.at("volume_mm3").get<double>());
    }
    for (const Json& hole : inspection.at("holes"))
        text += fmt::format("{}, {:.3f} mm\n", hole.at("class").get<std::string>(),
                            hole.at("diameter_mm").get<double>());
    return text;
}

class InspectedPart : public testing::TestWithParam<std::string> {};

TEST_P(InspectedPart, IsWhatItsFactsFileSaysAndWhatItWasBefore) {
    const Json facts = Json::parse(slurp(kFacts / (GetParam() + ".json")));
    const fs::path part = pathOf(facts.at("part").get<std::string>());
    if (!fs::exists(part)) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    std::vector<std::string> arguments{stepmillBinary(), "inspect", part, "--json"};
    for (const Json& option : facts.value("options", Json::array()))
        arguments.push_back(option.get<std::string>());
    if (facts.contains("stock")) {
        arguments.push_back("--stock");
        arguments.push_back(pathOf(facts.at("stock").get<std::string>()));
    }
    const ProgramRun run = runProgram(arguments);
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 1) << run.err;
    const Json inspection = Json::parse(run.out);
    expectFacts(facts, inspection);
    expectGolden("inspections/" + GetParam() + ".txt", goldenText(inspection));
}

INSTANTIATE_TEST_SUITE_P(Facts, InspectedPart, testing::ValuesIn(factsFiles()),
                         [](const auto& stem) { return stem.param; });

}  // namespace
}  // namespace stepmill::test
