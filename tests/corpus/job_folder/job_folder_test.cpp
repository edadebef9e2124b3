// The program and its job folders: nothing of an earlier job stays, two writers, stops, limits, closed ends.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"
#include "support/text_file.h"
#include "support/told.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kShoulder = kSource + "/step_parts/shoulder_block.step";
const std::string kPocket = kSource + "/step_parts/rounded_pocket.step";
const std::string kSlow = kSource + "/step_parts/bossed_pocket.step";

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

class JobFolders : public testing::Test {
  protected:
    static ProgramRun stepmill(Words words) {
        words.insert(words.begin(), stepmillBinary());
        return runProgram(words);
    }

    /// A line for the shell in which $S is the program, its exit code is the run's.
    ProgramRun shell(const std::string& line) const {
        return runProgram(
            {"/bin/bash", "-c", "cd '" + folder_.path() + "'; S='" + stepmillBinary() + "'; " + line});
    }

    /// Starts the program; its end is awaited with endOf().
    static pid_t start(Words words) {
        words.insert(words.begin(), stepmillBinary());
        return startProgram(words);
    }

    /// As a shell says it: 128 and the signal's number for one that killed it.
    static int endOf(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    }

    fs::path file(const std::string& name) const { return fs::path(folder_.path()) / name; }
    std::string plan(const std::string& part, const Words& options = {}) const {
        Words words{"plan", part, "-o", job_.string()};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramRun run = stepmill(words);
        EXPECT_LE(run.exit_code, 1) << run.err;
        return run.err;
    }

    TemporaryFolder folder_;
    fs::path job_ = file("job");
};

TEST_F(JobFolders, NothingOfAnEarlierPlanAndItsPostsStays) {
    plan(kPocket, {"--setup", "+z", "--setup", "-z"});  // nothing is left for the second
    for (const Words& how : {Words{"fanuc"}, {"grbl"}, {"grbl", "--per", "tool"}}) {
        Words words{"post", job_.string(), "--dialect"};
        words.insert(words.end(), how.begin(), how.end());
        EXPECT_EQ(stepmill(words).exit_code, 0);
    }
    EXPECT_FALSE(fs::exists(job_ / "S1.gcode")) << "the second post of a dialect replaces the first";
    EXPECT_EQ(stepmill({"verify", job_.string(), "--dialect", "grbl"}).exit_code, 0);
    std::ofstream(job_ / "notes.txt") << "hers";
    plan(kShoulder);
    EXPECT_EQ(namesIn(job_), (std::set<std::string>{"S1.ngc", "manifest.json", "notes.txt", "plan.json",
                                                    "report.html", "sheets.html"}));
    EXPECT_EQ(slurp(job_ / "notes.txt"), "hers");
    EXPECT_EQ(namesIn(folder_.path()), std::set<std::string>{"job"});
}

TEST_F(JobFolders, VerifyNamesStrangeProgramsAndEditedFiles) {
    plan(kShoulder);
    std::ofstream(job_ / "S1.ngc", std::ios::app) << "(checked by hand)\n";
    ProgramRun run = stepmill({"verify", job_.string(), "--json"});
    EXPECT_EQ(Json::parse(run.out).at("remarks"), Json::parse(R"([{"file": "S1.ngc", "is": "changed"}])"));
    fs::copy_file(job_ / "S1.ngc", job_ / "S9.ngc");
    run = stepmill({"verify", job_.string()});
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(test::tells(run.out, {"S9.ngc", "not of this job"}));
}

TEST_F(JobFolders, AProgramOfNobodysIsNamedBeforeAnyWorkIsDone) {
    fs::create_directory(job_);
    std::ofstream(job_ / "O0001.nc") << "%";
    const ProgramRun run = stepmill({"plan", kSlow, "-o", job_.string()});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("O0001.nc"), std::string::npos) << run.err;
    EXPECT_EQ(namesIn(job_), std::set<std::string>{"O0001.nc"});
}

TEST_F(JobFolders, EditsThatAreReplacedAreTold) {
    plan(kShoulder);
    std::ofstream(job_ / "S1.ngc", std::ios::app) << "(mine)\n";
    EXPECT_TRUE(test::tells(plan(kShoulder), {"S1.ngc", "edited"}));
}

TEST_F(JobFolders, PostsInThePlansOwnDialectTakeThePlaceOfItsPrograms) {
    plan(kSlow);
    EXPECT_EQ(stepmill({"post", job_.string(), "--per", "tool"}).exit_code, 0);
    EXPECT_FALSE(fs::exists(job_ / "S1.ngc"));
    EXPECT_EQ(stepmill({"verify", job_.string()}).exit_code, 0);
    EXPECT_EQ(stepmill({"post", job_.string()}).exit_code, 0);
    EXPECT_EQ(namesIn(job_),
              (std::set<std::string>{"S1.ngc", "manifest.json", "plan.json", "report.html", "sheets.html"}));
}

