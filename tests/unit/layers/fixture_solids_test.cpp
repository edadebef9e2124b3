#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <STEPControl_Writer.hxx>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "stepmill/layers/fixture_solids.h"
#include "support/occt_solids.h"
#include "support/run_program.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

double volumeOf(const std::vector<Fixture>& blocks) {
    double volume_mm3 = 0;
    for (const Fixture& block : blocks)
        volume_mm3 += area(block.section) * (block.top_z_mm - block.bottom_z_mm);
    return volume_mm3;
}

bool holds(const std::vector<Fixture>& blocks, const Vec3& p) {
    return std::any_of(blocks.begin(), blocks.end(), [&](const Fixture& block) {
        return p.z() >= block.bottom_z_mm && p.z() <= block.top_z_mm && contains(block.section, p.head<2>());
    });
}

/// A bed with two jaws, open along x.
TopoDS_Shape vise() {
    return cut(box(0, 0, 0, 100, 160, 60), box(-1, 40, 20, 102, 80, 41));
}

TEST(FixtureBlocks, AreTheSolidWhereItsWallsStandUpright) {
    const std::vector<Fixture> blocks =
        fixtureBlocks("vise", part(vise()), Eigen::Isometry3d(Eigen::Translation3d(-10, -40, -50)), kTol);
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_EQ(blocks[0].name, "vise");
    EXPECT_NEAR(blocks[0].top_z_mm, 10, 1e-6);
    EXPECT_NEAR(blocks[0].bottom_z_mm, -30, 1e-6);
    EXPECT_NEAR(blocks[1].bottom_z_mm, -50, 1e-6);
    EXPECT_NEAR(volumeOf(blocks), 100 * (160 * 20 + 80 * 40), 1e-3);
    EXPECT_TRUE(holds(blocks, {-10, -40, 10}));
    EXPECT_FALSE(holds(blocks, {0, 1, 0}));
}

TEST(FixtureBlocks, HoldARoundClampAtEveryHeight) {
    constexpr double kRadiusMm = 12;
    // It lies along x in the file and is turned by 30 degrees.
    const TopoDS_Shape bar =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()), kRadiusMm, 80).Shape();
    const Eigen::Isometry3d to_setup =
        Eigen::Translation3d(5, 7, -3) * Eigen::AngleAxisd(degToRad(30), Vec3::UnitZ());
    const std::vector<Fixture> blocks = fixtureBlocks("bar", part(bar), to_setup, kTol);
    for (double height_mm = -11.9; height_mm < 12; height_mm += 0.7)
        for (const double side : {-1.0, 1.0})
            for (const double along_mm : {0.001, 40.0, 79.999}) {
                const double half_mm = std::sqrt(kRadiusMm * kRadiusMm - height_mm * height_mm) - 1e-3;
                EXPECT_TRUE(holds(blocks, to_setup * Vec3(along_mm, side * half_mm, height_mm))) << height_mm;
            }
    EXPECT_LT(volumeOf(blocks), 1.2 * kPi * kRadiusMm * kRadiusMm * 80);
}

// A toe clamp, which rests on the stock's top with its nose and slants down behind it.
TEST(FixtureBlocks, LeaveFreeWhatIsUnderASlantingClamp) {
    BRepBuilderAPI_MakePolygon profile;
    for (const auto& [x, z] : std::initializer_list<std::pair<double, double>>{
             {-40, -25}, {-20, -25}, {-20, 2}, {10, 0}, {10, 15}, {-40, 15}})
        profile.Add(gp_Pnt(x, 20, z));
    profile.Close();
    const TopoDS_Shape clamp =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(profile.Wire()).Face(), gp_Vec(0, 30, 0));
    const std::vector<Fixture> blocks =
        fixtureBlocks("clamp", part(clamp), Eigen::Isometry3d::Identity(), kTol);
    EXPECT_TRUE(holds(blocks, {5, 30, 5}));
    EXPECT_TRUE(holds(blocks, {-30, 30, -20}));
    EXPECT_FALSE(holds(blocks, {-19, 30, -0.1}));
    EXPECT_FALSE(holds(blocks, {5, 30, -0.1}));
}

class FixtureFiles : public testing::Test {
  protected:
    void step(const char* name, const std::vector<TopoDS_Shape>& shapes) const {
        STEPControl_Writer writer;
        for (const TopoDS_Shape& shape : shapes)
            writer.Transfer(shape, STEPControl_AsIs);
        writer.Write(path(name).c_str());
    }

    FixtureFile read(const std::string& solid) const {
        writeFile(path("clamps.json"),
                  R"({"format": 1, "unit": "mm", "setups": [{"setup": "S1", "fixtures": [)"
                  R"({"name": "stop", "outline": [[-9, 0], [0, 0], [0, 9]], "bottom": -9, "top": 0}],)"
                  R"("solids": [)" +
                      solid + "]}]}");
        return readFixturesWithSolids(path("clamps.json"), kMaxFileBytes, kTol);
    }

    std::string refusal(const std::string& solid) const {
        try {
            read(solid);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
            return error.what();
        }
        return {};
    }

  private:
    fs::path path(const char* name) const { return fs::path(folder_.path()) / name; }

    TemporaryFolder folder_;
};

TEST_F(FixtureFiles, PlaceAllSolidsOfAStepFile) {
    step("vise.step", {box(0, 0, 0, 10, 20, 30), box(50, 0, 0, 10, 20, 30)});
    const FixtureFile file =
        read(R"({"name": "vise", "file": "vise.step", "up": "+y", "turn": 90, "at": [100, 0, -5]})");
    const std::vector<Fixture>& fixtures = file.setups.at("S1");
    ASSERT_EQ(fixtures.size(), 3U);
    EXPECT_EQ(fixtures[0].name, "stop");
    const std::vector<Fixture> blocks(fixtures.begin() + 1, fixtures.end());
    EXPECT_NEAR(volumeOf(blocks), 2 * 10 * 20 * 30, 1e-3);
    // The file's (x, y, z) stands at (100 + z, x, y - 5): y points up, then it is turned from x to y.
    EXPECT_TRUE(holds(blocks, {101, 1, -4}));
    EXPECT_TRUE(holds(blocks, {129, 9, 14}));
    EXPECT_TRUE(holds(blocks, {129, 51, 14}));
    EXPECT_FALSE(holds(blocks, {115, 30, 5}));
}

TEST_F(FixtureFiles, NameWhatIsWrongWithAStepFile) {
    EXPECT_NE(refusal(R"({"name": "vise", "file": "none.step", "at": [0, 0, 0]})")
                  .find("clamps.json#/setups/0/solids/0/file"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"name": "vise", "file": "clamps.json", "at": [0, 0, 0]})").find("STEP"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"name": "vise", "file": "vise.step", "up": "z", "at": [0, 0, 0]})")
                  .find("#/setups/0/solids/0/up"),
              std::string::npos);
    EXPECT_NE(
        refusal(R"({"name": "vise", "file": "vise.step", "at": [0, 0]})").find("#/setups/0/solids/0/at"),
        std::string::npos);
}

}  // namespace
}  // namespace stepmill::test
