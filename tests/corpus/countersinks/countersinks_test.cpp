// Random plates with countersunk holes: they are drilled, a countersink makes the cones in one stroke each,
// as a cycle, and the programs leave no more of them than the skin that bands ask for.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <BRepPrimAPI_MakeCone.hxx>
#include <nlohmann/json.hpp>

#include "sample_parts.h"
#include "solids.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "support/dice.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kTools = STEPMILL_SOURCE_DIR "/samples/shop_for_holes_tools.json";

/// What stays on a flank: two scallops of 0.02 mm by the bands, the guard and what tips are rounded to [mm].
constexpr double kSkinMm = 0.05;

struct SunkPlate {
    SamplePart part;
    double cones_mm3 = 0;  ///< of what the cones take beside the bores
    int cones = 0;
    double angle_deg = 90;
    double flanks_mm2 = 0;
};

SunkPlate sunkPlate(std::uint64_t seed) {
    Dice dice(seed);
    SunkPlate plate;
    plate.angle_deg = dice.oneOf({82.0, 90.0, 120.0});
    plate.cones = 2 + static_cast<int>(dice.below(4));
    const double thick = dice.between(10, 16, 1);
    std::vector<TopoDS_Shape> cuts;
    for (int i = 0; i < plate.cones; ++i) {
        const double x = 15 + 22.0 * i;
        const double y = dice.between(14, 26, 1);
        const double bore = dice.oneOf({5.0, 6.0});
        const double wide = bore + dice.between(1, 6, 0.5);
        const double slope = std::tan(degToRad(plate.angle_deg) / 2);
        const double high = (wide - bore) / 2 / slope;
        cuts.push_back(cylinder(x, y, bore, -1, thick + 1));
        cuts.push_back(
            BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, y, thick - high), gp::DZ()), bore / 2, wide / 2, high)
                .Shape());
        const double r = bore / 2;
        const double w = wide / 2;
        plate.cones_mm3 += kPi * high * ((w * w + w * r + r * r) / 3 - r * r);
        plate.flanks_mm2 += kPi * (w + r) * std::hypot(high, w - r);
        plate.part.about += fmt::format("; bore {} cone {:.2f}", bore, wide);
    }
    plate.part.name = fmt::format("sunk_{}", seed);
    plate.part.solid = assemble(box(0, 0, 0, 22.0 * plate.cones + 10, 40, thick), {}, cuts);
    return plate;
}

/// The holes' library with a countersink of that angle.
std::string libraryWith(double angle_deg) {
    Json library = Json::parse(readFile(kTools));
    library["tools"].push_back({{"id", "CS16"},
                                {"number", 88},
                                {"type", "countersink"},
                                {"diameter", 16},
                                {"tip_diameter", 2},
                                {"included_angle_deg", angle_deg},
                                {"flute_length", 12},
                                {"flutes", 3},
                                {"stick_out", 50},
                                {"shank", {{"diameter", 10}, {"from", 14}}},
                                {"holder", {{{"diameter", 32}, {"bottom", 50}, {"top", 100}}}},
                                {"cutting",
                                 {{{"material", "aluminium"},
                                   {"feed", 200},
                                   {"plunge_feed", 200},
                                   {"speed_rpm", 1200},
                                   {"dwell_s", 0.3}}}}});
    return library.dump(1);
}

class SunkPlates : public testing::TestWithParam<std::uint64_t> {
  protected:
    fs::path file(const std::string& name) const { return fs::path(folder_.path()) / name; }
    ProgramRun verify() const {
        return runProgram({stepmillBinary(), "verify", file("job").string(), "--part", part_.string(),
                           "--tools", file("tools.json").string()});
    }

    void plan(const SunkPlate& plate) {
        part_ = file(plate.part.name + ".step");
        std::ofstream(part_) << sampleStepText(plate.part);
        std::ofstream(file("tools.json")) << libraryWith(plate.angle_deg);
        const ProgramRun run =
            runProgram({stepmillBinary(), "plan", part_.string(), "--tools", file("tools.json").string(),
                        "-o", file("job").string(), "--setup", "+z", "--no-viewer"});
        ASSERT_LE(run.exit_code, 1) << run.err;
        plan_ = Json::parse(readFile(file("job") / "plan.json"));
    }

    const TemporaryFolder folder_;
    fs::path part_;
    Json plan_;
};

TEST_P(SunkPlates, AreSunkInOneStrokeEach) {
    const SunkPlate plate = sunkPlate(GetParam());
    SCOPED_TRACE(plate.part.about);
    plan(plate);
    int holes = 0;
    double taken_mm3 = 0;
    for (const Json& operation : plan_["operations"]) {
        EXPECT_TRUE(operation["role"] == "form" || operation["role"] == "drill" ||
                    operation["role"] == "spot");
        if (operation["role"] != "form") continue;
        EXPECT_EQ(operation["pattern"], "countersink");
        EXPECT_EQ(operation["dwell_s"], 0.3);
        holes += operation["holes"].get<int>();
        for (const Json& entry : operation["takes"])
            taken_mm3 += entry["volume_mm3"].get<double>();
    }
    EXPECT_EQ(holes, plate.cones);
    EXPECT_LE(taken_mm3, plate.cones_mm3 * 1.001);
    EXPECT_GE(taken_mm3, plate.cones_mm3 - kSkinMm * plate.flanks_mm2);
    const Json& books = plan_["volume_balance"];
    EXPECT_LE(books["residual_mm3"].get<double>() + books["unreachable_mm3"].get<double>(),
              kSkinMm * plate.flanks_mm2);
    const std::string program = readFile(file("job") / "S1.ngc");
    EXPECT_NE(program.find(" G82 "), std::string::npos) << "a cycle with a dwell";
    const ProgramRun proof = verify();
    EXPECT_LE(proof.exit_code, 1) << proof.out << proof.err;
}

TEST_P(SunkPlates, DeeperSinksAndShorterStaysAreFound) {
    const SunkPlate plate = sunkPlate(GetParam());
    plan(plate);
    const std::string program = readFile(file("job") / "S1.ngc");
    const std::size_t cycle = program.find(" G82 ");
    ASSERT_NE(cycle, std::string::npos);
    const std::size_t z = program.find('Z', cycle);
    const double depth = std::stod(program.substr(z + 1));
    const std::size_t end = program.find(' ', z);
    std::string deeper = program;
    deeper.replace(z, end - z, fmt::format("Z{:.4f}", depth - 0.15));
    const auto refuses = [&](const std::string& text) {
        std::ofstream(file("job") / "S1.ngc", std::ios::binary) << text;
        fs::remove(file("job") / "manifest.json");
        return verify().exit_code == 2;
    };
    EXPECT_TRUE(refuses(deeper));
    std::string hasty = program;
    const std::size_t stay = hasty.find(" P0.3", cycle);
    ASSERT_NE(stay, std::string::npos);
    hasty.replace(stay, 5, " P0.1");
    EXPECT_TRUE(refuses(hasty));
    EXPECT_FALSE(refuses(program));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SunkPlates, testing::Range<std::uint64_t>(1, 7));

}  // namespace
}  // namespace stepmill::test