TEST_F(JobFolders, AnEditedPlanIsToldAndNotPosted) {
    plan(kShoulder);
    std::ofstream(job_ / "plan.json", std::ios::app) << "\n";
    EXPECT_TRUE(test::tells(stepmill({"verify", job_.string()}).out, {"plan.json", "not as it was written"}));
    const ProgramRun run = stepmill({"post", job_.string(), "--dialect", "fanuc"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("plan.json: has been changed"), std::string::npos) << run.err;
}

TEST_F(JobFolders, InspectWritesBesideAPlanOfItsPartAlone) {
    plan(kShoulder);
    EXPECT_EQ(stepmill({"inspect", kShoulder, "-o", job_.string()}).exit_code, 0);
    EXPECT_TRUE(fs::exists(job_ / "inspect.html"));
    EXPECT_EQ(stepmill({"verify", job_.string()}).exit_code, 0);
    const ProgramRun run = stepmill({"inspect", kPocket, "-o", job_.string()});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("shoulder_block.step"), std::string::npos) << run.err;
}

TEST_F(JobFolders, OfTwoWritersOneIsRefusedOrBothAreWholeInTurn) {
    for (int i = 0; i < 30; ++i) {
        const pid_t one = start({"plan", kShoulder, "-o", job_.string(), "--jobs", "1"});
        const pid_t other = start({"plan", kPocket, "-o", job_.string(), "--jobs", "1"});
        const int one_end = endOf(one);
        const int other_end = endOf(other);
        EXPECT_TRUE(one_end == 0 || one_end == 2) << one_end;
        EXPECT_TRUE(other_end == 0 || other_end == 2) << other_end;
        EXPECT_TRUE(one_end == 0 || other_end == 0);
        EXPECT_EQ(namesIn(job_), (std::set<std::string>{"S1.ngc", "manifest.json", "plan.json", "report.html",
                                                        "sheets.html"}));
        const Json manifest = Json::parse(slurp(job_ / "manifest.json"));
        const Json planned = Json::parse(slurp(job_ / "plan.json"));
        EXPECT_EQ(manifest["part"]["sha256"], planned["part"]["sha256"]);
        EXPECT_EQ(namesIn(folder_.path()), std::set<std::string>{"job"});
    }
    EXPECT_EQ(stepmill({"verify", job_.string()}).exit_code, 0);
}

TEST_F(JobFolders, ASignalEndsARunAtAnyTimeAndLeavesTheOldJob) {
    plan(kShoulder);
    const std::string before = slurp(job_ / "manifest.json");
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        for (const int wait_ms : {1, 30, 120, 300}) {
            const pid_t run = start({"plan", kShoulder, "-o", job_.string()});
            std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
            kill(run, signal);
            const int end = endOf(run);
            EXPECT_TRUE(end == 0 || end == 128 + signal) << end;
            EXPECT_EQ(slurp(job_ / "manifest.json"), before) << "the same part has the same manifest";
            EXPECT_EQ(namesIn(folder_.path()), std::set<std::string>{"job"});
        }
    }
    EXPECT_EQ(stepmill({"verify", job_.string()}).exit_code, 0);
}

TEST_F(JobFolders, AKilledRunLeavesNothingThatTheNextDoesNotTidy) {
    plan(kShoulder);
    for (const int wait_ms : {50, 150, 250, 350, 450}) {
        const pid_t run = start({"plan", kShoulder, "-o", job_.string()});
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
        kill(run, SIGKILL);
        endOf(run);
        EXPECT_EQ(stepmill({"verify", job_.string()}).exit_code, 0) << wait_ms;
        plan(kShoulder);
        EXPECT_EQ(namesIn(folder_.path()), std::set<std::string>{"job"});
    }
}

TEST_F(JobFolders, AFileSizeLimitAtAnySizeLeavesTheOldJob) {
    plan(kShoulder);
    const std::string before = slurp(job_ / "manifest.json");
    for (const int blocks : {0, 1, 2, 10, 31, 36}) {
        const ProgramRun run =
            shell("ulimit -f " + std::to_string(blocks) + "; $S plan '" + kPocket + "' -o job > /dev/null");
        EXPECT_EQ(run.exit_code, 2);
        EXPECT_EQ(slurp(job_ / "manifest.json"), before);
        EXPECT_EQ(namesIn(folder_.path()), std::set<std::string>{"job"});
    }
}

