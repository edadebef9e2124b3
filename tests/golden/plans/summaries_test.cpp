// The summary of every sample part, compared as text. `make golden` writes them anew; review the diff.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

TEST(Golden, SummariesOfTheSampleParts) {
    const bool rewrite = std::getenv("STEPMILL_REWRITE_GOLDEN") != nullptr;
    for (const std::string& part : sampleParts()) {
        const TemporaryFolder folder;
        const ProgramRun run = runProgram({stepmillBinary(), "plan", part, "-o", folder.path() + "/plan"});
        const std::string summary = run.out.substr(0, run.out.find("\nReport:"));
        const fs::path golden =
            fs::path(STEPMILL_SOURCE_DIR) / "tests/golden/summaries" / fs::path(part).stem().concat(".txt");
        if (rewrite) {
            fs::create_directories(golden.parent_path());
            std::ofstream(golden) << summary;
            continue;
        }
        std::ifstream file(golden);
        const std::string expected{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(summary, expected) << golden;
    }
}

}  // namespace
}  // namespace stepmill::test
