// Every file of the collection of ill-formed and unwelcome STEP files ends as its README asks: refused with
// a reason or loaded, never a crash, never a hang.

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/core/supervise.h"
#include "stepmill/part/part.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeLimit_s = 60;
constexpr int kLoaded = 100;   // exit code of the child: plus the number of solids
constexpr int kRefused = 200;  // plus the error code

struct Expectation {
    std::string file;
    std::optional<ErrorCode> refusal;  ///< nothing: must load
    int solids = 0;                    ///< uses of solids, counting repeats
};

std::vector<Expectation> expectations() {
    using enum ErrorCode;
    return {{"ANC101-ill.stp", NoSolid},
            {"Mechanism_Example.stp", {}, 3},
            {"as1-oc-214_assembly.stp", {}, 18},
            {"as1_pe_203_assembly.stp", {}, 18},
            {"binary_noise.stp", NotStep},
            {"blends_test_30_shell_only.stp", NoSolid},
            {"bolt.stp", {}, 1},
            {"crlf_and_comments.stp", {}, 1},
            {"dangling_face_refs.stp", StepDamaged},
            {"dm1-id-214_all_bspline.stp", {}, 7},
            {"empty.stp", NotStep},
            {"empty_data_section.stp", NoSolid},
            {"gzip_renamed.stp", NotStep},
            {"header_only.stp", StepDamaged},
            {"huge_coordinate.stp", ImplausibleSize},
            {"moved_vertex.stp", InvalidSolid},
            {"nan_coordinate.stp", StepDamaged},
            {"no_units.stp", {}, 1},
            {"one_newline.stp", NotStep},
            {"open_shell_as_solid.stp", OpenShell},
            {"s1-c5-214_external_refs.stp", NoSolid},
            {"self_reference.stp", StepDamaged},
            {"sphere.stp", {}, 1},
            {"stl_renamed.stp", NotStep},
            {"text_renamed.stp", NotStep},
            {"truncated_90.stp", StepDamaged},
            {"truncated_half.stp", StepDamaged},
            {"truncated_in_header.stp", StepDamaged},
            {"truncated_no_endsec.stp", StepDamaged},
            {"ubend2_surface_only.stp", NoSolid},
            {"unknown_schema.stp", {}, 1},
            {"wavy-cube_shell_only.stp", NoSolid}};
}

/// Reads the file in a child, which prints the table's row and encodes the outcome in its exit code.
Supervised readSupervised(const fs::path& path) {
    return runSupervised(
        [&](StageBoard& stage) {
            stage.set("reading " + path.filename().string());
            try {
                int solids = 0;
                std::string names;
                for (const Part& part : readStep(path)) {
                    solids += part.count;
                    names += fmt::format("{} x {}, {:.6g} mm3; ", part.count, part.name, part.volume_mm3);
                    for (const Remark& remark : part.remarks)
                        names += "(" + remark.text + ") ";
                }
                fmt::print("| {:<30} | loaded  | {}|\n", path.filename().string(), names);
                return kLoaded + solids;
            } catch (const Error& error) {
                fmt::print("| {:<30} | refused | {} |\n", path.filename().string(), error.what());
                return kRefused + static_cast<int>(error.code());
            }
        },
        kTimeLimit_s);
}

TEST(BadParts, EveryFileIsRefusedWithReasonOrLoadedAsItsReadmeAsks) {
    const fs::path folder = fs::path(STEPMILL_SOURCE_DIR) / ".." / "shared" / "parts" / "bad";
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no collection of bad parts at " << folder;
    for (const Expectation& expected : expectations()) {
        SCOPED_TRACE(expected.file);
        ASSERT_TRUE(fs::exists(folder / expected.file));
        const Supervised run = readSupervised(folder / expected.file);
        ASSERT_EQ(run.end, Supervised::End::Exited) << run.last_stage << ", signal " << run.signal;
        const int wanted =
            expected.refusal ? kRefused + static_cast<int>(*expected.refusal) : kLoaded + expected.solids;
        EXPECT_EQ(run.exit_code, wanted);
    }
}

TEST(BadParts, EveryFileOfTheCollectionHasAnExpectation) {
    const fs::path folder = fs::path(STEPMILL_SOURCE_DIR) / ".." / "shared" / "parts" / "bad";
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no collection of bad parts at " << folder;
    std::set<std::string> known;
    for (const Expectation& expected : expectations())
        known.insert(expected.file);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".stp") continue;
        EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path().filename();
    }
}

}  // namespace
}  // namespace stepmill