TEST_F(JobFolders, AFullStandardOutputIsToldByEveryCommand) {
    plan(kShoulder);
    const std::string part = "'" + kShoulder + "'";
    for (const std::string& command :
         {"plan " + part + " -o other", "plan " + part + " -o other --json", "inspect " + part,
          "inspect " + part + " --json", "rank " + part, "rank " + part + " --csv",
          "rank '" + kSource + "/samples/lim2000_fig8.csv'", std::string("verify job"),
          std::string("verify job --json"), std::string("post job --dialect fanuc"),
          "tools validate '" + kSource + "/samples/shop_metric_tools.json'", std::string("--help"),
          std::string("--version")}) {
        const ProgramRun run = shell("$S " + command + " > /dev/full");
        EXPECT_EQ(run.exit_code, 2) << command;
        EXPECT_NE(run.err.find("standard output: "), std::string::npos) << command << ": " << run.err;
    }
}

TEST_F(JobFolders, AClosedPipeIsNoCrash) {
    plan(kShoulder);
    const std::string part = "'" + kShoulder + "'";
    for (const std::string& command :
         {"inspect " + part + " --json", "rank " + part + " --json", "plan " + part + " -o other --json",
          std::string("verify job"), std::string("--help")}) {
        const ProgramRun run = shell("$S " + command + " | true; exit ${PIPESTATUS[0]}");
        EXPECT_TRUE(run.exit_code == 141 || run.exit_code == 0) << command << ": " << run.exit_code;
        EXPECT_EQ(run.err, "") << command;
    }
}

TEST_F(JobFolders, PipesAndDevicesAreRefusedAsInputsOfEveryCommand) {
    plan(kShoulder);
    ASSERT_EQ(mkfifo(file("pipe.step").c_str(), 0600), 0);
    ASSERT_EQ(mkfifo(file("pipe.csv").c_str(), 0600), 0);
    const std::string part = "'" + kShoulder + "'";
    for (const std::string& input :
         {std::string("pipe.step"), std::string("/dev/zero"), std::string("/dev/stdin"), std::string(".")}) {
        for (const std::string& command :
             {"plan " + input, "inspect " + input, "rank " + input, std::string("rank pipe.csv"),
              "plan " + part + " -o o --tools " + input, "plan " + part + " -o o --machine " + input,
              "plan " + part + " -o o --fixtures " + input, "plan " + part + " -o o --stock " + input,
              "verify job --part " + input, "tools validate " + input}) {
            const ProgramRun run = shell("echo x | timeout 20 $S " + command);
            EXPECT_EQ(run.exit_code, 2) << command << ": " << run.err;
            EXPECT_NE(run.err.find(", not a file"), std::string::npos) << command << ": " << run.err;
        }
    }
}

TEST_F(JobFolders, LargeFilesAreRefusedByTheirSize) {
    fs::copy_file(kShoulder, file("huge.step"));
    fs::resize_file(file("huge.step"), std::uintmax_t{8} << 30);
    const ProgramRun huge = stepmill({"plan", file("huge.step").string(), "-o", job_.string()});
    EXPECT_EQ(huge.exit_code, 2);
    EXPECT_NE(huge.err.find("--max-file-size"), std::string::npos) << huge.err;
    EXPECT_LT(huge.seconds, 10);
    const ProgramRun small = stepmill({"inspect", kShoulder, "--max-file-size", "0.005"});
    EXPECT_EQ(small.exit_code, 2);
    EXPECT_NE(small.err.find("--max-file-size"), std::string::npos) << small.err;
}

TEST_F(JobFolders, LimitsAreToldAsWhatTheyAre) {
    const std::string slow = "'" + kSlow + "' -o job";
    std::ofstream(file("spaces.json")) << std::string(std::size_t{40} << 20, ' ');
    const ProgramRun memory =
        shell("$S tools validate spaces.json --memory 0.05; code=$?; rm spaces.json; exit $code");
    EXPECT_EQ(memory.exit_code, 2) << memory.err;
    EXPECT_NE(memory.err.find("ran out of memory"), std::string::npos) << memory.err;
    EXPECT_NE(memory.err.find("--memory"), std::string::npos) << memory.err;
    const ProgramRun time = shell("$S plan " + slow + " --timeout 0.001");
    EXPECT_EQ(time.exit_code, 2);
    EXPECT_NE(time.err.find("stopped after 0.001 s"), std::string::npos) << time.err;
    EXPECT_EQ(time.err.find("while ;"), std::string::npos) << time.err;
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(JobFolders, RangesAreToldInShortMessages) {
    for (const std::string option :
         {"--timeout nan", "--timeout inf", "--timeout -1", "--timeout 1e400", "--memory 0", "--memory nan",
          "--max-file-size -3", "--jobs -1", "--jobs 99999999999999999999", "--setup 1e308,1e308,1e308",
          "--setup 0,0,1e300", "--setup nan,0,1"}) {
        const ProgramRun run = shell("$S plan '" + kShoulder + "' -o job " + option);
        EXPECT_EQ(run.exit_code, 2) << option << ": " << run.err;
        EXPECT_LT(run.err.size(), 200u) << run.err;
        EXPECT_NE(run.err.find(option.substr(0, option.find(' '))), std::string::npos) << run.err;
    }
}

}  // namespace
}  // namespace stepmill::test
