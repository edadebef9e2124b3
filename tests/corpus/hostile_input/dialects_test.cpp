// A machine file may name any controller: plan, verify and post work with it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kSource = STEPMILL_SOURCE_DIR;

struct Controller {
    std::string dialect;
    std::string extension;
};

void PrintTo(const Controller& controller, std::ostream* out) {
    *out << controller.dialect;
}

const std::vector<Controller> kControllers{{"linuxcnc", ".ngc"}, {"fanuc", ".nc"}, {"grbl", ".gcode"}};

class MachineDialect : public testing::TestWithParam<Controller> {};

TEST_P(MachineDialect, IsPlannedProvenAndPosted) {
    const TemporaryFolder folder;
    const fs::path job = fs::path(folder.path()) / "job";
    const fs::path machine = fs::path(folder.path()) / "machine.json";
    json settings = json::parse(readFile(kSource + "/samples/machine_vmc.json"));
    settings["dialect"] = GetParam().dialect;
    std::ofstream(machine) << settings.dump();

    const ProgramRun planned = runProgram({stepmillBinary(), "plan", kSource + "/step_parts/four_setups.step",
                                           "--machine", machine.string(), "-o", job.string()});
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    for (const char* setup : {"S1", "S2", "S3", "S4"})
        EXPECT_TRUE(fs::exists(job / (setup + GetParam().extension)));
    const ProgramRun verified = runProgram({stepmillBinary(), "verify", job.string()});
    EXPECT_EQ(verified.exit_code, 0) << verified.out;
    for (const Controller& other : kControllers) {
        const fs::path posted = fs::path(folder.path()) / other.dialect;
        const ProgramRun post = runProgram(
            {stepmillBinary(), "post", job.string(), "--dialect", other.dialect, "-o", posted.string()});
        EXPECT_EQ(post.exit_code, 0) << other.dialect << ": " << post.err;
        EXPECT_TRUE(fs::exists(posted / ("S1" + other.extension))) << other.dialect;
    }
}

INSTANTIATE_TEST_SUITE_P(All, MachineDialect, testing::ValuesIn(kControllers));

}  // namespace
}  // namespace stepmill::test
