// Parts whose faces and edges are all splines, as some systems export them.

#include <gtest/gtest.h>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

class SplinedParts : public testing::TestWithParam<ExpectedOutcome> {};

void writeSplined(const std::string& part, const std::string& to) {
    STEPControl_Reader reader;
    reader.ReadFile(part.c_str());
    reader.TransferRoots();
    STEPControl_Writer writer;
    writer.Transfer(BRepBuilderAPI_NurbsConvert(reader.OneShape(), true).Shape(), STEPControl_AsIs);
    writer.Write(to.c_str());
}

struct InspectedFeature {
    std::string id;
    std::string type;
    double volume_mm3 = 0;
    std::size_t holes = 0;
};

struct Inspected {
    std::map<std::string, int> surfaces;
    std::vector<InspectedFeature> features;
    std::vector<double> hole_diameters_mm;
};

Inspected inspected(const std::string& part) {
    const ProgramRun run = runProgram({stepmillBinary(), "inspect", part, "--json"});
    EXPECT_LE(run.exit_code, 1) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    Inspected found;
    found.surfaces = json.at("part").at("surfaces").get<std::map<std::string, int>>();
    for (const auto& setup : json.at("setups"))
        for (const auto& feature : setup.at("features"))
            found.features.push_back({feature.at("id"), feature.at("class"), feature.at("volume_mm3"),
                                      feature.at("holes").size()});
    for (const auto& hole : json.at("holes"))
        found.hole_diameters_mm.push_back(hole.at("diameter_mm"));
    return found;
}

TEST_P(SplinedParts, HaveTheFeaturesAndHolesOfTheirPart) {
    if (GetParam().path.empty()) GTEST_SKIP() << GetParam().part << " is not beside this checkout";
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/splined.step";
    writeSplined(GetParam().path, file);
    const Inspected drawn = inspected(GetParam().path);
    const Inspected splined = inspected(file);
    EXPECT_EQ(splined.surfaces, drawn.surfaces);
    ASSERT_EQ(splined.features.size(), drawn.features.size());
    for (std::size_t i = 0; i < drawn.features.size(); ++i) {
        const InspectedFeature& feature = drawn.features[i];
        SCOPED_TRACE(feature.id);
        EXPECT_EQ(splined.features[i].id, feature.id);
        EXPECT_EQ(splined.features[i].type, feature.type);
        EXPECT_EQ(splined.features[i].holes, feature.holes);
        constexpr double kVolumeShare = 1e-4;
        EXPECT_NEAR(splined.features[i].volume_mm3, feature.volume_mm3, kVolumeShare * feature.volume_mm3);
    }
    ASSERT_EQ(splined.hole_diameters_mm.size(), drawn.hole_diameters_mm.size());
    for (std::size_t i = 0; i < drawn.hole_diameters_mm.size(); ++i)
        EXPECT_NEAR(splined.hole_diameters_mm[i], drawn.hole_diameters_mm[i], 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheCorpus, SplinedParts,
    testing::ValuesIn(expectedRows({"machined/hole_model.stp", "machined/isolated_blends_test_09.stp",
                                    "machined/nist_d2mi_827-9999-904.stp", "nist/nist_ftc_09_asme1_rd.stp"})),
    [](const auto& row) { return testName(row.param); });

}  // namespace
}  // namespace stepmill::test
